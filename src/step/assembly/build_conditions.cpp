#include "src/step/assembly/build_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "comm/agreement.hpp"
#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "comm/merge_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/deck/asked_for.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {

namespace {

/// Held directions by (node, direction), so that the first condition of the deck that holds one is known.
struct HeldDirection {
  int motion = 0;
  int condition = 0;  // place in the deck
};
using HeldMap = std::map<std::pair<int, int>, HeldDirection>;

/// The first contradiction between conditions in the order of the deck, and the rank that found it.
struct Contradiction {
  static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t condition = none;  // place in the deck
  std::int64_t direction = 0;
  std::int64_t node = 0;  // number in the whole mesh
  std::int64_t rank = 0;

  void merge(const Contradiction& other) {
    const auto key = [](const Contradiction& c) { return std::tuple(c.condition, c.direction, c.node, c.rank); };
    if (key(other) < key(*this)) *this = other;
  }
};

bool is_rest(const ConditionDeck& condition) {
  return condition.kind == ConditionDeck::Kind::fixed || condition.kind == ConditionDeck::Kind::symmetry;
}

/// Motion that a condition prescribes in one direction.
Motion make_motion(const ConditionDeck& condition, int k) {
  if (!condition.turn) return {condition.value[at(k)], condition.kind == ConditionDeck::Kind::displacement, {}};
  const TurnDeck& turn = *condition.turn;
  const auto first = (turn.axis + 1) % 3, second = (turn.axis + 2) % 3;
  const bool is_first = at(k) == first;
  const auto other = is_first ? second : first;
  return {turn.angular_velocity,
          false,
          {static_cast<int>(other), is_first ? -1.0 : 1.0, turn.through[at(k)], turn.through[other]}};
}

/// Rotations come after translations: directions 3, 4, 5.
constexpr int first_rotation = 3, direction_count = 6;

/// The held directions of this rank's nodes; of contradictions it notes the first, with its message.
class HeldDirectionFinder {
 public:
  HeldDirectionFinder(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid, Model& model)
      : deck_(deck), chunked_(chunked), rigid_(rigid), model_(model) {}

  HeldMap operator()() {
    model_.motions.push_back({});  // row 0: at rest
    for (std::size_t c = 0; c < deck_.conditions.size(); ++c) {
      const std::vector<int> nodes = select_nodes(chunked_.mesh, deck_, deck_.conditions[c].where);
      require_rotations(deck_.conditions[c], nodes);
      require_no_bodies(deck_.conditions[c], nodes);
      const bool turns = model_.has_rotations || model_.rigid.any();
      for (int k = 0; k < (turns ? direction_count : first_rotation); ++k) {
        if (deck_.conditions[c].active[static_cast<std::size_t>(k)]) hold(c, k, nodes);
      }
    }
    throw_contradiction();
    return std::move(held_);
  }

  /// Motions held by conditions, for the rigid bodies among their nodes; after the call.
  const std::vector<HeldByCondition>& motions() const { return motions_; }

 private:
  void hold(std::size_t c, int k, const std::vector<int>& nodes) {
    const ConditionDeck& condition = deck_.conditions[c];
    int row = 0;
    if (!is_rest(condition)) {
      row = static_cast<int>(model_.motions.size());
      model_.motions.push_back(make_motion(condition, k));
      model_.is_driven = true;
    }
    model_.is_driven = model_.is_driven || condition.when.any();  // nodes move as it begins to hold them
    motions_.push_back({c, k, row});
    for (const int node : nodes) {
      if (rigid_.holds(node)) continue;
      const auto [entry, is_new] = held_.emplace(std::pair{node, k}, HeldDirection{row, static_cast<int>(c)});
      const ConditionDeck& other = deck_.conditions[at(entry->second.condition)];
      const bool may_share = entry->second.motion == 0 && row == 0 && !condition.when.any() && !other.when.any();
      if (!is_new && !may_share && first_.condition == Contradiction::none) note(c, k, node, other);
    }
  }

