#pragma once
// Materials of a layer without stress across it: stresses xx, yy, xy from strain increments xx, yy, 2 xy.

#include "kernels/core/tensor.hpp"

namespace percuss {

/// What an update tells the element.
template <class T>
struct LayerResponse {
  T across;  // increment of the strain across the layer, which changes the thickness
  T share;   // what plastic flow has left of the shear stress that elasticity would give; 1: no flow
  T secant;  // modulus of the secant of the stress-strain curve over Young's; 1: has never flowed
};

/// Isotropic elastic constants of a layer.
struct PlaneElasticity {
  double youngs_modulus = 0;
  double poissons_ratio = 0;
  double shear_modulus = 0;

  /// Adds the stress of a strain increment.
  template <class T>
  PERCUSS_FORCE_INLINE void add_stress(T (&stress)[3], const T (&de)[3]) const {
    const T stiffness = T(youngs_modulus / (1 - poissons_ratio * poissons_ratio));
    stress[0] = stress[0] + stiffness * (de[0] + T(poissons_ratio) * de[1]);
    stress[1] = stress[1] + stiffness * (de[1] + T(poissons_ratio) * de[0]);
    stress[2] = stress[2] + T(shear_modulus) * de[2];
  }
};

/// LayerResponse::secant of the static flow stress at the plastic strain p: exactly 1 where p is 0.
template <class T>
PERCUSS_FORCE_INLINE T find_secant_share(const PlaneElasticity& elasticity, const T& flow_stress, const T& p) {
  const T flow = larger(flow_stress, T(1e-300));
  return flow / (flow + T(elasticity.youngs_modulus) * p);
}

inline PlaneElasticity find_plane_elasticity(double youngs_modulus, double poissons_ratio) {
  return {youngs_modulus, poissons_ratio, youngs_modulus / (2 * (1 + poissons_ratio))};
}

/// The elastic trial of a step, in the sum and the difference of the normal stresses, in which the return of J2
/// plasticity is diagonal (Simo and Taylor 1986; Simo and Hughes 1998, section 3.4): with the multiplier l, dp = l s_e,
/// the sum divided by 1 + E l / (2 (1 - nu)), the difference and the shear by 1 + 3 G l.
template <class T>
struct PlaneTrial {
  T sum, difference, xy;
  T normal, shear;  // the two parts of the squared equivalent stress
  T before;         // sum of the normal stresses at n
};

/// stress: at n.
template <class T>
PERCUSS_FORCE_INLINE PlaneTrial<T> find_plane_trial(const PlaneElasticity& elasticity, const T (&stress)[3],
                                                    const T (&de)[3]) {
  T s[3] = {stress[0], stress[1], stress[2]};
  elasticity.add_stress(s, de);
  PlaneTrial<T> trial{s[0] + s[1], s[0] - s[1], s[2], T(0), T(0), stress[0] + stress[1]};
  trial.normal = T(0.25) * trial.sum * trial.sum;
  trial.shear = T(0.75) * trial.difference * trial.difference + T(3) * trial.xy * trial.xy;
  return trial;
}

/// How fast the two parts of a trial fall with the multiplier.
struct PlaneReturnRates {
  double normal, shear;
};

PERCUSS_FORCE_INLINE PlaneReturnRates find_return_rates(const PlaneElasticity& e) {
  return {e.youngs_modulus / (2 * (1 - e.poissons_ratio)), 3 * e.shear_modulus};
}

/// The response but for its secant, and the equivalent stress at n+1.
template <class T>
struct PlaneReturn {
  LayerResponse<T> response;
  T equivalent;
};

/// Sets the stress at n+1.
template <class T>
PERCUSS_FORCE_INLINE PlaneReturn<T> return_in_plane(const PlaneElasticity& elasticity, const PlaneReturnRates& rates,
                                                    const PlaneTrial<T>& trial, const T& multiplier, T (&stress)[3]) {
  const T sum = trial.sum * (T(1) / (T(1) + T(rates.normal) * multiplier));
  const T share = T(1) / (T(1) + T(rates.shear) * multiplier);
  const T difference = share * trial.difference;
  stress[0] = T(0.5) * (sum + difference);
  stress[1] = T(0.5) * (sum - difference);
  stress[2] = share * trial.xy;
  const T equivalent =
      square_root(T(0.25) * sum * sum + T(0.75) * difference * difference + T(3) * stress[2] * stress[2]);
  const T elastic = T(-elasticity.poissons_ratio / elasticity.youngs_modulus) * (sum - trial.before);
  return {{elastic - T(0.5) * multiplier * sum, share, T(1)}, equivalent};
}

/// Linear elasticity in plane stress; no history.
struct ElasticLayer {
  static constexpr int most_history = 0;
  static constexpr bool can_yield = false;
  PlaneElasticity elasticity;

