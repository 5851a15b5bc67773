#include "src/step/constraints/build_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/mesh/hex_geometry.hpp"
#include "src/step/constraints/constraint_rows.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/springs/connected_nodes.hpp"
#include "src/step/springs/end_pairs.hpp"

namespace percuss {
namespace {

/// Every rank moves all of them.
constexpr std::size_t most_constrained_nodes = 200000;

std::vector<Item> gather_set(const Deck& deck, const ChunkedMesh& chunked, const Selector& where) {
  std::vector<int> own;
  for (const int n : select_nodes(chunked.mesh, deck, where))
    if (owns_node(chunked, n)) own.push_back(n);
  return gather_nodes(chunked, own);
}

/// How far the counterparts of a pair lie from where the others let expect them.
double find_mismatch(const std::vector<NodePair>& pairs) {
  const auto count = static_cast<double>(pairs.size());
  Vec3 mean{};
  for (const NodePair& pair : pairs)
    for (std::size_t k = 0; k < 3; ++k) mean[k] += (pair.second.place[k] - pair.first.place[k]) / count;
  double largest = 0;
  for (const NodePair& pair : pairs)
    largest = std::max(largest, find_distance(subtract(pair.second.place, pair.first.place), mean));
  return largest;
}

/// Nodes of the equations of an entry, a list for each.
EqualLists list_nodes(const NodeEquations& equations) {
  EqualLists lists;
  for (const std::vector<NodeTerm>& terms : equations) {
    std::vector<std::int64_t>& list = lists.emplace_back();
    for (const NodeTerm& term : terms) list.push_back(term.number);
  }
  return lists;
}

/// Entry by entry. Collective.
std::vector<EqualLists> find_lists(const Deck& deck, const ChunkedMesh& chunked,
                                   const std::vector<NodeEquations>& equations, ConstraintModel& model) {
  std::vector<PairOfEnds> entries;
  for (const ConstraintDeck& constraint : deck.constraints)
    if (constraint.between) entries.push_back({constraint.name, *constraint.between, constraint.place, true});
  const std::vector<std::vector<NodePair>> pairs = find_node_pairs(deck, chunked, entries, "constraint");
  std::vector<EqualLists> all;
  auto next = pairs.begin();
  for (const ConstraintDeck& constraint : deck.constraints) {
    EqualLists& lists = all.emplace_back(list_nodes(equations[all.size()]));
    if (!constraint.equation.empty()) {
      model.notes.push_back(fmt::format("constraint '{}': {} equations", constraint.name, lists.size()));
      continue;
    }
    if (constraint.nodes) {
      std::vector<std::int64_t>& list = lists.emplace_back();
      for (const Item& item : gather_set(deck, chunked, *constraint.nodes)) list.push_back(item.number);
      model.notes.push_back(fmt::format("constraint '{}': {} nodes", constraint.name, list.size()));
      continue;
    }
    for (const NodePair& pair : *next) lists.push_back({pair.first.number, pair.second.number});
    model.notes.push_back(fmt::format("constraint '{}': {} pairs, whose places match to {:.2g}", constraint.name,
                                      next->size(), find_mismatch(*next)));
    ++next;
  }
  return all;
}

void number_nodes(const std::vector<EqualLists>& entries, ConstraintModel& model) {
  std::vector<std::int64_t>& all = model.nodes;
  for (const EqualLists& lists : entries)
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

/// The lowest place of the group of each node, as lists are joined.
class Joiner {
 public:
  explicit Joiner(std::size_t count) : lowest_(count) { std::iota(lowest_.begin(), lowest_.end(), 0); }

  void join(int a, int b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    lowest_[at(high)] = low;
  }
  int find(int node) {
    while (lowest_[at(node)] != node) node = lowest_[at(node)] = lowest_[at(lowest_[at(node)])];
    return node;
  }

 private:
  std::vector<int> lowest_;
};

/// Groups of one direction, by their lowest nodes; nodes alone are none.
EqualGroups find_groups(const std::vector<EqualLists>& entries, const ConstraintModel& model, std::size_t k) {
  Joiner joiner(model.nodes.size());
  for (std::size_t c = 0; c < entries.size(); ++c) {
    if (!model.constraints[c].equal[k]) continue;
    for (const auto& list : entries[c])
      for (const std::int64_t number : list) joiner.join(find_place(model, list.front()), find_place(model, number));
  }
  std::vector<std::vector<int>> members(model.nodes.size());
  for (std::size_t n = 0; n < members.size(); ++n)
    members[at(joiner.find(static_cast<int>(n)))].push_back(static_cast<int>(n));
  EqualGroups groups;
  for (const std::vector<int>& group : members) {
    if (group.size() < 2) continue;
    groups.members.insert(groups.members.end(), group.begin(), group.end());
    groups.first.push_back(static_cast<int>(groups.members.size()));
  }
  return groups;
}

/// Throws, on all ranks, if a node of a constraint is marked. why: what its message says of such a node.
void refuse_marked(const ChunkedMesh& chunked, const std::vector<EqualLists>& entries, const ConstraintModel& model,
                   const std::vector<int>& is_marked, const char* why) {
  for (std::size_t c = 0; c < entries.size(); ++c) {
    for (const auto& list : entries[c]) {
      for (const std::int64_t number : list) {
        if (is_marked[at(find_place(model, number))] == 0) continue;
        throw InputError(fmt::format("{}: error: constraint '{}' names node {}, {}", model.constraints[c].place,
                                     model.constraints[c].name, find_node_id(chunked, number), why));
      }
    }
  }
}

void refuse_connected(const ChunkedMesh& chunked, const std::vector<EqualLists>& entries, const Model& model) {
  const ConstraintModel& constraints = model.constraints;
  refuse_marked(chunked, entries, constraints, mark_rigid_nodes(model, constraints),
                "which belongs to a rigid body (constraints are of nodes that deform): join nodes with rigid_sets");
  std::vector<int> is_welded;
  for (const std::int64_t number : constraints.nodes)
    is_welded.push_back(std::binary_search(model.welds.nodes.begin(), model.welds.nodes.end(), number) ? 1 : 0);
  refuse_marked(chunked, entries, constraints, is_welded,
                "which is welded, or of a solid at a weld (welds and constraints of one node would break each other): "
                "leave it out of one");
}

/// [nodes] row of the motion that holds each in a direction, of all ranks; -1: none.
std::vector<int> find_motions(const Model& model, std::size_t k) {
  const auto nodes = to_host(model.held.node), directions = to_host(model.held.direction),
             motions = to_host(model.held.motion);
  const auto owned = to_host(model.constraints.owned_node), places = to_host(model.constraints.owned_place);
  std::vector<int> motion_of_node(at(model.node_count), -1), found(model.constraints.nodes.size(), -1);
  for (std::size_t i = 0; i < at(model.held.count); ++i)
    if (directions(i) == static_cast<int>(k)) motion_of_node[at(nodes(i))] = motions(i);
  for (std::size_t i = 0; i < owned.extent(0); ++i) found[at(places(i))] = motion_of_node[at(owned(i))];
  all_reduce(model.ranks, Reduce::largest, found);
  return found;
}

/// Nodes that conditions hold must be held alike, or the first of them would move the others.
void refuse_held_to_differ(const ChunkedMesh& chunked, const std::vector<EqualLists>& entries, const Model& model,
                           std::size_t k) {
  const EqualGroups& groups = model.constraints.groups[k];
  const std::vector<int> motion = find_motions(model, k);
  std::vector<int> is_marked(motion.size(), 0);
  for (std::size_t g = 0; g + 1 < groups.first.size(); ++g) {
    int first = -1;
    for (int i = groups.first[g]; i < groups.first[g + 1]; ++i) {
      const std::size_t n = at(groups.members[at(i)]);
      if (motion[n] < 0) continue;
      if (first < 0) first = motion[n];
      if (motion[n] != first) is_marked[n] = 1;
    }
  }
  refuse_marked(chunked, entries, model.constraints, is_marked,
                "which another condition holds than a node that it moves equally with: hold them by one condition, or "
                "leave one of them out");
}

}  // namespace

void build_constraints(const Deck& deck, const ChunkedMesh& chunked, Model& model) {
  if (deck.constraints.empty()) return;
  ConstraintModel& constraints = model.constraints;
  for (const ConstraintDeck& of_deck : deck.constraints)
    constraints.constraints.push_back({of_deck.name,
                                       deck.where(of_deck.place),
                                       of_deck.equal,
                                       of_deck.between.has_value(),
                                       !of_deck.equation.empty(),
                                       of_deck.sum,
                                       {}});
  const std::vector<NodeEquations> equations = find_equations(deck, chunked);
  const std::vector<EqualLists> entries = find_lists(deck, chunked, equations, constraints);
  number_nodes(entries, constraints);
  if (constraints.nodes.size() > most_constrained_nodes)
    throw InputError(
        fmt::format("{}: error: constraints have {} nodes (at most {}, because every rank computes all of "
                    "them): name smaller sets",
                    constraints.constraints.back().place, constraints.nodes.size(), most_constrained_nodes));
  for (std::size_t c = 0; c < entries.size(); ++c) {
    Constraint& constraint = constraints.constraints[c];
    for (const auto& list : entries[c]) {
      const auto last = constraint.has_pairs ? list.begin() + 1 : list.end();
      for (auto number = list.begin(); number != last; ++number)
        constraint.nodes.push_back(find_place(constraints, *number));
    }
  }
  find_connected_nodes(chunked, constraints);
  refuse_connected(chunked, entries, model);
  if (std::any_of(equations.begin(), equations.end(), [](const NodeEquations& of) { return !of.empty(); }))
    constraints.rows = make_constraint_rows(entries, equations, constraints);
  for (std::size_t k = 0; k < 3 && constraints.rows.empty(); ++k) {
    constraints.groups[k] = find_groups(entries, constraints, k);
    refuse_held_to_differ(chunked, entries, model, k);
  }
}

}  // namespace percuss
