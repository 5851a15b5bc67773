#include "src/contact/overlap/crossed_sides.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "comm/all_reduce.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// Sets of nodes that are joined, each node on one of two sides of its set.
class SidedSets {
 public:
  explicit SidedSets(std::size_t count) : parent_(count), flip_(count, 0), is_undivided_(count, 0) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
  }

  struct Place {
    std::size_t set = 0;
    int side = 0;
  };
  Place find(std::size_t node) {
    Place place{node, 0};
    while (parent_[place.set] != place.set) {
      place.side ^= flip_[place.set];
      place.set = parent_[place.set];
    }
    for (int side = place.side; parent_[node] != place.set && node != place.set;) {
      const std::size_t next = parent_[node];
      const int step = flip_[node];
      parent_[node] = place.set;
      flip_[node] = side;
      side ^= step;
      node = next;
    }
    return place;
  }
  /// crosses: 1 if they are on different sides.
  void join(std::size_t a, std::size_t b, int crosses) {
    const Place p = find(a), q = find(b);
    const int flip = p.side ^ q.side ^ crosses;
    if (p.set == q.set) {
      if (flip != 0) is_undivided_[p.set] = 1;
      return;
    }
    const auto [first, last] = std::minmax(p.set, q.set);
    parent_[last] = first;
    flip_[last] = flip;
    if (is_undivided_[last] != 0) is_undivided_[first] = 1;
  }
  /// Whether a path over the lines of a set leads from a node to itself through the surface.
  bool is_undivided(std::size_t set) const { return is_undivided_[set] != 0; }

 private:
  std::vector<std::size_t> parent_;
  std::vector<int> flip_;
  std::vector<char> is_undivided_;
};

struct PlacedNode {
  std::int64_t number;
  Point3 x;
};

std::vector<PlacedNode> list_nodes(const std::vector<PartLine>& lines) {
  std::vector<PlacedNode> nodes;
  nodes.reserve(2 * lines.size());
  for (const PartLine& line : lines)
    for (int k = 0; k < 2; ++k) nodes.push_back({line.ends[k], line.x[k]});
  std::sort(nodes.begin(), nodes.end(), [](const PlacedNode& a, const PlacedNode& b) { return a.number < b.number; });
  const auto is_same = [](const PlacedNode& a, const PlacedNode& b) { return a.number == b.number; };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), is_same), nodes.end());
  return nodes;
}

std::size_t find_place(const std::vector<PlacedNode>& nodes, std::int64_t number) {
  const auto place = std::lower_bound(nodes.begin(), nodes.end(), number,
                                      [](const PlacedNode& node, std::int64_t of) { return node.number < of; });
  return static_cast<std::size_t>(place - nodes.begin());
}

bool is_odd(const std::vector<PiercingEdge>& piercing, const PartLine& line) {
  const auto place =
      std::lower_bound(piercing.begin(), piercing.end(), line, [](const PiercingEdge& edge, const PartLine& of) {
        const auto& ends = edge.edge.ends;
        return ends[0] != of.ends[0] ? ends[0] < of.ends[0] : ends[1] < of.ends[1];
      });
  return place != piercing.end() && place->edge.ends[0] == line.ends[0] && place->edge.ends[1] == line.ends[1] &&
         place->is_odd;
}

/// The node of some that is farthest from the faces that an edge may go through; the first that is farther than `most`
/// will do. Collective.
DeepNode find_farthest(const Communicator& ranks, FaceIndex& index, const PiercingEdge& edge,
                       const std::vector<Point3>& nodes, double most) {
  constexpr std::size_t batch = 1024;
  const BoxTree* const tree = index.find_tree(edge.in);
  DeepNode farthest;
  for (std::size_t first = 0; first < nodes.size() && farthest.depth <= most; first += batch) {
    const std::size_t last = std::min(first + batch, nodes.size());
    std::vector<double> distances(last - first, std::numeric_limits<double>::max());
    for (std::size_t i = first; tree != nullptr && i < last; ++i)
      distances[i - first] = tree->find_least(nodes[i], distances[i - first], [&](int f) {
        const bool is_own = edge.body == edge.in && index.topology(at(f)).part == edge.edge.part;
        return is_own ? std::numeric_limits<double>::max() : find_closest_point(index.load(at(f), nodes[i])).distance;
      });
    all_reduce(ranks, Reduce::least, distances);
    for (std::size_t i = first; i < last; ++i)
      if (distances[i - first] > farthest.depth) farthest = {distances[i - first], nodes[i]};
  }
  return farthest;
}

}  // namespace

DeepNode CrossedSides::find_depth(const Communicator& ranks, FaceIndex& index, const PiercingEdge& edge) const {
  constexpr double any = std::numeric_limits<double>::infinity();
  if (inner >= 0) return find_farthest(ranks, index, edge, nodes[inner], any);
  const int fewer = nodes[1].size() < nodes[0].size() ? 1 : 0;
  const DeepNode deep = find_farthest(ranks, index, edge, nodes[fewer], any);
  const DeepNode other = find_farthest(ranks, index, edge, nodes[1 - fewer], deep.depth);
  return other.depth < deep.depth ? other : deep;
}

std::vector<CrossedSides> divide_part(const std::vector<PartLine>& lines, const std::vector<PiercingEdge>& piercing) {
  const std::vector<PlacedNode> nodes = list_nodes(lines);
  SidedSets sets(nodes.size());
  for (const PartLine& line : lines)
    sets.join(find_place(nodes, line.ends[0]), find_place(nodes, line.ends[1]), is_odd(piercing, line) ? 1 : 0);
  std::map<std::size_t, CrossedSides> crossed;  // by set; the lowest numbers come first
  std::map<std::size_t, int> faults;
  for (std::size_t e = 0; e < piercing.size(); ++e) {
    const PiercingEdge& edge = piercing[e];
    if (!edge.is_odd) continue;
    const std::size_t node = find_place(nodes, edge.edge.ends[edge.inner]);
    if (node == nodes.size() || nodes[node].number != edge.edge.ends[edge.inner]) continue;
    const SidedSets::Place place = sets.find(node);
    if (sets.is_undivided(place.set)) continue;
    CrossedSides& sides = crossed[place.set];
    if (edge.is_of_solid) {
      if (sides.inner >= 0 && sides.inner != place.side) faults[place.set] = 1;
      sides.inner = place.side;
    }
    sides.edges.push_back(e);
  }
  for (const auto& [set, fault] : faults) crossed.erase(set);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const SidedSets::Place place = sets.find(n);
    const auto of = crossed.find(place.set);
    if (of != crossed.end()) of->second.nodes[place.side].push_back(nodes[n].x);
  }
  std::vector<CrossedSides> list;
  for (auto& [set, sides] : crossed) list.push_back(std::move(sides));
  return list;
}

}  // namespace percuss
