#pragma once
// What an Exodus II mesh holds, in words.

#include <string>

namespace percuss {

/// Several lines: counts, extent, blocks, node sets and side sets by the names that a deck uses, whatever the kind of
/// the elements; then what percuss reads of it. That is checked as for a run: throws InputError that names the wrong
/// element, SystemError if the file cannot be read.
std::string describe_mesh_file(const std::string& file);

/// Whether the bytes or the name of a file are those of a mesh format.
bool is_mesh_file(const std::string& file);

}  // namespace percuss
