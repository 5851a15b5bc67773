#pragma once
// J2 plasticity with power-law hardening and the rate dependence of Cowper and Symonds.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Yield stress sigma_y = yield_stress + hardening_coefficient p^hardening_exponent (Ludwik 1909), with p the
/// equivalent plastic strain. History: p.
struct PowerLawPlasticity {
  static constexpr const char* name = "power_law_plasticity";
  using Constants = PowerLawPlasticity;
  double youngs_modulus = 0, poissons_ratio = 0;
  double yield_stress = 0, hardening_coefficient = 0, hardening_exponent = 1;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = PowerLawPlasticity;
    return join_keys(
        with_elastic_keys<M>(
            need("yield_stress", &M::yield_stress, KeyRange::positive, "pressure", "Uniaxial stress at first yield."),
            need("hardening_coefficient", &M::hardening_coefficient, KeyRange::not_negative, "pressure",
                 "K of the yield stress yield_stress + K p^n."),
            need("hardening_exponent", &M::hardening_exponent, KeyRange::positive, "-",
                 "n of the yield stress yield_stress + K p^n.")),
        rate_keys<M>());
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Static yield stress and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const T hardening = T(hardening_coefficient) * power(p, hardening_exponent);
    return {T(yield_stress) + hardening, T(hardening_exponent) * hardening / larger(p, T(1e-300))};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION auto start_flow(const T* history, const T& dt) const {
    return start_rate_flow(*this, history, dt);
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    return_by_isotropic_hardening(*this, step);
  }
};

}  // namespace percuss
