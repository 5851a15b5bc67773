#pragma once
// Rate dependence of Cowper and Symonds (Brown University report 28, 1957), which plasticity models may add.

#include "kernels/material/material_key.hpp"
#include "kernels/material/radial_return.hpp"

namespace percuss {

/// Flow stress at the plastic strain rate r: static flow stress times 1 + (r / D)^(1/q). D = 0: none.
struct CowperSymonds {
  /// The flow stress after dp in dt of the static one.
  template <class T>
  KOKKOS_INLINE_FUNCTION static FlowStress<T> apply(double rate, double exponent, const FlowStress<T>& at_rest,
                                                    const T& dp, const T& dt) {
    if (rate <= 0) return at_rest;
    const T strain = larger(dp, T(1e-300));
    const T more = power(strain / larger(T(rate) * dt, T(1e-300)), 1 / exponent);
    return {at_rest.value * (T(1) + more),
            at_rest.slope * (T(1) + more) + at_rest.value * more / (T(exponent) * strain)};
  }
};

/// The update of a material with isotropic hardening find_yield(p) and the constants of Cowper and Symonds; history[0]
/// is p.
template <class T, class Material>
KOKKOS_INLINE_FUNCTION void return_by_isotropic_hardening(const Material& m, PointStep<T>& step) {
  const LameConstants c = m.moduli();
  const double resistance = 3 * c.mu;
  const Trial<T> trial = find_trial(c, step.stress, step.motion.de);
  const T p = step.history[0];
  const T at_rest = m.find_yield(p).value;
  const auto flow = [&](const T& dp) {
    return CowperSymonds::apply(m.cowper_symonds_rate, m.cowper_symonds_exponent, m.find_yield(p + dp), dp,
                                step.motion.dt);
  };
  const T dp = find_plastic_increment(trial.von_mises, resistance, at_rest, flow);
  step.history[0] = p + dp;
  return_stress(trial, resistance, dp, larger(trial.von_mises - T(resistance) * dp, at_rest), step);
}

/// Their keys, for a struct of constants with the members cowper_symonds_rate and cowper_symonds_exponent.
template <class C>
constexpr std::array<MaterialKey<C>, 2> rate_keys() {
  return {may("cowper_symonds_rate", &C::cowper_symonds_rate, KeyRange::not_negative, "1 / time",
              "Plastic strain rate that doubles the flow stress; 0: it does not depend on the rate."),
          may("cowper_symonds_exponent", &C::cowper_symonds_exponent, KeyRange::positive, "-",
              "q in 1 + (rate / cowper_symonds_rate)^(1/q).")};
}

}  // namespace percuss