  static constexpr int count_history() { return 0; }

  template <class T>
  PERCUSS_FORCE_INLINE LayerResponse<T> update(T (&stress)[3], T* /*history*/, const T (&de)[3],
                                               const T& /*dt*/) const {
    elasticity.add_stress(stress, de);
    return {T(-elasticity.poissons_ratio / (1 - elasticity.poissons_ratio)) * (de[0] + de[1]), T(1), T(1)};
  }
};

/// J2 plasticity with linear isotropic hardening in plane stress: yield stress sigma_y + H p, history p.
struct J2Layer {
  static constexpr int most_history = 1;
  static constexpr bool can_yield = true;
  /// Enough for round-off: Newton's steps double the digits, of which the first bracket gives one or more.
  static constexpr int most_iterations = 12;
  PlaneElasticity elasticity;
  double yield_stress = 0;
  double hardening_modulus = 0;

  static constexpr int count_history() { return 1; }

  template <class T>
  PERCUSS_FORCE_INLINE LayerResponse<T> update(T (&stress)[3], T* history, const T (&de)[3], const T& /*dt*/) const {
    const PlaneTrial<T> trial = find_plane_trial(elasticity, stress, de);
    const T yield = T(yield_stress) + T(hardening_modulus) * history[0];
    T multiplier = T(0);
    if (any(trial.normal + trial.shear > yield * yield)) multiplier = find_multiplier(trial, yield);
    PlaneReturn<T> to = return_in_plane(elasticity, find_return_rates(elasticity), trial, multiplier, stress);
    history[0] = history[0] + multiplier * to.equivalent;
    to.response.secant = find_secant_share(elasticity, T(yield_stress) + T(hardening_modulus) * history[0], history[0]);
    return to.response;
  }

 private:
  /// Solves s_e(l) (1 - H l) = sigma_y for l, 0 where the trial is elastic. s_e lies between s_e(0) / (1 + k l) of the
  /// largest and of the smallest k, which brackets l; Newton's steps from the lower end stay inside. A lane that has
  /// converged keeps its value, so that it does not depend on the others of its pack.
  template <class T>
  PERCUSS_FORCE_INLINE T find_multiplier(const PlaneTrial<T>& trial, const T& yield) const {
    const double hardening = hardening_modulus;
    const auto [k_normal, k_shear] = find_return_rates(elasticity);
    const T start = square_root(trial.normal + trial.shear);
    const T excess = larger(start - yield, T(0));
    T low = excess * (T(1) / (T(hardening) * start + T(larger(k_normal, k_shear)) * yield));
    T high = excess * (T(1) / (T(hardening) * start + T(smaller(k_normal, k_shear)) * yield));
    T l = low;
    for (int i = 0; i < most_iterations; ++i) {
      const T a = T(1) / (T(1) + T(k_normal) * l), b = T(1) / (T(1) + T(k_shear) * l);
      const T normal = trial.normal * a * a, shear = trial.shear * b * b;
      const T equivalent = square_root(normal + shear);
      const T rest = T(1) - T(hardening) * l;
      const T residual = equivalent * rest - yield;
      const T over_equivalent = T(1) / larger(equivalent, T(1e-300));
      const T slope =
          -(T(k_normal) * a * normal + T(k_shear) * b * shear) * over_equivalent * rest - T(hardening) * equivalent;
      low = select(residual > T(0), l, low);
      high = select(residual < T(0), l, high);
      T next = l - residual / select(slope < T(0), slope, T(-1));
      next = select((next >= low) & (next <= high), next, T(0.5) * (low + high));
      const auto open = (residual > T(4e-16) * start) | (residual < T(-4e-16) * start);
      const auto moves = open & (excess > T(0));
      if (!any(moves)) break;
      l = select(moves, next, l);
    }
    return select(excess > T(0), l, T(0));
  }
};

}  // namespace percuss
