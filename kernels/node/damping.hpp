#pragma once
// Damping of nodes in proportion to their mass: the force -c m v, against the frame of the scene.
//
// The impulse of a step uses the mean of the velocities before and after it, so that no c makes the step shorter:
// v(n+1/2) = [(1 - h) v(n-1/2) + (dt_mean f + P) / m] / (1 + h) with h = c dt_mean / 2. The impulse P of contact, ties,
// welds and constraints comes later in the step. Those who look for it take m (1 + h) for m.

#include "kernels/node/damped_nodes.hpp"

namespace percuss {

/// Nodes in translation or in rotation, in a step.
struct DampedMotion {
  Rows3<const double> before;  // v(n-1/2)
  Array<const double> mass;
  Rows3<const double> inverse_mass;  // 0 in held directions and of nodes of rigid bodies, which are left alone
  Rows3<double> velocity;            // in: v(n+1/2) without damping; out: with it
  Rows3<double> damped_inverse;      // out: inverse_mass / (1 + h)
  Array<const int> tensor_row{};  // find_damping_impulses() leaves nodes alone whose row is not negative; empty: none
};

/// Inputs of the damping of a step.
struct DampingStep {
  Array<const double> coefficients;  // c by row, at least 0 [1 / time]
  double dt_mean = 0;
};

/// h of a step. coefficient: c, at least 0 [1 / time].
KOKKOS_INLINE_FUNCTION double find_damping(double coefficient, double dt_mean) { return 0.5 * coefficient * dt_mean; }

/// Impulse over momentum: what the mean of v(n-1/2) and of the velocity at n+1/2 without damping is multiplied by.
KOKKOS_INLINE_FUNCTION double find_damped_share(double h) { return 2 * h / (1 + h); }

/// Damps the velocities of a step. growth: [nodes] out, 1 + h of those that are free in a direction;
/// empty: not wanted.
void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                     const DampedMotion& motion, const Array<double>& growth);

/// The impulses of the damping -h m (v(n-1/2) + v(n+1/2)), with the velocities at the end of the step; 0 where there is
/// none. impulse: [nodes] out [mass x velocity].
void find_damping_impulses(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                           const DampedMotion& motion, const Rows3<double>& impulse);

}  // namespace percuss
