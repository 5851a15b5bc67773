#include "src/step/sensors/held_directions.hpp"

#include <algorithm>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"

namespace percuss {
namespace {

/// Entries of held directions whose conditions hold.
struct HeldEntries {
  HeldDirections all;
  Array<int> owned;
};

/// keeps: by entry.
HeldEntries keep_entries(const HeldEntries& from, const std::vector<char>& keeps) {
  const auto node = to_host(from.all.node), direction = to_host(from.all.direction), motion = to_host(from.all.motion);
  const auto start = to_host(from.all.start);
  const auto owned_before = to_host(from.owned);
  std::vector<char> is_owned(keeps.size(), 0);
  for (std::size_t i = 0; i < owned_before.extent(0); ++i) is_owned[static_cast<std::size_t>(owned_before(i))] = 1;
  std::vector<int> nodes, directions, motions, owned;
  std::vector<double> starts;
  for (std::size_t i = 0; i < keeps.size(); ++i) {
    if (keeps[i] == 0) continue;
    if (is_owned[i] != 0) owned.push_back(static_cast<int>(nodes.size()));
    nodes.push_back(node(i));
    directions.push_back(direction(i));
    motions.push_back(motion(i));
    starts.push_back(start(i));
  }
  return {{to_view("percuss::held_node", nodes), to_view("percuss::held_direction", directions),
           to_view("percuss::held_motion", motions), to_view("percuss::held_start", starts),
           static_cast<int>(nodes.size())},
          to_view("percuss::owned_held", owned)};
}

/// [entries] 1: of a node that has not vanished.
std::vector<char> mark_present(const State& state, const HeldDirections& held) {
  const auto node = to_host(held.node);
  const auto mass = to_host(state.mass);
  std::vector<char> marks(static_cast<std::size_t>(held.count), 0);
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = mass(static_cast<std::size_t>(node(i))) > 0 ? 1 : 0;
  return marks;
}

/// inverse: 0 in the directions that are held, 1 / mass in those that no longer are. mass: or rotary inertia.
HeldEntries pick_held(const Model& model, const HeldEntries& from, const std::vector<int>& held_by, const State& state,
                      const Array<double>& mass, const Rows3<double>& inverse) {
  const auto node = to_host(from.all.node), direction = to_host(from.all.direction);
  const auto masses = to_host(mass);
  const auto inverses = to_host(inverse);
  std::vector<char> keeps = mark_present(state, from.all);
  for (std::size_t i = 0; i < held_by.size(); ++i) {
    const Switch& of = model.switches.conditions[static_cast<std::size_t>(held_by[i])];
    const bool holds = of.is_on(state.happened);
    const auto n = static_cast<std::size_t>(node(i)), k = static_cast<std::size_t>(direction(i));
    if (of.any()) inverses(n, k) = holds || masses(n) == 0 ? 0 : 1 / masses(n);
    if (!holds) keeps[i] = 0;
  }
  copy_values(inverse, inverses);
  return keep_entries(from, keeps);
}

}  // namespace

void set_held_directions(const Model& model, State& state) {
  if (!model.switches.switches_conditions) return;
  own_masses(model, state);
  const HeldEntries moves =
      pick_held(model, {model.held, model.owned_held}, model.switches.held_by, state, state.mass, state.inverse_mass);
  state.held = moves.all;
  state.owned_held = moves.owned;
  if (!model.has_rotations) return;
  const HeldEntries spins = pick_held(model, {model.held_spins, model.owned_held_spins}, model.switches.spins_held_by,
                                      state, state.inertia, state.inverse_inertia);
  state.held_spins = spins.all;
  state.owned_held_spins = spins.owned;
}

void drop_vanished_directions(State& state) {
  const auto drop = [&](HeldDirections& held, Array<int>& owned) {
    const std::vector<char> keeps = mark_present(state, held);
    if (std::find(keeps.begin(), keeps.end(), 0) == keeps.end()) return;
    const HeldEntries kept = keep_entries({held, owned}, keeps);
    held = kept.all;
    owned = kept.owned;
  };
  drop(state.held, state.owned_held);
  drop(state.held_spins, state.owned_held_spins);
}

}  // namespace percuss
