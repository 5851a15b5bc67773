#pragma once
// The return in plane stress about several back stresses that recover (Chaboche's law), by one scalar equation.

#include "kernels/material/laws/chaboche.hpp"
#include "kernels/shell/plane_stress.hpp"

namespace percuss {

/// A stress in the plane by the sum and the difference of its normal components and its shear: the modes in which
/// elasticity and the yield surface are both diagonal.
template <class T>
struct PlaneModes {
  T sum, difference, xy;

  PERCUSS_FORCE_INLINE static PlaneModes load(const T* stress) {
    return {stress[0] + stress[1], stress[0] - stress[1], stress[2]};
  }
  PERCUSS_FORCE_INLINE void store(T* stress) const {
    stress[0] = T(0.5) * (sum + difference), stress[1] = T(0.5) * (sum - difference), stress[2] = xy;
  }
  PERCUSS_FORCE_INLINE void add(const T& factor, const PlaneModes& other) {
    sum = sum + factor * other.sum, difference = difference + factor * other.difference, xy = xy + factor * other.xy;
  }
};

/// The product whose root is the equivalent stress.
template <class T>
PERCUSS_FORCE_INLINE T contract(const PlaneModes<T>& a, const PlaneModes<T>& b) {
  return T(0.25) * a.sum * b.sum + T(0.75) * a.difference * b.difference + T(3) * a.xy * b.xy;
}

/// The stress about the back stress at the end of a step with the plastic increment dp, as if the flow stress were
/// `flow`, and its equivalent stress with the slope by dp.
template <class T>
struct PlaneAbout {
  PlaneModes<T> stress;
  ValueAndSlope<T> equivalent;
  T multiplier, move;  // dp / flow, and K of it: by move (s - b) the terms move
};

/// A step of a layer: from the trial less what is left of the terms, mode i falls by 1 / (1 + (k_i + K) l), with the
/// multiplier l = dp / flow, k_i the rates of J2 plasticity in plane stress and K(dp) that of BackStresses.
template <class T>
struct PlaneTerms {
  const MaterialTable& terms;
  const PlaneReturnRates& rates;
  PlaneModes<T> trial;
  const T* back;  // of each term xx, yy, xy

  PERCUSS_FORCE_INLINE PlaneAbout<T> at(const T& dp, const FlowStress<T>& flow) const {
    PlaneModes<T> s = trial, slope{T(0), T(0), T(0)};
    for (int k = 0; k < terms.rows; ++k) {
      const T kept = BackStresses::keep(terms.x[k], dp);
      const auto term = PlaneModes<T>::load(back + 3 * k);
      s.add(-kept, term);
      slope.add(T(terms.x[k]) * kept * kept, term);
    }
    const ValueAndSlope<T> modulus = BackStresses::find_modulus(terms, dp);
    const T over_flow = T(1) / larger(flow.value, T(1e-300)), l = dp * over_flow;
    // d(K l) / d dp, of which modulus.slope is that at a constant flow
    const T l_slope = (T(1) - l * flow.slope) * over_flow;
    const T move_slope = (modulus.slope - modulus.value * l * flow.slope) * over_flow;
    const auto fall = [&](T& value, T& rise, double rate) {
      const T share = T(1) / (T(1) + (T(rate) + modulus.value) * l);
      value = value * share;
      rise = share * (rise - value * (T(rate) * l_slope + move_slope));
    };
    fall(s.sum, slope.sum, rates.normal);
    fall(s.difference, slope.difference, rates.shear);
    fall(s.xy, slope.xy, rates.shear);
    const T equivalent = square_root(contract(s, s));
    return {s, {equivalent, contract(s, slope) / larger(equivalent, T(1e-300))}, l, modulus.value * l};
  }
};

/// Advances a layer of Chaboche's law. history: p, then the terms by xx, yy, xy, whose deviators are the solid's.
template <class T>
PERCUSS_FORCE_INLINE LayerResponse<T> return_about_terms(const PlaneElasticity& elasticity, const Chaboche& law,
                                                         T (&stress)[3], T* history, const T (&de)[3], const T& dt) {
  const PlaneReturnRates rates = find_return_rates(elasticity);
  const T before = stress[0] + stress[1];
  elasticity.add_stress(stress, de);
  const PlaneTerms<T> step{law.back_stresses, rates, PlaneModes<T>::load(stress), history + 1};
  const auto flow = law.start_flow(history, dt);
  const T start = step.at(T(0), {flow.at_rest, T(0)}).equivalent.value;
  const T secant = find_secant_share(elasticity, T(flow.at_rest), history[0]);
  const auto yields = start > flow.at_rest;
  T dp(0);
  if (any(yields)) {
    const T high = select(yields, (start - flow.lowest) * T(1 / smaller(rates.normal, rates.shear)), T(1));
    dp = find_falling_root<BackStresses::halving>(yields, high, start, [&](const T& x) {
      const FlowStress<T> now = flow(x);
      const ValueAndSlope<T> reached = step.at(x, now).equivalent;
      return ValueAndSlope<T>{reached.value - now.value, reached.slope - now.slope};
    });
  }
  const PlaneAbout<T> end = step.at(dp, {larger(flow(dp).value, flow.lowest), T(0)});
  PlaneModes<T> whole = end.stress;
  for (int k = 0; k < law.back_stresses.rows; ++k) {
    T* const b = history + 1 + 3 * k;
    const T kept = BackStresses::keep(law.back_stresses.x[k], dp);
    auto term = PlaneModes<T>::load(b);
    term.add(T(law.back_stresses.y[k]) * end.multiplier, end.stress);
    PlaneModes<T> left{T(0), T(0), T(0)};
    left.add(kept, term);
    left.store(b);
    whole.add(T(1), left);
  }
  history[0] = history[0] + dp;
  whole.store(stress);
  const T elastic = T(-elasticity.poissons_ratio / elasticity.youngs_modulus) * (whole.sum - before);
  const T share = (T(1) + end.move) / (T(1) + T(rates.shear) * end.multiplier + end.move);
  return {elastic - T(0.5) * end.multiplier * end.stress.sum, share, secant};
}

}  // namespace percuss
