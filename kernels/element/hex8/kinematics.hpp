#pragma once
// What the motion of an element over a step is to its materials: rates, rotation and stretch.

#include "kernels/element/hex8/modes.hpp"
#include "kernels/material/point_step.hpp"
#include "kernels/material/polar.hpp"

namespace percuss {

/// From the stretches at n and n+1.
template <class T>
PERCUSS_FORCE_INLINE VolumeChange<T> find_volume_change(const Symmetric3<T>& before, const Symmetric3<T>& after) {
  const T j = determinant(full(after));
  return {j - determinant(full(before)), T(1) / j};
}

/// What the motion of an element over a step is to its materials.
template <class T>
struct StepMotion {
  VectorModes<T> middle;  // positions at n+1/2
  VolumeGradient<T> b;    // at n+1/2
  Matrix3<T> l;           // velocity gradient
  T trace_d;
  Matrix3<T> turn;         // of advance_polar()
  Matrix3<T> rotations;    // R(n) + R(n+1), of which half turns rates half way
  Symmetric3<T> de;        // strain increment in the unrotated frame
  Symmetric3<T> stretch;   // V at n+1/2
  VolumeChange<T> change;  // of J = det V
};

/// Rates on the geometry of the mid-point, turned half way. a, v: modes of x(n+1) and v(n+1/2). polar: in at n, out at
/// n+1.
template <class T>
PERCUSS_FORCE_INLINE StepMotion<T> follow_motion(const VectorModes<T>& a, const VectorModes<T>& v, const T& dt,
                                                 Polar<T>& polar) {
  StepMotion<T> out;
  const T half = number<T>(0.5), half_dt = half * dt;
  for (int m = 1; m <= 7; ++m) out.middle[m] = a[m] - half_dt * v[m];
  out.b = find_volume_gradient(out.middle);
  out.l = find_velocity_gradient(v, out.b);
  const Symmetric3<T> d = symmetric_part(out.l);
  out.trace_d = trace(d);
  const Matrix3<T> before = polar.rotation;
  const Symmetric3<T> stretch_before = polar.stretch;
  advance_polar(out.l, dt, polar, out.turn);
  out.stretch = half * (stretch_before + polar.stretch);
  out.change = find_volume_change(stretch_before, polar.stretch);
  out.rotations = before + polar.rotation;
  out.de = (number<T>(0.25) * dt) * pull_back(out.rotations, d);
  return out;
}

}  // namespace percuss
