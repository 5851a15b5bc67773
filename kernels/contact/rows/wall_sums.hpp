#pragma once
// What rigid walls do to the scene in a step.

#include "kernels/core/exact_sum.hpp"

namespace percuss {

/// Impulses of walls on nodes, and their moments about a point: all that contact gives the bodies together, for what
/// they give one another cancels.
struct WallSums {
  ExactSum impulse[3], moment[3];
  ExactSum work;  // of walls that move, on the bodies

  KOKKOS_INLINE_FUNCTION void merge(const WallSums& other) {
    for (int k = 0; k < 3; ++k) {
      impulse[k].merge(other.impulse[k]);
      moment[k].merge(other.moment[k]);
    }
    work.merge(other.work);
  }
};

/// Impulse of the rows of one wall in the direction in which it moves, of pushes and of friction.
struct WallPush {
  ExactSum push, friction;

  KOKKOS_INLINE_FUNCTION void merge(const WallPush& other) {
    push.merge(other.push);
    friction.merge(other.friction);
  }
};

/// Sums over the nodes before a wall with a mass, from which its speed follows in a pass (moving_walls.hpp).
struct WallMeeting {
  ExactSum mass, momentum;

  KOKKOS_INLINE_FUNCTION void merge(const WallMeeting& other) {
    mass.merge(other.mass);
    momentum.merge(other.momentum);
  }
};

}  // namespace percuss
