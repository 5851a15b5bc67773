#pragma once
// Reads a part from an Exodus II file: classic netCDF, 64-bit offset, 64-bit data or netCDF-4; 32- or 64-bit integers.

#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// The chosen blocks (all if none is named) with their node sets, side sets and ids. Nodes that the blocks do not use
/// are dropped, sets are cut to what is left. Throws InputError if the file does not hold a mesh that can be run
/// (every problem found, elements by their ids), SystemError if it cannot be opened or read; neither names the file. A
/// netCDF-4 file is read once before in a process of its own, because the HDF5 library crashes on some damaged files.
PartMesh read_exodus_mesh(const ExodusMesh& source);

}  // namespace percuss
