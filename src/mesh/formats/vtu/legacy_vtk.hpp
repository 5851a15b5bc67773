#pragma once
// Meshes of legacy VTK files (VTK file formats, "Simple Legacy Formats"): unstructured grids, as text or big-endian
// binary, versions 1 to 5.

#include <memory>
#include <string>
#include <string_view>

#include "src/mesh/files/file_results.hpp"

namespace percuss {

/// Throws InputError, with file and line, if the file is damaged or of a form that is not read; SystemError if it
/// cannot be read.
std::unique_ptr<MeshFile> open_legacy_vtk_file(const std::string& path);

/// Its arrays of cells and points. Throws likewise.
FileResults read_legacy_vtk_results(const std::string& path, const ResultsWish& wish);

/// Whether the first bytes of a file are those of a legacy VTK file.
bool is_legacy_vtk_file(std::string_view first_bytes);

}  // namespace percuss
