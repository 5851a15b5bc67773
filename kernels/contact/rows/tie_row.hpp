#pragma once
// The row of a tie: three directions, held both ways, that bring the node to its place in the frame of the face at n+1.

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

/// The row of a tie whose places are set. last: impulse of the last step.
KOKKOS_INLINE_FUNCTION void fill_tie_row(const TieGeometry& tie, const RowInputs& inputs, const RowNodes& at,
                                         const RowTouch& touch, const Point3& last, ContactRow& row) {
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
  const TiedPlaces start = find_tied_places(row, at, 0), end = find_tied_places(row, at, inputs.motion.dt);
  const TurnedTie turned = turn_tie(tie, start.face);
  row.arm = start.node;
  for (int i = 0; i < 4; ++i) row.rho[i + 1] = turned.face.corner[i];
  row.inverse_inertia = invert(turned.inertia);
  const Point3 apart = end.node - turn_tie(tie, end.face).offset;
  row.gap = apart.x;
  row.slide[0] = apart.y;
  row.slide[1] = apart.z;
  const Point3 guess = inputs.impulse_scale * last;
  row.impulse = {guess.x, {guess.y, guess.z}};
  row.previous = row.impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// D of a tie: one for all directions. A direction in which nothing can be moved asks for nothing; what is missing
/// there is what conditions do to the tie.
KOKKOS_INLINE_FUNCTION void set_tie_stiffness(ContactRow& row, const double stiffness[3]) {
  double largest = 0;
  for (int d = 0; d < 3; ++d) {
    largest = stiffness[d] > largest ? stiffness[d] : largest;
    if (stiffness[d] > 0) continue;
    double& apart = d == 0 ? row.gap : row.slide[d - 1];
    const double way = apart < 0 ? -apart : apart;
    row.torn = way > row.torn ? way : row.torn;
    apart = 0;
    (d == 0 ? row.impulse.push : row.impulse.rub[d - 1]) = 0;
  }
  row.is_held = !(largest > 0);
  row.stiffness = row.rub_stiffness = row.is_held ? 1 : largest;
  row.previous = row.impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

}  // namespace percuss
