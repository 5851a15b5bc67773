#include "src/step/damping/damping_stage.hpp"

#include <algorithm>

#include "kernels/core/view_copy.hpp"
#include "kernels/node/motion.hpp"
#include "src/step/model/impulses.hpp"

namespace percuss {

DampingStage::DampingStage(const Model& model)
    : model_(model),
      values_(model.dampings.size(), 0),
      coefficients_("percuss::damping_coefficients", model.dampings.size()),
      impulse_("percuss::damping_impulse", static_cast<std::size_t>(model.node_count)) {
  const std::size_t nodes = impulse_.extent(0);
  masses_.growth = Array<double>("percuss::mass_growth", nodes);
  masses_.inverse_mass = Rows3<double>("percuss::damped_inverse_mass", nodes);
  if (!model.has_rotations) return;
  masses_.inverse_inertia = Rows3<double>("percuss::damped_inverse_inertia", nodes);
  spin_impulse_ = Rows3<double>("percuss::damping_spin_impulse", nodes);
}

void DampingStage::begin_step(const State& /*state*/, const StepTimes& times) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = std::max(model_.dampings[i](times.time), 0.0);
  is_active_ = std::any_of(values_.begin(), values_.end(), [](double value) { return value > 0; });
  if (!is_active_) return;
  const auto host = Kokkos::create_mirror_view(coefficients_);
  for (std::size_t i = 0; i < values_.size(); ++i) host(i) = values_[i];
  copy_values(coefficients_, host);
}

DampedMotion DampingStage::find_motion(const State& state) const {
  return {state.v_before, state.mass, state.inverse_mass, state.v, masses_.inverse_mass};
}

DampedMotion DampingStage::find_spins(const State& state) const {
  return {state.w_before, state.inertia, state.inverse_inertia, state.w, masses_.inverse_inertia};
}

void DampingStage::change_velocities(State& state, const StepTimes& times) {
  if (!is_active_) return;
  damp_velocities(ExecSpace(), model_.damped_nodes, {coefficients_, times.dt_mean}, find_motion(state), masses_.growth);
  state.damped = masses_;
}

double DampingStage::bound_component(const State& state, double /*predicted*/) const {
  return find_largest_component(ExecSpace(), state.v);
}

void DampingStage::change_spins(State& state, const StepTimes& times) {
  if (!is_active_) return;
  damp_velocities(ExecSpace(), model_.damped_nodes, {coefficients_, times.dt_mean}, find_spins(state), {});
  if (!state.spin_tensors.any()) return;
  find_damping_impulses(ExecSpace(), model_.damped_nodes, {coefficients_, times.dt_mean}, find_spins(state),
                        spin_impulse_);
  complete_damping(ExecSpace(), state.spin_inertia(), state.turning_nodes(times.dt), spin_impulse_);
}

void DampingStage::book_motion(State& state, const StepTimes& times) {
  if (!is_active_) return;
  const DampingStep step{coefficients_, times.dt_mean};
  find_damping_impulses(ExecSpace(), model_.damped_nodes, step, find_motion(state), impulse_);
  if (model_.has_rotations) {
    DampedMotion spins = find_spins(state);
    spins.tensor_row = state.spin_tensors.row;
    find_damping_impulses(ExecSpace(), model_.damped_nodes, step, spins, spin_impulse_);
  }
  const auto x = state.x, v = state.v, v_before = state.v_before, w = state.w, w_before = state.w_before;
  const auto impulse = impulse_, spin_impulse = spin_impulse_;
  const bool has_spins = model_.has_rotations;
  const Kokkos::Array<double, 3> center{{model_.mass_center[0], model_.mass_center[1], model_.mass_center[2]}};
  const auto sums = sums_(
      ExecSpace(), model_.owned_nodes, KOKKOS_LAMBDA(const int n, Kokkos::Array<double, 7>& sum) {
        double j[3], r[3];
        for (int k = 0; k < 3; ++k) {
          j[k] = impulse(n, k);
          r[k] = x(n, k) - center[k];
          sum[0] += 0.5 * j[k] * (v(n, k) + v_before(n, k));
        }
        add_impulse(r, j, 1, [&](int i, double value) { sum[i] += value; });
        for (int k = 0; has_spins && k < 3; ++k) {
          sum[0] += 0.5 * spin_impulse(n, k) * (w(n, k) + w_before(n, k));
          sum[4 + k] += spin_impulse(n, k);
        }
      });
  state.books.damping_work.merge(sums[0]);
  state.books.damping_work.normalize();
  add_to_books(sums, 1, state.books);
}

}  // namespace percuss
