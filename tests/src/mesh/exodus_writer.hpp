#pragma once
// Writes small Exodus II files, good or bad, in every container.

#include <cstdint>
#include <string>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss::testing_mesh {

enum class Container { classic, offset64, netcdf4, netcdf4_int64 };

struct WrittenBlock {
  std::int64_t id = 1;
  std::string name;
  std::string topology = "HEX8";
  int nodes_per_element = 8;
  std::vector<std::int64_t> corners;  // 1-based
  std::vector<double> attribute{};    // of each element; empty: none
};

struct WrittenSet {
  std::int64_t id = 1;
  std::string name;
  std::vector<std::int64_t> entries;  // nodes or elements, 1-based
  std::vector<std::int64_t> sides;    // of a side set
};

struct WrittenMesh {
  int dimensions = 3;
  std::vector<Vec3> nodes;
  std::vector<WrittenBlock> blocks;
  std::vector<WrittenSet> node_sets, side_sets;
  std::vector<std::int64_t> node_ids, element_ids;  // empty: no map
  bool single_precision = false;
};

/// Two unit cubes in a row along x: 12 nodes, block 10 ("left") and block 20 (no name), element ids 101 and 102, node
/// ids 1001 to 1012, node set 5 ("corner": the first node), side set 6 (no name: x = 0 and x = 2).
WrittenMesh make_two_cubes();

/// Writes the mesh and returns the path, in the tests' temporary folder.
std::string write_exodus(const WrittenMesh& mesh, const std::string& name, Container container = Container::classic);

/// Writes bytes as they are, likewise.
std::string write_bytes(const std::string& bytes, const std::string& name);
std::string read_bytes(const std::string& path);

/// A classic file whose attribute `int64_status` has 255 values, which libraries read into room for one.
std::string lengthen_status(std::string bytes);

}  // namespace percuss::testing_mesh
