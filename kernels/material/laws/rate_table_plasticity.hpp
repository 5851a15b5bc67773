#pragma once
// J2 plasticity with tables of yield stress for several rates.

#include "kernels/material/material_key.hpp"
#include "kernels/material/radial_return.hpp"

namespace percuss {

/// Yield stress from curves over the equivalent plastic strain p, one for each rate of p; between the rates straight
/// over the rate or its logarithm, beyond them constant. The rate is that of the step. History: p.
struct RateTablePlasticity {
  static constexpr const char* name = "rate_table_plasticity";
  using Constants = RateTablePlasticity;
  double youngs_modulus = 0, poissons_ratio = 0;
  RateCurves hardening;
  bool logarithmic = false;

  static constexpr auto keys() {
    using M = RateTablePlasticity;
    return with_elastic_keys<M>(
        need("hardening_at_rates", &M::hardening, KeyRange::positive, "1 / time, -, pressure",
             "For each rate of plastic strain, ascending, the yield stress over equivalent plastic strain."),
        may("rate_interpolation", &M::logarithmic, "linear", "logarithmic",
            "Between two rates the yield stress is straight over the rate or over its logarithm."));
  }

  /// What is wrong between constants; empty: nothing.
  const char* find_fault() const {
    return logarithmic && hardening.rate[0] <= 0 ? "logarithmic rate_interpolation beside a rate of 0" : "";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Flow stress over a step as a function of dp. Curves may fall, over p and from one rate to the next.
  template <class T>
  struct Flow {
    const RateTablePlasticity& law;
    T p, over_dt;
    T at_rest, lowest;

    KOKKOS_INLINE_FUNCTION FlowStress<T> operator()(const T& dp) const {
      const auto now = law.hardening.find(p + dp, dp * over_dt, law.logarithmic);
      return FlowStress<T>{now.y, now.slope + now.rate_slope * over_dt};
    }
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION Flow<T> start_flow(const T* history, const T& dt) const {
    const T p = history[0];
    return {*this, p, T(1) / larger(dt, T(1e-300)), hardening.find_on(0, p).y, T(hardening.lowest)};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    return_by_isotropic_hardening(*this, step);
  }
};

}  // namespace percuss
