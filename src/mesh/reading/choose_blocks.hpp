#pragma once
// Blocks and elements of a mesh file that a part takes.

#include <string>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"

namespace percuss {

/// Blocks of a file that a part takes.
struct Choice {
  std::vector<FileBlock> blocks;  // that have elements of it
  std::vector<char> elements;     // [elements of the file] whether it is taken; empty: all of the blocks
};

/// wanted: names of blocks, `block_7` by their ids, or of element sets; empty: all blocks. Throws InputError for a name
/// that the file lacks.
Choice choose_blocks(const MeshFile& file, const std::vector<std::string>& wanted);

/// Throws InputError if a chosen block has elements of a kind that cannot be run; it names the blocks that can.
void check_kinds(const MeshFile& file, const std::vector<FileBlock>& chosen);

}  // namespace percuss
