#pragma once
// Rotation and stretch of a material point, step by step (Flanagan and Taylor 1987).
//
// F = V R with V symmetric. The rotation advances with the spin that keeps V symmetric, through the exact rotation of
// the step (their equation 16: the Cayley transform), and the stretch through the exact incremental deformation of a
// step with a constant velocity gradient at the mid-point. A rigid rotation of any size leaves V's eigenvalues as
// they are.

#include "kernels/element/modes.hpp"

namespace percuss {

template <class T>
struct Polar {
  Matrix3<T> rotation;    // R, orthogonal
  Symmetric3<T> stretch;  // V
};

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

/// The rotation of the quaternion (d, n) of any length: exactly orthogonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation(const T& d, const Vector3<T>& n) {
  const T scale = T(2) / (d * d + dot(n, n));
  const Vector3<T> sn = scale * n, t = d * sn;
  return {{{T(1) - (sn.y * n.y + sn.z * n.z), sn.x * n.y - t.z, sn.x * n.z + t.y},
           {sn.x * n.y + t.z, T(1) - (sn.x * n.x + sn.z * n.z), sn.y * n.z - t.x},
           {sn.x * n.z - t.y, sn.y * n.z + t.x, T(1) - (sn.x * n.x + sn.y * n.y)}}};
}

/// Rotation by the constant spin w over dt: (I - dt/2 W)^-1 (I + dt/2 W), exactly orthogonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation_increment(const Vector3<T>& w, const T& dt) {
  return find_rotation(T(1), (T(0.5) * dt) * w);
}

/// Advances R and V from n to n+1 with the velocity gradient l of the mid-point.
///
/// The spin at n turns the axes to first order; what is left of the antisymmetric part of F(n+1) transpose(R) then
/// gives the missing rotation (one Newton step of the polar decomposition), so that V R = F to fourth order in a step.
/// Both are vectors h of a quaternion (1, h), and their product is one rotation.
template <class T>
PERCUSS_FORCE_INLINE Polar<T> advance_polar(const Polar<T>& old, const Matrix3<T>& l, const T& dt) {
  const Matrix3<T> half = (T(0.5) * dt) * l;
  const Vector3<T> predicted = find_material_spin(symmetric_part(half), axial_vector(half), old.stretch);

  // x(n+1) - x(n) = dt L (x(n) + x(n+1)) / 2, hence F(n+1) = f F(n) with f = (I - dt/2 L)^-1 (I + dt/2 L).
  const Matrix3<T> one = identity_matrix<T>();
  const Matrix3<T> f = inverse(one - half, T(2)) - one;
  const Matrix3<T> stretched = f * full(old.stretch);
  const Matrix3<T> trial = stretched * transpose(find_rotation(T(1), predicted));

  const Symmetric3<T> s = symmetric_part(trial);
  const T tr = trace(s);
  const Symmetric3<T> a{tr - s.xx, tr - s.yy, tr - s.zz, -s.xy, -s.yz, -s.zx};
  const Vector3<T> missing = solve(a, axial_vector(trial));
  const Matrix3<T> turn =
      find_rotation(T(1) - dot(missing, predicted), missing + predicted + cross(missing, predicted));
  return {turn * old.rotation, symmetric_product(stretched, turn)};
}

/// What the motion of an element over a step is to its materials.
template <class T>
struct StepMotion {
  VectorModes<T> middle;  // positions at n+1/2
  VolumeGradient<T> b;    // at n+1/2
  Matrix3<T> l;           // velocity gradient
  T trace_d;
  Matrix3<T> turn;   // (R(n) + R(n+1)) / 2: turns rates half way
  Symmetric3<T> de;  // strain increment in the unrotated frame
};

/// Rates on the geometry of the mid-point, turned half way. a, v: modes of x(n+1) and v(n+1/2). polar: in at n, out at
/// n+1.
template <class T>
PERCUSS_FORCE_INLINE StepMotion<T> follow_motion(const VectorModes<T>& a, const VectorModes<T>& v, const T& dt,
                                                 Polar<T>& polar) {
  StepMotion<T> out;
  const T half = T(0.5), half_dt = half * dt;
  for (int m = 1; m <= 7; ++m) out.middle[m] = a[m] - half_dt * v[m];
  out.b = find_volume_gradient(out.middle);
  out.l = find_velocity_gradient(v, out.b);
  const Symmetric3<T> d = symmetric_part(out.l);
  out.trace_d = trace(d);
  const Polar<T> next = advance_polar(polar, out.l, dt);
  out.turn = half * (polar.rotation + next.rotation);
  out.de = dt * pull_back(out.turn, d);
  for (int i = 0; i < 3; ++i) polar.rotation.row[i] = next.rotation.row[i];
  polar.stretch = next.stretch;
  return out;
}

}  // namespace percuss
