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

/// One direction of nodes that turn about an axis of space: what the other direction across the axis gives to it.
struct TurnShare {
  int other = -1;  // that direction; -1: no turn
  double sign = 0;
  double center = 0, other_center = 0;  // place of the axis in both directions [length]
};

/// The prescribed motions of a step, one row a condition and direction: v(n+1/2), or the displacement at n+1. Of a turn
/// by an angle a in a step dt: sin(a) / dt, and (1 - cos(a)) / dt in `back`, so that the distance from the axis stays.
struct PrescribedMotions {
  Array<double> value, back;
  Array<int> is_displacement;
  Array<TurnShare> turn;
};

/// Sets v(n+1/2) of every fixed direction. A prescribed displacement u gives the velocity that reaches start + u.
void hold_velocities(const ExecSpace& space, const HeldDirections& held, const PrescribedMotions& motions,
                     const Rows3<const double>& x, double dt, const Rows3<double>& v);

}  // namespace percuss
