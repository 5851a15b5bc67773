#pragma once
// Nearly incompressible hyperelasticity whose energy depends on the first invariant of the isochoric stretch and on J.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// First and second derivative by I1 of the energy W(I1) [stress].
template <class T>
struct EnergySlopes {
  T first, second;
};

/// Advances a point of the energy W(I1) + K/2 (J - 1)^2, I1 = tr(b), b = J^(-2/3) B: sigma = (2/J) W' dev(b) + K (J -
/// 1) I (Holzapfel, Nonlinear Solid Mechanics, section 6.5). start: moduli at rest; find_slopes: of I1. History: U.
///
/// Waves: the tangent has 2 W' (1 + the largest stretch of b) as neo-Hookean rubber, and (4/J) W'' (n . dev(b) n)^2,
/// where (n . A n)^2 <= 2/3 A : A of any A without trace.
template <class T, class FindSlopes>
KOKKOS_INLINE_FUNCTION void advance_by_first_invariant(PointStep<T>& step, const LameConstants& start,
                                                       const FindSlopes& find_slopes) {
  const double bulk_modulus = start.lambda + 2.0 / 3.0 * start.mu;
  const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
  StretchHistory::store(u, step.history);
  const T j = step.motion.volume_ratio, over_j = T(1) / j;
  const Symmetric3<T> b = power(j, -2.0 / 3.0) * find_square(u);
  const T first = trace(b);
  const EnergySlopes<T> w = find_slopes(first);
  const Symmetric3<T> deviator = add_pressure(b, T(-1.0 / 3.0) * first);
  step.stress = add_pressure((T(2) * over_j * w.first) * deviator, T(bulk_modulus) * (j - T(1)));
  const T mu = larger(w.first, T(0)) * (T(1) + bound_largest_eigenvalue(b)) +
               T(4.0 / 3.0) * larger(w.second, T(0)) * contract(deviator, deviator);
  step.mu = over_j * mu;
  step.lambda = T(bulk_modulus) * larger(j, T(1)) - T(2.0 / 3.0 * start.mu) * over_j;
}

}  // namespace percuss
