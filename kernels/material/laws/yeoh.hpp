#pragma once
// Yeoh's hyperelasticity, nearly incompressible.

#include "kernels/material/first_invariant.hpp"

namespace percuss {

/// Stored energy c10 (I1 - 3) + c20 (I1 - 3)^2 + c30 (I1 - 3)^3 + K/2 (J - 1)^2 (Yeoh, Rubber Chemistry and Technology
/// 66, 754, 1993). History: U.
struct Yeoh {
  static constexpr const char* name = "yeoh";
  static constexpr bool stores_energy = true;
  using Constants = Yeoh;
  double c10 = 0, c20 = 0, c30 = 0, bulk_modulus = 0;

  static constexpr auto keys() {
    using Y = Yeoh;
    return std::array{need("c10", &Y::c10, KeyRange::positive, "pressure",
                           "c10 of the stored energy c10 (I1 - 3) + c20 (I1 - 3)^2 + c30 (I1 - 3)^3 + bulk_modulus "
                           "(J - 1)^2 / 2."),
                      may("c20", &Y::c20, KeyRange::any, "pressure", "c20 of the stored energy; see c10."),
                      may("c30", &Y::c30, KeyRange::any, "pressure", "c30 of the stored energy; see c10."),
                      need("bulk_modulus", &Y::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus.")};
  }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return {bulk_modulus - 4.0 / 3.0 * c10, 2 * c10}; }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    advance_by_first_invariant(step, moduli(), [this](const T& first) {
      const T i = first - T(3);
      return EnergySlopes<T>{T(c10) + i * (T(2 * c20) + T(3 * c30) * i), T(2 * c20) + T(6 * c30) * i};
    });
  }
};

}  // namespace percuss
