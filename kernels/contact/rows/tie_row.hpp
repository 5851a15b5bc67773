#pragma once
// The rows of a tie: three directions, held both ways, that bring the node to its place in the frame of the face at
// n+1; and three that turn the node in the step as the face turns.
//
// The spin of the node is w, that of the face W = A^-1 sum b_i x v_i (tie_geometry.hpp). A moment Q on the node gives
// the corners the impulses -(A^-1 Q) x b_i: their sum is zero, and so is that of the moments, since sum rho_i x (q x
// b_i) = A q. The moment does the work Q . (w - W), so none where both turn alike. With P = Q / l and the velocity l (w
// - W), l the size of the face, it is a row like any other. Nothing else touches the spin of the node in contact, so
// the row keeps it itself (TurningRow).

#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

/// Places of a row's nodes in data by place, relative to the tied node; after `share` of the step.
struct TiedPlaces {
  Point3 node{};  // from the point of the face
  FacePoints face;
};
KOKKOS_INLINE_FUNCTION TiedPlaces find_tied_places(const ContactRow& row, const RowNodes& at, double dt) {
  const Point3 x = load_row(at.x, row.place[0]), v = load_row(at.v, row.place[0]);
  TiedPlaces places;
  for (int i = 0; i < 4; ++i) {
    const int a = row.place[i + 1];
    places.face.corner[i] = (load_row(at.x, a) - x) + dt * (load_row(at.v, a) - v);
    places.node = places.node + row.weight[i + 1] * places.face.corner[i];
  }
  return places;
}

/// Fills the part of a tie's row that does not depend on what it ties.
KOKKOS_INLINE_FUNCTION void start_tie_row(const TieGeometry& tie, const RowTouch& touch, ContactRow& row) {
  for (int slot = 0; slot < touch.count; ++slot) row.weight[slot] = touch.weight[slot];
  row.count = touch.count;
  row.key = touch.key;
  row.kind = RowKind::tie;
  row.face = touch.face;
  row.record = touch.record;
  row.pair = touch.pair;
  row.size = tie.size;
  row.friction = contact_limits::no_friction_limit;
  row.normal = row.gap_gradient = {1, 0, 0};
  row.tangent[0] = {0, 1, 0};
  row.tangent[1] = {0, 0, 1};
}

/// The face at n, what is missing along the axes at n+1, and the first guess.
KOKKOS_INLINE_FUNCTION void set_tie_state(const TurnedTie& face, const Point3& apart, const Point3& guess,
                                          ContactRow& row) {
  for (int i = 0; i < 4; ++i) row.rho[i + 1] = face.face.corner[i];
  row.inverse_inertia = invert(face.inertia);
  row.gap = apart.x;
  row.slide[0] = apart.y;
  row.slide[1] = apart.z;
  row.impulse = {guess.x, {guess.y, guess.z}};
  row.previous = row.impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// The row of a tie whose places are set. last: impulse of the last step.
KOKKOS_INLINE_FUNCTION void fill_tie_row(const TieGeometry& tie, const RowInputs& inputs, const RowNodes& at,
                                         const RowTouch& touch, const Point3& last, ContactRow& row) {
  start_tie_row(tie, touch, row);
  const TiedPlaces start = find_tied_places(row, at, 0), end = find_tied_places(row, at, inputs.motion.dt);
  row.arm = start.node;
  const Point3 apart = end.node - turn_tie(tie, end.face).offset;
  set_tie_state(turn_tie(tie, start.face), apart, inputs.impulse_scale * last, row);
}

/// D of a tie: one for all directions. A direction in which nothing can be moved requests nothing; what is missing
/// there is what conditions do to the tie.
KOKKOS_INLINE_FUNCTION void set_tie_stiffness(ContactRow& row, const double stiffness[3]) {
  double largest = 0;
  for (int d = 0; d < 3; ++d) {
    largest = stiffness[d] > largest ? stiffness[d] : largest;
    if (stiffness[d] > 0) continue;
    double& apart = d == 0 ? row.gap : row.slide[d - 1];
    const double way = apart < 0 ? -apart : apart;
    row.held_apart = way > row.held_apart ? way : row.held_apart;
    apart = 0;
    (d == 0 ? row.impulse.normal : row.impulse.tangential[d - 1]) = 0;
  }
  row.is_held = !(largest > 0);
  row.stiffness = row.tangential_stiffness = row.is_held ? 1 : largest;
  row.previous = row.impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// Angle by which a face turns from one state to another: the Gibbs vector g of c_i - b_i = g x (b_i + c_i) / 2, 2 tan
/// (angle / 2) about the axis.
KOKKOS_INLINE_FUNCTION Point3 find_turn(const FacePoints& from, const FacePoints& to) {
  Symmetric3<double> inertia{};
  Point3 sum{};
  for (int i = 0; i < 4; ++i) {
    const Point3 middle = 0.5 * (from.corner[i] + to.corner[i]), way = to.corner[i] - from.corner[i];
    sum = sum + cross(middle, way);
    inertia = inertia + Symmetric3<double>{middle.y * middle.y + middle.z * middle.z,
                                           middle.z * middle.z + middle.x * middle.x,
                                           middle.x * middle.x + middle.y * middle.y,
                                           -(middle.x * middle.y),
                                           -(middle.y * middle.z),
                                           -(middle.z * middle.x)};
  }
  return invert(inertia) * sum;
}

/// The row of a rotation whose places are set. last: P of the last step. A node without a rotation, or of a rigid body,
/// requests nothing.
KOKKOS_INLINE_FUNCTION TurningRow fill_turning_row(const TieGeometry& tie, const RowInputs& inputs, const RowNodes& at,
                                                   const RowTouch& touch, const Point3& last, ContactRow& row) {
  start_tie_row(tie, touch, row);
  const int node = touch.node[0];
  const bool is_free = inputs.spins.inertia(node) > 0 && !(inputs.bodies.count > 0 && inputs.bodies.of_node(node) >= 0);
  TurningRow turning;
  row.lever = tie.size;
  if (!is_free) return turning;
  const double l = row.lever, dt = inputs.motion.dt;
  const Point3 spin = load_row(inputs.spins.spin, node), inverse = load_row(inputs.spins.inverse_inertia, node);
  turning.compliance = l * l * inverse;
  turning.before = l * load_row(inputs.spins.before, node);
  turning.predicted = l * spin;
  const TurnedTie start = turn_tie(tie, find_tied_places(row, at, 0).face);
  const TurnedTie end = turn_tie(tie, find_tied_places(row, at, dt).face);
  const Point3 apart = l * (dt * spin - find_turn(start.face, end.face));
  set_tie_state(start, apart, inputs.impulse_scale * last, row);
  return turning;
}

/// Change of the node's spin by the row's own impulse, times the lever.
KOKKOS_INLINE_FUNCTION Point3 find_own_change(const ContactRow& row, const TurningRow& turning) {
  const Point3 &c = turning.compliance, &p = row.force;
  return {c.x * p.x, c.y * p.y, c.z * p.z};
}

/// Mean spin of the node before and after the step, times the lever.
KOKKOS_INLINE_FUNCTION Point3 find_mean_spin(const ContactRow& row, const TurningRow& turning) {
  return 0.5 * (turning.before + (turning.predicted + find_own_change(row, turning)));
}

}  // namespace percuss
