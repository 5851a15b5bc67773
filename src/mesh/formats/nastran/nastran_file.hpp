#pragma once
// Meshes of Nastran bulk data: grid points, solids, shells, bars, properties, sets, coordinate systems and included
// files (MSC and NX Nastran Quick Reference Guides, "Bulk Data Entries"; OptiStruct's SET).
//
// A property is a block. Other entries are left to the deck of percuss; a note names them.

#include <memory>
#include <string>
#include <string_view>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or has what changes the mesh and is not read;
/// SystemError if it cannot be read.
std::unique_ptr<MeshFile> open_nastran_file(const std::string& path);

/// Whether the first bytes of a file are those of bulk data, or of what may stand before it.
bool is_nastran_file(std::string_view first_bytes);

}  // namespace percuss
