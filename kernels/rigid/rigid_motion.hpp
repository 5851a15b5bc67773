#pragma once
// The motion of one rigid body over a step: pure functions.
//
// The nodes of the body move from n to n+1 as central differences would move them under constraint forces along the
// lines between them (SHAKE). Of a rigid body that is the discrete Moser-Veselov scheme (Moser and Veselov, Commun.
// Math. Phys. 139, 1991; McLachlan and Zanna, Found. Comput. Math. 5, 2005; Hairer and Vilmart, J. Phys. A 39, 2006):
// second order, symplectic, reversible. It conserves the angular momentum of the nodes, sum m x(n) x v(n+1/2), and of a
// free body also L . I(n)^-1 L.
//
// The turn from n to n+1 is that of Cayley's formula with the vector q (of Gibbs), |q| = tan(angle / 2). A node at r
// from the centre has the mean velocity V + w x (r(n) + r(n+1)) / 2 with w = 2 q / dt: exactly what moves it.

#include <cmath>

#include "kernels/core/tensor.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// A rotation as a unit quaternion w + x i + y j + z k.
struct Orientation {
  double w = 1, x = 0, y = 0, z = 0;
};

KOKKOS_INLINE_FUNCTION Orientation operator*(const Orientation& a, const Orientation& b) {
  return {a.w * b.w - (a.x * b.x + a.y * b.y + a.z * b.z), a.w * b.x + b.w * a.x + (a.y * b.z - a.z * b.y),
          a.w * b.y + b.w * a.y + (a.z * b.x - a.x * b.z), a.w * b.z + b.w * a.z + (a.x * b.y - a.y * b.x)};
}

/// Scales an orientation to length one, so that the orientation of a body never drifts off the rotations.
KOKKOS_INLINE_FUNCTION Orientation normalize(const Orientation& a) {
  const double scale = 1 / std::sqrt(a.w * a.w + a.x * a.x + a.y * a.y + a.z * a.z);
  return {scale * a.w, scale * a.x, scale * a.y, scale * a.z};
}

KOKKOS_INLINE_FUNCTION Matrix3<double> find_rotation(const Orientation& a) {
  return {{{1 - 2 * (a.y * a.y + a.z * a.z), 2 * (a.x * a.y - a.w * a.z), 2 * (a.x * a.z + a.w * a.y)},
           {2 * (a.x * a.y + a.w * a.z), 1 - 2 * (a.z * a.z + a.x * a.x), 2 * (a.y * a.z - a.w * a.x)},
           {2 * (a.x * a.z - a.w * a.y), 2 * (a.y * a.z + a.w * a.x), 1 - 2 * (a.x * a.x + a.y * a.y)}}};
}

/// The orientation after the turn with Gibbs' vector q.
KOKKOS_INLINE_FUNCTION Orientation turn(const Orientation& orientation, const Vector3<double>& q) {
  return normalize(Orientation{1, q.x, q.y, q.z} * orientation);
}

/// Components of the spin, along the global axes, that are prescribed.
struct HeldSpin {
  bool held[3] = {false, false, false};
  double rate[3] = {0, 0, 0};  // where held [rad / time]
};

KOKKOS_INLINE_FUNCTION double get(const Vector3<double>& a, int k) { return k == 0 ? a.x : (k == 1 ? a.y : a.z); }
KOKKOS_INLINE_FUNCTION void set(Vector3<double>& a, int k, double value) {
  (k == 0 ? a.x : (k == 1 ? a.y : a.z)) = value;
}

/// Angular momentum of the nodes about the centre in the step that turns the body by q. inertia: at n.
KOKKOS_INLINE_FUNCTION Vector3<double> find_spin_momentum(const Symmetric3<double>& inertia, const Vector3<double>& q,
                                                          double dt) {
  const Vector3<double> iq = inertia * q;
  return (2 / (dt * (1 + dot(q, q)))) * (iq + cross(q, iq));
}

/// The turn q with this angular momentum, by Newton's method. Of held components the turn is given, and the momentum
/// does not count. Turns of less than about one radian a step are found.
KOKKOS_INLINE_FUNCTION Vector3<double> find_turn(const Symmetric3<double>& inertia, const Vector3<double>& momentum,
                                                 const HeldSpin& hold, double dt) {
  constexpr int most_iterations = 30;
  const Vector3<double> half = (0.5 * dt) * momentum;
  Vector3<double> q = solve(inertia, half);
  for (int k = 0; k < 3; ++k)
    if (hold.held[k]) set(q, k, 0.5 * dt * hold.rate[k]);
  const double enough = 1e-30;  // square of the relative change: the next one is round-off
  for (int i = 0; i < most_iterations; ++i) {
    const Vector3<double> iq = inertia * q;
    Vector3<double> f = iq + cross(q, iq) - (1 + dot(q, q)) * half;
    const Matrix3<double> outer{{half.x * q, half.y * q, half.z * q}};
    Matrix3<double> slope = full(inertia) + antisymmetric(q) * full(inertia) - antisymmetric(iq) - 2.0 * outer;
    for (int k = 0; k < 3; ++k) {
      if (!hold.held[k]) continue;
      slope.row[k] = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
      set(f, k, 0);
    }
    const Vector3<double> change = inverse(slope) * f;
    q = q - change;
    if (!(dot(change, change) > enough * dot(q, q))) break;
  }
  return q;
}

/// The inverse of the inertia among the rotations that are free; zero elsewhere.
KOKKOS_INLINE_FUNCTION Symmetric3<double> invert_free(const Symmetric3<double>& inertia, const bool (&held)[3]) {
  // With the held rows and columns those of the unit matrix the inverse has them too; then they go.
  Symmetric3<double> a = inertia;
  if (held[0]) a.xx = 1, a.xy = a.zx = 0;
  if (held[1]) a.yy = 1, a.xy = a.yz = 0;
  if (held[2]) a.zz = 1, a.yz = a.zx = 0;
  const Adjugate<double> adjugate = find_adjugate(a);
  Symmetric3<double> inverse = (1 / adjugate.determinant) * adjugate.matrix;
  if (held[0]) inverse.xx = 0;
  if (held[1]) inverse.yy = 0;
  if (held[2]) inverse.zz = 0;
  return inverse;
}

}  // namespace percuss
