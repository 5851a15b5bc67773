#pragma once
// Ogden's hyperelasticity, nearly incompressible.

#include "kernels/material/principal_stretches.hpp"

namespace percuss {

/// Stored energy sum_i mu_i / alpha_i (b1^alpha_i + b2^alpha_i + b3^alpha_i - 3) + K/2 (J - 1)^2 with the principal
/// stretches b = J^(-1/3) l (Ogden, Proc. R. Soc. A 326, 565, 1972). History: U.
struct Ogden {
  static constexpr const char* name = "ogden";
  static constexpr bool stores_energy = true;
  using Constants = Ogden;
  MaterialTable terms;
  double bulk_modulus = 0;

  static constexpr auto keys() {
    using O = Ogden;
    return std::array{
        need("terms", &O::terms, KeyRange::any, "-, pressure",
             "Exponents alpha, ascending, and their moduli mu, of the stored energy sum mu / alpha (b1^alpha + "
             "b2^alpha + b3^alpha - 3) + bulk_modulus (J - 1)^2 / 2, b = J^(-1/3) times the principal stretches; at "
             "most 8 rows."),
        need("bulk_modulus", &O::bulk_modulus, KeyRange::positive, "pressure", "Bulk modulus.")};
  }
  const char* find_fault() const { return find_fault_of(terms); }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const {
    const double mu = find_shear_modulus(terms);
    return {bulk_modulus - 2.0 / 3.0 * mu, mu};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION ValueAndSlope<T> find_term(const T& stretch) const {
    return add_powers(terms, stretch);
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    advance_isochoric_stretches(step, bulk_modulus, [this](const T& stretch) { return find_term(stretch); });
  }
};

}  // namespace percuss
