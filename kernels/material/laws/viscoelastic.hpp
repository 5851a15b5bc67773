#pragma once
// Linear viscoelasticity by Prony series, in shear and in volume.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// s(t) = integral of 2 G(t - t') de/dt' with G(t) = long_term_shear_modulus + sum_i G_i exp(-t / tau_i), from the rows
/// (tau_i, G_i), and the mean stress likewise with K(t) = bulk_modulus + sum_i K_i exp(-t / tau_i). Each term advances
/// by its exact solution for a constant rate (Taylor, Pister and Goudreau, Int. J. Num. Meth. Eng. 2, 1970): h(n+1) =
/// exp(-x) h(n) + 2 G_i (1 - exp(-x)) / x de, x = dt / tau_i. History: the h_i of shear, then those of volume.
struct Viscoelastic {
  static constexpr const char* name = "viscoelastic";
  using Constants = Viscoelastic;
  static constexpr int most_terms = 6;
  double bulk_modulus = 0, long_term_shear_modulus = 0;
  MaterialTable relaxation, bulk_relaxation;

  static constexpr auto keys() {
    using M = Viscoelastic;
    return std::array{need("bulk_modulus", &M::bulk_modulus, KeyRange::positive, "pressure",
                           "Bulk modulus; with bulk_relaxation that when all has relaxed."),
                      need("long_term_shear_modulus", &M::long_term_shear_modulus, KeyRange::not_negative, "pressure",
                           "Shear modulus when all has relaxed."),
                      may("relaxation", &M::relaxation, KeyRange::positive, "time, pressure",
                          "Relaxation times and the shear moduli that go with them; at most 6 rows."),
                      may("bulk_relaxation", &M::bulk_relaxation, KeyRange::positive, "time, pressure",
                          "Relaxation times and the bulk moduli that go with them; at most 6 rows.")};
  }
  const char* find_fault() const {
    if (relaxation.rows + bulk_relaxation.rows == 0) return "neither relaxation nor bulk_relaxation";
    if (relaxation.rows > most_terms) return "more than 6 rows of relaxation";
    if (bulk_relaxation.rows > most_terms) return "more than 6 rows of bulk_relaxation";
    if (relaxation.rows > 0 && !(relaxation.x[0] > 0)) return "a relaxation time that is not positive";
    if (bulk_relaxation.rows > 0 && !(bulk_relaxation.x[0] > 0))
      return "a time of bulk_relaxation that is not positive";
    return moduli().mu > 0 ? "" : "no shear modulus (long_term_shear_modulus is 0, and nothing relaxes in shear)";
  }

  static constexpr int history_count = 7 * most_terms;
  KOKKOS_INLINE_FUNCTION int count_history() const { return 6 * relaxation.rows + bulk_relaxation.rows; }

  /// Instantaneous moduli, those of fast loading.
  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    double mu = long_term_shear_modulus, bulk = bulk_modulus;
    for (int i = 0; i < relaxation.rows; ++i) mu += relaxation.y[i];
    for (int i = 0; i < bulk_relaxation.rows; ++i) bulk += bulk_relaxation.y[i];
    return {bulk - 2.0 / 3.0 * mu, mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const T volumetric = trace(step.motion.de);
    const Symmetric3<T> de = add_pressure(step.motion.de, T(-1.0 / 3.0) * volumetric);
    Symmetric3<T> change = add_pressure(T(2 * long_term_shear_modulus) * de, T(bulk_modulus) * volumetric);
    for (int i = 0; i < relaxation.rows; ++i) {
      T* const h = step.history + 6 * i;
      const Symmetric3<T> old{h[0], h[1], h[2], h[3], h[4], h[5]};
      const Decay<T> decay = find_decay(step.motion.dt * T(1 / relaxation.x[i]));
      const Symmetric3<T> now = decay.left * old + (T(2 * relaxation.y[i]) * decay.mean) * de;
      change = change + now + T(-1) * old;
      h[0] = now.xx, h[1] = now.yy, h[2] = now.zz, h[3] = now.xy, h[4] = now.yz, h[5] = now.zx;
    }
    step.stress = step.stress + add_pressure(change, relax_volume(step, volumetric));
  }

 private:
  /// exp(-x), and its mean from 0 to x.
  template <class T>
  struct Decay {
    T left, mean;
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION static Decay<T> find_decay(const T& x) {
    constexpr double small = 1e-4;  // below it the series of (1 - exp(-x)) / x is exact to 1e-13
    const T left = exponential(-x);
    return {left, select(x < T(small), T(1) - x * (T(0.5) - T(1.0 / 6.0) * x), (T(1) - left) / larger(x, T(1e-300)))};
  }

  /// Change of the mean stress by the terms of volume.
  template <class T>
  KOKKOS_INLINE_FUNCTION T relax_volume(PointStep<T>& step, const T& volumetric) const {
    T change(0);
    for (int i = 0; i < bulk_relaxation.rows; ++i) {
      T& h = step.history[6 * relaxation.rows + i];
      const Decay<T> decay = find_decay(step.motion.dt * T(1 / bulk_relaxation.x[i]));
      const T now = decay.left * h + (T(bulk_relaxation.y[i]) * decay.mean) * volumetric;
      change = change + now - h;
      h = now;
    }
    return change;
  }
};

}  // namespace percuss
