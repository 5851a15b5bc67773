#pragma once
// The stretch of a point, for materials whose stress follows from the deformation and not from its rate.

#include "kernels/material/point/point_step.hpp"
#include "kernels/material/point/polar.hpp"

namespace percuss {

/// U between steps, in the unrotated frame, in six scalars of a history that start at the identity.
struct StretchHistory {
  static constexpr int count = 6;

  static void start(double* history) { history[0] = history[1] = history[2] = 1; }

  template <class T>
  KOKKOS_INLINE_FUNCTION static Symmetric3<T> load(const T* h) {
    return {h[0], h[1], h[2], h[3], h[4], h[5]};
  }
  template <class T>
  KOKKOS_INLINE_FUNCTION static void store(const Symmetric3<T>& u, T* h) {
    h[0] = u.xx, h[1] = u.yy, h[2] = u.zz, h[3] = u.xy, h[4] = u.yz, h[5] = u.zx;
  }
};

template <class T>
KOKKOS_INLINE_FUNCTION T find_determinant(const Symmetric3<T>& u) {
  return determinant(full(u));
}

/// a a, which is symmetric.
template <class T>
KOKKOS_INLINE_FUNCTION Symmetric3<T> find_square(const Symmetric3<T>& a) {
  return symmetric_product(full(a), full(a));
}

/// Principal values and unit directions of a symmetric tensor.
template <class T>
struct PrincipalAxes {
  T value[3];
  Vector3<T> direction[3];
};

/// By Jacobi's rotations, cyclic; six sweeps reach round-off from anywhere (Golub and Van Loan, section 8.5).
template <class T>
KOKKOS_INLINE_FUNCTION PrincipalAxes<T> find_principal_axes(const Symmetric3<T>& a) {
  constexpr int sweeps = 6;
  T m[3][3] = {{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}};
  T v[3][3] = {{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}};
  for (int turn = 0; turn < 3 * sweeps; ++turn) {
    const int p = turn % 3, q = (p + 1) % 3, r = 3 - p - q;
    // t = tan of the angle that takes m[p][q] away, the smaller of two
    const auto none = m[p][q] == T(0);
    const T theta = T(0.5) * (m[q][q] - m[p][p]) / select(none, T(1), m[p][q]);
    const T size = larger(theta, -theta);
    const T t = select(none, T(0), select(theta < T(0), T(-1), T(1)) / (size + square_root(size * size + T(1))));
    const T c = T(1) / square_root(t * t + T(1)), s = t * c;
    const T pq = m[p][q], pr = m[p][r], qr = m[q][r];
    m[p][p] = m[p][p] - t * pq;
    m[q][q] = m[q][q] + t * pq;
    m[p][q] = m[q][p] = T(0);
    m[p][r] = m[r][p] = c * pr - s * qr;
    m[q][r] = m[r][q] = s * pr + c * qr;
    for (int k = 0; k < 3; ++k) {
      const T vp = v[k][p], vq = v[k][q];
      v[k][p] = c * vp - s * vq;
      v[k][q] = s * vp + c * vq;
    }
  }
  PrincipalAxes<T> out;
  for (int i = 0; i < 3; ++i) {
    out.value[i] = m[i][i];
    out.direction[i] = {v[0][i], v[1][i], v[2][i]};
  }
  return out;
}

/// Spin of the material axes: axial vector of Omega = R_dot transpose(R), from V_dot = L V - V Omega symmetric.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_material_spin(const Symmetric3<T>& d, const Vector3<T>& w,
                                                   const Symmetric3<T>& s) {
  // twice the axial vector of D V - V D
  const Vector3<T> z{s.xy * d.zx - s.zx * d.xy + (s.yy - s.zz) * d.yz + s.yz * (d.zz - d.yy),
                     s.yz * d.xy - s.xy * d.yz + (s.zz - s.xx) * d.zx + s.zx * (d.xx - d.zz),
                     s.zx * d.yz - s.yz * d.zx + (s.xx - s.yy) * d.xy + s.xy * (d.yy - d.xx)};
  const T tr = trace(s);
  const Symmetric3<T> a{tr - s.xx, tr - s.yy, tr - s.zz, -s.xy, -s.yz, -s.zx};
  return w + solve(a, z);
}

/// Advances U by the increment de of the unrotated rate of deformation. In the unrotated frame the axes turn only by
/// what the point turns beyond it, so that the rest of the spin is the one that keeps U symmetric. Its determinant is
/// set to that of the element's volume.
template <class T>
KOKKOS_INLINE_FUNCTION Symmetric3<T> advance_stretch(const Symmetric3<T>& u, const PointMotion<T>& motion) {
  const Vector3<T> zero{T(0), T(0), T(0)};
  const Vector3<T> spin = motion.turn + T(-1) * find_material_spin(motion.de, zero, u);
  Polar<T> polar{identity_matrix<T>(), u};
  Matrix3<T> turn;
  advance_polar(full(motion.de) + antisymmetric(spin), T(1), polar, turn);
  return power(motion.volume_ratio / find_determinant(polar.stretch), 1.0 / 3.0) * polar.stretch;
}

}  // namespace percuss
