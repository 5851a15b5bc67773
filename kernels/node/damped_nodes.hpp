#pragma once
// Nodes that are damped in proportion to their mass (damping.hpp), and their response to impulses.

#include "kernels/core/views.hpp"

namespace percuss {

/// The damping coefficient of each node; const after set-up.
struct DampedNodes {
  Array<int> entry;  // [nodes] row of the coefficients; -1: not damped; empty: nothing is damped in the scene
};

/// What answers the impulses that act after the damping of a step, as those of contact. These change the velocity that
/// is damped, too: a node answers them like one with 1 + h times its mass (damping.hpp).
struct DampedMasses {
  Array<double> growth;           // [nodes] 1 + h, 1: not damped, or held; empty: nothing is damped in the step
  Rows3<double> inverse_mass;     // [nodes] over 1 + h; 0 in held directions
  Rows3<double> inverse_inertia;  // likewise; empty without rotations

  KOKKOS_INLINE_FUNCTION double find_growth(int n) const { return growth.extent(0) > 0 ? growth(n) : 1; }
};

}  // namespace percuss
