#pragma once
// Damping of nodes in proportion to their mass: the force -c m v, against the frame of the scene.
//
// The impulse of a step uses the mean of the velocities before and after it, so that no c makes the step shorter:
// v(n+1/2) = [(1 - h) v(n-1/2) + dt_mean f / m] / (1 + h) with h = c dt_mean / 2.
//
// Forces that come later in the step, as those of penalty contact, are not divided by 1 + h. Damping of the old
// velocity alone leaves all forces whole: they balance at rest. v(n+1/2) = (1 - h) / (1 + h) v(n-1/2) + dt_mean f / m.
// The largest stable step is then 2 / w / sqrt(1 + h). It limits h.

#include "kernels/node/damped_nodes.hpp"

namespace percuss {

/// Largest share of the old velocity that a step takes: 1 + h = 2 / (2 - share), and steps are at most 0.9 of the
/// bound.
inline constexpr double largest_old_share = 0.3;

/// Nodes in translation or in rotation, in a step.
struct DampedMotion {
  Rows3<const double> before;        // v(n-1/2)
  Rows3<const double> inverse_mass;  // 0 in held directions and of nodes of rigid bodies, which are left alone
  Array<const double> mass;
  Rows3<double> velocity;  // in: v(n+1/2) without damping; out: with it
  Rows3<double> impulse;   // out: of the damping, 0 where there is none [mass x velocity]
};

/// What takes part in the damping of a step.
struct DampingStep {
  Array<const double> coefficients;  // c by row, at least 0 [1 / time]
  double dt_mean = 0;
  DampedVelocity velocity = DampedVelocity::mean;
};

/// Impulse over momentum: what the damped velocity is multiplied by. A mean is that of the velocities without damping.
/// coefficient: c, at least 0 [1 / time].
KOKKOS_INLINE_FUNCTION double find_damped_share(double coefficient, double dt_mean, DampedVelocity velocity) {
  const double both = coefficient * dt_mean, share = both / (1 + 0.5 * both);
  return velocity == DampedVelocity::old && share > largest_old_share ? largest_old_share : share;
}

/// The velocity that is damped.
KOKKOS_INLINE_FUNCTION double find_damped_velocity(double before, double after, DampedVelocity velocity) {
  return velocity == DampedVelocity::old ? before : 0.5 * (before + after);
}

/// Damps the step.
void damp_velocities(const ExecSpace& space, const DampedNodes& nodes, const DampingStep& step,
                     const DampedMotion& motion);

}  // namespace percuss
