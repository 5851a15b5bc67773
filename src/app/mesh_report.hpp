#pragma once
// What an Exodus II mesh holds, in words.

#include <string>

namespace percuss {

/// Several lines: nodes, elements, extent and volume, node sets and side sets by the names that selectors use. The mesh
/// is checked as for a run: throws InputError that names the wrong element, SystemError if the file cannot be read.
std::string describe_exodus_mesh(const std::string& file);

}  // namespace percuss
