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
  static constexpr bool grows_in_increments = true, is_of_fibres = true;
  static constexpr bool bends_plastically = true;  // hexahedra yield as sections (plastic_bending.hpp)
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
    const T volumetric = number<T>(lambda) * trace(de);
    const Symmetric3<T> trial =
        stress + number<T>(2 * mu) * de + Symmetric3<T>{volumetric, volumetric, volumetric, T(0), T(0), T(0)};
    const Return<T> to = find_return(trial, history[0]);
    const T share = T(1) - to.lost;
    history[0] = history[0] + to.dp;
    stress = share * to.deviator + Symmetric3<T>{to.mean, to.mean, to.mean, T(0), T(0), T(0)};
    return describe_return(to, share);
  }

  /// The update in float, with what stress and p do not hold in their rests (long_sum.hpp); that of p is history[1]. An
  /// elastic trial stays as it is, where taking it apart and together again would change its last digit.
  template <class T>
  PERCUSS_FORCE_INLINE PlasticReturn<T> update(Symmetric3<T>& stress, Symmetric3<T>& rest, T* history,
                                               const Symmetric3<T>& de) const {
    const Symmetric3<T> increment = find_elastic_increment(moduli(), de);
    const Return<T> to = find_return(stress + (increment + rest), history[0]);
    add_to(history[0], history[1], to.dp);
    add_to(stress, rest, increment + (-to.lost) * to.deviator);
    return describe_return(to, T(1) - to.lost);
  }

 private:
  /// The radial return of a trial stress; `lost`: the share of its deviator that goes.
  template <class T>
  struct Return {
    Symmetric3<T> deviator;
    T mean, von_mises, yield, dp, lost;
  };

  template <class T>
  PERCUSS_FORCE_INLINE Return<T> find_return(const Symmetric3<T>& trial, const T& p) const {
    const T third = number<T>(1.0 / 3.0);
    const T mean = third * trace(trial);
    const Symmetric3<T> deviator{trial.xx - mean, trial.yy - mean, trial.zz - mean, trial.xy, trial.yz, trial.zx};
    const T von_mises = square_root(number<T>(1.5) * contract(deviator, deviator));
    // admissible?
    const T yield = number<T>(yield_stress) + number<T>(hardening_modulus) * p;
    const T excess = larger(von_mises - yield, T(0));
    // return: von_mises - 3 mu dp = yield + H dp
    const T dp = excess * number<T>(1.0 / (3 * mu + hardening_modulus));
    return {deviator, mean, von_mises,
            yield,    dp,   number<T>(3 * mu) * dp / larger(von_mises, number<T>(next_to_nothing<T>))};
  }

  template <class T>
  PERCUSS_FORCE_INLINE PlasticReturn<T> describe_return(const Return<T>& to, const T& share) const {
    const T flow_stress = to.yield + number<T>(hardening_modulus) * to.dp;
    const T ratio = share * to.von_mises / flow_stress;
    return {share, flow_stress, ratio * ratio};
  }
};

}  // namespace percuss
