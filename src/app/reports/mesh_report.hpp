#pragma once
// What an Exodus II mesh holds, in words.

#include <string>

namespace percuss {

/// Several lines: counts, extent, blocks, node sets and side sets by the names that a deck uses, whatever the kind of
/// the elements; then what percuss reads of it. That is checked as for a run: throws InputError that names the wrong
/// element, SystemError if the file cannot be read.
std::string describe_exodus_mesh(const std::string& file);

}  // namespace percuss