  /// Throws, on all ranks, if rotations are held and no node of any rank has one. Symmetry holds those that there are.
  void require_rotations(const ConditionDeck& condition, const std::vector<int>& nodes) const {
    const auto first = condition.active.begin() + first_rotation;
    const auto active = std::find(first, condition.active.end(), true);
    if (condition.kind == ConditionDeck::Kind::symmetry || active == condition.active.end()) return;
    int some = std::any_of(nodes.begin(), nodes.end(), [&](int n) { return rigid_.holds(n); }) ? 1 : 0;
    if (model_.has_rotations && some == 0) {
      const auto inertia = to_host(model_.inertia);
      some = std::any_of(nodes.begin(), nodes.end(), [&](int n) { return inertia(static_cast<std::size_t>(n)) > 0; });
    }
    all_reduce(model_.ranks, Reduce::largest, some);
    if (some != 0) return;
    throw InputError(
        fmt::format("{}: error: {} has no effect here (only nodes of shells, beams and rigid bodies have rotations, "
                    "and none of these is one)",
                    deck_.where(condition.where.place), direction_names[at(active - condition.active.begin())]));
  }

  /// Throws, on all ranks, if a sensor is to switch what holds a rigid body, or a turn to hold one.
  void require_no_bodies(const ConditionDeck& condition, const std::vector<int>& nodes) const {
    if ((!condition.when.any() && !condition.turn) || !find_body(condition.where).empty()) return;
    int some = std::any_of(nodes.begin(), nodes.end(), [&](int n) { return rigid_.holds(n); }) ? 1 : 0;
    all_reduce(model_.ranks, Reduce::largest, some);
    if (some == 0) return;
    if (condition.turn)
      throw InputError(
          fmt::format("{}: error: nodes of a rigid body are to turn (turn moves nodes that deform): leave them out, or "
                      "give the body a velocity with rx, ry or rz",
                      deck_.where(condition.where.place)));
    throw InputError(fmt::format(
        "{}: error: the condition is of a rigid body and has from or until (sensors switch "
        "conditions on nodes that deform, and those that name a body): name it with body: in place of nodes",
        deck_.where(condition.where.place)));
  }

  void note(std::size_t c, int k, int node, const ConditionDeck& other) {
    const auto n = static_cast<std::size_t>(node);
    first_ = {static_cast<std::int64_t>(c), k, chunked_.mesh.node_numbers[n], model_.ranks.rank()};
    const bool is_switched = deck_.conditions[c].when.any() || other.when.any();
    message_ = fmt::format(
        "{}: error: node {} is held in direction {} by two conditions {} (the other is at {}): leave it out of one of "
        "them",
        deck_.where(deck_.conditions[c].where.place), chunked_.mesh.node_ids[n], direction_names[at(k)],
        is_switched ? "of which a sensor switches one" : "that move it", deck_.where(other.where.place));
  }

  /// Throws on all ranks, if any has found a contradiction.
  void throw_contradiction() {
    MergeReduction<Contradiction>()(model_.ranks, first_);
    if (first_.condition == Contradiction::none) return;
    throw InputError(broadcast_text(model_.ranks, message_, static_cast<int>(first_.rank)));
  }

