// A target under libFuzzer, which brings the main function.

#include <sanitizer/lsan_interface.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "comm/communicator.hpp"
#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  // MPI keeps what it allocates at its start, and libFuzzer ends by _Exit: neither is a leak of a reader.
  __lsan_disable();
  [[maybe_unused]] static const auto* const mpi = new percuss::MpiSession(*argc, *argv);
  __lsan_enable();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  percuss::fuzz::try_bytes(std::string(reinterpret_cast<const char*>(bytes), count));
  return 0;
}
