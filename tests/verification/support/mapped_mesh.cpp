#include "tests/verification/support/mapped_mesh.hpp"

#include <algorithm>
#include <array>

#include "src/mesh/topology/topologies.hpp"

namespace percuss::test {

using testing_mesh::WrittenBlock;
using testing_mesh::WrittenMesh;
using testing_mesh::WrittenSet;

namespace {

/// Adds the elements of a lattice whose sections are quadrilaterals, `count` nodes each.
void extrude(const std::vector<std::array<int, 4>>& quads, int count, int along, WrittenMesh& mesh) {
  WrittenBlock block;
  block.name = "body";
  for (int layer = 0; layer < along; ++layer) {
    for (const std::array<int, 4>& quad : quads) {
      for (const int section : {layer, layer + 1}) {
        for (const int node : quad) block.corners.push_back(1 + node + std::int64_t{count} * section);
      }
    }
  }
  mesh.blocks.push_back(block);
}

}  // namespace

WrittenMesh make_mapped_box(const std::array<int, 3>& cells, const std::function<Vec3(const Vec3&)>& place) {
  WrittenMesh mesh;
  for (int k = 0; k <= cells[2]; ++k) {
    for (int j = 0; j <= cells[1]; ++j) {
      for (int i = 0; i <= cells[0]; ++i) {
        mesh.nodes.push_back(place({double(i) / cells[0], double(j) / cells[1], double(k) / cells[2]}));
      }
    }
  }
  const int row = cells[0] + 1;
  std::vector<std::array<int, 4>> quads;
  for (int j = 0; j < cells[1]; ++j) {
    for (int i = 0; i < cells[0]; ++i) {
      const int low = i + row * j;
      quads.push_back({low, low + 1, low + 1 + row, low + row});
    }
  }
  extrude(quads, row * (cells[1] + 1), cells[2], mesh);
  return mesh;
}

void add_node_set(WrittenMesh& mesh, int id, const char* name, const std::function<bool(const Vec3&)>& holds) {
  WrittenSet set;
  set.id = id;
  set.name = name;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (holds(mesh.nodes[n])) set.entries.push_back(static_cast<std::int64_t>(n + 1));
  }
  mesh.node_sets.push_back(set);
}

void cut_into_wedges(WrittenMesh& mesh) {
  static constexpr std::size_t of_wedges[] = {0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7};
  for (WrittenBlock& block : mesh.blocks) {
    std::vector<std::int64_t> corners;
    for (std::size_t e = 0; e < block.corners.size(); e += 8) {
      for (const std::size_t corner : of_wedges) corners.push_back(block.corners[e + corner]);
    }
    block.topology = "WEDGE6";
    block.nodes_per_element = 6;
    block.corners = corners;
  }
}

void cut_into_tetrahedra(WrittenMesh& mesh) {
  for (WrittenBlock& block : mesh.blocks) {
    std::vector<std::int64_t> cut;
    for (std::size_t first = 0; first < block.corners.size(); first += 8) {
      const auto corner = [&](int i) { return block.corners[first + static_cast<std::size_t>(i)]; };
      Vec3 middle{};
      for (int i = 0; i < 8; ++i) {
        const Vec3& x = mesh.nodes[static_cast<std::size_t>(corner(i) - 1)];
        for (std::size_t k = 0; k < 3; ++k) middle[k] += x[k] / 8;
      }
      mesh.nodes.push_back(middle);
      const auto apex = static_cast<std::int64_t>(mesh.nodes.size());
      for (const FaceCorners& face : hex8_topology.faces()) {
        std::array<std::int64_t, 4> nodes{};
        for (std::size_t i = 0; i < 4; ++i) nodes[i] = corner(face.four[i]);
        std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
        cut.insert(cut.end(), {nodes[0], nodes[2], nodes[1], apex, nodes[0], nodes[3], nodes[2], apex});
      }
    }
    block.corners = cut;
    block.nodes_per_element = 4;
    block.topology = "TETRA";
  }
}

WrittenMesh make_quarter_cylinder(double radius, double length, int n, int along) {
  return make_quarter_cylinder(radius, length, n, along, choose_core_form<2>(split_round(4 * n)));
}

WrittenMesh make_quarter_cylinder(double radius, double length, int n, int along, CoreForm form) {
  const RoundedLattice<2> lattice(radius, split_round(4 * n), form);
  // The core's quarter, row by row; then rings of 2 n + 1 nodes from the x axis to the y axis.
  const int core_nodes = (n + 1) * (n + 1), around = 2 * n + 1, count = core_nodes + n * around;
  const auto rim = [n](int s) {
    return s <= n ? std::array<int, 2>{2 * n, n + s} : std::array<int, 2>{3 * n - s, 2 * n};
  };
  std::vector<std::array<double, 2>> section;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) section.push_back(lattice({n + i, n + j}, 0));
  }
  for (int ring = 1; ring <= n; ++ring) {
    for (int s = 0; s < around; ++s) section.push_back(lattice(rim(s), ring));
  }
  const auto ring_node = [&](int ring, int s) {
    if (ring > 0) return core_nodes + (ring - 1) * around + s;
    const std::array<int, 2> at = rim(s);
    return at[0] - n + (n + 1) * (at[1] - n);
  };
  std::vector<std::array<int, 4>> quads;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int low = i + (n + 1) * j;
      quads.push_back({low, low + 1, low + n + 2, low + n + 1});
    }
  }
  for (int ring = 0; ring < n; ++ring) {
    for (int s = 0; s < 2 * n; ++s) {
      quads.push_back({ring_node(ring, s), ring_node(ring + 1, s), ring_node(ring + 1, s + 1), ring_node(ring, s + 1)});
    }
  }
  WrittenMesh mesh;
  for (int layer = 0; layer <= along; ++layer) {
    for (const auto& p : section) mesh.nodes.push_back({p[0], p[1], length * layer / along});
  }
  extrude(quads, count, along, mesh);
  const double tiny = 1e-9 * radius;
  add_node_set(mesh, 1, "foot", [&](const Vec3& p) { return p[2] < tiny; });
  add_node_set(mesh, 2, "x_plane", [&](const Vec3& p) { return p[0] < tiny; });
  add_node_set(mesh, 3, "y_plane", [&](const Vec3& p) { return p[1] < tiny; });
  return mesh;
}

}  // namespace percuss::test
