#pragma once
// When does a beam fail? By the forces of its section, as a spot weld, or at a time.

#include <limits>

#include "kernels/beam/beam2.hpp"

namespace percuss {

/// A limit that is not set is infinite.
struct BeamLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double axial = none;                    // of a tension
  double shear_y = none, shear_z = none;  // of either sign, as those that follow
  double torque = none, moment_y = none, moment_z = none;
  double time = none;
};

/// The sum of the squares of the forces over their limits; the beam fails where it reaches 1. A compression does not
/// count.
KOKKOS_INLINE_FUNCTION double find_beam_load(const BeamLimits& limits, const BeamForces<double>& f) {
  const double shares[] = {larger(f.normal, 0.0) / limits.axial, f.shear_y / limits.shear_y,
                           f.shear_z / limits.shear_z,           f.torque / limits.torque,
                           f.moment_y / limits.moment_y,         f.moment_z / limits.moment_z};
  double sum = 0;
  for (const double share : shares) sum += share * share;
  return sum;
}

}  // namespace percuss
