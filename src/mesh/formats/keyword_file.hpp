#pragma once
// Meshes of LS-DYNA keyword decks: nodes, solids, shells, parts, sets and included files (LS-DYNA Keyword User's
// Manual, volume I, "Getting started", *NODE, *ELEMENT, *PART, *SET, *INCLUDE). Fields in columns, also long ones, or
// with commas.
//
// A part is a block. Other keywords are left to the deck of percuss; a note names them.

#include <memory>
#include <string>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or has what changes the mesh and is not read;
/// SystemError if it cannot be read.
std::unique_ptr<MeshFile> open_keyword_file(const std::string& path);

/// Whether the first bytes of a file are those of a keyword deck.
bool is_keyword_file(std::string_view first_bytes);

}  // namespace percuss
