#include "tests/verification/mapped_shell.hpp"

namespace percuss::test {

using testing_mesh::WrittenBlock;
using testing_mesh::WrittenMesh;
using testing_mesh::WrittenSet;

WrittenMesh make_mapped_shell(const std::array<int, 2>& cells, const std::function<Vec3(double, double)>& place) {
  WrittenMesh mesh;
  for (int j = 0; j <= cells[1]; ++j) {
    for (int i = 0; i <= cells[0]; ++i) mesh.nodes.push_back(place(double(i) / cells[0], double(j) / cells[1]));
  }
  WrittenBlock block{1, "surface", "SHELL4", 4, {}};
  const int row = cells[0] + 1;
  for (int j = 0; j < cells[1]; ++j) {
    for (int i = 0; i < cells[0]; ++i) {
      const std::int64_t low = 1 + i + std::int64_t{row} * j;
      block.corners.insert(block.corners.end(), {low, low + 1, low + 1 + row, low + row});
    }
  }
  mesh.blocks.push_back(block);
  return mesh;
}

void add_edge_sets(const std::array<int, 2>& cells, WrittenMesh& mesh) {
  const int row = cells[0] + 1;
  const auto add = [&](std::int64_t id, const char* name, int count, int first, int stride) {
    WrittenSet set;
    set.id = id;
    set.name = name;
    for (int k = 0; k < count; ++k) set.entries.push_back(1 + first + k * stride);
    mesh.node_sets.push_back(set);
  };
  add(1, "u_min", cells[1] + 1, 0, row);
  add(2, "u_max", cells[1] + 1, cells[0], row);
  add(3, "v_min", row, 0, 1);
  add(4, "v_max", row, row * cells[1], 1);
}

}  // namespace percuss::test
