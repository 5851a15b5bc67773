#pragma once
// Rotation and stretch of a material point, step by step (Flanagan and Taylor 1987).
//
// F = V R with V symmetric. The rotation advances with the spin that keeps V symmetric, through the exact rotation of
// the step (their equation 16: the Cayley transform), and the stretch through the exact incremental deformation of a
// step with a constant velocity gradient at the mid-point. A rigid rotation of any size leaves V's eigenvalues as
// they are.

#include "kernels/core/tensor.hpp"

namespace percuss {

template <class T>
struct Polar {
  Matrix3<T> rotation;    // R, orthogonal
  Symmetric3<T> stretch;  // V
};

/// Spin of the material axes: axial vector of Omega = R_dot transpose(R), from V_dot = L V - V Omega symmetric.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> find_material_spin(const Symmetric3<T>& d, const Vector3<T>& w,
                                                   const Symmetric3<T>& stretch) {
  const T minus_two = T(-2);
  const Vector3<T> z = minus_two * axial_vector(full(stretch) * full(d));  // axial vector of D V - V D
  const T tr = trace(stretch);
  const Symmetric3<T> a{tr - stretch.xx, tr - stretch.yy, tr - stretch.zz, -stretch.xy, -stretch.yz, -stretch.zx};
  return w + solve(a, z);
}

/// Rotation by the constant spin w over dt: (I - dt/2 W)^-1 (I + dt/2 W), exactly orthogonal.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_rotation_increment(const Vector3<T>& w, const T& dt) {
  const Vector3<T> h = (T(0.5) * dt) * w;
  const T s = T(2) / (T(1) + dot(h, h));
  const Vector3<T> sh = s * h;
  return {{{T(1) - (sh.y * h.y + sh.z * h.z), sh.x * h.y - sh.z, sh.x * h.z + sh.y},
           {sh.x * h.y + sh.z, T(1) - (sh.x * h.x + sh.z * h.z), sh.y * h.z - sh.x},
           {sh.x * h.z - sh.y, sh.y * h.z + sh.x, T(1) - (sh.x * h.x + sh.y * h.y)}}};
}

/// Advances R and V from n to n+1 with the velocity gradient l of the mid-point.
///
/// The spin at n turns the axes to first order; what is left of the antisymmetric part of F(n+1) transpose(R) then
/// gives the missing rotation (one Newton step of the polar decomposition), so that V R = F to fourth order in a step.
template <class T>
PERCUSS_FORCE_INLINE Polar<T> advance_polar(const Polar<T>& old, const Matrix3<T>& l, const T& dt) {
  const Vector3<T> spin = find_material_spin(symmetric_part(l), axial_vector(l), old.stretch);
  const Matrix3<T> turn = find_rotation_increment(spin, dt);

  // x(n+1) - x(n) = dt L (x(n) + x(n+1)) / 2, hence F(n+1) = f F(n) with f = (I - dt/2 L)^-1 (I + dt/2 L).
  const Matrix3<T> one = identity_matrix<T>();
  const Matrix3<T> half = (T(0.5) * dt) * l;
  const Matrix3<T> f = inverse(one - half) * (one + half);
  const Matrix3<T> trial = (f * full(old.stretch)) * transpose(turn);

  const Symmetric3<T> s = symmetric_part(trial);
  const T tr = trace(s);
  const Symmetric3<T> a{tr - s.xx, tr - s.yy, tr - s.zz, -s.xy, -s.yz, -s.zx};
  const Matrix3<T> correction = find_rotation_increment(solve(a, axial_vector(trial)), T(2));
  return {correction * (turn * old.rotation), symmetric_part(trial * transpose(correction))};
}

}  // namespace percuss
