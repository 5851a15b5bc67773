#pragma once
// Hourglass control of the mean-quadrature hexahedron after Flanagan and Belytschko (1981), in modal form.
//
// The hourglass rate of mode h (4 to 7) is u_h = v_h - L a_h: what is left of the mode when the mean velocity gradient
// is taken out. Its generalised force Q_h is conjugate to u_h, so the power is sum_h Q_h . u_h.

#include "kernels/element/hex8/modes.hpp"

namespace percuss {

/// Four generalised hourglass forces or rates, modes 4 to 7.
template <class T>
struct HourglassModes {
  Vector3<T> mode[4];
};

/// u_h = v_h - L a_h with the geometry of the mid-point.
template <class T>
PERCUSS_FORCE_INLINE HourglassModes<T> find_hourglass_rates(const VectorModes<T>& v, const VectorModes<T>& a,
                                                            const Matrix3<T>& l) {
  HourglassModes<T> u;
  for (int h = 0; h < 4; ++h) u.mode[h] = v[4 + h] - l * a[4 + h];
  return u;
}

/// Power sum_h Q_h . u_h.
template <class T>
PERCUSS_FORCE_INLINE T find_power(const HourglassModes<T>& q, const HourglassModes<T>& u) {
  return dot(q.mode[0], u.mode[0]) + dot(q.mode[1], u.mode[1]) + dot(q.mode[2], u.mode[2]) + dot(q.mode[3], u.mode[3]);
}

/// kappa of the stiffness form Q_dot = kappa u in the unrotated frame: (k/8) 2 mu (B:B / V), `coefficient` being k.
template <class T>
PERCUSS_FORCE_INLINE T find_hourglass_stiffness(const T& gradient_square, const T& volume, double mu,
                                                double coefficient) {
  return number<T>(coefficient * mu / 4) * gradient_square * (T(1) / volume);
}

/// eta of the viscous form Q = eta u: the share k (`coefficient`) of the critical damping of an hourglass mode that has
/// the stiffness form with k = 1, whose omega_h^2 = 64 kappa / m = 16 mu B:B / (m V).
template <class T>
PERCUSS_FORCE_INLINE T find_hourglass_viscosity(const T& gradient_square, const T& volume, const T& mass, double mu,
                                                double coefficient) {
  return number<T>(coefficient / 8) * square_root(number<T>(mu) * mass * gradient_square / volume);
}

/// Work of a step by the trapezoid: (Q(n) + Q(n+1)) . u dt / 2, from the sum of both.
template <class T>
PERCUSS_FORCE_INLINE T find_hourglass_work(const HourglassModes<T>& sum, const HourglassModes<T>& u, const T& dt) {
  return number<T>(0.5) * dt * find_power(sum, u);
}

}  // namespace percuss
