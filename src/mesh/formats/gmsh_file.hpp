#pragma once
// Meshes of Gmsh: MSH 2.2 and 4.1, ASCII and binary (Gmsh reference manual, "MSH file format").
//
// Groups of volumes are blocks. A group of surfaces is a side set if it lies on faces of volumes, else a block of
// shells. Groups of curves and of points are node sets.

#include <memory>
#include <string>

#include "src/mesh/files/text_mesh.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or of another version; SystemError if it cannot be
/// read.
std::unique_ptr<MeshFile> open_gmsh_file(const std::string& path);

}  // namespace percuss
