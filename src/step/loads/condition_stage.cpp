#include "src/step/loads/condition_stage.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/core/host_copy.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/step/sensors/held_directions.hpp"

namespace percuss {

ConditionStage::ConditionStage(const Model& model) : model_(model) {
  std::vector<int> is_displacement;
  std::vector<TurnShare> turns;
  is_displacement.reserve(model.motions.size());
  turns.reserve(model.motions.size());
  for (const Motion& motion : model.motions) {
    is_displacement.push_back(motion.is_displacement ? 1 : 0);
    turns.push_back(motion.turn);
  }
  motions_ = {Array<double>("percuss::motion_values", model.motions.size()),
              Array<double>("percuss::motion_turns_back", model.motions.size()),
              to_view("percuss::is_displacement", is_displacement), to_view("percuss::motion_turns", turns)};
}

void ConditionStage::start(State& state) {
  hold(state.held, state, 0, state.v);
  hold(state.held_spins, state, 0, state.w);
}

void ConditionStage::change_velocities(State& state, const StepTimes& times) {
  hold(state.held, state, times.dt, state.v);
}

double ConditionStage::bound_component(const State& state, double predicted) const {
  if (predicted < 0 || state.held.count == 0) return predicted;
  return std::max(predicted, find_largest_component(ExecSpace(), state.held.node, state.held.count, state.v));
}

void ConditionStage::change_spins(State& state, const StepTimes& times) {
  hold(state.held_spins, state, times.dt, state.w);
  if (state.spin_tensors.any() && state.held_spins.count > 0)
    follow_held_spins(ExecSpace(), state.spin_inertia(), state.turning_nodes(times.dt));
}

void ConditionStage::set_switches(State& state) { set_held_directions(model_, state); }

void ConditionStage::hold(const HeldDirections& held, const State& state, double dt, const Rows3<double>& velocities) {
  if (held.count == 0) return;
  evaluate(state, dt);
  hold_velocities(ExecSpace(), held, motions_, state.x, dt > 0 ? dt : 1, velocities);
}

/// Values of the prescribed motions for the step from n to n+1.
void ConditionStage::evaluate(const State& state, double dt) {
  const auto values = Kokkos::create_mirror_view(motions_.value);
  const auto back = Kokkos::create_mirror_view(motions_.back);
  for (std::size_t m = 0; m < model_.motions.size(); ++m) {
    const Motion& motion = model_.motions[m];
    values(m) = motion.curve(motion.is_displacement ? state.time + dt : state.time + 0.5 * dt);
    if (motion.is_displacement && dt == 0) values(m) = 0;  // at the start: at rest where the mesh put it
    back(m) = 0;
    if (motion.turn.other < 0 || dt == 0) continue;
    const double half = 0.5 * dt * values(m);
    back(m) = 2 * std::sin(half) * std::sin(half) / dt;
    values(m) = std::sin(2 * half) / dt;
  }
  copy_values(motions_.value, values);
  copy_values(motions_.back, back);
}

}  // namespace percuss
