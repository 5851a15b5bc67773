#include <cstddef>

#include "src/mesh/part_mesh.hpp"
#include "src/mesh/rounded_lattice.hpp"

namespace percuss {
namespace {

/// Nodes and elements of the core cube, counted along x first.
struct CoreGrid {
  int cells;

  int node(int i, int j, int k) const { return i + (cells + 1) * (j + (cells + 1) * k); }
  std::array<int, 8> corners(int i, int j, int k) const {
    return {node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
  }
  bool on_boundary(int i, int j, int k) const {
    return i == 0 || j == 0 || k == 0 || i == cells || j == cells || k == cells;
  }
};

/// The core's boundary faces, outward by the right-hand rule, as core node indexes.
std::vector<std::array<int, 4>> list_boundary_faces(const CoreGrid& grid) {
  const int n = grid.cells;
  std::vector<std::array<int, 4>> faces;
  const auto add = [&](int i, int j, int k, int face) {
    const std::array<int, 8> corners = grid.corners(i, j, k);
    std::array<int, 4> nodes{};
    for (std::size_t c = 0; c < 4; ++c) nodes[c] = corners[static_cast<std::size_t>(hex_faces[face][c])];
    faces.push_back(nodes);
  };
  for (int b = 0; b < n; ++b) {
    for (int a = 0; a < n; ++a) {
      add(a, 0, b, 0);
      add(n - 1, a, b, 1);
      add(a, n - 1, b, 2);
      add(0, a, b, 3);
      add(a, b, 0, 4);
      add(a, b, n - 1, 5);
    }
  }
  return faces;
}

}  // namespace

PartMesh make_sphere(const SphereShape& shape) {
  const RoundSplit split = split_round(shape.across);
  const RoundedLattice<3> lattice(shape.radius, split);
  const CoreGrid grid{split.core};
  PartMesh mesh;
  std::vector<std::array<int, 3>> boundary;  // lattice points
  std::vector<int> boundary_place;           // by core node: index into boundary
  for (int k = 0; k <= grid.cells; ++k) {
    for (int j = 0; j <= grid.cells; ++j) {
      for (int i = 0; i <= grid.cells; ++i) {
        boundary_place.push_back(static_cast<int>(boundary.size()));
        if (grid.on_boundary(i, j, k)) boundary.push_back({i, j, k});
        mesh.nodes.push_back(lattice({i, j, k}, 0));
      }
    }
  }
  const int core_nodes = static_cast<int>(mesh.nodes.size()), shell_nodes = static_cast<int>(boundary.size());
  for (int shell = 1; shell <= split.rings; ++shell) {
    for (const auto& point : boundary) mesh.nodes.push_back(lattice(point, shell));
  }
  for (int k = 0; k < grid.cells; ++k) {
    for (int j = 0; j < grid.cells; ++j) {
      for (int i = 0; i < grid.cells; ++i) mesh.elements.push_back(grid.corners(i, j, k));
    }
  }
  const auto node = [&](int core_node, int shell) {
    if (shell == 0) return core_node;
    return core_nodes + (shell - 1) * shell_nodes + boundary_place[static_cast<std::size_t>(core_node)];
  };
  const std::vector<std::array<int, 4>> faces = list_boundary_faces(grid);
  auto& surface = mesh.side_sets["surface"];
  for (int shell = 0; shell < split.rings; ++shell) {
    for (const auto& [a, b, c, d] : faces) {
      if (shell == split.rings - 1) surface.push_back({static_cast<int>(mesh.elements.size()), 5});
      mesh.elements.push_back({node(a, shell), node(b, shell), node(c, shell), node(d, shell), node(a, shell + 1),
                               node(b, shell + 1), node(c, shell + 1), node(d, shell + 1)});
    }
  }
  return mesh;
}

}  // namespace percuss
