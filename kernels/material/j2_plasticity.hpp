#pragma once
// J2 plasticity with linear isotropic hardening, radial return (Wilkins 1964; Krieg and Krieg 1977).

#include "kernels/material/elastic.hpp"
#include "kernels/material/plastic_return.hpp"
#include "kernels/material/point_step.hpp"

namespace percuss {

/// Yield stress sigma_y = yield_stress + hardening_modulus * p, with p the equivalent plastic strain.
/// History: p. The hardening modulus is d(sigma_y)/dp, in units of stress.
struct J2Plasticity {
  static constexpr const char* name = "j2_plasticity";
  struct Constants {
    double youngs_modulus = 0, poissons_ratio = 0, yield_stress = 0, hardening_modulus = 0;
  };
  static constexpr auto keys() {
    return with_elastic_keys<Constants>(need("yield_stress", &Constants::yield_stress, KeyRange::positive, "pressure",
                                             "Uniaxial stress at first yield."),
                                        may("hardening_modulus", &Constants::hardening_modulus, KeyRange::not_negative,
                                            "pressure", "Slope of yield stress over equivalent plastic strain."));
  }

  static constexpr bool is_compiled_in = true;
  static constexpr bool takes_equation_of_state = true;
  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool can_yield = true;
  double lambda = 0;
  double mu = 0;
  double yield_stress = 0;
  double hardening_modulus = 0;

  static J2Plasticity make(const Constants& c) {
    const LameConstants moduli = find_lame_constants(c.youngs_modulus, c.poissons_ratio);
    return {moduli.lambda, moduli.mu, c.yield_stress, c.hardening_modulus};
  }

  PERCUSS_FORCE_INLINE LameConstants moduli() const { return {lambda, mu}; }

  /// Advances the unrotated Cauchy stress and p by the strain increment d dt.
  template <class T>
  PERCUSS_FORCE_INLINE PlasticReturn<T> update(Symmetric3<T>& stress, T* history, const Symmetric3<T>& de) const {
    const T third = T(1.0 / 3.0);
    // trial
    const T volumetric = T(lambda) * trace(de);
    const Symmetric3<T> trial =
        stress + T(2 * mu) * de + Symmetric3<T>{volumetric, volumetric, volumetric, T(0), T(0), T(0)};
    const T mean = third * trace(trial);
    const Symmetric3<T> deviator{trial.xx - mean, trial.yy - mean, trial.zz - mean, trial.xy, trial.yz, trial.zx};
    const T von_mises = square_root(T(1.5) * contract(deviator, deviator));
    // admissible?
    const T yield = T(yield_stress) + T(hardening_modulus) * history[0];
    const T excess = larger(von_mises - yield, T(0));
    // return: von_mises - 3 mu dp = yield + H dp
    const T dp = excess * T(1.0 / (3 * mu + hardening_modulus));
    const T share = T(1) - T(3 * mu) * dp / larger(von_mises, T(1e-300));
    history[0] = history[0] + dp;
    stress = share * deviator + Symmetric3<T>{mean, mean, mean, T(0), T(0), T(0)};
    const T flow_stress = yield + T(hardening_modulus) * dp;
    const T ratio = share * von_mises / flow_stress;
    return {share, flow_stress, ratio * ratio};
  }
};

}  // namespace percuss
