#pragma once
// Files that show whether they are complete: a seal at the end holds the length of the data before it and a hash of
// them.
//
// A truncated file, or one with a changed byte, is detected before it is interpreted. HDF5 ignores bytes after its own
// data.

#include <string>

#include "comm/communicator.hpp"

namespace percuss {

/// Appends the seal and waits until the disk has all. The ranks share the reading. Collective. Throws SystemError, on
/// all ranks.
void seal_file(const Communicator& ranks, const std::string& path);

/// Throws InputError if the file has no seal or does not match it, SystemError if it cannot be read; both on all ranks.
/// Collective.
void check_seal(const Communicator& ranks, const std::string& path);

/// Checks a seal by this process alone, also without MPI.
void check_seal(const std::string& path);

/// Whether there is a file whose seal fits; false for what cannot be read. By this process alone.
bool is_sealed(const std::string& path);

}  // namespace percuss
