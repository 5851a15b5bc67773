#pragma once
// A material without strength: all of its stress comes from its equation of state.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// No deviatoric stress, no history.
struct Fluid {
  static constexpr const char* name = "fluid";
  using Constants = Fluid;

  static constexpr std::array<MaterialKey<Fluid>, 0> keys() { return {}; }

  static constexpr int history_count = 0;
  static constexpr bool takes_equation_of_state = true;
  static constexpr bool needs_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return {}; }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    step.stress = {T(0), T(0), T(0), T(0), T(0), T(0)};
    step.mu = T(0);
  }
};

}  // namespace percuss
