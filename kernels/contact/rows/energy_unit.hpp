#pragma once
// Energies of rows as whole numbers of a unit, so that their sum does not depend on the order of the rows, whatever
// threads and ranks they lie on, and costs an addition each. Exact sums of doubles (exact_sum.hpp) cost many times that
// and are not needed where only magnitudes are compared.

#include <cmath>
#include <cstdint>

#include "kernels/core/simd.hpp"

namespace percuss {

struct EnergyUnit {
  static constexpr double most = 68719476736.0;  // 2^36 units a row: sums of 2^26 rows stay below 2^63

  double per_unit = 0;  // units per energy; 0: nothing is known of the magnitude, and everything counts as nothing

  /// largest: an energy that rows are expected not to exceed by much, >= 0; one that does counts as `most`.
  KOKKOS_INLINE_FUNCTION static EnergyUnit of_largest(double largest) {
    const double per_unit = most / largest;
    return {largest > 0 && std::isfinite(per_unit) ? per_unit : 0};
  }

  /// For the pass after one whose largest term was this: terms shrink as the iteration converges, and the unit with
  /// them, so that none is lost that matters; terms that grow 256 times in a pass still count in full.
  KOKKOS_INLINE_FUNCTION static EnergyUnit after(double largest) {
    constexpr double growth = 256;
    return of_largest(growth * largest);
  }

  KOKKOS_INLINE_FUNCTION bool is_known() const { return per_unit > 0; }

  /// Whole units of an energy, or of a difference of energies, rounded towards zero; of a pack the sum of its lanes.
  /// What is no number counts as most.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION std::int64_t count(const T& energy) const {
    const T units = energy * T(per_unit);
    const T bounded = select(units < T(most), units, T(most));
    // Whole numbers below 2^53: the sum of the lanes is exact, whatever their order.
    return static_cast<std::int64_t>(sum_lanes(truncate(select(bounded > T(-most), bounded, T(-most)))));
  }
};

}  // namespace percuss
