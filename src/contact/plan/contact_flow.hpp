#pragma once
// Data of the plan of contact: the content of ranks, the cached topology, and the number of items between ranks.

#include <map>
#include <utility>

#include "comm/partition/assign_parts.hpp"
#include "comm/rcb/cut_tree.hpp"
#include "src/contact/plan/plan_contact.hpp"

namespace percuss {

/// Items that go from rank to rank; what stays on a rank does not count.
class Flow {
 public:
  void add(int from, int to, std::int64_t items = 1) {
    if (from != to) items_[{from, to}] += items;
  }

  /// A message from every sender to every receiver, of so many bytes an item ...
  void send(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.first, items * bytes, phase, plan);
  }
  /// ... or back along the same ways ...
  void send_back(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.second, items * bytes, phase, plan);
  }
  /// ... or of so many bytes in all.
  void announce(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.first, bytes, phase, plan);
  }
  void announce_back(std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) const {
    for (const auto& [pair, items] : items_) count(pair.second, bytes, phase, plan);
  }

 private:
  static void count(int rank, std::int64_t bytes, Traffic ContactRankPlan::*phase, ContactPlan& plan) {
    Traffic& traffic = plan.ranks[static_cast<std::size_t>(rank)].*phase;
    ++traffic.messages;
    traffic.bytes += bytes;
  }

  std::map<std::pair<int, int>, std::int64_t> items_;  // by sender and receiver
};

/// Who has what in the two decompositions.
struct ContactPlanner::Places {
  Numbering fe;  // of the mesh, with the ranks of the plan
  CutTree tree;
  std::vector<int> rank_of_part;
  std::vector<int> owners;  // [points] ranks

  int find_fe_rank(int mesh_node) const { return fe.find_node_owner(mesh_node); }
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
