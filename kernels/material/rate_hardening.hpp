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

/// Flow stress over a step from p on, as a function of dp, of a material with isotropic hardening find_yield(p) and the
/// constants of Cowper and Symonds.
template <class T, class Material>
struct RateFlow {
  const Material& material;
  T p, dt;
  T at_rest;  // static, at p

  KOKKOS_INLINE_FUNCTION FlowStress<T> operator()(const T& dp) const {
    return CowperSymonds::apply(material.cowper_symonds_rate, material.cowper_symonds_exponent,
                                material.find_yield(p + dp), dp, dt);
  }
};

template <class T, class Material>
KOKKOS_INLINE_FUNCTION RateFlow<T, Material> start_rate_flow(const Material& material, const T* history, const T& dt) {
  return {material, history[0], dt, material.find_yield(history[0]).value};
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
