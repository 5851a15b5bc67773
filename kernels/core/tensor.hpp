#pragma once
// Small vectors and 3x3 matrices on any scalar: double, float or a SIMD pack.
//
// Plain aggregates with the operations that kinematics and materials need, written out so that a pack stays in
// registers. Symmetric tensors are stored as xx, yy, zz, xy, yz, zx throughout percuss.

#include "kernels/core/simd.hpp"

namespace percuss {

template <class T>
struct Vector3 {
  T x, y, z;
};

template <class T>
PERCUSS_FORCE_INLINE Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> operator*(const T& s, const Vector3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
PERCUSS_FORCE_INLINE T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
PERCUSS_FORCE_INLINE T norm(const Vector3<T>& a) {
  return square_root(dot(a, a));
}

/// A symmetric tensor: xx, yy, zz, xy, yz, zx.
template <class T>
struct Symmetric3 {
  T xx, yy, zz, xy, yz, zx;
};

template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> operator+(const Symmetric3<T>& a, const Symmetric3<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> operator*(const T& s, const Symmetric3<T>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}
template <class T>
PERCUSS_FORCE_INLINE T trace(const Symmetric3<T>& a) {
  return a.xx + a.yy + a.zz;
}
/// a : b, both off-diagonal halves counted.
template <class T>
PERCUSS_FORCE_INLINE T contract(const Symmetric3<T>& a, const Symmetric3<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + T(2) * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> operator*(const Symmetric3<T>& s, const Vector3<T>& a) {
  return {s.xx * a.x + s.xy * a.y + s.zx * a.z, s.xy * a.x + s.yy * a.y + s.yz * a.z,
          s.zx * a.x + s.yz * a.y + s.zz * a.z};
}
/// Adjugate and determinant: inverse(a) = adjugate / determinant.
template <class T>
struct Adjugate {
  Symmetric3<T> matrix;
  T determinant;
};
template <class T>
PERCUSS_FORCE_INLINE Adjugate<T> find_adjugate(const Symmetric3<T>& a) {
  const Symmetric3<T> c{a.yy * a.zz - a.yz * a.yz, a.xx * a.zz - a.zx * a.zx, a.xx * a.yy - a.xy * a.xy,
                        a.yz * a.zx - a.xy * a.zz, a.xy * a.zx - a.xx * a.yz, a.xy * a.yz - a.yy * a.zx};
  return {c, a.xx * c.xx + a.xy * c.xy + a.zx * c.zx};
}
/// inverse(a) b for a symmetric, well conditioned a.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> solve(const Symmetric3<T>& a, const Vector3<T>& b) {
  const Adjugate<T> adjugate = find_adjugate(a);
  return (T(1) / adjugate.determinant) * (adjugate.matrix * b);
}

/// A 3x3 matrix by rows.
template <class T>
struct Matrix3 {
  Vector3<T> row[3];
};

template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> operator+(const Matrix3<T>& a, const Matrix3<T>& b) {
  return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> operator-(const Matrix3<T>& a, const Matrix3<T>& b) {
  return {{a.row[0] - b.row[0], a.row[1] - b.row[1], a.row[2] - b.row[2]}};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> operator*(const T& s, const Matrix3<T>& a) {
  return {{s * a.row[0], s * a.row[1], s * a.row[2]}};
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> operator*(const Matrix3<T>& a, const Vector3<T>& b) {
  return {dot(a.row[0], b), dot(a.row[1], b), dot(a.row[2], b)};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> transpose(const Matrix3<T>& a) {
  return {{{a.row[0].x, a.row[1].x, a.row[2].x},
           {a.row[0].y, a.row[1].y, a.row[2].y},
           {a.row[0].z, a.row[1].z, a.row[2].z}}};
}
/// transpose(a) b.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> transpose_times(const Matrix3<T>& a, const Vector3<T>& b) {
  return b.x * a.row[0] + b.y * a.row[1] + b.z * a.row[2];
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> operator*(const Matrix3<T>& a, const Matrix3<T>& b) {
  return {{transpose_times(b, a.row[0]), transpose_times(b, a.row[1]), transpose_times(b, a.row[2])}};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> identity_matrix() {
  return {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}};
}
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> full(const Symmetric3<T>& a) {
  return {{{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}}};
}
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> symmetric_part(const Matrix3<T>& a) {
  const T half = T(0.5);
  return {a.row[0].x,
          a.row[1].y,
          a.row[2].z,
          half * (a.row[0].y + a.row[1].x),
          half * (a.row[1].z + a.row[2].y),
          half * (a.row[2].x + a.row[0].z)};
}
/// The antisymmetric matrix with axial vector w.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> antisymmetric(const Vector3<T>& w) {
  return {{{T(0), -w.z, w.y}, {w.z, T(0), -w.x}, {-w.y, w.x, T(0)}}};
}
template <class T>
PERCUSS_FORCE_INLINE T determinant(const Matrix3<T>& a) {
  return dot(a.row[0], cross(a.row[1], a.row[2]));
}
/// numerator inverse(a); a must not be singular.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> inverse(const Matrix3<T>& a, const T& numerator = T(1)) {
  const Vector3<T> c0 = cross(a.row[1], a.row[2]);
  const Vector3<T> c1 = cross(a.row[2], a.row[0]);
  const Vector3<T> c2 = cross(a.row[0], a.row[1]);
  const T scale = numerator / dot(a.row[0], c0);
  return scale * transpose(Matrix3<T>{{c0, c1, c2}});
}
/// a transpose(b), which is known to be symmetric.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> symmetric_product(const Matrix3<T>& a, const Matrix3<T>& b) {
  return {dot(a.row[0], b.row[0]), dot(a.row[1], b.row[1]), dot(a.row[2], b.row[2]),
          dot(a.row[0], b.row[1]), dot(a.row[1], b.row[2]), dot(a.row[2], b.row[0])};
}
/// q s transpose(q): the way back for an orthogonal q.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> push_forward(const Matrix3<T>& q, const Symmetric3<T>& s) {
  return symmetric_product(q * full(s), q);
}
/// transpose(q) s q: a symmetric tensor in the axes that the columns of q span.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> pull_back(const Matrix3<T>& q, const Symmetric3<T>& s) {
  return push_forward(transpose(q), s);
}

}  // namespace percuss
