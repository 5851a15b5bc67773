#pragma once
// Compressible hyperelasticity of foams by principal stretches.

#include "kernels/material/principal_stretches.hpp"

namespace percuss {

/// Stored energy sum_i mu_i / alpha_i (l1^alpha_i + l2^alpha_i + l3^alpha_i - 3 + (J^(-alpha_i beta) - 1) / beta), beta
/// = nu / (1 - 2 nu), l the principal stretches (Hill, Advances in Applied Mechanics 18, 1978; Storakers, J. Mech.
/// Phys. Solids 34, 125, 1986). A bar that is pulled has the lateral stretch l^-nu. History: U.
struct Hyperfoam {
  static constexpr const char* name = "hyperfoam";
  static constexpr bool stores_energy = true;
  using Constants = Hyperfoam;
  MaterialTable terms;
  double poissons_ratio = 0;

  static constexpr auto keys() {
    using H = Hyperfoam;
    return std::array{
        need(
            "terms", &H::terms, KeyRange::any, "-, pressure",
            "Exponents alpha, ascending, and their moduli mu, of the stored energy sum mu / alpha (l1^alpha + l2^alpha "
            "+ l3^alpha - 3 + (J^(-alpha beta) - 1) / beta), l the principal stretches; at most 8 rows."),
        may("poissons_ratio", &H::poissons_ratio, KeyRange::poissons_ratio, "-",
            "Poisson's ratio nu; beta = nu / (1 - 2 nu).")};
  }
  const char* find_fault() const {
    if (!(poissons_ratio > -1.0 / 3.0))
      return "a poissons_ratio that is not above -1/3 (the bulk modulus is not positive)";
    return find_fault_of(terms);
  }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION double find_beta() const { return poissons_ratio / (1 - 2 * poissons_ratio); }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    const double mu = find_shear_modulus(terms);
    return {2 * mu * find_beta(), mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_term(const T& stretch) const {
    return add_powers(terms, stretch);
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const PrincipalAxes<T> axes = advance_principal_stretches(step);
    const T j = step.motion.volume_ratio;
    ValueAndSlope<T> s[3];
    for (int i = 0; i < 3; ++i) s[i] = find_term(axes.value[i]);
    const ValueAndSlope<T> volume = add_powers(terms, power(j, -find_beta()));  // its slope is by ln J^-beta
    set_principal_stress(step, axes, s, -volume.value);
    step.lambda = T(find_beta()) * volume.slope / j;
  }
};

}  // namespace percuss
