#pragma once
// Nodes as sums over their kinetic energy see them, in translation or in rotation.

#include "kernels/rigid/rigid_motion.hpp"
#include "src/step/model/state.hpp"

namespace percuss {

/// Velocities at n-1/2 and the forces at n that change them; of rotations angular velocities and moments.
struct MovingNodes {
  Rows3<double> velocity;
  Rows3<double> slots;  // forces by slot
  Array<double> inertia;
  Rows3<double> inverse;  // 0 in held directions
  NodeSlots nodes_to_slots;
  Gravity gravity;
  double dt = 0;          // between n-1 and n; 0 before the first step
  SpinTensors tensors{};  // of rotations: what nodes of beams have besides

  KOKKOS_INLINE_FUNCTION void find_force(int n, double (&f)[3]) const {
    for (int k = 0; k < 3; ++k) f[k] = inertia(n) * gravity.g[k];
    for (int i = nodes_to_slots.first(n); i < nodes_to_slots.first(n + 1); ++i) {
      for (int k = 0; k < 3; ++k) f[k] += slots(nodes_to_slots.slots(i), k);
    }
  }

  /// Kinetic energy m v(n-1/2) v*(n+1/2) / 2 of direction k, on which f acts.
  KOKKOS_INLINE_FUNCTION double find_energy(int n, int k, double f) const {
    const double change = inverse(n, k) > 0 ? dt * f : 0;  // a held direction goes its own way
    return 0.5 * velocity(n, k) * (find_momentum(n, k) + change);
  }

  KOKKOS_INLINE_FUNCTION double find_momentum(int n, int k) const {
    const double plain = inertia(n) * velocity(n, k);
    if (tensors.row.extent(0) == 0 || tensors.row(n) < 0) return plain;
    const Vector3<double> w{velocity(n, 0), velocity(n, 1), velocity(n, 2)};
    return plain + get(load_tensor(tensors.excess, tensors.row(n)) * w, k);
  }
};

inline MovingNodes find_translations(const Model& model, const State& state) {
  const double dt = state.step == 0 ? 0.0 : state.dt;
  return {state.v, state.slot_force, state.mass, state.inverse_mass, model.nodes_to_slots, state.gravity, dt};
}

/// Only of scenes with shells.
inline MovingNodes find_rotations(const Model& model, const State& state) {
  const double dt = state.step == 0 ? 0.0 : state.dt;
  return {state.w, state.slot_moment, state.inertia, state.inverse_inertia, model.nodes_to_slots, {},
          dt,      state.spin_tensors};
}

}  // namespace percuss
