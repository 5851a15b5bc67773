#pragma once
// A material without strength: its pressure comes from its equation of state, its deviatoric stress from its viscosity.

#include "kernels/material/radial_return.hpp"

namespace percuss {

/// Newtonian: deviatoric stress 2 eta e', e' the deviator of the rate of deformation. No history.
struct Fluid {
  static constexpr const char* name = "fluid";
  using Constants = Fluid;
  double viscosity = 0;

  static constexpr auto keys() {
    return std::array{may("viscosity", &Fluid::viscosity, KeyRange::not_negative, "pressure x time",
                          "Dynamic viscosity eta: the deviatoric stress is 2 eta times the deviatoric rate.")};
  }

  static constexpr int history_count = 0;
  static constexpr bool takes_equation_of_state = true;
  static constexpr bool needs_equation_of_state = true;

  KOKKOS_INLINE_FUNCTION LameConstants moduli() const { return {}; }

  template <class T>
  KOKKOS_INLINE_FUNCTION void update(PointStep<T>& step) const {
    step.stress = {T(0), T(0), T(0), T(0), T(0), T(0)};
    step.mu = T(0);
    if (!(viscosity > 0)) return;
    constexpr double least_dt = 1e-300;  // of the evaluation of the start, which has no step
    const T per_time = select(step.motion.dt > T(0), T(2 * viscosity) / larger(step.motion.dt, T(least_dt)), T(0));
    const Symmetric3<T>& de = step.motion.de;
    step.stress = per_time * add_pressure(de, T(-1.0 / 3.0) * trace(de));
    // The rate is that of half a step before: with the eigenvalues w^2 of the stiffness and g of the viscosity over the
    // mass, central differences are stable for w^2 dt^2 / 4 + g dt / 2 <= 1, as with the stiffness w^2 + 2 g / dt.
    step.mu = per_time;
  }
};

}  // namespace percuss
