#pragma once
// The eight-node hexahedron in its eight modes (a Walsh-Hadamard transform of the corner values).
//
// With xi, eta, zeta = +-1 at the corners, mode m of a corner quantity u is u_m = sum_I phi_m(I) u_I with
// phi = {1, xi, eta, zeta, eta zeta, zeta xi, xi eta, xi eta zeta}. In these modes the mean-quadrature element of
// Flanagan and Belytschko (1981) needs about half the operations of the corner form: the volume derivative has six
// non-zero modes, and modes 4 to 7 are their hourglass base vectors.

#include "kernels/core/short_scalar.hpp"

namespace percuss {

/// Modes of one scalar corner quantity; u[8] in Exodus corner order is overwritten by its modes 0 to 7.
template <class T>
PERCUSS_FORCE_INLINE void to_modes(T (&u)[8]) {
  // Corners (xi, eta, zeta): 0 ---, 1 +--, 2 ++-, 3 -+-, 4 --+, 5 +-+, 6 +++, 7 -++. First xi, then eta, then zeta.
  const T s01 = u[0] + u[1], d01 = u[1] - u[0];
  const T s32 = u[3] + u[2], d32 = u[2] - u[3];
  const T s45 = u[4] + u[5], d45 = u[5] - u[4];
  const T s76 = u[7] + u[6], d76 = u[6] - u[7];
  const T low = s01 + s32, low_eta = s32 - s01, low_xi = d01 + d32, low_xi_eta = d32 - d01;
  const T top = s45 + s76, top_eta = s76 - s45, top_xi = d45 + d76, top_xi_eta = d76 - d45;
  u[0] = low + top;
  u[1] = low_xi + top_xi;
  u[2] = low_eta + top_eta;
  u[3] = top - low;
  u[4] = top_eta - low_eta;
  u[5] = top_xi - low_xi;
  u[6] = low_xi_eta + top_xi_eta;
  u[7] = top_xi_eta - low_xi_eta;
}

/// Corner values u_I = sum_m phi_m(I) f_m, the transpose of to_modes (8 times its inverse); f[8] is overwritten.
template <class T>
PERCUSS_FORCE_INLINE void to_corners(T (&f)[8]) {
  const T low = f[0] - f[3], top = f[0] + f[3];
  const T low_xi = f[1] - f[5], top_xi = f[1] + f[5];
  const T low_eta = f[2] - f[4], top_eta = f[2] + f[4];
  const T low_xi_eta = f[6] - f[7], top_xi_eta = f[6] + f[7];
  const T a = low - low_eta, b = low + low_eta, c = low_xi - low_xi_eta, d = low_xi + low_xi_eta;
  const T e = top - top_eta, g = top + top_eta, h = top_xi - top_xi_eta, k = top_xi + top_xi_eta;
  f[0] = a - c;
  f[1] = a + c;
  f[2] = b + d;
  f[3] = b - d;
  f[4] = e - h;
  f[5] = e + h;
  f[6] = g + k;
  f[7] = g - k;
}

/// Modes 1 to 7 of a vector corner quantity (mode 0, the sum, is never needed): mode[m - 1].
template <class T>
struct VectorModes {
  Vector3<T> mode[7];
  PERCUSS_FORCE_INLINE const Vector3<T>& operator[](int m) const { return mode[m - 1]; }
  PERCUSS_FORCE_INLINE Vector3<T>& operator[](int m) { return mode[m - 1]; }
};

/// The modes of the volume derivative: B_iI = dV/dx_iI = sum_m phi_m(I) b_im / 64, and the volume itself.
template <class T>
struct VolumeGradient {
  Vector3<T> mode[6];  // b_1 to b_6; b_7 is zero
  T volume;
  PERCUSS_FORCE_INLINE const Vector3<T>& operator[](int m) const { return mode[m - 1]; }
  PERCUSS_FORCE_INLINE Vector3<T>& operator[](int m) { return mode[m - 1]; }
};

/// Exact volume and its exact derivative (Flanagan and Belytschko 1981, their equations 16 to 18 and 79, in modes).
template <class T>
PERCUSS_FORCE_INLINE VolumeGradient<T> find_volume_gradient(const VectorModes<T>& a) {
  const T third = number<T>(1.0 / 3.0);
  VolumeGradient<T> b;
  const Vector3<T> c4 = third * a[4], c5 = third * a[5], c6 = third * a[6];
  b[1] = cross(a[2], a[3]) + cross(c6, a[5]);
  b[2] = cross(a[3], a[1]) + cross(c4, a[6]);
  b[3] = cross(a[1], a[2]) + cross(c5, a[4]);
  b[4] = cross(a[3], c5) + cross(c6, a[2]);
  b[5] = cross(a[1], c6) + cross(c4, a[3]);
  b[6] = cross(c5, a[1]) + cross(a[2], c4);
  b.volume = number<T>(1.0 / 64.0) * (dot(a[1], b[1]) + dot(a[4], b[4]));
  return b;
}

/// L_ij = (1/V) sum_I v_iI B_jI, the mean velocity gradient; exactly zero for a uniform velocity.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_velocity_gradient(const VectorModes<T>& v, const VolumeGradient<T>& b) {
  const T scale = T(1) / (T(64) * b.volume);
  Matrix3<T> l{{v[1].x * b[1], v[1].y * b[1], v[1].z * b[1]}};
  for (int m = 2; m <= 6; ++m) {
    l.row[0] = l.row[0] + v[m].x * b[m];
    l.row[1] = l.row[1] + v[m].y * b[m];
    l.row[2] = l.row[2] + v[m].z * b[m];
  }
  return scale * l;
}

}  // namespace percuss
