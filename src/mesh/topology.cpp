// What the connectivity alone says: exterior faces and bodies.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "kernels/core/counting_sort.hpp"
#include "src/mesh/mesh.hpp"
#include "src/mesh/topology.hpp"

namespace percuss {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

using Elements = std::vector<std::array<int, 8>>;

std::array<int, 4> sort_face_nodes(const Elements& elements, const ElementFace& face) {
  const std::array<int, 8>& corners = elements[at(face.element)];
  const int* row = hex_faces[face.face];
  std::array<int, 4> nodes{corners[at(row[0])], corners[at(row[1])], corners[at(row[2])], corners[at(row[3])]};
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// All faces of all elements by their lowest node: the same face of two elements meets in one bucket.
using FacesByLowestNode = BucketsOf<ElementFace, std::int64_t>;

FacesByLowestNode bin_faces(const Elements& elements, std::size_t node_count) {
  const auto lowest = [&](const ElementFace& face) {
    const std::array<int, 8>& corners = elements[at(face.element)];
    const int* row = hex_faces[face.face];
    return at(std::min({corners[at(row[0])], corners[at(row[1])], corners[at(row[2])], corners[at(row[3])]}));
  };
  return collect_buckets<ElementFace, std::int64_t>(node_count, [&](auto&& put) {
    for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
      if (is_shell(elements[at(e)])) continue;
      for (int f = 0; f < 6; ++f) put(lowest({e, f}), ElementFace{e, f});
    }
  });
}

int find_root(std::vector<int>& parent, int node) {
  while (parent[at(node)] != node) {
    parent[at(node)] = parent[at(parent[at(node)])];
    node = parent[at(node)];
  }
  return node;
}

}  // namespace

std::vector<std::uint8_t> mark_exterior_faces(const Elements& elements, std::size_t node_count) {
  const FacesByLowestNode bins = bin_faces(elements, node_count);
  using Key = std::pair<std::array<int, 4>, ElementFace>;
  std::vector<Key> keys;
  std::vector<std::uint8_t> exterior(elements.size(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (is_shell(elements[e])) exterior[e] = 1U << shell_bottom | 1U << shell_top;
  }
  for (std::size_t n = 0; n < node_count; ++n) {
    keys.clear();
    for (std::int64_t i = bins.first[n]; i < bins.first[n + 1]; ++i) {
      const ElementFace& face = bins.items[static_cast<std::size_t>(i)];
      keys.emplace_back(sort_face_nodes(elements, face), face);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const bool as_before = i > 0 && keys[i].first == keys[i - 1].first;
      const bool as_after = i + 1 < keys.size() && keys[i].first == keys[i + 1].first;
      if (as_before || as_after) continue;
      std::uint8_t& mask = exterior[at(keys[i].second.element)];
      mask = static_cast<std::uint8_t>(mask | (1U << keys[i].second.face));
    }
  }
  return exterior;
}

std::vector<ElementFace> find_exterior_faces(const Mesh& mesh) {
  std::vector<ElementFace> faces;
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
    for (int f = 0; f < 6; ++f) {
      if ((mesh.exterior[at(e)] >> f & 1) != 0) faces.push_back({e, f});
    }
  }
  return faces;
}

std::vector<int> find_bodies(const Elements& elements, std::size_t node_count) {
  std::vector<int> parent(node_count);  // a forest over nodes; a root is the lowest node of its tree
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& element : elements) {
    int root = find_root(parent, element[0]);
    for (const int node : element) {
      const int other = find_root(parent, node), low = std::min(root, other);
      parent[at(std::max(root, other))] = low;
      root = low;
    }
  }
  std::vector<int> root_to_body(node_count, -1), bodies(elements.size());
  int count = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    int& body = root_to_body[at(find_root(parent, elements[e][0]))];
    if (body < 0) body = count++;
    bodies[e] = body;
  }
  return bodies;
}

}  // namespace percuss
