// Nothing: the target that compiles it has the headers of others that all targets share (PercussTargets.cmake).
