#pragma once
// J2 plasticity with linear isotropic and linear kinematic hardening together.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Yield where the von Mises stress of s - a reaches yield_stress + (1 - k) H p, with H the hardening modulus, k the
/// kinematic share and the back stress a growing by da = (2/3) k H dep (Prager 1956; Ziegler 1959; radial return: Krieg
/// and Key 1976). History: p, then a, a deviator, by xx, yy, zz, xy, yz, zx.
struct CombinedHardening {
  static constexpr const char* name = "combined_hardening";
  using Constants = CombinedHardening;
  double youngs_modulus = 0, poissons_ratio = 0;
  double yield_stress = 0, hardening_modulus = 0, kinematic_share = 0;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = CombinedHardening;
    return join_keys(
        with_elastic_keys<M>(
            need("yield_stress", &M::yield_stress, KeyRange::positive, "pressure", "Uniaxial stress at first yield."),
            may("hardening_modulus", &M::hardening_modulus, KeyRange::not_negative, "pressure",
                "Slope of yield stress over equivalent plastic strain."),
            need("kinematic_share", &M::kinematic_share, KeyRange::share, "-",
                 "Share of the hardening that moves the yield surface; the rest widens it.")),
        rate_keys<M>());
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 7;
  static constexpr int plane_history_count = 4;  // of a layer of a shell (kernels/shell/hardening_layer.hpp)
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Modulus of the part that moves the yield surface.
  KOKKOS_INLINE_FUNCTION double kinematic_modulus() const { return kinematic_share * hardening_modulus; }

  /// Static radius of the yield surface and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const double isotropic = hardening_modulus - kinematic_modulus();
    return {T(yield_stress) + T(isotropic) * p, T(isotropic)};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION auto start_flow(const T* history, const T& dt) const {
    return start_rate_flow(*this, history, dt);
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants c = moduli();
    const double resistance = 3 * c.mu + kinematic_modulus();
    T* const h = step.history;
    const Symmetric3<T> back{h[1], h[2], h[3], h[4], h[5], h[6]};
    // the trial about the back stress, which is a deviator
    const ElasticTrial<T> trial = find_trial(c, step.stress + T(-1) * back, step.motion.de);
    const auto flow = start_flow(h, step.motion.dt);
    const T dp = find_plastic_increment(trial.von_mises, resistance, flow);
    h[0] = h[0] + dp;
    // da = (2/3) k H (3/2) dp n, n = trial deviator / von Mises stress
    const T over_von_mises = T(1) / larger(trial.von_mises, T(1e-300));
    const Symmetric3<T> moved = back + (T(kinematic_modulus()) * dp * over_von_mises) * trial.deviator;
    h[1] = moved.xx, h[2] = moved.yy, h[3] = moved.zz, h[4] = moved.xy, h[5] = moved.yz, h[6] = moved.zx;
    return_stress(trial, resistance, dp, larger(trial.von_mises - T(resistance) * dp, flow.at_rest), step);
    // what was set is s - a(n+1)
    step.stress = step.stress + moved;
  }
};

}  // namespace percuss
