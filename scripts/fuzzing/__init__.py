"""Random scenes of impact: made from a seed, run, measured apart from the program, and shrunk where they fail."""
