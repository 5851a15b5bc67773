#pragma once
// Hourglass control of the mean-quadrature hexahedron after Flanagan and Belytschko (1981), in modal form.
//
// The hourglass rate of mode h (4 to 7) is u_h = v_h - L a_h: what is left of the mode when the mean velocity gradient
// is taken out. Its generalised force Q_h is conjugate to u_h, so the power is sum_h Q_h . u_h.

#include "kernels/element/modes.hpp"

namespace percuss {

/// Four generalised hourglass forces or rates, modes 4 to 7.
template <class T>
struct HourglassModes {
  Vector3<T> mode[4];
};

/// u_h = v_h - L a_h with the geometry of the mid-point.
template <class T>
KOKKOS_INLINE_FUNCTION HourglassModes<T> find_hourglass_rates(const VectorModes<T>& v, const VectorModes<T>& a,
                                                              const Matrix3<T>& l) {
  HourglassModes<T> u;
  for (int h = 0; h < 4; ++h) u.mode[h] = v[4 + h] - l * a[4 + h];
  return u;
}

/// Power sum_h Q_h . u_h.
template <class T>
KOKKOS_INLINE_FUNCTION T find_power(const HourglassModes<T>& q, const HourglassModes<T>& u) {
  return dot(q.mode[0], u.mode[0]) + dot(q.mode[1], u.mode[1]) + dot(q.mode[2], u.mode[2]) + dot(q.mode[3], u.mode[3]);
}

/// kappa of the stiffness form Q_dot = kappa u in the unrotated frame: (k/8) 2 mu (B:B / V), `coefficient` being k.
template <class T>
KOKKOS_INLINE_FUNCTION T find_hourglass_stiffness(const T& gradient_square, const T& volume, double mu,
                                                  double coefficient) {
  return T(coefficient * mu / 4) * gradient_square / volume;
}

/// Square of the angular frequency of an hourglass mode under the stiffness form with k = 1: 16 mu B:B / (m V).
template <class T>
KOKKOS_INLINE_FUNCTION T find_hourglass_frequency_square(const T& gradient_square, const T& volume, const T& mass,
                                                         double mu) {
  return T(16 * mu) * gradient_square / (mass * volume);
}

/// How much larger than on a parallelepiped the stiffest hourglass pattern is: a bound of the largest eigenvalue of
/// gamma_h . gamma_k / 8, gamma_h = phi_h - sum_j a_jh B_j / V, from the norms of its three terms. 1 without
/// distortion.
template <class T>
KOKKOS_INLINE_FUNCTION T find_hourglass_magnification(const VectorModes<T>& a, const VolumeGradient<T>& b,
                                                      const T& largest_gradient) {
  const T a_square = dot(a[4], a[4]) + dot(a[5], a[5]) + dot(a[6], a[6]) + dot(a[7], a[7]);
  const T b_square = dot(b[4], b[4]) + dot(b[5], b[5]) + dot(b[6], b[6]);
  const T inverse_volume = T(1) / b.volume;
  return T(1) + inverse_volume * (T(1.0 / 32) * square_root(a_square * b_square) +
                                  T(1.0 / 8) * inverse_volume * largest_gradient * a_square);
}

}  // namespace percuss
