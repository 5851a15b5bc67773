#pragma once
// A vector of three doubles for the geometry of contact: points relative to a local origin, displacements, normals.

#include <Kokkos_Core.hpp>

#include <cmath>

#include "kernels/core/views.hpp"

namespace percuss {

struct Vector3 {
  double x = 0, y = 0, z = 0;
};

KOKKOS_INLINE_FUNCTION Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
KOKKOS_INLINE_FUNCTION Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
KOKKOS_INLINE_FUNCTION Vector3 operator-(const Vector3& a) { return {-a.x, -a.y, -a.z}; }
KOKKOS_INLINE_FUNCTION Vector3 operator*(double s, const Vector3& a) { return {s * a.x, s * a.y, s * a.z}; }

KOKKOS_INLINE_FUNCTION double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

KOKKOS_INLINE_FUNCTION Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

KOKKOS_INLINE_FUNCTION double norm(const Vector3& a) { return std::sqrt(dot(a, a)); }

/// a / |a|; the zero vector stays zero.
KOKKOS_INLINE_FUNCTION Vector3 normalize(const Vector3& a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : Vector3{};
}

/// Largest of the absolute components.
KOKKOS_INLINE_FUNCTION double max_component(const Vector3& a) {
  const double x = a.x < 0 ? -a.x : a.x, y = a.y < 0 ? -a.y : a.y, z = a.z < 0 ? -a.z : a.z;
  const double xy = x > y ? x : y;
  return xy > z ? xy : z;
}

/// Row `i` of node data.
template <class Rows>
KOKKOS_INLINE_FUNCTION Vector3 load_row(const Rows& rows, int i) {
  return {rows(i, 0), rows(i, 1), rows(i, 2)};
}

template <class Rows>
KOKKOS_INLINE_FUNCTION void store_row(const Rows& rows, int i, const Vector3& a) {
  rows(i, 0) = a.x;
  rows(i, 1) = a.y;
  rows(i, 2) = a.z;
}

/// A 3 x 3 matrix, row by row.
struct Matrix3 {
  double m[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
};

KOKKOS_INLINE_FUNCTION Vector3 operator*(const Matrix3& a, const Vector3& b) {
  return {a.m[0][0] * b.x + a.m[0][1] * b.y + a.m[0][2] * b.z, a.m[1][0] * b.x + a.m[1][1] * b.y + a.m[1][2] * b.z,
          a.m[2][0] * b.x + a.m[2][1] * b.y + a.m[2][2] * b.z};
}

/// Inverse of a symmetric positive definite matrix, given its upper triangle; zero if it is singular.
KOKKOS_INLINE_FUNCTION Matrix3 invert_symmetric(const Matrix3& a) {
  const double c00 = a.m[1][1] * a.m[2][2] - a.m[1][2] * a.m[1][2];
  const double c01 = a.m[0][2] * a.m[1][2] - a.m[0][1] * a.m[2][2];
  const double c02 = a.m[0][1] * a.m[1][2] - a.m[0][2] * a.m[1][1];
  const double c11 = a.m[0][0] * a.m[2][2] - a.m[0][2] * a.m[0][2];
  const double c12 = a.m[0][1] * a.m[0][2] - a.m[0][0] * a.m[1][2];
  const double c22 = a.m[0][0] * a.m[1][1] - a.m[0][1] * a.m[0][1];
  const double determinant = a.m[0][0] * c00 + a.m[0][1] * c01 + a.m[0][2] * c02;
  if (!(determinant > 0)) return {};
  const double s = 1 / determinant;
  return {{{s * c00, s * c01, s * c02}, {s * c01, s * c11, s * c12}, {s * c02, s * c12, s * c22}}};
}

}  // namespace percuss
