// Messages of ranks for pairs of edges, by the steps of a run.

#include <algorithm>
#include <set>

#include "kernels/core/host_copy.hpp"
#include "src/contact/check/ranked_edge_check.hpp"
#include "src/contact/plan/contact_flow.hpp"
#include "src/contact/search/ranked_edges.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

/// The nodes on which the check of an edge depends.
std::array<int, 6> list_read_nodes(const EdgeTopology& edge) {
  return {static_cast<int>(edge.ends[0]),  static_cast<int>(edge.ends[1]),  static_cast<int>(edge.wings[0]),
          static_cast<int>(edge.wings[1]), static_cast<int>(edge.wings[2]), static_cast<int>(edge.wings[3])};
}

}  // namespace

/// The cuts, fitted to the points of edges.
struct ContactPlanner::EdgeTree {
  std::vector<Cut> cuts;

  explicit EdgeTree(const CutTree& tree) {
    const auto host = to_host(tree.cuts);
    cuts.assign(host.data(), host.data() + host.extent(0));
    for (Cut& cut : cuts) {
      cut.lower_end = -std::numeric_limits<double>::infinity();
      cut.upper_begin = std::numeric_limits<double>::infinity();
    }
  }

  /// As Rcb::refit() does, of a point of a part.
  void hold(const std::array<double, 3>& x, int part) {
    int first = 0, last = static_cast<int>(cuts.size());
    while (last - first > 1) {
      const int middle = find_middle_rank(first, last);
      Cut& cut = cuts[at(middle)];
      const double place = x[at(cut.axis)];
      if (part < middle) {
        cut.lower_end = std::max(cut.lower_end, place);
        last = middle;
      } else {
        cut.upper_begin = std::min(cut.upper_begin, place);
        first = middle;
      }
    }
  }
};

/// The part in which the middle of each edge lies; owners of points are still parts.
void ContactPlanner::find_edge_owners(Places& places) const {
  for (const EdgeTopology& edge : share_.edges) {
    Vec3 middle{};
    for (const std::int64_t end : edge.ends)
      for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.5 * whole_.mesh.nodes[static_cast<std::size_t>(end)][k];
    places.edge_owners.push_back(find_owner(places.tree, middle, edge.number));
  }
}

/// Points to owners, edges to the ranks that their boxes reach; then the nodes and histories of paired edges are named.
void ContactPlanner::plan_edge_search(const Places& places, ContactPlan& plan) const {
  if (share_.edges.empty()) return;
  EdgeTree fitted(places.tree);
  Flow points, edges, nodes, history;
  std::size_t point = 0;
  for (std::size_t e = 0; e < share_.edges.size(); ++e) {
    const int home = places.find_home(share_.edges[e]), pieces = pairs_.divided_edges[e].pieces;
    for (int k = 0; k < pieces; ++k) fitted.hold(pairs_.edge_points[point++], places.edge_owners[e]);
    points.add(home, places.rank_of_part[at(places.edge_owners[e])], pieces);
  }
  const CutTree tree{places.tree.rank_count, to_view("contact::edge_cuts", fitted.cuts)};
  for (std::size_t e = 0; e < share_.edges.size(); ++e) {
    const std::array<double, 6>& box = pairs_.edge_boxes[e];
    visit_reached_ranks(tree, std::array{box[0], box[1], box[2]}, std::array{box[3], box[4], box[5]},
                        [&](int part) { edges.add(places.find_home(share_.edges[e]), places.rank_of_part[at(part)]); });
  }
  const auto search = &ContactRankPlan::search;
  points.send(place_bytes, search, plan);
  edges.send(RankedEdges::record_bytes, search, plan);
  const Named named = name_edges(places, pairs_.edges);
  named.nodes.send_back(number_bytes, search, plan);
  named.history.send_back(number_bytes, search, plan);
}

/// Items read by the ranks that find pairs of edges: nodes from their FE owners, history of edges A from their homes.
ContactPlanner::Named ContactPlanner::name_edges(const Places& places, const PairsOfEdges& pairs) const {
  std::vector<std::set<int>> nodes(at(places.tree.rank_count)), edges(nodes.size());  // by rank
  for (const auto& [a, b] : pairs) {
    const auto rank = at(places.rank_of_part[at(places.edge_owners[at(a)])]);
    for (const int edge : {a, b})
      for (const int node : list_read_nodes(share_.edges[at(edge)])) nodes[rank].insert(node);
    edges[rank].insert(a);
  }
  Named named;
  for (int rank = 0; rank < places.tree.rank_count; ++rank) {
    for (const int node : nodes[at(rank)]) named.nodes.add(places.find_fe_rank(node), rank);
    for (const int edge : edges[at(rank)]) named.history.add(places.find_home(share_.edges[at(edge)]), rank);
  }
  return named;
}

/// Counts what the check of some pairs reads and sends back, a number of times a step.
void ContactPlanner::send_edge_check(const Places& places, const PairsOfEdges& pairs, double times,
                                     ContactPlan& plan) const {
  const auto step = &ContactRankPlan::step;
  const Named named = name_edges(places, pairs);
  named.nodes.send(motion_bytes, step, plan, times);
  named.history.send(0, step, plan, times);  // contacts that are remembered, and touches back: plan_edge_check()
  named.history.send_back(0, step, plan, times);
}

void ContactPlanner::plan_edge_check(const Places& places, ContactPlan& plan) const {
  if (pairs_.edges.empty()) return;
  if (!pairs_.lists_near) {
    send_edge_check(places, pairs_.edges, 1, plan);
  } else {
    const double lists = 1 / pairs_.steps_per_list;
    send_edge_check(places, pairs_.edges, lists, plan);
    send_edge_check(places, pairs_.near_edges, 1 - lists, plan);
    const Named named = name_edges(places, pairs_.edges);
    for (const Flow* asked : {&named.nodes, &named.history})
      asked->send_back(flag_bytes, &ContactRankPlan::step, plan, lists);
  }
  for (const auto& [a, b] : pairs_.edge_touches) {
    const int home = places.find_home(share_.edges[at(a)]), rank = places.rank_of_part[at(places.edge_owners[at(a)])];
    if (home == rank) continue;
    plan.ranks[at(rank)].step.bytes += RankedEdgeCheck::touch_bytes;
    plan.ranks[at(home)].step.bytes += RankedEdgeCheck::history_bytes;
  }
}

}  // namespace percuss
