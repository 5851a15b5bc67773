#pragma once
// Makes parts of mesh files of any format (src/mesh/files/mesh_file.hpp).

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/mesh/files/mesh_file.hpp"
#include "src/mesh/part_mesh.hpp"

namespace percuss {

/// Content of a file, whether it can be run or not.
struct MeshContents {
  std::string format;
  int dimensions = 0;
  std::int64_t elements = 0;
  std::vector<FileBlock> blocks;
  std::vector<FileSet> node_sets, side_sets, element_sets;
  std::string kinds;        // of elements that can be run
  std::vector<Vec3> nodes;  // of all blocks and of none [length]
};

/// Reads the lists of a file, not its elements. Throws InputError if it is damaged or of no known format, SystemError
/// if it cannot be opened or read; neither names the file.
MeshContents read_mesh_contents(const std::string& path);

/// Files that several parts may come from: each is opened once.
class MeshFiles {
 public:
  /// The chosen blocks (all if none is named) with their sets and ids. Nodes that the blocks do not use are dropped,
  /// sets are cut to what is left. Throws InputError if the file does not hold a mesh that can be run (every problem
  /// found, elements by their ids), SystemError if it cannot be opened or read; neither names the file. A file of a
  /// format that libraries read is read once before in a process of its own, because they crash on some damaged files.
  PartMesh read(const FileMesh& source);

 private:
  std::map<std::string, std::unique_ptr<MeshFile>> files_;  // by path
};

/// MeshFiles::read() of one part alone.
PartMesh read_part_mesh(const FileMesh& source);

}  // namespace percuss
