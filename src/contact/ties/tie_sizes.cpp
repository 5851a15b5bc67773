#include "src/contact/ties/tie_sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

struct NodeBox {
  Vec3 low, high;
};

/// [ties] boxes of the tied nodes, wider by the largest distance of one from its face. Collective.
std::vector<NodeBox> find_tied_boxes(const Mesh& mesh, const TiedSurfaces& ties, const Communicator& ranks) {
  constexpr double margin = 1e-3;  // share of the box: faces that lie on it are in
  std::vector<double> bounds(6 * ties.known.size(), -std::numeric_limits<double>::infinity());  // -low, high
  for (std::size_t t = 0; t < ties.known.size(); ++t) {
    for (const std::int64_t number : ties.known[t]) {
      const auto place = std::lower_bound(mesh.node_numbers.begin(), mesh.node_numbers.end(), number);
      const Vec3& x = mesh.nodes[at(place - mesh.node_numbers.begin())];
      for (std::size_t k = 0; k < 3; ++k) {
        bounds[6 * t + k] = std::max(bounds[6 * t + k], -x[k]);
        bounds[6 * t + 3 + k] = std::max(bounds[6 * t + 3 + k], x[k]);
      }
    }
  }
  all_reduce(ranks, Reduce::largest, bounds);
  std::vector<NodeBox> boxes(ties.known.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, bounds[6 * t + k] + bounds[6 * t + 3 + k]);
    const double reach = ties.counts[t].farthest + margin * size;
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[t].low[k] = -bounds[6 * t + k] - reach;
      boxes[t].high[k] = bounds[6 * t + 3 + k] + reach;
    }
  }
  return boxes;
}

/// Sums over the faces of a side that `takes` them: areas, and how many.
template <class Takes>
void add_faces(const Mesh& mesh, const std::vector<ElementFace>& faces, const Takes& takes, ExactSum* sums) {
  for (const ElementFace& face : faces) {
    const std::array<int, 4> corners = mesh.elements.face_nodes(face);
    if (!takes(corners)) continue;
    const auto place = [&](std::size_t i) { return mesh.nodes[at(corners[i])]; };
    const Vec3 twice = cross(subtract(place(2), place(0)), subtract(place(3), place(1)));
    sums[0].add(0.5 * std::sqrt(dot(twice, twice)));
    sums[1].add(1);
  }
}

}  // namespace

std::vector<TieSizes> find_tie_sizes(const ChunkedMesh& chunked, const TiedSurfaces& ties, const Communicator& ranks) {
  const Mesh& mesh = chunked.mesh;
  if (!ties.any()) return {};
  const std::vector<NodeBox> boxes = find_tied_boxes(mesh, ties, ranks);
  std::vector<ExactSum> sums(4 * boxes.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    const std::vector<std::int64_t>& known = ties.known[t];
    const auto is_tied = [&](int node) {
      return std::binary_search(known.begin(), known.end(), mesh.node_numbers[at(node)]);
    };
    const auto is_all_tied = [&](const auto& corners) { return std::all_of(corners.begin(), corners.end(), is_tied); };
    const auto is_inside = [&](const auto& corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        double middle = 0;
        for (const int node : corners) middle += 0.25 * mesh.nodes[at(node)][k];
        if (middle < boxes[t].low[k] || middle > boxes[t].high[k]) return false;
      }
      return true;
    };
    add_faces(mesh, ties.faces[t][0], is_all_tied, &sums[4 * t]);
    add_faces(mesh, ties.faces[t][1], is_inside, &sums[4 * t + 2]);
  }
  sum_over_ranks(ranks, sums);
  const auto find_size = [&](std::size_t i) {
    const double count = sums[i + 1].round();
    return count > 0 ? std::sqrt(sums[i].round() / count) : 0;
  };
  std::vector<TieSizes> sizes;
  for (std::size_t t = 0; t < boxes.size(); ++t) sizes.push_back({find_size(4 * t), find_size(4 * t + 2)});
  return sizes;
}

}  // namespace percuss
