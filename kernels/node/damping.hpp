#pragma once
// Damping of nodes in proportion to their mass: the force -c m v, against the frame of the scene.
//
// The impulse of a step uses the mean of the velocities before and after it, so that no c makes the step shorter:
// v(n+1/2) = [(1 - h) v(n-1/2) + dt_mean f / m] / (1 + h) with h = c dt_mean / 2.

#include "kernels/core/views.hpp"

namespace percuss {

/// Which coefficient damps each node; const after set-up.
struct DampedNodes {
  Array<int> entry;  // [nodes] row of the coefficients; -1: not damped; empty: no node of this rank is
};

/// Nodes in translation or in rotation, in a step.
struct DampedMotion {
  Rows3<const double> before;        // v(n-1/2)
  Rows3<const double> inverse_mass;  // 0 in held directions and of nodes of rigid bodies, which are left alone
  Array<const double> mass;
  Rows3<double> velocity;  // in: v(n+1/2) without damping; out: with it
  Rows3<double> impulse;   // out: of the damping, 0 where there is none [mass x velocity]
};

/// Impulse over momentum at n: what a mean of the velocities before and after, without damping, is multiplied by.
/// coefficient: c, at least 0 [1 / time].
KOKKOS_INLINE_FUNCTION double find_damped_share(double coefficient, double dt_mean) {
  const double both = coefficient * dt_mean;
  return both / (1 + 0.5 * both);
}

/// Damps the step. coefficients: c by row.
void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const Array<const double>& coefficients,
                     double dt_mean, const DampedMotion& motion);

}  // namespace percuss
