#include "src/contact/ties/tie_hinges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "comm/all_reduce.hpp"
#include "comm/gather_items.hpp"
#include "src/contact/surface/number_map.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"

namespace percuss {
namespace {

/// Nodes farther from the line of a row than this share of their mean distance clamp. A second row is an element away.
constexpr double straight = 0.1;
/// An axis with a smaller component than this of a unit vector does not hold a rotation about that vector.
constexpr double across = 1e-6;

/// A tied node of a shell.
struct TurningNode {
  std::int64_t number = -1, id = 0;
  Vec3 x{};
  int tie = 0;
  int body = 0;               // of the mesh
  std::array<int, 3> held{};  // 1: rotations about x, y, z that something else holds

  bool operator<(const TurningNode& other) const { return number < other.number; }
};

/// Two tied nodes of one shell, by number.
using ShellEdge = std::array<std::int64_t, 2>;

/// Tied shells known to a rank, and then to all.
struct TiedShells {
  std::vector<TurningNode> nodes;  // ascending
  std::vector<ShellEdge> edges;
};

/// The first tie that each node of this rank is in; -1: none.
std::vector<int> list_ties(const Mesh& mesh, const TiedSurfaces& ties) {
  std::vector<int> tie_of_node(mesh.nodes.size(), -1);
  for (std::size_t t = 0; t < ties.known.size(); ++t) {
    for (const std::int64_t number : ties.known[t]) {
      int& tie = tie_of_node[at(find_number(mesh.node_numbers, number))];
      if (tie < 0) tie = static_cast<int>(t);
    }
  }
  return tie_of_node;
}

TiedShells list_tied_shells(const Mesh& mesh, const std::vector<int>& tie_of_node) {
  TiedShells found;
  std::map<int, int> body_of_node;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.topology_of(e).is_surface()) continue;
    int last = -1;
    for (const int n : mesh.corners(e)) {
      if (tie_of_node[at(n)] < 0) continue;
      body_of_node[n] = mesh.bodies[e];
      if (last >= 0) found.edges.push_back({mesh.node_numbers[at(last)], mesh.node_numbers[at(n)]});
      last = n;
    }
  }
  for (const auto& [n, body] : body_of_node)
    found.nodes.push_back(
        {mesh.node_numbers[at(n)], mesh.node_ids[at(n)], mesh.nodes[at(n)], tie_of_node[at(n)], body, {}});
  return found;
}

/// Marks what else holds rotations. Collective.
class RotationHolder {
 public:
  RotationHolder(const Mesh& mesh, const Deck& deck, TiedShells& shells) : mesh_(mesh), deck_(deck), shells_(shells) {}

  void mark() {
    for (TurningNode& node : shells_.nodes)
      if (deck_.contact.ties[at(node.tie)].rotations) node.held = {1, 1, 1};
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (!deck_.parts[at(mesh_.part_of(e))].rigid) continue;
      for (const int n : mesh_.corners(e)) hold(n, {1, 1, 1});
    }
    for (const RigidSetDeck& set : deck_.rigid_sets)
      for (const int n : select_nodes(mesh_, deck_, set.where)) hold(n, {1, 1, 1});
    for (const ConditionDeck& condition : deck_.conditions) {
      const std::array<bool, 6>& active = condition.active;
      if (!active[3] && !active[4] && !active[5]) continue;
      for (const int n : select_nodes(mesh_, deck_, condition.where)) hold(n, {active[3], active[4], active[5]});
    }
  }

 private:
  void hold(int node, const std::array<int, 3>& axes) {
    const TurningNode wanted{mesh_.node_numbers[at(node)]};
    const auto found = std::lower_bound(shells_.nodes.begin(), shells_.nodes.end(), wanted);
    if (found == shells_.nodes.end() || found->number != wanted.number) return;
    for (std::size_t k = 0; k < 3; ++k) found->held[k] |= axes[k];
  }

  const Mesh& mesh_;
  const Deck& deck_;
  TiedShells& shells_;
};

/// The tied shells of all ranks, each node once.
TiedShells gather(const Communicator& ranks, const TiedShells& own) {
  TiedShells all{gather_items(ranks, own.nodes), gather_items(ranks, own.edges)};
  std::stable_sort(all.nodes.begin(), all.nodes.end());
  std::vector<TurningNode> once;
  for (const TurningNode& node : all.nodes) {
    if (once.empty() || once.back().number != node.number) once.push_back(node);
    for (std::size_t k = 0; k < 3; ++k) once.back().held[k] |= node.held[k];
  }
  all.nodes = std::move(once);
  return all;
}

