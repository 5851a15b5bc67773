#include "src/mesh/topology/collapsed_hexahedron.hpp"

#include <algorithm>
#include <cstddef>

namespace percuss {
namespace {

using Nodes = std::vector<std::int64_t>;

bool has(const Nodes& nodes, std::int64_t node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); }

Nodes list_once(std::span<const std::int64_t> nodes) {
  Nodes once;
  for (const std::int64_t node : nodes) {
    if (!has(once, node)) once.push_back(node);
  }
  return once;
}

/// Faces of three and of four different nodes, outward; what is left of others has no area.
struct FacesLeft {
  std::vector<Nodes> triangles, quadrilaterals;
  bool is_sound = true;  // no face has a node twice but in a row
};

FacesLeft list_faces(std::span<const std::int64_t> nodes) {
  FacesLeft faces;
  for (const FaceCorners& face : hex8_topology.faces()) {
    Nodes cycle;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int64_t node = nodes[static_cast<std::size_t>(face.four[i])];
      if (node != nodes[static_cast<std::size_t>(face.four[(i + 3) % 4])]) cycle.push_back(node);
    }
    if (list_once(cycle).size() < std::min<std::size_t>(cycle.size(), 3)) continue;
    if (list_once(cycle).size() < cycle.size()) faces.is_sound = false;
    if (cycle.size() == 3) faces.triangles.push_back(cycle);
    if (cycle.size() == 4) faces.quadrilaterals.push_back(cycle);
  }
  return faces;
}

/// The node of `others` at the other end of an edge; 0: there is none.
std::int64_t find_across(std::span<const std::int64_t> nodes, std::int64_t node, const Nodes& others) {
  for (const auto& [a, b] : hex8_topology.edges()) {
    const std::int64_t first = nodes[static_cast<std::size_t>(a)], second = nodes[static_cast<std::size_t>(b)];
    if (first == node && has(others, second)) return second;
    if (second == node && has(others, first)) return first;
  }
  return 0;
}

std::int64_t find_rest(const Nodes& all, const Nodes& without) {
  return *std::find_if(all.begin(), all.end(), [&](std::int64_t node) { return !has(without, node); });
}

}  // namespace

std::optional<SolidOfNodes> collapse_hexahedron(std::span<const std::int64_t> nodes) {
  if (nodes.size() != 8) return {};
  const Nodes all = list_once(nodes);
  const FacesLeft faces = list_faces(nodes);
  const std::size_t triangles = faces.triangles.size(), quadrilaterals = faces.quadrilaterals.size();
  if (!faces.is_sound) return {};
  if (all.size() == 6 && triangles == 2 && quadrilaterals == 3) {
    const Nodes &low = faces.triangles[0], &top = faces.triangles[1];  // low: 0 2 1 of the wedge
    return SolidOfNodes{TopologyKind::wedge6,
                        {low[0], low[2], low[1], find_across(nodes, low[0], top), find_across(nodes, low[2], top),
                         find_across(nodes, low[1], top)}};
  }
  if (all.size() == 5 && triangles == 4 && quadrilaterals == 1) {
    const Nodes& base = faces.quadrilaterals[0];  // 0 3 2 1 of the pyramid
    return SolidOfNodes{TopologyKind::pyramid5, {base[0], base[3], base[2], base[1], find_rest(all, base)}};
  }
  if (all.size() == 4 && triangles >= 2) {
    const Nodes& base = faces.triangles[0];  // 0 2 1 of the tetrahedron
    return SolidOfNodes{TopologyKind::tet4, {base[0], base[2], base[1], find_rest(all, base)}};
  }
  return {};
}

}  // namespace percuss
