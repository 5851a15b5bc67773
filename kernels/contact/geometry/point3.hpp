#pragma once
// Vectors in double for the geometry of contact: points relative to a local origin, displacements, normals.

#include <cmath>

#include "kernels/core/tensor.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

using Point3 = Vector3<double>;

KOKKOS_INLINE_FUNCTION Point3 operator-(const Point3& a) { return {-a.x, -a.y, -a.z}; }

/// a / |a|; the zero vector stays zero.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> normalize(const Vector3<T>& a) {
  const T length = norm(a), zero(0), one(1);
  const auto has_length = length > zero;
  const T scale = one / select(has_length, length, one);
  return {select(has_length, scale * a.x, zero), select(has_length, scale * a.y, zero),
          select(has_length, scale * a.z, zero)};
}

/// Largest of the absolute components.
KOKKOS_INLINE_FUNCTION double max_component(const Point3& a) {
  const double x = a.x < 0 ? -a.x : a.x, y = a.y < 0 ? -a.y : a.y, z = a.z < 0 ? -a.z : a.z;
  const double xy = x > y ? x : y;
  return xy > z ? xy : z;
}

/// Row `i` of node data.
template <class Rows>
KOKKOS_INLINE_FUNCTION Point3 load_row(const Rows& rows, int i) {
  return {rows(i, 0), rows(i, 1), rows(i, 2)};
}

template <class Rows>
KOKKOS_INLINE_FUNCTION void store_row(const Rows& rows, int i, const Point3& a) {
  rows(i, 0) = a.x;
  rows(i, 1) = a.y;
  rows(i, 2) = a.z;
}

/// Inverse of a symmetric positive definite matrix; zero if it is singular.
KOKKOS_INLINE_FUNCTION Symmetric3<double> invert(const Symmetric3<double>& a) {
  const double xx = a.yy * a.zz - a.yz * a.yz, xy = a.yz * a.zx - a.xy * a.zz, zx = a.xy * a.yz - a.yy * a.zx;
  const double yy = a.xx * a.zz - a.zx * a.zx, yz = a.xy * a.zx - a.xx * a.yz, zz = a.xx * a.yy - a.xy * a.xy;
  const double determinant = a.xx * xx + a.xy * xy + a.zx * zx;
  if (!(determinant > 0)) return {};
  const double s = 1 / determinant;
  return {s * xx, s * yy, s * zz, s * xy, s * yz, s * zx};
}

}  // namespace percuss
