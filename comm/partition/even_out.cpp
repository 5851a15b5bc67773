#include "comm/partition/even_out.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace percuss {

namespace {

struct Move {
  int vertex = -1, part = -1;
  long long growth = std::numeric_limits<long long>::max();  // of the cut
};

class Parts {
 public:
  Parts(const Graph& graph, int part_count, std::vector<int>& parts)
      : graph_(graph), parts_(parts), costs_(static_cast<std::size_t>(part_count), 0), members_(costs_.size()) {
    for (std::size_t v = 0; v < parts.size(); ++v) {
      costs_[static_cast<std::size_t>(parts[v])] += graph.vertex_weights[v];
      members_[static_cast<std::size_t>(parts[v])].push_back(static_cast<int>(v));
    }
  }

  const std::vector<long long>& costs() const { return costs_; }
  const std::vector<int>& members(std::size_t part) const { return members_[part]; }
  long long cost(int vertex) const { return graph_.vertex_weights[static_cast<std::size_t>(vertex)]; }

  /// Growth of the cut by moving a vertex: edges to its own part are cut, those to the new part no longer.
  long long find_growth(int vertex, int part) const {
    long long growth = 0;
    const int own = parts_[static_cast<std::size_t>(vertex)];
    for_each_edge(vertex, [&](int other_part, int weight) {
      if (other_part == own) growth += weight;
      if (other_part == part) growth -= weight;
    });
    return growth;
  }

  template <class Visit>
  void for_each_edge(int vertex, const Visit& visit) const {
    const auto v = static_cast<std::size_t>(vertex);
    for (int e = graph_.first[v]; e < graph_.first[v + 1]; ++e) {
      const auto edge = static_cast<std::size_t>(e);
      visit(parts_[static_cast<std::size_t>(graph_.neighbours[edge])], graph_.edge_weights[edge]);
    }
  }

  void move(const Move& move) {
    auto& from = members_[static_cast<std::size_t>(parts_[static_cast<std::size_t>(move.vertex)])];
    auto& to = members_[static_cast<std::size_t>(move.part)];
    costs_[static_cast<std::size_t>(parts_[static_cast<std::size_t>(move.vertex)])] -= cost(move.vertex);
    costs_[static_cast<std::size_t>(move.part)] += cost(move.vertex);
    from.erase(std::lower_bound(from.begin(), from.end(), move.vertex));
    to.insert(std::lower_bound(to.begin(), to.end(), move.vertex), move.vertex);
    parts_[static_cast<std::size_t>(move.vertex)] = move.part;
  }

 private:
  const Graph& graph_;
  std::vector<int>& parts_;
  std::vector<long long> costs_;           // [parts]
  std::vector<std::vector<int>> members_;  // [parts] vertices, ascending
};

/// The move to `part` of one of the vertices that adds least to the cut.
Move find_cheapest_to(const Parts& parts, const std::vector<int>& vertices, int part) {
  Move best;
  for (const int vertex : vertices) {
    const long long growth = parts.find_growth(vertex, part);
    if (growth < best.growth) best = {vertex, part, growth};
  }
  return best;
}

/// The move out of the heaviest part that adds least to the cut, among those after which both parts are lighter than
/// the heaviest is now. Vertices go to parts that they touch, or to the lightest of all.
Move find_relief(const Parts& parts, std::size_t heaviest) {
  const auto& costs = parts.costs();
  const auto lightest = static_cast<int>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  Move best;
  for (const int vertex : parts.members(heaviest)) {
    const auto consider = [&](int part) {
      const auto p = static_cast<std::size_t>(part);
      if (p == heaviest || costs[p] + parts.cost(vertex) >= costs[heaviest]) return;
      const Move move{vertex, part, parts.find_growth(vertex, part)};
      if (move.growth < best.growth || (move.growth == best.growth && move.vertex == best.vertex && part < best.part)) {
        best = move;
      }
    };
    consider(lightest);
    parts.for_each_edge(vertex, [&](int part, int) { consider(part); });
  }
  return best;
}

}  // namespace

void fill_empty_parts(const Graph& graph, int part_count, std::vector<int>& assignment) {
  Parts parts(graph, part_count, assignment);
  for (int part = 0; part < part_count; ++part) {
    if (!parts.members(static_cast<std::size_t>(part)).empty()) continue;
    std::size_t heaviest = 0;
    long long cost = -1;
    for (std::size_t p = 0; p < parts.costs().size(); ++p) {
      if (parts.members(p).size() < 2 || parts.costs()[p] <= cost) continue;
      heaviest = p;
      cost = parts.costs()[p];
    }
    parts.move(find_cheapest_to(parts, parts.members(heaviest), part));
  }
}

void even_out(const Graph& graph, int part_count, std::vector<int>& assignment) {
  Parts parts(graph, part_count, assignment);
  const auto& costs = parts.costs();
  const auto mean = static_cast<double>(std::accumulate(costs.begin(), costs.end(), 0LL)) / part_count;
  for (;;) {
    const auto heaviest = static_cast<std::size_t>(std::max_element(costs.begin(), costs.end()) - costs.begin());
    if (static_cast<double>(costs[heaviest]) <= even_enough * mean) return;
    const Move relief = find_relief(parts, heaviest);
    if (relief.vertex < 0) return;
    parts.move(relief);
  }
}

}  // namespace percuss
