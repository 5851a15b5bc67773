#pragma once
// Which nodes are damped in proportion to their mass (damping.hpp).

#include "kernels/core/views.hpp"

namespace percuss {

/// Which coefficient damps each node; const after set-up.
struct DampedNodes {
  Array<int> entry;  // [nodes] row of the coefficients; -1: not damped; empty: no node of this rank is
};

/// What the damping of a step acts on: the mean of v(n-1/2) and v(n+1/2), or v(n-1/2) alone.
enum class DampedVelocity { mean, old };

}  // namespace percuss
