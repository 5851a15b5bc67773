#pragma once
// What rigid walls do to the scene in a step.

#include "kernels/core/exact_sum.hpp"

namespace percuss {

/// Impulses of walls on nodes, and their moments about a point: all that contact gives the bodies together, for what
/// they give one another cancels.
struct WallSums {
  ExactSum impulse[3], moment[3];

  KOKKOS_INLINE_FUNCTION void merge(const WallSums& other) {
    for (int k = 0; k < 3; ++k) {
      impulse[k].merge(other.impulse[k]);
      moment[k].merge(other.moment[k]);
    }
  }
};

}  // namespace percuss
