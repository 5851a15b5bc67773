#pragma once
// The stretch of a point, for materials whose stress follows from the deformation and not from its rate.

#include "kernels/material/point_step.hpp"
#include "kernels/material/polar.hpp"

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

/// Finds eigenvalues by Jacobi's rotations, cyclic; six sweeps reach round-off from anywhere (Golub and Van Loan,
/// section 8.5).
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

/// What turns a material that strains: V_dot = L V - V Omega is symmetric for Omega, the spin of L and A^-1 z (axial
/// vectors), with A = tr(V) I - V and z, twice the axial vector of D V - V D.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_turn_resistance(const Symmetric3<T>& v) {
  const T tr = trace(v);
  return {tr - v.xx, tr - v.yy, tr - v.zz, -v.xy, -v.yz, -v.zx};
}
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_turn_drive(const Symmetric3<T>& d, const Symmetric3<T>& v) {
  return {v.xy * d.zx - v.zx * d.xy + (v.yy - v.zz) * d.yz + v.yz * (d.zz - d.yy),
          v.yz * d.xy - v.xy * d.yz + (v.zz - v.xx) * d.zx + v.zx * (d.xx - d.zz),
          v.zx * d.yz - v.yz * d.zx + (v.xx - v.yy) * d.xy + v.xy * (d.yy - d.xx)};
}

/// Advances U by the increment de of the unrotated rate of deformation. A point that turns with the frame spins beyond
/// it only by what keeps U symmetric; the spin of one that turns apart is given, and U is its V as the frame sees it.
/// The determinant of U is set to that of the element's volume.
template <class T>
KOKKOS_INLINE_FUNCTION Symmetric3<T> advance_stretch(const Symmetric3<T>& u, const PointMotion<T>& motion) {
  Vector3<T> spin = motion.spin;
  if (!motion.is_apart) spin = spin + T(-1) * solve(find_turn_resistance(u), find_turn_drive(motion.de, u));
  Polar<T> polar{identity_matrix<T>(), u};
  Matrix3<T> turn;
  advance_polar(full(motion.de) + antisymmetric(spin), T(1), polar, turn);
  return power(motion.volume_ratio / find_determinant(polar.stretch), 1.0 / 3.0) * polar.stretch;
}

}  // namespace percuss
