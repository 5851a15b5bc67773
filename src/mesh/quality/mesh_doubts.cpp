#include "src/mesh/quality/mesh_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>

#include "src/index.hpp"
#include "src/mesh/element_height.hpp"
#include "src/mesh/quality/check_mesh.hpp"

namespace percuss {
namespace {

/// The thinnest elements are slivers if they are a few, thinner than the median by the first ratio and than all others
/// by the second: the intended growth of a graded mesh from layer to layer is less.
constexpr double sliver_ratio = 5, gap_ratio = 3, few_share = 0.01;
constexpr std::size_t few_least = 4;

/// Elements that a warning names.
constexpr std::size_t most_named = 5;

double find_height(const PartMesh& mesh, std::size_t element) {
  return find_element_height(mesh.elements.topology_of(element), gather_corners(mesh.elements, element, mesh.nodes));
}

void warn_of_slivers(const PartMesh& mesh, std::size_t element_count, std::vector<Warning>& warnings) {
  std::vector<double> heights;
  for (std::size_t e = 0; e < element_count; ++e) heights.push_back(find_height(mesh, e));
  if (heights.empty()) return;
  const auto element = static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin());
  std::sort(heights.begin(), heights.end());
  const double least = heights.front(), middle = heights[heights.size() / 2];
  const auto most = std::max(few_least, static_cast<std::size_t>(few_share * static_cast<double>(heights.size())));
  std::size_t slivers = 1;
  while (slivers <= most && slivers < heights.size() && heights[slivers] < gap_ratio * heights[slivers - 1]) ++slivers;
  if (middle < sliver_ratio * least || slivers > most || slivers == heights.size()) return;
  warnings.push_back(
      {"sliver_element",
       fmt::format("element {} is a sliver: {:.3g} across, the median element {:.3g}{} (it limits the time step of the "
                   "whole scene to about 1/{:.0f} of that of the median element): repair the mesh there",
                   id_of(mesh.element_ids, element), least, middle,
                   slivers > 1 ? fmt::format(" ({} elements are like it)", slivers) : "", middle / least),
       "", 0, 1});
}

/// An edge of a shell, and whether the shell goes along it from its lower node to its higher.
struct Edge {
  int low = 0, high = 0, element = 0;
  bool rises = false;
  friend auto operator<=>(const Edge&, const Edge&) = default;
};

struct Neighbour {
  int element = 0, other = 0;
  bool agrees = false;  // whether their normals are on the same side
  friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

/// Pairs of shells that alone share an edge, both ways. Where three meet no side continues.
std::vector<Neighbour> list_neighbours(const PartMesh& mesh, std::size_t element_count) {
  std::vector<Edge> edges;
  for (int e = 0; e < static_cast<int>(element_count); ++e) {
    const Topology& topology = mesh.elements.topology_of(at(e));
    if (!topology.is_surface()) continue;
    const std::span<const int> corners = mesh.elements.corners(at(e));
    for (const auto& edge : topology.edges()) {
      const int a = corners[at(edge[0])], b = corners[at(edge[1])];
      edges.push_back({std::min(a, b), std::max(a, b), e, a < b});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Neighbour> neighbours;
  const auto nodes = [](const Edge& edge) { return std::pair(edge.low, edge.high); };
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && nodes(edges[next]) == nodes(edges[i])) ++next;
    if (next - i != 2) continue;
    const bool agrees = edges[i].rises != edges[i + 1].rises;
    neighbours.push_back({edges[i].element, edges[i + 1].element, agrees});
    neighbours.push_back({edges[i + 1].element, edges[i].element, agrees});
  }
  std::sort(neighbours.begin(), neighbours.end());
  return neighbours;
}

/// The shells that are turned against most of those that they are joined to.
class TurnedShells {
 public:
  TurnedShells(std::size_t element_count, const std::vector<Neighbour>& neighbours)
      : neighbours_(neighbours), side_(element_count, 0) {}

  /// Ascending.
  std::vector<int> find() {
    for (const Neighbour& neighbour : neighbours_) {
      if (side_[at(neighbour.element)] == 0) visit_piece(neighbour.element);
    }
    std::sort(turned_.begin(), turned_.end());
    return std::move(turned_);
  }

 private:
  /// Gives each shell that is joined to the first the side 1 or -1 on which it is, and notes those of the fewer.
  void visit_piece(int first) {
    std::vector<int> piece{first};
    side_[at(first)] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Neighbour from{piece[i], -1, false};
      for (auto n = std::lower_bound(neighbours_.begin(), neighbours_.end(), from);
           n != neighbours_.end() && n->element == piece[i]; ++n) {
        if (side_[at(n->other)] != 0) continue;
        side_[at(n->other)] = n->agrees ? side_[at(n->element)] : -side_[at(n->element)];
        piece.push_back(n->other);
      }
    }
    const auto with_first = std::count_if(piece.begin(), piece.end(), [&](int e) { return side_[at(e)] == 1; });
    const int fewer = 2 * with_first < static_cast<std::ptrdiff_t>(piece.size()) ? 1 : -1;
    std::copy_if(piece.begin(), piece.end(), std::back_inserter(turned_), [&](int e) { return side_[at(e)] == fewer; });
  }

  const std::vector<Neighbour>& neighbours_;
  std::vector<int> side_;  // 0: not visited
  std::vector<int> turned_;
};

void warn_of_turned_shells(const PartMesh& mesh, std::size_t element_count, std::vector<Warning>& warnings) {
  const std::vector<Neighbour> neighbours = list_neighbours(mesh, element_count);
  const std::vector<int> turned = TurnedShells(element_count, neighbours).find();
  if (turned.empty()) return;
  std::string names;
  for (std::size_t i = 0; i < std::min(turned.size(), most_named); ++i)
    names += fmt::format("{}{}", i > 0 ? ", " : "", id_of(mesh.element_ids, at(turned[i])));
  if (turned.size() > most_named) names += ", ...";
  warnings.push_back(
      {"shell_normals",
       fmt::format("{} shell{} turned against {} neighbours, with opposite normals: element{} {} (top and bottom are "
                   "swapped there, for pressures, side sets and stresses): reverse their node order",
                   turned.size(), turned.size() == 1 ? " is" : "s are", turned.size() == 1 ? "its" : "their",
                   turned.size() == 1 ? "" : "s", names),
       "", 0, 1});
}

}  // namespace

void warn_of_doubts(const PartMesh& mesh, std::size_t element_count, std::vector<Warning>& warnings) {
  warn_of_slivers(mesh, element_count, warnings);
  warn_of_turned_shells(mesh, element_count, warnings);
}

}  // namespace percuss
