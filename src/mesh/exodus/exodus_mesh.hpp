#pragma once
// Reads a part from an Exodus II file: classic netCDF, 64-bit offset, 64-bit data or netCDF-4; 32- or 64-bit integers.

#include <string>
#include <vector>

#include "src/mesh/exodus/exodus_file.hpp"
#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// What a file holds, whether it can be run or not.
struct ExodusContents {
  int dimensions = 0;
  std::int64_t elements = 0;
  std::vector<ExodusBlock> blocks;
  std::vector<ExodusSet> node_sets, side_sets;
  std::vector<Vec3> nodes;  // of all blocks and of none [length]
};

/// Reads the lists of a file, not its elements. Throws InputError if it is damaged or none of Exodus II, SystemError if
/// it cannot be opened or read; neither names the file.
ExodusContents read_exodus_contents(const std::string& path);

/// Whether the elements of a block are of a kind that can be run.
bool can_run(const ExodusBlock& block);

/// All these kinds: "HEX8, SHELL4, ...".
std::string list_kinds();

/// The chosen blocks (all if none is named) with their node sets, side sets and ids. Nodes that the blocks do not use
/// are dropped, sets are cut to what is left. Throws InputError if the file does not hold a mesh that can be run
/// (every problem found, elements by their ids), SystemError if it cannot be opened or read; neither names the file. A
/// netCDF-4 file is read once before in a process of its own, because the HDF5 library crashes on some damaged files.
PartMesh read_exodus_mesh(const ExodusMesh& source);

}  // namespace percuss
