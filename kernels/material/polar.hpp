#pragma once
// Rotation and stretch of a material point, step by step (Flanagan and Taylor 1987).
//
// F = V R with V symmetric. The stretch advances through the exact incremental deformation of a step with a constant
// velocity gradient at the mid-point, and the rotation by the Cayley transform (their equation 16) that keeps V
// symmetric at the end of the step, where they integrate the spin that keeps it so. A rigid rotation leaves V's
// eigenvalues as they are.

#include "kernels/core/long_sum.hpp"
#include "kernels/core/short_scalar.hpp"
#include "kernels/core/tensor.hpp"

namespace percuss {

template <class T>
struct Polar {
  Matrix3<T> rotation;    // R, orthogonal
  Symmetric3<T> stretch;  // V
};
/// In float with the rest of R. No member of no size does without it in double: behind one at the end of a member nvcc
/// 13.0 takes the wrong place for the members that follow.
template <class T>
requires is_short<T>
struct Polar<T> {
  Matrix3<T> rotation;
  Symmetric3<T> stretch;
  Matrix3<T> rotation_rest{};
};

/// The rotation of the quaternion (d, n) of any length: exactly orthogonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation(const T& d, const Vector3<T>& n) {
  const T scale = T(2) / (d * d + dot(n, n));
  const Vector3<T> sn = scale * n, t = d * sn;
  return {{{T(1) - (sn.y * n.y + sn.z * n.z), sn.x * n.y - t.z, sn.x * n.z + t.y},
           {sn.x * n.y + t.z, T(1) - (sn.x * n.x + sn.z * n.z), sn.y * n.z - t.x},
           {sn.x * n.z - t.y, sn.y * n.z + t.x, T(1) - (sn.x * n.x + sn.y * n.y)}}};
}

/// The rotation less the identity, to the last digit however small the angle.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_turn(const T& d, const Vector3<T>& n) {
  const T scale = T(2) / (d * d + dot(n, n));
  const Vector3<T> sn = scale * n, t = d * sn;
  return {{{-(sn.y * n.y + sn.z * n.z), sn.x * n.y - t.z, sn.x * n.z + t.y},
           {sn.x * n.y + t.z, -(sn.x * n.x + sn.z * n.z), sn.y * n.z - t.x},
           {sn.x * n.z - t.y, sn.y * n.z + t.x, -(sn.x * n.x + sn.y * n.y)}}};
}

/// Rotation by the constant spin w over dt: (I - dt/2 W)^-1 (I + dt/2 W), exactly orthogonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation_increment(const Vector3<T>& w, const T& dt) {
  return find_rotation(T(1), (number<T>(0.5) * dt) * w);
}

/// A rotation by its axis and angle: that of the quaternion (d, n) of any length.
template <class T>
struct Quaternion {
  T d;
  Vector3<T> n;
};

/// The rotation Q that is left when m = V Q is freed of a symmetric V, for a Q that turns by less than a right angle.
///
/// With Q = (I - H)^-1 (I + H) the antisymmetric part of m transpose(Q) vanishes if
/// m - transpose(m) = H s + s H - H (m - transpose(m)) H, s = m + transpose(m); with axial vectors h of H and a of
/// m - transpose(m) and P = tr(s) I - s, P h + c h = a with the scalar c = h . a. With g = inverse(P) a this is
/// c = g . a (1 - |g|^2 + ...): (1 + |g|^2) / (1 + 2 |g|^2) has the first three terms if V is isotropic, two if not.
template <class T>
PERCUSS_FORCE_INLINE Quaternion<T> find_rotation_factor(const Matrix3<T>& m, const Vector3<T>& a) {
  const T two = T(2);
  Symmetric3<T> p{two * (m.row[1].y + m.row[2].z), two * (m.row[2].z + m.row[0].x), two * (m.row[0].x + m.row[1].y),
                  -(m.row[0].y + m.row[1].x),      -(m.row[1].z + m.row[2].y),      -(m.row[2].x + m.row[0].z)};
  const Adjugate<T> first = find_adjugate(p);
  const Vector3<T> g = first.matrix * a;  // times the determinant
  const T g_square = dot(g, g), square = first.determinant * first.determinant;
  const T c = dot(g, a) * (square + g_square) / (first.determinant * (square + two * g_square));
  p.xx = p.xx + c;
  p.yy = p.yy + c;
  p.zz = p.zz + c;
  const Adjugate<T> second = find_adjugate(p);
  return {second.determinant, second.matrix * a};
}

