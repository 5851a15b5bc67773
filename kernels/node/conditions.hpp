#pragma once
// Held directions of nodes: fixed, symmetry, prescribed velocity and displacement.

#include "kernels/core/views.hpp"

namespace percuss {

/// One fixed direction of one node an entry; const after set-up. A node and direction occurs once.
struct HeldDirections {
  Array<int> node;
  Array<int> direction;  // 0, 1, 2
  Array<int> motion;     // row of the prescribed motions
  Array<double> start;   // coordinate at time 0 [length]
  int count = 0;
};

/// The prescribed motions of a step, one row a condition and direction: v(n+1/2), or the displacement at n+1.
struct PrescribedMotions {
  Array<double> value;
  Array<int> is_displacement;
};

/// Sets v(n+1/2) of every fixed direction. A prescribed displacement u gives the velocity that reaches start + u.
void hold_velocities(const ExecSpace& space, const HeldDirections& held, const PrescribedMotions& motions,
                     const Rows3<const double>& x, double dt, const Rows3<double>& v);

}  // namespace percuss
