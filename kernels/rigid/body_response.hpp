#pragma once
// How a rigid body answers impulses on its nodes in a step: linear in them, with the body as it stands at n.

#include "kernels/core/tensor.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

struct BodyResponse {
  Vector3<double> center{};              // at n
  Vector3<double> inverse_mass{};        // 0 in held directions
  Symmetric3<double> inverse_inertia{};  // about the centre, at n; 0 about held axes
  double growth = 1;                     // of its masses by damping (DampedMasses), which both have in them
};

/// An impulse on a body and its moment about the centre.
struct Wrench {
  Vector3<double> impulse{}, moment{};
};

/// What the impulse j at r from the centre is to the body.
KOKKOS_INLINE_FUNCTION Wrench find_wrench(const Vector3<double>& r, const Vector3<double>& j) {
  return {j, cross(r, j)};
}

/// Changes of velocity and spin that a wrench causes.
struct BodyChange {
  Vector3<double> velocity{}, spin{};

  /// Change of the velocity of a node at r from the centre.
  KOKKOS_INLINE_FUNCTION Vector3<double> at(const Vector3<double>& r) const { return velocity + cross(spin, r); }
};

KOKKOS_INLINE_FUNCTION BodyChange find_change(const BodyResponse& body, const Wrench& w) {
  const Vector3<double>& m = body.inverse_mass;
  return {{m.x * w.impulse.x, m.y * w.impulse.y, m.z * w.impulse.z}, body.inverse_inertia * w.moment};
}

/// Velocity of a node at r in each direction under a unit impulse in it.
KOKKOS_INLINE_FUNCTION Vector3<double> find_compliance(const BodyResponse& body, const Vector3<double>& r) {
  const Vector3<double> tx{0, r.z, -r.y}, ty{-r.z, 0, r.x}, tz{r.y, -r.x, 0};  // r x e
  const Symmetric3<double>& w = body.inverse_inertia;
  return {body.inverse_mass.x + dot(tx, w * tx), body.inverse_mass.y + dot(ty, w * ty),
          body.inverse_mass.z + dot(tz, w * tz)};
}

/// Bounds of |r x c| by component from the absolute values of both; symmetric: dot(a, bound_cross(r, b)) =
/// dot(bound_cross(r, a), b).
KOKKOS_INLINE_FUNCTION Vector3<double> bound_cross(const Vector3<double>& r, const Vector3<double>& c) {
  return {r.y * c.z + r.z * c.y, r.z * c.x + r.x * c.z, r.x * c.y + r.y * c.x};
}

/// Absolute values of the components.
KOKKOS_INLINE_FUNCTION Symmetric3<double> find_abs_tensor(const Symmetric3<double>& a) {
  const auto abs = [](double x) { return x < 0 ? -x : x; };
  return {abs(a.xx), abs(a.yy), abs(a.zz), abs(a.xy), abs(a.yz), abs(a.zx)};
}

}  // namespace percuss
