#pragma once
// Data of the plan of contact: the content of ranks, the cached topology, and the number of items between ranks.

#include <map>
#include <utility>

#include "comm/partition/assign_parts.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "src/contact/plan/plan_contact.hpp"

namespace percuss {

/// Bytes of an item as a run sends it: the number of a node or an edge, whether something is wanted, a place, and a
/// place with its velocity.
inline constexpr double number_bytes = 8, flag_bytes = 1, place_bytes = 24, motion_bytes = 48;

/// Items that go from rank to rank; what stays on a rank does not count.
class Flow {
 public:
  /// No items: a message that may be empty.
  void add(int from, int to, std::int64_t items = 1) {
    if (from != to) items_[{from, to}] += items;
  }

  /// A message from every sender to every receiver, of a size in bytes an item, a number of times ...
  void send(double bytes, PlannedTraffic ContactRankPlan::*phase, ContactPlan& plan, double times = 1) const {
    for (const auto& [pair, items] : items_) count(pair.first, static_cast<double>(items) * bytes, times, plan, phase);
  }
  /// ... or back along the same ways ...
  void send_back(double bytes, PlannedTraffic ContactRankPlan::*phase, ContactPlan& plan, double times = 1) const {
    for (const auto& [pair, items] : items_) count(pair.second, static_cast<double>(items) * bytes, times, plan, phase);
  }
  /// ... or of so many bytes in all.
  void announce(double bytes, PlannedTraffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.first, bytes, 1, plan, phase);
  }
  void announce_back(double bytes, PlannedTraffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.second, bytes, 1, plan, phase);
  }

 private:
  static void count(int rank, double bytes, double times, ContactPlan& plan, PlannedTraffic ContactRankPlan::*phase) {
    PlannedTraffic& traffic = plan.ranks[static_cast<std::size_t>(rank)].*phase;
    traffic.messages += times;
    traffic.bytes += times * bytes;
  }

  std::map<std::pair<int, int>, std::int64_t> items_;  // by sender and receiver
};

/// Who has what in the two decompositions.
struct ContactPlanner::Places {
  Numbering fe;  // of the mesh, with the ranks of the plan
  CutTree tree;
  std::vector<int> rank_of_part;
  std::vector<int> owners;       // [points] ranks
  std::vector<int> edge_owners;  // [edges] parts

  int find_fe_rank(int mesh_node) const { return fe.find_node_owner(mesh_node); }
  /// The rank that has the contacts of an edge.
  int find_home(const EdgeTopology& edge) const { return fe.find_element_owner(edge.elements[0]); }
};

/// Nodes and histories that ranks ask others for.
struct ContactPlanner::Named {
  Flow nodes, history;
};

/// Marks nodes that a rank knows.
struct ContactPlanner::Visit {
  std::vector<int> last;  // [mesh nodes] rank that marked it last
  explicit Visit(std::size_t nodes) : last(nodes, -1) {}

  bool is_first(int node, int rank) {
    const bool first = last[static_cast<std::size_t>(node)] != rank;
    last[static_cast<std::size_t>(node)] = rank;
    return first;
  }
};

}  // namespace percuss
