#pragma once
// Mooney-Rivlin hyperelasticity, nearly incompressible.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Stored energy c10 (I1 - 3) + c01 (I2 - 3) + K/2 (J - 1)^2 with the invariants of b = J^(-2/3) B, so that sigma =
/// (2/J) dev((c10 + I1 c01) b - c01 b b) + K (J - 1) I (Holzapfel, Nonlinear Solid Mechanics, section 6.5). History: U.
struct MooneyRivlin {
  static constexpr const char* name = "mooney_rivlin";
  static constexpr bool stores_energy = true;
  using Constants = MooneyRivlin;
  double c10 = 0, c01 = 0, bulk_modulus = 0;

  static constexpr auto keys() {
    using M = MooneyRivlin;
    return std::array{need("c10", &M::c10, KeyRange::positive, "pressure",
                           "c10 of the stored energy c10 (I1 - 3) + c01 (I2 - 3) + bulk_modulus (J - 1)^2 / 2."),
                      need("c01", &M::c01, KeyRange::not_negative, "pressure", "c01 of the stored energy; see c10."),
                      need("bulk_modulus", &M::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus.")};
  }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    const double mu = 2 * (c10 + c01);
    return {bulk_modulus - 2.0 / 3.0 * mu, mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
    StretchHistory::store(u, step.history);
    const T j = step.motion.volume_ratio, over_j = T(1) / j;
    const Symmetric3<T> b = power(j, -2.0 / 3.0) * find_square(u), bb = find_square(b);
    const T first = trace(b), second = T(0.5) * (first * first - trace(bb));
    const Symmetric3<T> whole = (T(2) * over_j) * ((T(c10) + T(c01) * first) * b + T(-c01) * bb);
    step.stress = add_pressure(whole, T(bulk_modulus) * (j - T(1)) - T(1.0 / 3.0) * trace(whole));
    // stretches of b and of its inverse, b b - I1 b + I2 I, which the two terms stiffen with
    const Symmetric3<T> inverse = add_pressure(bb + (-first) * b, second);
    step.mu =
        over_j * (T(c10) * (T(1) + bound_largest_eigenvalue(b)) + T(c01) * (T(1) + bound_largest_eigenvalue(inverse)));
    step.lambda = T(bulk_modulus) * larger(j, T(1)) - T(2.0 / 3.0) * T(2 * (c10 + c01)) * over_j;
  }
};

}  // namespace percuss
