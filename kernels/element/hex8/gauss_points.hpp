#pragma once
// The 2x2x2 points of the trilinear hexahedron, in modes, and a bound of its largest Laplace eigenvalue.
//
// With the modes u_m of a corner quantity, u(xi) = (1/8) sum_m u_m phi_m(xi). Two points a direction integrate the
// volume and its gradient exactly, so that the mean over the points is that of modes.hpp.

#include "kernels/element/hex8/stable_step.hpp"

namespace percuss {

/// Coordinates of point p of 8, numbered like the corners.
struct GaussPoint {
  double xi, eta, zeta;
};

PERCUSS_FORCE_INLINE GaussPoint find_gauss_point(int p) {
  constexpr double place = 0.57735026918962576451;  // 1/sqrt(3)
  const int side = p & 3;
  return {side == 1 || side == 2 ? place : -place, side >= 2 ? place : -place, p >= 4 ? place : -place};
}

/// 8 times the derivatives by xi, eta, zeta of the field with the modes a.
template <class T>
PERCUSS_FORCE_INLINE void find_derivatives(const VectorModes<T>& a, const GaussPoint& at, Vector3<T> (&d)[3]) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta), zeta = number<T>(at.zeta);
  d[0] = a[1] + eta * a[6] + zeta * (a[5] + eta * a[7]);
  d[1] = a[2] + xi * a[6] + zeta * (a[4] + xi * a[7]);
  d[2] = a[3] + eta * a[4] + xi * (a[5] + eta * a[7]);
}

/// Geometry at a point: c_k = 64 det J grad xi_k, and 512 det J.
template <class T>
struct PointGeometry {
  Vector3<T> c[3];
  T volume;
};

template <class T>
PERCUSS_FORCE_INLINE PointGeometry<T> find_point_geometry(const VectorModes<T>& a, const GaussPoint& at) {
  Vector3<T> d[3];
  find_derivatives(a, at, d);
  PointGeometry<T> out{{cross(d[1], d[2]), cross(d[2], d[0]), cross(d[0], d[1])}, T(0)};
  out.volume = dot(d[0], out.c[0]);
  return out;
}

/// Adds 512 times the modes of the corner forces that a stress at a point gives: sum_k (d phi_m / d xi_k) sigma c_k.
template <class T>
PERCUSS_FORCE_INLINE void add_point_force(const Symmetric3<T>& stress, const PointGeometry<T>& point,
                                          const GaussPoint& at, VectorModes<T>& f) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta), zeta = number<T>(at.zeta);
  const Vector3<T> t1 = stress * point.c[0], t2 = stress * point.c[1], t3 = stress * point.c[2];
  f[1] = f[1] + t1;
  f[2] = f[2] + t2;
  f[3] = f[3] + t3;
  f[4] = f[4] + zeta * t2 + eta * t3;
  f[5] = f[5] + zeta * t1 + xi * t3;
  f[6] = f[6] + eta * t1 + xi * t2;
  f[7] = f[7] + eta * (zeta * t1 + xi * t3) + xi * (zeta * t2);
}

/// (grad xi_k . grad xi_l) det J of all points, by point: xx, yy, zz, xy, yz, zx stand for the pairs k, l.
template <class T>
struct PointMetrics {
  T xx[8], yy[8], zz[8], xy[8], yz[8], zx[8];

  /// 8 times it, from the geometry of point p. scale: 1 / g.volume, or the ratio of the volume that counts to its
  /// square.
  PERCUSS_FORCE_INLINE void set(int p, const PointGeometry<T>& g, const T& scale) {
    xx[p] = scale * dot(g.c[0], g.c[0]);
    yy[p] = scale * dot(g.c[1], g.c[1]);
    zz[p] = scale * dot(g.c[2], g.c[2]);
    xy[p] = scale * dot(g.c[0], g.c[1]);
    yz[p] = scale * dot(g.c[1], g.c[2]);
    zx[p] = scale * dot(g.c[2], g.c[0]);
  }
};

