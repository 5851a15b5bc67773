#pragma once
// Meshes of Abaqus input files: nodes, elements, sets, surfaces, parts and their instances (Abaqus Keywords Reference
// Guide; Element Library for the numbers of faces).
//
// Elements of one ELSET of *ELEMENT are a block. Other keywords are left to the deck of percuss; a note names them.

#include <memory>
#include <string>
#include <string_view>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or has what changes the mesh and is not read;
/// SystemError if it cannot be read.
std::unique_ptr<MeshFile> open_abaqus_file(const std::string& path);

/// Whether the first bytes of a file are those of an Abaqus input file.
bool is_abaqus_file(std::string_view first_bytes);

}  // namespace percuss
