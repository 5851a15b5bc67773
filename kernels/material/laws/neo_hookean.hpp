#pragma once
// Compressible neo-Hookean hyperelasticity.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Stored energy mu/2 (tr B - 3) - mu ln J + lambda/2 (ln J)^2, so that sigma = (mu (B - I) + lambda ln J I) / J (Bonet
/// and Wood, Nonlinear Continuum Mechanics, section 6.4.3). History: U.
struct NeoHookean {
  static constexpr const char* name = "neo_hookean";
  static constexpr bool stores_energy = true;
  using Constants = NeoHookean;
  double youngs_modulus = 0, poissons_ratio = 0;

  static constexpr auto keys() { return with_elastic_keys<NeoHookean>(); }

  static constexpr int history_count = StretchHistory::count;
  static void start(double* history) { StretchHistory::start(history); }

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return find_lame_constants(youngs_modulus, poissons_ratio); }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    const LameConstants c = moduli();
    const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
    StretchHistory::store(u, step.history);
    const Symmetric3<T> b = find_square(u);
    const T j = step.motion.volume_ratio, over_j = T(1) / j, log_j = logarithm(j);
    step.stress = add_pressure((T(c.mu) * over_j) * b, (T(c.lambda) * log_j - T(c.mu)) * over_j);
    // lambda/J (tr d)^2 + 2 (mu - lambda ln J)/J |d|^2, and the stress itself on the gradient of the velocity
    const T stretch = bound_largest_eigenvalue(b);
    step.lambda = T(c.lambda) * over_j;
    step.mu = T(0.5) * over_j * larger(T(c.mu) * (T(1) + stretch) - T(c.lambda) * log_j, T(c.mu));
  }
};

}  // namespace percuss
