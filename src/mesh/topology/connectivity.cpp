#include "src/mesh/topology/connectivity.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "kernels/core/counting_sort.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Faces of all solids by their lowest node: the same face of two elements meets in one bucket.
using FacesByLowestNode = BucketsOf<ElementFace, std::int64_t>;

FacesByLowestNode bin_faces(const Elements& elements, std::size_t node_count) {
  return collect_buckets<ElementFace, std::int64_t>(node_count, [&](auto&& put) {
    for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
      const Topology& topology = elements.topology_of(at(e));
      if (!topology.is_solid()) continue;
      for (int f = 0; f < topology.face_count; ++f) {
        const std::array<int, 4> nodes = elements.face_nodes({e, f});
        put(at(std::min({nodes[0], nodes[1], nodes[2], nodes[3]})), ElementFace{e, f});
      }
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

void mark(std::uint8_t& mask, int face) { mask = static_cast<std::uint8_t>(mask | (1U << face)); }

}  // namespace

std::vector<std::uint8_t> mark_exterior_faces(const Elements& elements, std::size_t node_count) {
  const FacesByLowestNode bins = bin_faces(elements, node_count);
  using Key = std::pair<std::array<int, 4>, ElementFace>;
  std::vector<Key> keys;
  std::vector<std::uint8_t> exterior(elements.size(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Topology& topology = elements.topology_of(e);
    for (int f = 0; topology.is_surface() && f < topology.face_count; ++f) mark(exterior[e], f);
  }
  for (std::size_t n = 0; n < node_count; ++n) {
    keys.clear();
    for (std::int64_t i = bins.first[n]; i < bins.first[n + 1]; ++i) {
      const ElementFace& face = bins.items[static_cast<std::size_t>(i)];
      keys.emplace_back(elements.face_key(face), face);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const bool as_before = i > 0 && keys[i].first == keys[i - 1].first;
      const bool as_after = i + 1 < keys.size() && keys[i].first == keys[i + 1].first;
      if (!as_before && !as_after) mark(exterior[at(keys[i].second.element)], keys[i].second.face);
    }
  }
  return exterior;
}

std::vector<int> find_bodies(const Elements& elements, std::size_t node_count) {
  std::vector<int> parent(node_count);  // a forest over nodes; a root is the lowest node of its tree
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    int root = find_root(parent, elements.corners(e)[0]);
    for (const int node : elements.corners(e)) {
      const int other = find_root(parent, node), low = std::min(root, other);
      parent[at(std::max(root, other))] = low;
      root = low;
    }
  }
  std::vector<int> root_to_body(node_count, -1), bodies(elements.size());
  int count = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    int& body = root_to_body[at(find_root(parent, elements.corners(e)[0]))];
    if (body < 0) body = count++;
    bodies[e] = body;
  }
  return bodies;
}

}  // namespace percuss
