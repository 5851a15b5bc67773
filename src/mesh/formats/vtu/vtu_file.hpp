#pragma once
// Meshes of VTK unstructured grids in XML (VTK file formats, "XML file formats"): points and cells. Cells of one number
// in an array of blocks are a block.

#include <memory>
#include <string>
#include <string_view>

#include "src/mesh/files/file_results.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or of a form that is not read; SystemError if it
/// cannot be read.
std::unique_ptr<MeshFile> open_vtu_file(const std::string& path);

/// Its arrays of cells and points. Throws likewise.
FileResults read_vtu_results(const std::string& path, const ResultsWish& wish);

/// Whether the first bytes of a file are those of an XML file of VTK.
bool is_vtu_file(std::string_view first_bytes);

}  // namespace percuss
