#pragma once
// J2 plasticity with a table of yield stress, and the rate dependence of Cowper and Symonds.

#include "kernels/material/rate_hardening.hpp"

namespace percuss {

/// Yield stress from the rows (equivalent plastic strain p, yield stress), straight between them. History: p.
struct TabulatedPlasticity {
  static constexpr const char* name = "tabulated_plasticity";
  using Constants = TabulatedPlasticity;
  double youngs_modulus = 0, poissons_ratio = 0;
  MaterialTable hardening;
  double cowper_symonds_rate = 0, cowper_symonds_exponent = 1;

  static constexpr auto keys() {
    using M = TabulatedPlasticity;
    return join_keys(with_elastic_keys<M>(
                         need("hardening", &M::hardening, KeyRange::positive, "-, pressure",
                              "Yield stress over equivalent plastic strain; level before the first and after the last "
                              "row. It may fall.")),
                     rate_keys<M>());
  }

  static constexpr HistoryScalar history_names[] = {HistoryScalar::equivalent_plastic_strain};
  static constexpr int history_count = 1;
  static constexpr bool takes_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  /// Static yield stress and its slope at p.
  template <class T>
  KOKKOS_INLINE_FUNCTION FlowStress<T> find_yield(const T& p) const {
    const auto row = hardening(p);
    return {row.y, row.slope};
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION auto start_flow(const T* history, const T& dt) const {
    return start_rate_flow(*this, history, dt);
  }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    return_by_isotropic_hardening(*this, step);
  }
};

}  // namespace percuss
