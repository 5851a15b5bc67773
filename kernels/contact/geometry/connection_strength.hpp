#pragma once
// Failure criterion of ties and welds.

#include <cmath>

#include "kernels/core/views.hpp"

namespace percuss {

/// A tie or a weld fails where (pull / normal)^m + (shear / shear strength)^n reaches 1: both forces, or both stresses.
struct ConnectionStrength {
  double normal = 0, shear = 0;  // 0: none
  double normal_exponent = 2, shear_exponent = 2;
};

/// How much of a strength is used up; 1: all. pull: along the normal; below 0 it does not count.
KOKKOS_INLINE_FUNCTION double find_strength_use(const ConnectionStrength& strength, double pull, double shear) {
  double use = 0;
  if (strength.normal > 0 && pull > 0) use += std::pow(pull / strength.normal, strength.normal_exponent);
  if (strength.shear > 0 && shear > 0) use += std::pow(shear / strength.shear, strength.shear_exponent);
  return use;
}

}  // namespace percuss