/// [rows] places of the nodes that shells connect, by the lowest.
std::vector<std::vector<std::size_t>> list_rows(const TiedShells& shells) {
  std::vector<std::size_t> lowest(shells.nodes.size());
  std::iota(lowest.begin(), lowest.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (lowest[i] != i) i = lowest[i] = lowest[lowest[i]];
    return i;
  };
  for (const ShellEdge& edge : shells.edges) {
    std::array<std::size_t, 2> ends{};
    for (std::size_t k = 0; k < 2; ++k)
      ends[k] = find(static_cast<std::size_t>(
          std::lower_bound(shells.nodes.begin(), shells.nodes.end(), TurningNode{edge[k]}) - shells.nodes.begin()));
    lowest[std::max(ends[0], ends[1])] = std::min(ends[0], ends[1]);
  }
  std::map<std::size_t, std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < lowest.size(); ++i) rows[find(i)].push_back(i);
  std::vector<std::vector<std::size_t>> list;
  for (auto& [first, row] : rows) list.push_back(std::move(row));
  return list;
}

std::size_t find_farthest(const std::vector<TurningNode>& nodes, const std::vector<std::size_t>& row,
                          std::size_t from) {
  return *std::max_element(row.begin(), row.end(), [&](std::size_t a, std::size_t b) {
    return find_distance(nodes[a].x, nodes[from].x) < find_distance(nodes[b].x, nodes[from].x);
  });
}

/// Line from the first node of a row to its last.
struct RowLine {
  Vec3 from{}, way{};
  double length = 0, spacing = 0;
};

/// Whether a node lies on the line of a row, and may turn about it.
bool turns_about(const RowLine& line, const TurningNode& node) {
  const Vec3 from = subtract(node.x, line.from);
  const double along = dot(from, line.way) / line.length, most = straight * line.spacing;
  if (dot(from, from) - along * along > most * most) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (node.held[k] != 0 && std::abs(line.way[k]) > across * line.length) return false;
  return true;
}

/// Line of a row of nodes between its ends.
RowLine make_line(const TurningNode& first, const TurningNode& last, std::size_t count) {
  const Vec3 way = subtract(last.x, first.x);
  const double length = std::sqrt(dot(way, way));
  return {first.x, way, length, length / static_cast<double>(count - 1)};
}

/// [tie, body] places of the nodes.
std::map<std::pair<int, int>, std::vector<std::size_t>> list_sides(const std::vector<TurningNode>& nodes) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> sides;
  for (std::size_t i = 0; i < nodes.size(); ++i) sides[{nodes[i].tie, nodes[i].body}].push_back(i);
  return sides;
}

}  // namespace

std::vector<TieHinge> find_tie_hinges(const ChunkedMesh& chunked, const Deck& deck, const TiedSurfaces& ties,
                                      const Communicator& ranks) {
  const auto turns = [](const TieDeck& tie) { return !tie.rotations; };
  const Mesh& mesh = chunked.mesh;
  if (!has_shells(mesh) || std::none_of(deck.contact.ties.begin(), deck.contact.ties.end(), turns)) return {};
  TiedShells own = list_tied_shells(mesh, list_ties(mesh, ties));
  int some = own.nodes.empty() ? 0 : 1;
  all_reduce(ranks, Reduce::largest, some);
  if (some == 0) return {};
  RotationHolder(mesh, deck, own).mark();
  const TiedShells all = gather(ranks, own);
  const auto sides = list_sides(all.nodes);
  std::vector<TieHinge> hinges;
  for (const std::vector<std::size_t>& row : list_rows(all)) {
    if (row.size() < 2) continue;
    const std::size_t first = find_farthest(all.nodes, row, row.front()), last = find_farthest(all.nodes, row, first);
    const TurningNode& any = all.nodes[row.front()];
    const RowLine line = make_line(all.nodes[first], all.nodes[last], row.size());
    const auto turns_there = [&](std::size_t i) { return turns_about(line, all.nodes[i]); };
    const std::vector<std::size_t>& side = sides.at({any.tie, any.body});
    if (!(line.length > 0) || !std::all_of(row.begin(), row.end(), turns_there) ||
        !std::all_of(side.begin(), side.end(), turns_there))
      continue;
    const auto [low, high] = std::minmax(first, last);
    hinges.push_back({any.tie, static_cast<std::int64_t>(row.size()), all.nodes[low].id, all.nodes[high].id});
  }
  std::stable_sort(hinges.begin(), hinges.end(), [](const TieHinge& a, const TieHinge& b) { return a.tie < b.tie; });
  return hinges;
}

}  // namespace percuss
