#include <cstddef>

#include "src/mesh/part_mesh.hpp"

namespace percuss {
namespace {

struct BoxGrid {
  std::array<int, 3> cells;

  int node(int i, int j, int k) const { return i + (cells[0] + 1) * (j + (cells[1] + 1) * k); }
  int element(int i, int j, int k) const { return i + cells[0] * (j + cells[1] * k); }
  std::array<int, 8> corners(int i, int j, int k) const {
    return {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
  }
};

/// Elements of the layer `index` along `axis`, each with the same face; ascending because the grid counts x first.
std::vector<ElementFace> list_layer_faces(const BoxGrid& grid, std::size_t axis, int index, int face) {
  std::array<int, 3> first{0, 0, 0}, last = grid.cells;
  first[axis] = index;
  last[axis] = index + 1;
  std::vector<ElementFace> faces;
  for (int k = first[2]; k < last[2]; ++k) {
    for (int j = first[1]; j < last[1]; ++j) {
      for (int i = first[0]; i < last[0]; ++i) faces.push_back({grid.element(i, j, k), face});
    }
  }
  return faces;
}

}  // namespace

PartMesh make_box(const BoxShape& shape) {
  const BoxGrid grid{shape.cells};
  const auto [nx, ny, nz] = shape.cells;
  // Dividing first makes the last coordinate the size itself.
  const auto place = [&](std::size_t axis, int index) {
    return shape.size[axis] * (double(index) / shape.cells[axis]);
  };
  const auto count = [](int x, int y, int z) {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(y) * static_cast<std::size_t>(z);
  };
  PartMesh mesh;
  mesh.nodes.reserve(count(nx + 1, ny + 1, nz + 1));
  mesh.elements.reserve(count(nx, ny, nz));
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) mesh.nodes.push_back({place(0, i), place(1, j), place(2, k)});
    }
  }
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) mesh.elements.push_back(grid.corners(i, j, k));
    }
  }
  mesh.side_sets["x_min"] = list_layer_faces(grid, 0, 0, 3);
  mesh.side_sets["x_max"] = list_layer_faces(grid, 0, nx - 1, 1);
  mesh.side_sets["y_min"] = list_layer_faces(grid, 1, 0, 0);
  mesh.side_sets["y_max"] = list_layer_faces(grid, 1, ny - 1, 2);
  mesh.side_sets["z_min"] = list_layer_faces(grid, 2, 0, 4);
  mesh.side_sets["z_max"] = list_layer_faces(grid, 2, nz - 1, 5);
  return mesh;
}

}  // namespace percuss
