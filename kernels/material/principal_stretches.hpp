#pragma once
// Hyperelasticity by principal stretches: stress and bound of waves of energies that are sums over the stretches.

#include "kernels/material/radial_return.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Advances U of the history and returns its axes.
template <class T>
KOKKOS_INLINE_FUNCTION PrincipalAxes<T> advance_principal_stretches(PointStep<T>& step) {
  const Symmetric3<T> u = advance_stretch(StretchHistory::load(step.history), step.motion);
  StretchHistory::store(u, step.history);
  return find_principal_axes(u);
}

/// What the directions i and j add to the tangent: the largest eigenvalue of [[c + s_j, c], [c, c + s_i]], by the
/// gradients L_ij and L_ji, c = (s_i l_j^2 - s_j l_i^2) / (l_i^2 - l_j^2) (Ogden, Non-linear Elastic Deformations,
/// section 6.1.4). s: Kirchhoff stress; slope: its derivative by ln l, for stretches that are equal.
template <class T>
KOKKOS_INLINE_FUNCTION T bound_shear_of_pair(const T (&stretch)[2], const ValueAndSlope<T> (&s)[2]) {
  constexpr double equal = 1e-5;  // difference of squares: the mean of the slopes is exact to its square
  const T a = stretch[0] * stretch[0], b = stretch[1] * stretch[1], difference = a - b;
  const T size = larger(difference, -difference);
  const auto apart = size > T(equal) * (a + b);
  const T by_slope = (s[0].slope + s[1].slope) / (T(2) * (a + b));
  const T quotient = select(apart, (s[0].value - s[1].value) / select(apart, difference, T(1)), by_slope);
  const T mean = T(0.5) * (s[0].value + s[1].value), half = T(0.5) * (s[0].value - s[1].value);
  const T c = T(0.5) * quotient * (a + b) - mean;
  return c + mean + square_root(c * c + half * half);
}

/// Sets the stress by the axes and its part of the bound of waves, mu; returns the largest slope, at least 0.
/// s: Kirchhoff stress of each direction as a function of its stretch, and its derivative by ln l; pressure: what all
/// have beside it. The tangent is that of s, of `pressure`, which the law adds to lambda, and minus the stress.
template <class T>
KOKKOS_INLINE_FUNCTION T set_principal_stress(PointStep<T>& step, const PrincipalAxes<T>& axes,
                                              const ValueAndSlope<T> (&s)[3], const T& pressure) {
  const T over_j = T(1) / step.motion.volume_ratio;
  ValueAndSlope<T> whole[3];
  T steepest(0), push(0);
  step.stress = {T(0), T(0), T(0), T(0), T(0), T(0)};
  for (int i = 0; i < 3; ++i) {
    whole[i] = {s[i].value + pressure, s[i].slope};
    const Vector3<T>& n = axes.direction[i];
    step.stress = step.stress + (over_j * whole[i].value) *
                                    Symmetric3<T>{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
    steepest = larger(steepest, s[i].slope);
    push = larger(push, -whole[i].value);
  }
  T bound = steepest + push;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    bound = larger(bound, bound_shear_of_pair<T>({axes.value[i], axes.value[j]}, {whole[i], whole[j]}));
  }
  step.mu = T(0.5) * over_j * bound;
  return steepest;
}

/// Advances a point of the energy sum_i w(l_i J^(-1/3)) + K/2 (J - 1)^2: sigma_i = (s_i - (s_1 + s_2 + s_3) / 3) / J +
/// K (J - 1), s = l w' of the isochoric stretch (Ogden, Proc. R. Soc. A 326, 565, 1972). find_term: s and its
/// derivative by ln l, of l. History: U.
template <class T, class FindTerm>
KOKKOS_INLINE_FUNCTION void advance_isochoric_stretches(PointStep<T>& step, double bulk_modulus,
                                                        const FindTerm& find_term) {
  const PrincipalAxes<T> axes = advance_principal_stretches(step);
  const T j = step.motion.volume_ratio, scale = power(j, -1.0 / 3.0);
  ValueAndSlope<T> s[3];
  for (int i = 0; i < 3; ++i) s[i] = find_term(scale * axes.value[i]);
  const T mean = T(1.0 / 3.0) * (s[0].value + s[1].value + s[2].value);
  const T steepest = set_principal_stress(step, axes, s, T(bulk_modulus) * j * (j - T(1)) - mean);
  step.lambda = T(bulk_modulus) * (T(2) * j - T(1)) - T(1.0 / 3.0) * steepest / j;
}

/// Terms mu_i and alpha_i: s(l) = sum mu_i l^alpha_i, and its derivative by ln l. terms: rows (alpha_i, mu_i).
template <class T>
KOKKOS_INLINE_FUNCTION ValueAndSlope<T> add_powers(const MaterialTable& terms, const T& stretch) {
  const T log_stretch = logarithm(stretch);
  ValueAndSlope<T> sum{T(0), T(0)};
  for (int i = 0; i < terms.rows; ++i) {
    const T term = T(terms.y[i]) * exponential(T(terms.x[i]) * log_stretch);
    sum.value = sum.value + term;
    sum.slope = sum.slope + T(terms.x[i]) * term;
  }
  return sum;
}

/// Shear modulus at rest of terms.
KOKKOS_INLINE_FUNCTION double find_shear_modulus(const MaterialTable& terms) {
  double twice = 0;
  for (int i = 0; i < terms.rows; ++i) twice += terms.x[i] * terms.y[i];
  return 0.5 * twice;
}

/// Most terms of a law.
inline constexpr int most_stretch_terms = 8;

/// What is wrong with terms; empty: nothing.
inline const char* find_fault_of(const MaterialTable& terms) {
  if (terms.rows > most_stretch_terms) return "more than 8 rows of terms";
  for (int i = 0; i < terms.rows; ++i) {
    if (terms.x[i] == 0) return "an exponent of terms that is 0";
  }
  return find_shear_modulus(terms) > 0 ? "" : "terms whose shear modulus, half the sum of mu alpha, is not positive";
}

}  // namespace percuss
