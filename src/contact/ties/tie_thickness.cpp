#include "src/contact/ties/tie_thickness.hpp"

#include <algorithm>
#include <cstdint>

#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Message of a rank on a node to its owner, and the owner's answer.
struct NodeValue {
  std::int64_t node = -1;
  int asker = 0;
  double value = 0;
};

std::size_t find_place(const std::vector<int>& nodes, int node) {
  return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

/// Gives each asker the most that any of them knows.
void share_most(std::vector<NodeValue>& received) {
  std::sort(received.begin(), received.end(), [](const NodeValue& a, const NodeValue& b) {
    return a.node != b.node ? a.node < b.node : a.asker < b.asker;
  });
  for (auto first = received.begin(); first != received.end();) {
    const auto last = std::find_if(first, received.end(), [&](const NodeValue& t) { return t.node != first->node; });
    double most = 0;
    for (auto t = first; t != last; ++t) most = std::max(most, t->value);
    for (; first != last; ++first) first->value = most;
  }
}

/// Gives each node, ascending, the largest value that any rank has for it. Collective.
void share_largest(const ChunkedMesh& chunked, const std::vector<int>& nodes, ItemExchange& exchange,
                   std::vector<double>& values) {
  const Mesh& mesh = chunked.mesh;
  std::vector<int> owners, askers;
  std::vector<NodeValue> known;
  for (std::size_t i = 0; i < values.size(); ++i) {
    known.push_back({mesh.node_numbers[at(nodes[i])], exchange.ranks().rank(), values[i]});
    owners.push_back(chunked.numbering.find_node_owner(known.back().node));
  }
  std::vector<NodeValue> received = exchange.send(owners, known);
  share_most(received);
  for (const NodeValue& t : received) askers.push_back(t.asker);
  for (const NodeValue& t : exchange.send(askers, received)) {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), t.node,
                                        [&](int n, std::int64_t number) { return mesh.node_numbers[at(n)] < number; });
    values[static_cast<std::size_t>(place - nodes.begin())] = t.value;
  }
}

}  // namespace

double find_half_thickness(const Mesh& mesh, const ElementFace& face) {
  return 0.5 * mesh.thickness_of(at(face.element));
}

double find_largest_half_thickness(const Mesh& mesh) {
  double largest = 0;
  for (const ElementBlock& block : mesh.elements.blocks) largest = std::max(largest, 0.5 * block.section.thickness);
  return largest;
}

std::vector<double> find_node_thickness(const ChunkedMesh& chunked, const SurfaceNodes& side, ItemExchange& exchange) {
  const Mesh& mesh = chunked.mesh;
  if (!(find_largest_half_thickness(mesh) > 0)) return {};
  std::vector<double> half(side.nodes.size(), 0);
  for (const ElementFace& face : side.faces) {
    for (const int node : mesh.elements.face_nodes(face)) {
      const std::size_t place = find_place(side.nodes, node);
      if (place < side.nodes.size() && side.nodes[place] == node)
        half[place] = std::max(half[place], find_half_thickness(mesh, face));
    }
  }
  share_largest(chunked, side.nodes, exchange, half);
  return half;
}

void leave_out_what_lies_behind(const ChunkedMesh& chunked, const TieSearch& search, std::vector<ClosestFace>& answers,
                                ItemExchange& exchange) {
  constexpr double steep = 0.7;  // sine of the angle at which an edge leads away from the surface
  const Mesh& mesh = chunked.mesh;
  const std::vector<int>& nodes = search.nodes;
  if (!(find_largest_half_thickness(mesh) > 0)) return;
  std::vector<int> places(mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) places[at(nodes[i])] = static_cast<int>(i);
  std::vector<double> behind(nodes.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (const int n : mesh.corners(e)) {
      for (const int m : mesh.corners(e)) {
        if (n == m || places[at(n)] < 0 || places[at(m)] < 0) continue;
        const double farther = answers[at(places[at(n)])].distance - answers[at(places[at(m)])].distance;
        if (farther > steep * find_distance(search.places[at(n)], search.places[at(m)])) behind[at(places[at(n)])] = 1;
      }
    }
  }
  share_largest(chunked, nodes, exchange, behind);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ClosestFace& answer = answers[i];
    if (answer.found.face < 0 || !(behind[i] > 0)) continue;
    if (answer.distance > search.distance.value_or(default_tie_distance * answer.found.geometry.size))
      answer.found.face = -1;
  }
}

std::vector<ElementFace> add_other_sides(const Mesh& mesh, std::vector<ElementFace> faces) {
  const std::size_t count = faces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ElementFace face = faces[i];
    if (mesh.topology_of(at(face.element)).is_surface())
      faces.push_back({face.element, face.face == top_face ? bottom_face : top_face});
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace percuss
