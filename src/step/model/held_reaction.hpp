#pragma once
// What a condition gives to a node that it holds.

#include "src/step/model/state.hpp"

namespace percuss {

/// Whatever holds a direction gives J = m (v+ - v-) - dt_mean (f + m g) - P, with the forces f at n, the velocities
/// before and after the step and the contact impulse P.
struct HeldReactions {
  HeldDirections held;
  Gravity gravity;
  Rows3<const double> v, v_before, force, impulse;
  Array<const double> mass;
  double dt_mean = 0;

  /// J of entry i of the held directions [force x time].
  KOKKOS_INLINE_FUNCTION double operator()(int i) const {
    const int n = held.node(i), k = held.direction(i);
    const double m = mass(n);
    return m * (v(n, k) - v_before(n, k)) - dt_mean * (force(n, k) + m * gravity.g[k]) - impulse(n, k);
  }
};

inline HeldReactions find_reactions(const Model& model, const State& state, double dt_mean) {
  return {model.held, model.gravity, state.v, state.v_before, state.force, state.impulse, state.mass, dt_mean};
}

}  // namespace percuss
