#pragma once
// Files that a deck or a command names may come from elsewhere: an HDF5 file among them takes nothing from other files
// of this machine unless the user allows it.

#include <string>

#include "src/deck/deck.hpp"

namespace percuss {

/// Throws InputError, with its place in the deck, if a mesh file of the deck takes data from another file. What is no
/// HDF5 file is left to whoever reads it.
void refuse_external_meshes(const Deck& deck);

/// Throws InputError, with the name of the file, if a checkpoint does.
void refuse_external_checkpoint(const std::string& path);

/// Throws InputError if a file to continue from is of another kind, such as a summary.
void refuse_other_file(const std::string& path);

/// Throws InputError, with the name of the file, if a run that continues in `folder` from `checkpoint` cannot trust
/// what it opens there: files that are no regular ones, and, unless allowed, HDF5 files that lead to others. Writes
/// would follow such links.
void check_results_to_go_on_with(const std::string& folder, const std::string& checkpoint, bool allow_external);

}  // namespace percuss
