#pragma once
// Looks at the container of an Exodus II file (netCDF or HDF5) before any library does. The libraries read zeros past
// the end of a truncated classic file, print by themselves, and believe every count.

#include <cstdint>
#include <filesystem>

namespace percuss {

/// Format of the file by its first bytes.
struct ExodusContainer {
  bool is_hdf5 = false;
  std::uintmax_t bytes = 0;         // length of the file
  std::uintmax_t most_payload = 0;  // upper bound of the data that can be in it [bytes], compression included
  double records_end = 0;           // first byte behind the records that a classic header promises
};

/// Throws InputError if the file does not exist, is not a regular file, is neither netCDF nor HDF5, or is shorter than
/// its header promises (records of results left aside); SystemError if it cannot be read.
ExodusContainer inspect_exodus_container(const std::filesystem::path& file);

}  // namespace percuss
