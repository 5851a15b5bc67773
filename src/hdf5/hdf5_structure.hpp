#pragma once
// Checks the links of an HDF5 file once, before any reader. Libraries follow a loop of links without end, and read
// other files of the disk through a link, a virtual dataset or external storage.

#include <cstdint>
#include <string>

namespace percuss::hdf5 {

/// Whether a file may take data from other files.
enum class ExternalFiles { refuse, allow };

/// Deeper than anybody nests groups, less than what takes the stack of a library that follows them.
inline constexpr int deepest_group = 100;

/// Looks at every object of a file. Throws InputError, without the name of the file, if a group can be reached in two
/// ways (a loop, or copies without end), if groups are nested absurdly deep, if there are more links than the file has
/// room for, if HDF5 cannot read its structure, or if it takes data from another file and may not. Damaged files can
/// crash HDF5: called in a trial process first (src/mesh/formats/exodus/trial_process.hpp).
void check_structure(const std::string& path, ExternalFiles external);

/// Whether HDF5 would take a file for one of its own, also behind a user block; false for what cannot be read.
bool has_hdf5_signature(const std::string& path);

}  // namespace percuss::hdf5
