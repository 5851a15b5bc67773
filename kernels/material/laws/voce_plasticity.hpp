#pragma once
// J2 plasticity with hardening that saturates, and the rate dependence of Cowper and Symonds.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Yield stress sigma_y = yield_stress + saturation_stress (1 - exp(-saturation_rate p)) + hardening_modulus p (Voce,
/// J. Inst. Metals 74, 1948), with p the equivalent plastic strain. History: p.
struct VocePlasticity {
  static constexpr const char* name = "voce_plasticity";
  using Constants = VocePlasticity;
  double youngs_modulus = 0, poissons_ratio = 0;
  double yield_stress = 0, saturation_stress = 0, saturation_rate = 0, hardening_modulus = 0;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = VocePlasticity;
    return join_keys(
        with_elastic_keys<M>(
            need("yield_stress", &M::yield_stress, KeyRange::positive, "pressure", "Uniaxial stress at first yield."),
            need("saturation_stress", &M::saturation_stress, KeyRange::not_negative, "pressure",
                 "Q: how much the yield stress grows in the end, by Q (1 - exp(-b p))."),
            need("saturation_rate", &M::saturation_rate, KeyRange::not_negative, "-",
                 "b of the growth Q (1 - exp(-b p))."),
            may("hardening_modulus", &M::hardening_modulus, KeyRange::not_negative, "pressure",
                "Slope of yield stress over equivalent plastic strain.")),
        rate_keys<M>());
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Static yield stress and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const T left = T(saturation_stress) * exponential(T(-saturation_rate) * p);
    return {T(yield_stress + saturation_stress) - left + T(hardening_modulus) * p,
            T(saturation_rate) * left + T(hardening_modulus)};
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