/// Axial vector of m - transpose(m).
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_twist(const Matrix3<T>& m) {
  return {m.row[2].y - m.row[1].z, m.row[0].z - m.row[2].x, m.row[1].x - m.row[0].y};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation_factor(const Matrix3<T>& m) {
  const Quaternion<T> q = find_rotation_factor(m, find_twist(m));
  return find_rotation(q.d, q.n);
}

/// v turned by the turn of a step.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> turn_along(const Matrix3<T>& turn, const Vector3<T>& v) {
  if constexpr (is_short<T>)
    return v + turn * v;
  else
    return turn * v;
}

/// (I - a)^-1 (I + a) - I, to the last digit of a small a: with the cofactors c_i of I - a by columns, whose
/// determinant is (I - a)_i . c_i for each i, it is 2 / det times the columns c_i with a_i . c_i on the diagonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_deformation_increment(const Matrix3<T>& a) {
  const Matrix3<T> r = identity_matrix<T>() - a;
  const Vector3<T> c0 = cross(r.row[1], r.row[2]), c1 = cross(r.row[2], r.row[0]), c2 = cross(r.row[0], r.row[1]);
  const T own = dot(a.row[0], c0);
  const T scale = T(2) / (c0.x - own);
  return scale * Matrix3<T>{{{own, c1.x, c2.x}, {c0.y, dot(a.row[1], c1), c2.y}, {c0.z, c1.z, dot(a.row[2], c2)}}};
}

/// transpose(f)^-1 of the step, f = (I - dt/2 L)^-1 (I + dt/2 L), in float less the identity (turn_along()): what takes
/// a covector of n, such as a gradient, along to n+1.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_force_increment(const Matrix3<T>& l, const T& dt) {
  const Matrix3<T> a = (number<T>(-0.5) * dt) * transpose(l);
  if constexpr (is_short<T>) {
    return find_deformation_increment(a);
  } else {
    const Matrix3<T> one = identity_matrix<T>();
    return inverse(one - a, T(2)) - one;
  }
}

/// As advance_polar() in single precision, which would lose small increments of 1: increments are kept apart from their
/// sums, and the digits that R does not hold go to its remainder.
template <class T>
PERCUSS_FORCE_INLINE void advance_short_polar(const Matrix3<T>& l, const T& dt, Polar<T>& polar, Matrix3<T>& turn) {
  const Matrix3<T> grown = find_deformation_increment((number<T>(0.5) * dt) * l) * full(polar.stretch);
  const Matrix3<T> stretched = full(polar.stretch) + grown;
  const Quaternion<T> q = find_rotation_factor(stretched, find_twist(grown));
  turn = find_turn(q.d, q.n);
  add_to(polar.rotation, polar.rotation_rest, turn * polar.rotation);
  polar.stretch = symmetric_product(stretched, identity_matrix<T>() + turn);
}

/// Advances R and V from n to n+1, in place, with the velocity gradient l of the mid-point. turn: out, the rotation
/// increment: R(n+1) = turn R(n), or (I + turn) R(n) in float (turn_along()).
template <class T>
PERCUSS_FORCE_INLINE void advance_polar(const Matrix3<T>& l, const T& dt, Polar<T>& polar, Matrix3<T>& turn) {
  // x(n+1) - x(n) = dt L (x(n) + x(n+1)) / 2, hence F(n+1) = f F(n) with f = (I - dt/2 L)^-1 (I + dt/2 L).
  if constexpr (is_short<T>) {
    advance_short_polar(l, dt, polar, turn);
  } else {
    const Matrix3<T> one = identity_matrix<T>();
    const Matrix3<T> f = inverse(one - (number<T>(0.5) * dt) * l, T(2)) - one;
    const Matrix3<T> stretched = f * full(polar.stretch);
    turn = find_rotation_factor(stretched);
    polar.rotation = turn * polar.rotation;
    polar.stretch = symmetric_product(stretched, turn);
  }
}

/// Upper bound of the largest eigenvalue of a symmetric tensor, without a root: the largest sum of a row (Gershgorin),
/// exact if the tensor is diagonal.
template <class T>
PERCUSS_FORCE_INLINE T bound_by_rows(const Symmetric3<T>& g) {
  const T xy = larger(g.xy, T(0) - g.xy), yz = larger(g.yz, T(0) - g.yz), zx = larger(g.zx, T(0) - g.zx);
  return larger(larger(g.xx + xy + zx, g.yy + xy + yz), g.zz + yz + zx);
}

/// Upper bound of the largest eigenvalue of a symmetric tensor: tr/3 + sqrt(2/3) |dev|, exact if the others are equal.
template <class T>
PERCUSS_FORCE_INLINE T bound_largest_eigenvalue(const Symmetric3<T>& g) {
  const T mean = number<T>(1.0 / 3.0) * trace(g);
  const Symmetric3<T> deviator{g.xx - mean, g.yy - mean, g.zz - mean, g.xy, g.yz, g.zx};
  return mean + square_root(number<T>(2.0 / 3.0) * contract(deviator, deviator));
}

}  // namespace percuss
