// Only in executables with the address sanitizer: plugins of MPI stay loaded until the process ends, so that the report
// of leaks can tell whose memory it was (cmake/lsan_suppressions.txt).
extern "C" __attribute__((visibility("default"))) int dlclose(void*) { return 0; }
