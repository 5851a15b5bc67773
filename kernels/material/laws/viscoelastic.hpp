#pragma once
// Linear viscoelasticity in shear by a Prony series, elastic in volume.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// s(t) = integral of 2 G(t - t') de/dt' with G(t) = long_term_shear_modulus + sum_i G_i exp(-t / tau_i), from the rows
/// (tau_i, G_i). Each term advances by its exact solution for a constant rate (Taylor, Pister and Goudreau, Int. J.
/// Num. Meth. Eng. 2, 1970): h(n+1) = exp(-x) h(n) + 2 G_i (1 - exp(-x)) / x de, x = dt / tau_i. History: the h_i.
struct Viscoelastic {
  static constexpr const char* name = "viscoelastic";
  using Constants = Viscoelastic;
  static constexpr int most_terms = 4;
  double bulk_modulus = 0, long_term_shear_modulus = 0;
  MaterialTable relaxation;

  static constexpr auto keys() {
    using M = Viscoelastic;
    return std::array{need("bulk_modulus", &M::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus."),
                      need("long_term_shear_modulus", &M::long_term_shear_modulus, KeyRange::not_negative, "pressure",
                           "Shear modulus when all has relaxed."),
                      need("relaxation", &M::relaxation, KeyRange::positive, "time, pressure",
                           "Relaxation times and the shear moduli that go with them; at most 4 rows.")};
  }
  const char* find_fault() const {
    if (relaxation.rows > most_terms) return "more than 4 rows of relaxation";
    return relaxation.x[0] > 0 ? "" : "a relaxation time that is not positive";
  }

  static constexpr int history_count = 6 * most_terms;
  KOKKOS_INLINE_FUNCTION int count_history() const { return 6 * relaxation.rows; }

  /// Of fast loading.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    double mu = long_term_shear_modulus;
    for (int i = 0; i < relaxation.rows; ++i) mu += relaxation.y[i];
    return {bulk_modulus - 2.0 / 3.0 * mu, mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    constexpr double small = 1e-4;  // below it the series of (1 - exp(-x)) / x is exact to 1e-13
    const T volumetric = trace(step.motion.de);
    const Symmetric3<T> de = add_pressure(step.motion.de, T(-1.0 / 3.0) * volumetric);
    Symmetric3<T> change = add_pressure(T(2 * long_term_shear_modulus) * de, T(bulk_modulus) * volumetric);
    for (int i = 0; i < relaxation.rows; ++i) {
      T* const h = step.history + 6 * i;
      const Symmetric3<T> old{h[0], h[1], h[2], h[3], h[4], h[5]};
      const T x = step.motion.dt * T(1 / relaxation.x[i]), left = exponential(-x);
      const T mean = select(x < T(small), T(1) - x * (T(0.5) - T(1.0 / 6.0) * x), (T(1) - left) / larger(x, T(1e-300)));
      const Symmetric3<T> now = left * old + (T(2 * relaxation.y[i]) * mean) * de;
      change = change + now + T(-1) * old;
      h[0] = now.xx, h[1] = now.yy, h[2] = now.zz, h[3] = now.xy, h[4] = now.yz, h[5] = now.zx;
    }
    step.stress = step.stress + change;
  }
};

}  // namespace percuss
