#pragma once
// Where the records of elements of all kinds, and of all solids, hold the same.

#include "kernels/core/precision.hpp"

namespace percuss {

/// Begin of the record of any element.
struct CommonRecord {
  static constexpr int mass = 0;
};

/// What the record of a solid of any shape begins with, in scalars of one lane: mass, q, R (9), V (6), in float the
/// rest of R (9), stress (6) of its first point.
struct SolidRecord : CommonRecord {
  static constexpr int rest = is_single_precision ? 1 : 0;
  static constexpr int viscous_pressure = 1, rotation = 2, stretch = 11, stress = 17 + 9 * rest;
};

}  // namespace percuss
