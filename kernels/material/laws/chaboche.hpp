#pragma once
// J2 plasticity under cyclic loads: back stresses that saturate, and isotropic hardening or softening that does.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Terms of the back stress: rows of recovery rate gamma, ascending, and modulus C.
struct BackStresses {
  static constexpr int most = 4;
  static constexpr int halving = 8;  // the equations fall, but may bend (find_falling_root)

  /// What is left of a term over dp, with its implicit recovery.
  template <class T>
  KOKKOS_INLINE_FUNCTION static T keep(double gamma, const T& dp) {
    return T(1) / (T(1) + T(gamma) * dp);
  }

  /// K(dp) = sum C_k / (1 + gamma_k dp), and the derivative of K dp: by K dp the terms move along the flow.
  template <class T>
  KOKKOS_INLINE_FUNCTION static ValueAndSlope<T> find_modulus(const MaterialTable& terms, const T& dp) {
    ValueAndSlope<T> modulus{T(0), T(0)};
    for (int k = 0; k < terms.rows; ++k) {
      const T kept = keep(terms.x[k], dp);
      modulus.value = modulus.value + T(terms.y[k]) * kept;
      modulus.slope = modulus.slope + T(terms.y[k]) * kept * kept;
    }
    return modulus;
  }
};

/// Yield where the von Mises stress of s - a reaches yield_stress + Q (1 - exp(-b p)) + H p, p the equivalent plastic
/// strain. a is a sum of terms with da = (2/3) C dep - gamma a dp (Armstrong and Frederick, CEGB report RD/B/N731,
/// 1966; Chaboche, Int. J. Plasticity 5, 247, 1989). The step is that of backward Euler. History: p, then the terms,
/// each a deviator by xx, yy, zz, xy, yz, zx.
struct Chaboche {
  static constexpr const char* name = "chaboche";
  using Constants = Chaboche;
  double youngs_modulus = 0, poissons_ratio = 0;
  double yield_stress = 0;
  MaterialTable back_stresses;
  double cyclic_stress = 0, cyclic_rate = 0, hardening_modulus = 0;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = Chaboche;
    return join_keys(
        with_elastic_keys<M>(
            need("yield_stress", &M::yield_stress, KeyRange::positive, "pressure", "Uniaxial stress at first yield."),
            need("back_stresses", &M::back_stresses, KeyRange::positive, "-, pressure",
                 "Terms of the back stress: rates of recovery gamma, ascending and not negative, and moduli C. Each "
                 "term grows towards C / gamma; with gamma 0 it grows on. At most 4 rows."),
            may("cyclic_stress", &M::cyclic_stress, KeyRange::any, "pressure",
                "Q: how much the yield stress grows in the end, by Q (1 - exp(-b p)); negative: it falls."),
            may("cyclic_rate", &M::cyclic_rate, KeyRange::not_negative, "-", "b of the growth Q (1 - exp(-b p))."),
            may("hardening_modulus", &M::hardening_modulus, KeyRange::not_negative, "pressure",
                "Slope of the yield stress over equivalent plastic strain, beside that growth.")),
        rate_keys<M>());
  }
  const char* find_fault() const {
    if (back_stresses.rows > BackStresses::most) return "more than 4 rows of back_stresses";
    if (back_stresses.x[0] < 0) return "a rate of back_stresses that is negative";
    return yield_stress + cyclic_stress > 0 ? "" : "a sum of yield_stress and cyclic_stress that is not positive";
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1 + 6 * BackStresses::most;
  static constexpr int plane_history_count = 1 + 3 * BackStresses::most;  // of a layer of a shell
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Static radius of the yield surface and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const T left = T(cyclic_stress) * exponential(T(-cyclic_rate) * p);
    return {T(yield_stress + cyclic_stress) - left + T(hardening_modulus) * p,
            T(cyclic_rate) * left + T(hardening_modulus)};
  }

  template <class T>
  struct Flow : RateFlow<T, Chaboche> {
    T lowest;  // where the yield stress falls
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION Flow<T> start_flow(const T* history, const T& dt) const {
    return {start_rate_flow(*this, history, dt), T(cyclic_stress < 0 ? yield_stress + cyclic_stress : yield_stress)};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants c = moduli();
    T* const terms = step.history + 1;
    const ElasticTrial<T> trial = find_trial(c, step.stress, step.motion.de);
    const auto flow = start_flow(step.history, step.motion.dt);
    const T start = find_relative(trial, terms, T(0)).von_mises;
    const T dp = find_increment(c, trial, terms, start, flow);
    step.history[0] = step.history[0] + dp;
    // s and each term follow the direction of s - a at the end: flow strains by (3/2) dp relative / von Mises stress
    const Relative<T> relative = find_relative(trial, terms, dp);
    const Symmetric3<T> along = (dp / larger(relative.von_mises, T(1e-300))) * relative.stress;
    for (int k = 0; k < back_stresses.rows; ++k)
      store_term(BackStresses::keep(back_stresses.x[k], dp) * (load_term(terms, k) + T(back_stresses.y[k]) * along),
                 terms, k);
    step.stress = add_pressure(trial.deviator + T(-3 * c.mu) * along, trial.mean);
    const T fall = (T(3 * c.mu) + BackStresses::find_modulus(back_stresses, dp).value) * dp;
    const T after = relative.von_mises - fall, flow_stress = larger(after, flow.at_rest);
    const T ratio = after / larger(flow_stress, T(1e-300));
    step.plastic = {after / larger(relative.von_mises, T(1e-300)), flow_stress, smaller(ratio * ratio, T(1))};
  }

 private:
  /// The trial less what is left of the terms after dp, and its slope by dp.
  template <class T>
  struct Relative {
    Symmetric3<T> stress;
    T von_mises, slope;  // d von_mises / d dp
  };

  template <class T>
  KOKKOS_INLINE_FUNCTION static Symmetric3<T> load_term(const T* terms, int k) {
    const T* const a = terms + 6 * k;
    return {a[0], a[1], a[2], a[3], a[4], a[5]};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION static void store_term(const Symmetric3<T>& term, T* terms, int k) {
    T* const a = terms + 6 * k;
    a[0] = term.xx, a[1] = term.yy, a[2] = term.zz, a[3] = term.xy, a[4] = term.yz, a[5] = term.zx;
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION Relative<T> find_relative(const ElasticTrial<T>& trial, const T* terms, const T& dp) const {
    Symmetric3<T> stress = trial.deviator, slope{T(0), T(0), T(0), T(0), T(0), T(0)};
    for (int k = 0; k < back_stresses.rows; ++k) {
      const T kept = BackStresses::keep(back_stresses.x[k], dp);
      const Symmetric3<T> term = load_term(terms, k);
      stress = stress + (-kept) * term;
      slope = slope + (T(back_stresses.x[k]) * kept * kept) * term;
    }
    const T size = square_root(T(1.5) * contract(stress, stress));
    return {stress, size, T(1.5) * contract(stress, slope) / larger(size, T(1e-300))};
  }

  /// dp with |relative(dp)| - (3 mu + K(dp)) dp = flow(dp), 0 where the trial is elastic. The left side falls by 3 mu
  /// or more, since no term is above C / gamma.
  template <class T>
  KOKKOS_INLINE_FUNCTION T find_increment(const LameConstants& c, const ElasticTrial<T>& trial, const T* terms,
                                          const T& start, const Flow<T>& flow) const {
    const auto yields = start > flow.at_rest;
    if (!any(yields)) return T(0);
    const T high = select(yields, (start - flow.lowest) * T(1 / (3 * c.mu)), T(1));
    return find_falling_root<BackStresses::halving>(yields, high, start, [&](const T& dp) {
      const Relative<T> relative = find_relative(trial, terms, dp);
      const ValueAndSlope<T> modulus = BackStresses::find_modulus(back_stresses, dp);
      const FlowStress<T> now = flow(dp);
      return ValueAndSlope<T>{relative.von_mises - (T(3 * c.mu) + modulus.value) * dp - now.value,
                              relative.slope - T(3 * c.mu) - modulus.slope - now.slope};
    });
  }
};

}  // namespace percuss