  const Deck& deck_;
  const ChunkedMesh& chunked_;
  const RigidMap& rigid_;
  Model& model_;
  HeldMap held_;
  std::vector<HeldByCondition> motions_;
  Contradiction first_;
  std::string message_;
};

/// Held translations or rotations, with what of them this rank owns.
struct HeldLists {
  HeldDirections all;
  Array<int> owned;
  std::vector<int> by;    // [entries] condition
  Rows3<double> inverse;  // [nodes] 1 / mass, 0 in held directions and where there is no mass
};

/// Lists held directions of three, from the first on. mass: [node] mass, or rotary inertia.
HeldLists list_held(const HeldMap& held, int first, const ChunkedMesh& chunked, const RigidMap& rigid,
                    const std::vector<double>& mass) {
  std::vector<std::array<double, 3>> inverse(mass.size());
  for (std::size_t n = 0; n < mass.size(); ++n) {
    if (mass[n] > 0 && !rigid.holds(static_cast<int>(n))) inverse[n] = {1 / mass[n], 1 / mass[n], 1 / mass[n]};
  }
  std::vector<int> node, direction, motion, owned, by;
  std::vector<double> start;
  for (const auto& [key, value] : held) {
    if (key.second < first || key.second >= first + 3) continue;
    const auto n = static_cast<std::size_t>(key.first);
    const auto k = static_cast<std::size_t>(key.second - first);
    inverse[n][k] = 0;
    if (mass[n] == 0) continue;  // the rotation of a node without shells
    if (owns_node(chunked, key.first)) owned.push_back(static_cast<int>(node.size()));
    node.push_back(key.first);
    direction.push_back(static_cast<int>(k));
    motion.push_back(value.motion);
    by.push_back(value.condition);
    start.push_back(first == 0 ? chunked.mesh.nodes[n][k] : 0);
  }
  return {
      {to_view("percuss::held_node", node), to_view("percuss::held_direction", direction),
       to_view("percuss::held_motion", motion), to_view("percuss::held_start", start), static_cast<int>(node.size())},
      to_view("percuss::owned_held", owned),
      std::move(by),
      to_rows("percuss::inverse_mass", inverse)};
}

}  // namespace

void build_switches(const Deck& deck, Model& model) {
  SwitchModel& switches = model.switches;
  switches.sensors = deck.sensors.size();
  const auto list = [&](const auto& entries, std::vector<Switch>& out) {
    for (const auto& entry : entries) out.push_back(find_switch(deck.sensors, entry.when));
  };
  list(deck.pressures, switches.pressures);
  list(deck.nodal_loads, switches.nodal_loads);
  list(deck.conditions, switches.conditions);
  switches.switches_conditions =
      std::any_of(switches.conditions.begin(), switches.conditions.end(), [](const Switch& of) { return of.any(); });
}

void build_held_directions(const Deck& deck, const ChunkedMesh& chunked, const RigidMap& rigid,
                           const std::vector<double>& mass, Model& model) {
  HeldDirectionFinder find(deck, chunked, rigid, model);
  const HeldMap held = find();
  hold_rigid_bodies(deck, chunked, rigid, find.motions(), model);
  const HeldLists moves = list_held(held, 0, chunked, rigid, mass);
  model.held = moves.all;
  model.owned_held = moves.owned;
  model.inverse_mass = moves.inverse;
  model.switches.held_by = moves.by;
  if (!model.has_rotations) return;
  const auto inertia = to_host(model.inertia);
  const HeldLists spins =
      list_held(held, first_rotation, chunked, rigid, {inertia.data(), inertia.data() + inertia.extent(0)});
  model.held_spins = spins.all;
  model.owned_held_spins = spins.owned;
  model.inverse_inertia = spins.inverse;
  model.switches.spins_held_by = spins.by;
}

MassPoint find_mass_point(const ChunkedMesh& chunked, const std::vector<int>& nodes, const std::vector<double>& mass) {
  std::array<ExactSum, 4> sums{};
  for (const int node : nodes) {
    if (!owns_node(chunked, node)) continue;
    const auto n = static_cast<std::size_t>(node);
    for (std::size_t k = 0; k < 3; ++k) sums[k].add(mass[n] * chunked.mesh.nodes[n][k]);
    sums[3].add(mass[n]);
  }
  sum_over_ranks(find_ranks(chunked.mesh), sums);
  const double total = sums[3].round();
  return {total, {sums[0].round() / total, sums[1].round() / total, sums[2].round() / total}};
}

}  // namespace percuss
