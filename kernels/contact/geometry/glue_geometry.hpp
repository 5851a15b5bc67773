#pragma once
// A glued node: how far it is from its place on the face, and the forces that pull both together.
//
// The place is that of a tie (tie_geometry.hpp): x = sum N_i x_i + R r0. A force P on the node has -N_i P - q x b_i on
// the corners, so that its work is that of P along the separation in the frame that turns with the face, and linear and
// angular momentum are conserved.

#include "kernels/contact/geometry/tie_geometry.hpp"

namespace percuss {

/// Where a glued node is from its face at a moment.
struct Separation {
  TurnedTie turned;
  Point3 arm{};     // from sum N_i x_i to the node
  Point3 normal{};  // unit vector, out of the face towards the side on which the node was glued
  double opening = 0;
  Point3 slide{};  // across the normal
};

/// side: 1 where the node was glued outside, -1 behind a shell.
KOKKOS_INLINE_FUNCTION Separation find_separation(const TieGeometry& tie, int side, const Point3& node,
                                                  const FacePoints& face) {
  FacePoints near;  // from a corner: precise far from the origin, too
  for (int i = 0; i < 4; ++i) near.corner[i] = face.corner[i] - face.corner[0];
  Separation of;
  of.turned = turn_tie(tie, near);
  of.arm = (node - face.corner[0]) - interpolate(near, tie.weight);
  of.normal = static_cast<double>(side) * find_face_normal(of.turned.face);
  const Point3 away = of.arm - of.turned.offset;
  of.opening = dot(away, of.normal);
  of.slide = away - of.opening * of.normal;
  return of;
}

/// Forces of glue on a node and the four corners of its face.
struct GlueForces {
  Point3 force[5];
};
KOKKOS_INLINE_FUNCTION GlueForces spread_force(const TieGeometry& tie, const Separation& of, const Point3& on_node) {
  const Point3 couple = invert(of.turned.inertia) * cross(of.arm, on_node);
  GlueForces forces;
  forces.force[0] = on_node;
  for (int i = 0; i < 4; ++i)
    forces.force[i + 1] = -1.0 * (tie.weight[i] * on_node + cross(couple, of.turned.face.corner[i]));
  return forces;
}

/// Bounds on the share of the force that each of the five gets.
struct GlueShares {
  double share[5] = {1, 0, 0, 0, 0};
};
KOKKOS_INLINE_FUNCTION GlueShares bound_shares(const TieGeometry& tie, const Separation& of) {
  const Symmetric3<double> inverse = invert(of.turned.inertia);
  const double squares = inverse.xx * inverse.xx + inverse.yy * inverse.yy + inverse.zz * inverse.zz +
                         2 * (inverse.xy * inverse.xy + inverse.yz * inverse.yz + inverse.zx * inverse.zx);
  const double turning = std::sqrt(squares) * norm(of.arm);
  GlueShares shares;
  for (int i = 0; i < 4; ++i) shares.share[i + 1] = std::abs(tie.weight[i]) + turning * norm(of.turned.face.corner[i]);
  return shares;
}

}  // namespace percuss
