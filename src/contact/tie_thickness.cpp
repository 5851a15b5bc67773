#include "src/contact/tie_thickness.hpp"

#include <algorithm>
#include <cstdint>

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// What a rank knows of a node, for its owner, and the owner's answer.
struct NodeThickness {
  std::int64_t node = -1;
  int asker = 0;
  double half = 0;  // of the thickest shell [length]
};

std::size_t find_place(const std::vector<int>& nodes, int node) {
  return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

/// Gives each asker the most that any of them knows.
void share_most(std::vector<NodeThickness>& told) {
  std::sort(told.begin(), told.end(), [](const NodeThickness& a, const NodeThickness& b) {
    return a.node != b.node ? a.node < b.node : a.asker < b.asker;
  });
  for (auto first = told.begin(); first != told.end();) {
    const auto last = std::find_if(first, told.end(), [&](const NodeThickness& t) { return t.node != first->node; });
    double most = 0;
    for (auto t = first; t != last; ++t) most = std::max(most, t->half);
    for (; first != last; ++first) first->half = most;
  }
}

}  // namespace

double find_half_thickness(const Mesh& mesh, const ElementFace& face) {
  if (!is_shell(mesh.elements[at(face.element)])) return 0;
  return 0.5 * mesh.parts[at(mesh.element_part[at(face.element)])].thickness;
}

double find_largest_half_thickness(const Mesh& mesh) {
  double largest = 0;
  for (const MeshPart& part : mesh.parts) largest = std::max(largest, 0.5 * part.thickness);
  return largest;
}

std::vector<double> find_node_thickness(const ChunkedMesh& chunked, const SurfaceNodes& side, ItemExchange& exchange) {
  const Mesh& mesh = chunked.mesh;
  if (!(find_largest_half_thickness(mesh) > 0)) return {};
  std::vector<double> half(side.nodes.size(), 0);
  for (const ElementFace& face : side.faces) {
    for (const int corner : hex_faces[face.face]) {
      const int node = mesh.elements[at(face.element)][at(corner)];
      const std::size_t place = find_place(side.nodes, node);
      if (place < side.nodes.size() && side.nodes[place] == node)
        half[place] = std::max(half[place], find_half_thickness(mesh, face));
    }
  }
  std::vector<int> owners, askers;
  std::vector<NodeThickness> known;
  for (std::size_t i = 0; i < half.size(); ++i) {
    known.push_back({mesh.node_numbers[at(side.nodes[i])], exchange.ranks().rank(), half[i]});
    owners.push_back(chunked.numbering.find_node_owner(known.back().node));
  }
  std::vector<NodeThickness> told = exchange.send(owners, known);
  share_most(told);
  for (const NodeThickness& t : told) askers.push_back(t.asker);
  for (const NodeThickness& t : exchange.send(askers, told)) {
    const auto place = std::lower_bound(side.nodes.begin(), side.nodes.end(), t.node,
                                        [&](int n, std::int64_t number) { return mesh.node_numbers[at(n)] < number; });
    half[static_cast<std::size_t>(place - side.nodes.begin())] = t.half;
  }
  return half;
}

std::vector<ElementFace> add_other_sides(const Mesh& mesh, std::vector<ElementFace> faces) {
  const std::size_t count = faces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ElementFace face = faces[i];
    if (is_shell(mesh.elements[at(face.element)]))
      faces.push_back({face.element, face.face == shell_top ? shell_bottom : shell_top});
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace percuss
