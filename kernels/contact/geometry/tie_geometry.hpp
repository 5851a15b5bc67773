#pragma once
// A node tied to a face: the place that it has in the face's own frame, and keeps.
//
// At the start the node is at x = sum N_i x_i + r0. It stays at x = sum N_i x_i + R r0, R the rotation that turns the
// corners b0_i of the start (from their mean) closest to those of now, rho_i: the polar rotation, where
// sum (R b0_i) x rho_i = 0. The rate of R is A^-1 sum b_i x v_i, b_i = R b0_i, A = sum ((b . rho) I - b rho^T). So the
// impulses that hold the node are the transpose of the rate of the constraint, P on the node and -N_i P - q x b_i on
// the corners, q = A^-1 (r x P): they do no work and keep linear and angular momentum, because the constraint does not
// see a rigid motion. A row (contact_row.hpp) with b for rho and A for J says just that.

#include "kernels/contact/geometry/face_geometry.hpp"

namespace percuss {

/// A tie at the start, the same on any rank.
struct TieGeometry {
  double weight[4] = {0, 0, 0, 0};  // N
  Point3 offset{};                  // r0
  FacePoints face;                  // b0
  double size = 0;                  // shortest edge of the face
  bool turns = false;               // the row of the node's rotation, not of its place
};

/// A tie turned with its face.
struct TurnedTie {
  Point3 offset{};               // R r0
  FacePoints face;               // b
  Symmetric3<double> inertia{};  // A
};

/// Corners from their mean.
KOKKOS_INLINE_FUNCTION FacePoints center_face(const FacePoints& face) {
  const Point3 middle = find_middle(face);
  FacePoints centered;
  for (int i = 0; i < 4; ++i) centered.corner[i] = face.corner[i] - middle;
  return centered;
}

/// Three unit vectors that go with a face: along a diagonal, across it in the plane of both, and normal to both.
struct FaceFrame {
  Point3 axis[3];
};
KOKKOS_INLINE_FUNCTION FaceFrame find_frame(const FacePoints& face) {
  const Point3 along = normalize(face.corner[2] - face.corner[0]), normal = find_face_normal(face);
  return {{along, cross(normal, along), normal}};
}

/// Transforms a vector from the frame `from` to the frame `to`.
KOKKOS_INLINE_FUNCTION Point3 change_frame(const FaceFrame& from, const FaceFrame& to, const Point3& a) {
  return dot(a, from.axis[0]) * to.axis[0] + (dot(a, from.axis[1]) * to.axis[1] + dot(a, from.axis[2]) * to.axis[2]);
}

/// The vector turned by the Cayley rotation of `angle`: exactly as long as before.
KOKKOS_INLINE_FUNCTION Point3 rotate(const Point3& angle, const Point3& a) {
  const Point3 half = 0.5 * angle, swing = cross(half, a);
  return a + (2 / (1 + dot(half, half))) * (swing + cross(half, swing));
}

/// A of corners b and rho; symmetric where sum b x rho = 0.
KOKKOS_INLINE_FUNCTION Symmetric3<double> find_tie_inertia(const FacePoints& b, const FacePoints& rho) {
  Symmetric3<double> a{};
  for (int i = 0; i < 4; ++i) {
    const Point3 &p = b.corner[i], &q = rho.corner[i];
    a = a + Symmetric3<double>{p.y * q.y + p.z * q.z,          p.z * q.z + p.x * q.x,
                               p.x * q.x + p.y * q.y,          -0.5 * (p.x * q.y + p.y * q.x),
                               -0.5 * (p.y * q.z + p.z * q.y), -0.5 * (p.z * q.x + p.x * q.z)};
  }
  return a;
}

/// Turns a tie with its face. now: the corners, relative to any origin near them. The rotation is found by Newton's
/// iteration from that of the diagonals; it is the same for equal bits of the corners.
KOKKOS_INLINE_FUNCTION TurnedTie turn_tie(const TieGeometry& tie, const FacePoints& now) {
  constexpr int max_turns = 8;
  constexpr double small = 1e-18;  // square of a turn whose square, the error left after it, is below round-off
  const FacePoints rho = center_face(now);
  const FaceFrame from = find_frame(tie.face), to = find_frame(now);
  TurnedTie turned;
  turned.offset = change_frame(from, to, tie.offset);
  for (int i = 0; i < 4; ++i) turned.face.corner[i] = change_frame(from, to, tie.face.corner[i]);
  for (int k = 0; k < max_turns; ++k) {
    Point3 spin{};
    for (int i = 0; i < 4; ++i) spin = spin + cross(turned.face.corner[i], rho.corner[i]);
    const Point3 turn = invert(find_tie_inertia(turned.face, rho)) * spin;
    turned.offset = rotate(turn, turned.offset);
    for (Point3& corner : turned.face.corner) corner = rotate(turn, corner);
    if (!(dot(turn, turn) > small)) break;
  }
  turned.inertia = find_tie_inertia(turned.face, rho);
  return turned;
}

}  // namespace percuss
