#pragma once
// Gives tetrahedra of a mesh to be written the middles of their edges as nodes.

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "src/mesh/topology/tet4.hpp"
#include "tests/src/mesh/exodus_writer.hpp"

namespace percuss::testing_mesh {

/// Blocks TET4 become TETRA10. The middle of an edge belongs to each node set that has both of its ends.
inline void raise_to_ten_nodes(WrittenMesh& mesh) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
  const auto find_middle = [&](std::int64_t a, std::int64_t b) {
    const auto [middle, is_new] = middles.emplace(std::minmax(a, b), static_cast<std::int64_t>(mesh.nodes.size()) + 1);
    if (is_new) {
      const Vec3 &x = mesh.nodes[static_cast<std::size_t>(a - 1)], &y = mesh.nodes[static_cast<std::size_t>(b - 1)];
      mesh.nodes.push_back({0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])});
    }
    return middle->second;
  };
  for (WrittenBlock& block : mesh.blocks) {
    std::vector<std::int64_t> ten;
    for (std::size_t e = 0; e + 4 <= block.corners.size(); e += 4) {
      const std::int64_t* corners = &block.corners[e];
      ten.insert(ten.end(), corners, corners + 4);
      for (const auto& [a, b] : tet4_topology.edges()) ten.push_back(find_middle(corners[a], corners[b]));
    }
    block.topology = "TETRA10";
    block.nodes_per_element = 10;
    block.corners = std::move(ten);
  }
  for (WrittenSet& set : mesh.node_sets) {
    const std::vector<std::int64_t> ends = set.entries;
    const auto has = [&](std::int64_t node) { return std::find(ends.begin(), ends.end(), node) != ends.end(); };
    for (const auto& [edge, middle] : middles)
      if (has(edge.first) && has(edge.second)) set.entries.push_back(middle);
  }
}

}  // namespace percuss::testing_mesh