/// Upper bound of the largest eigenvalue of a symmetric 4x4 matrix, from its trace and the sum of its squares.
template <class T>
PERCUSS_FORCE_INLINE T bound_largest_of_four(const T& sum, const T& square) {
  return number<T>(0.25) * sum + square_root(number<T>(0.75) * larger(square - number<T>(0.25) * sum * sum, T(0)));
}

/// Upper bound of the largest eigenvalue of H_IJ = sum_p det J grad N_I . grad N_J. m: 8 times the metrics;
/// overwritten.
///
/// In the orthonormal modes phi_m / sqrt(8), H is a block A of the three linear modes, D of the four others and C
/// between: H <= (A + D)/2 + sqrt((A - D)^2 / 4 + |C|^2). Sums over the points with the signs of phi come
/// from the transform of the corners; each factor xi, eta or zeta brings r = 1/sqrt(3). For a brick C vanishes, and the
/// bound is exact if two of its edges are equal.
template <class T>
PERCUSS_FORCE_INLINE T bound_largest_laplacian(PointMetrics<T>& m) {
  to_modes(m.xx);
  to_modes(m.yy);
  to_modes(m.zz);
  to_modes(m.xy);
  to_modes(m.yz);
  to_modes(m.zx);
  const T third = number<T>(1.0 / 3.0), r = number<T>(0.57735026918962576451);
  const T linear = bound_largest_eigenvalue(Symmetric3<T>{m.xx[0], m.yy[0], m.zz[0], m.xy[0], m.yz[0], m.zx[0]});
  // C by columns eta zeta, zeta xi, xi eta (each r), xi eta zeta (r^2)
  const Vector3<T> c4{m.xy[3] + m.zx[2], m.yy[3] + m.yz[2], m.yz[3] + m.zz[2]};
  const Vector3<T> c5{m.xx[3] + m.zx[1], m.xy[3] + m.yz[1], m.zx[3] + m.zz[1]};
  const Vector3<T> c6{m.xx[2] + m.xy[1], m.xy[2] + m.yy[1], m.zx[2] + m.yz[1]};
  const Vector3<T> c7{m.xx[4] + m.xy[5] + m.zx[6], m.xy[4] + m.yy[5] + m.yz[6], m.zx[4] + m.yz[5] + m.zz[6]};
  const T coupling = third * (dot(c4, c4) + dot(c5, c5) + dot(c6, c6) + third * dot(c7, c7));
  // D, 3 times its entries
  const T twist = T(2) * (m.xy[6] + m.zx[5] + m.yz[4]);
  const T d44 = m.yy[0] + m.zz[0] + T(2) * m.yz[4], d55 = m.xx[0] + m.zz[0] + T(2) * m.zx[5],
          d66 = m.xx[0] + m.yy[0] + T(2) * m.xy[6], d77 = third * (m.xx[0] + m.yy[0] + m.zz[0] + twist);
  const T d45 = m.xy[0] + m.yz[5] + m.zx[4] + m.zz[6], d46 = m.zx[0] + m.yz[6] + m.xy[4] + m.yy[5],
          d56 = m.yz[0] + m.zx[6] + m.xy[5] + m.xx[4];
  const T d47 = r * (m.xy[2] + m.yy[1] + T(2) * m.yz[7] + m.zx[3] + m.zz[1]),
          d57 = r * (m.xx[2] + m.xy[1] + T(2) * m.zx[7] + m.yz[3] + m.zz[2]),
          d67 = r * (m.xx[3] + T(2) * m.xy[7] + m.zx[1] + m.yy[3] + m.yz[2]);
  const T square = d44 * d44 + d55 * d55 + d66 * d66 + d77 * d77 +
                   T(2) * (d45 * d45 + d46 * d46 + d56 * d56 + d47 * d47 + d57 * d57 + d67 * d67);
  const T bilinear = third * bound_largest_of_four(d44 + d55 + d66 + d77, square);
  const T half = number<T>(0.5), difference = half * (linear - bilinear);
  return number<T>(1.0 / 64.0) * (half * (linear + bilinear) + square_root(difference * difference + coupling));
}

}  // namespace percuss
