#pragma once
// From a touch to a row: geometry at x_n, the gap that is wanted, the first guess from the last step.

#include "kernels/contact/geometry/face_geometry.hpp"
#include "kernels/contact/rows/row_system.hpp"

namespace percuss {

KOKKOS_INLINE_FUNCTION Point3 find_abs(const Point3& c) {
  return {c.x < 0 ? -c.x : c.x, c.y < 0 ? -c.y : c.y, c.z < 0 ? -c.z : c.z};
}

/// A row that nothing can move requests nothing.
KOKKOS_INLINE_FUNCTION void hold_row(ContactRow& row) {
  row.is_held = true;
  row.impulse = RowImpulse{};
  row.previous = RowImpulse{};
  row.force = Point3{};
  row.couple = Point3{};
  row.friction = 0;
  row.target = row.gap;  // met as it is
}

/// D of the directions; free: D of the push if no direction of its nodes were held. A row whose nodes are all held
/// cannot be moved and requests nothing. Nor does one whose nodes are free only across the push, but for round-off of
/// its direction: to close a gap they would have to move beyond all bounds.
KOKKOS_INLINE_FUNCTION void set_stiffness(ContactRow& row, const double stiffness[3], double free) {
  const auto choose = [](double d) { return d > 0 ? d : 1; };
  row.stiffness = choose(stiffness[0]);
  row.tangential_stiffness = choose(stiffness[1] > stiffness[2] ? stiffness[1] : stiffness[2]);
  if (!(stiffness[0] > contact_limits::least_freedom * free)) hold_row(row);
}

/// A vector shortened to `longest`.
KOKKOS_INLINE_FUNCTION Point3 shorten(const Point3& a, double longest) {
  const double length = norm(a);
  return length > longest ? (longest / length) * a : a;
}

/// The gap wanted at n+1. None that exists may be lost below zero; penetration is recovered slowly; an overlap accepted
/// at the start stays as it is, and what opened of it stays open.
KOKKOS_INLINE_FUNCTION void set_target(ContactRow& row) {
  const double floor = find_floor(row);
  const double recovered = row.gap_start + contact_limits::recovery * row.size;
  row.target = recovered < floor ? recovered : floor;
}

/// Thickness rotates with the faces: it comes nearer by at most this many times what nodes do.
inline constexpr double longest_turn = 3;

/// The most by which the gap of a touch can change in the step: no point of either side moves farther relative to the
/// other than their nodes do.
KOKKOS_INLINE_FUNCTION double find_longest_approach(const ContactRow& row, const RowNodes& at, double dt) {
  double fastest = 0;
  const int first_bearing = row.kind == RowKind::edges ? 2 : 1;
  for (int i = 0; i < first_bearing; ++i) {
    for (int j = first_bearing; j < row.count; ++j) {
      const double speed = norm(load_row(at.v, row.place[i]) - load_row(at.v, row.place[j]));
      fastest = speed > fastest ? speed : fastest;
    }
  }
  return (row.has_thickness ? longest_turn : 1) * norm(row.gap_gradient) * dt * fastest;
}

/// Where faces are crushed to slivers the measured gap jumps, as the closest point leaps from one triangle to another.
/// What it jumps by is penetration that exists: closed in one step it would throw bodies apart, the faster the shorter
/// the step.
KOKKOS_INLINE_FUNCTION void limit_closing(const RowNodes& at, double dt, ContactRow& row) {
  const double recovered = contact_limits::recovery * row.size;
  if (row.gap + recovered >= row.target) return;  // whatever the approach, which is not negative
  const double reachable = row.gap + find_longest_approach(row, at, dt) + recovered;
  if (reachable < row.target) row.target = reachable;
}

/// Changes of place in the step by the velocities without contact, and by those with which the check saw the nodes.
struct RowWays {
  Point3 predicted{}, checked{};
};

KOKKOS_INLINE_FUNCTION RowWays find_ways(const RowNodes& at, double dt, const ContactRow& row) {
  return {dt * find_work_velocity(row, TouchedVelocity{at.v, row}),
          dt * find_work_velocity(row, TouchedVelocity{at.v_checked, row})};
}

/// Slide of a step below which little is known of how it changes the gap, share of h. The sides of springs come
/// together far more than they slide, and what dents change would turn the push of two tips along their slide.
inline constexpr double least_slide = 1e-5, least_slide_of_springs = 1e-3;

/// How much of the slip that sticking owes from earlier steps a row takes over, share of h: springs keep all of it.
inline constexpr double longest_slip = contact_limits::recovery, longest_slip_of_springs = 1e300;

/// Whether a spring pushes a row. place: of its nodes.
struct SpringChoice {
  SpringRows rows;
  Array<const double> spring;
  Array<const int> body_of_place;  // empty: there are no rigid bodies

  SpringChoice(const RowInputs& inputs, const RowSystem& system)
      : rows(inputs.springs),
        spring(system.at.spring),
        body_of_place(system.bodies.count() > 0 ? Array<const int>(system.bodies.of_place) : Array<const int>()) {}

  KOKKOS_INLINE_FUNCTION bool operator()(RowKind kind, const int* place, int count, double offset) const {
    if (rows == SpringRows::all) return true;
    if (!(offset > 0)) return false;  // no sheet
    if (rows == SpringRows::none || kind == RowKind::wall || kind == RowKind::tie) return false;
    bool are_rigid = body_of_place.extent(0) > 0;  // these among themselves have no waves that throw them back
    for (int slot = 0; slot < count; ++slot) {
      if (!(spring(place[slot]) > 0)) return false;
      are_rigid = are_rigid && body_of_place(place[slot]) >= 0;
    }
    return !are_rigid;
  }
};

/// The discrete gradient of the gap (Gonzalez, J. Nonlinear Sci. 6, 1996): turns the push direction of a persisting
/// contact, along the direction in which the two sides slide, so that the predicted motion gives exactly the gap change
/// that the check measured. A push then gives no energy where the gap stays as it is, however normals turn and bodies
/// dent. change: of the gap; least: slide of which little is known [length].
KOKKOS_INLINE_FUNCTION Point3 find_discrete_gradient(const Point3& normal, const Point3& way, double change,
                                                     double least) {
  constexpr double most_turn = 0.2;  // tangent of an angle
  const double along = dot(normal, way), missing = change - along;
  const Point3 slide = way - along * normal;
  const double slid = dot(slide, slide), square = slid + along * along + least * least;
  const double turn = missing / square, most = most_turn * most_turn;
  const double steep = turn * turn * slid;
  return normalize(normal + (steep > most ? turn * std::sqrt(most / steep) : turn) * slide);
}

/// Penetration is recovered slowly, as the row itself measures it: from its own gap at n, whatever the geometry at n
/// says. No work was done against the difference of the two, and it would be recovered under load.
KOKKOS_INLINE_FUNCTION void limit_recovery(const RowWays& ways, ContactRow& row) {
  const double recovered = contact_limits::recovery * row.size;
  if (row.gap_start >= recovered) return;
  const double reachable = row.gap - dot(row.gap_gradient, ways.predicted) + recovered;
  if (reachable < row.target) row.target = reachable;
}

/// Overlap to be pushed out, by the record: in its first step a row may find more.
KOKKOS_INLINE_FUNCTION double find_to_push(double of_record, double reference) {
  return of_record > 0 && of_record < reference ? reference : of_record;
}

/// Continues a history record: first guess of the impulses, owed slip, accepted overlap.
KOKKOS_INLINE_FUNCTION void continue_record(const LastContact& record, const RowInputs& inputs, ContactRow& row) {
  const Point3 last = inputs.impulse_scale * record.impulse;
  const double push = dot(last, row.normal);
  row.impulse.normal = push > 0 ? push : 0;
  const double overlap = row.gap_start < 0 ? -row.gap_start : 0;
  row.reference = record.reference < overlap ? record.reference : overlap;
  row.to_push = find_to_push(record.to_push, row.reference);
  row.held = record.held;
  if (!(row.friction > 0)) return;
  const Point3 owed = shorten(record.slip, (row.has_spring ? longest_slip_of_springs : longest_slip) * row.size);
  for (int d = 0; d < 2; ++d) {
    row.impulse.tangential[d] = dot(last, row.tangent[d]);
    row.slide[d] += dot(owed, row.tangent[d]);
  }
  limit_friction(row, row.impulse);
}

/// The rest of a row once its place and gaps are known. old: what it continues, if anything.
KOKKOS_INLINE_FUNCTION void complete_row(const RowInputs& inputs, const RowNodes& at, bool continues,
                                         const LastContact& old, ContactRow& row) {
  if (row.friction > 0) {
    set_tangents(row);
    const Point3 v = find_slip_velocity(row, TouchedVelocity{at.v, row});
    for (int d = 0; d < 2; ++d) row.slide[d] = inputs.motion.dt * dot(v, row.tangent[d]);
  }
  row.depth_tolerance = inputs.depth_tolerance;
  if (continues) continue_record(old, inputs, row);
  set_target(row);
  row.previous = row.impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// rho^2 I - rho rho^T.
KOKKOS_INLINE_FUNCTION Symmetric3<double> find_inertia(const Point3& p) {
  return {p.y * p.y + p.z * p.z, p.z * p.z + p.x * p.x, p.x * p.x + p.y * p.y,
          -(p.x * p.y),          -(p.y * p.z),          -(p.z * p.x)};
}

/// The share of the arm from the middle of both edges to that of one which bears a moment: none where they cross by
/// more than 30 degrees, all where they are parallel and only that arm bears a moment about both.
KOKKOS_INLINE_FUNCTION double find_common_share(const FacePoints& ends) {
  constexpr double square_of_sine = 0.25;
  const Point3 u = ends.corner[1] - ends.corner[0], v = ends.corner[3] - ends.corner[2], c = cross(u, v);
  const double most = square_of_sine * dot(u, u) * dot(v, v), square = dot(c, c);
  return square < most ? 1 - square / most : 0;
}

/// rho and J of two edges that thickness keeps apart: the moment of friction, as long an arm as that distance, is borne
/// by each about its own middle. Borne about the middle of both, it would take back most of the friction of short
/// edges. Still sum rho_i = 0 and sum x_i x (q x rho_i) = J q.
KOKKOS_INLINE_FUNCTION Symmetric3<double> set_edge_arms(const FacePoints& ends, ContactRow& row) {
  const Point3 middle = find_middle(ends), to_a = 0.5 * (ends.corner[0] + ends.corner[1]) - middle;
  const double share = find_common_share(ends);
  Symmetric3<double> inertia{};
  for (int i = 0; i < 4; ++i) {
    const Point3 away = i < 2 ? to_a : -to_a, own = (ends.corner[i] - middle) - away;
    row.rho[i] = own + share * away;
    inertia = inertia + find_inertia(own) + share * find_inertia(away);
  }
  return inertia;
}

/// rho, J^-1 and r from the places at n.
KOKKOS_INLINE_FUNCTION void set_arms(const Rows3<const double>& x, ContactRow& row) {
  // Bearing nodes: the last four slots.
  const int first = row.count - 4;
  const Point3 origin = load_row(x, row.place[0]);
  FacePoints bearing;
  row.arm = Point3{};
  for (int slot = 0; slot < row.count; ++slot) {
    const Point3 p = load_row(x, row.place[slot]) - origin;
    row.arm = row.arm + row.weight[slot] * p;
    if (slot >= first) bearing.corner[slot - first] = p;
  }
  if (row.kind == RowKind::edges && row.has_thickness) {
    row.inverse_inertia = invert(set_edge_arms(bearing, row));
    return;
  }
  const Point3 middle = find_middle(bearing);
  Symmetric3<double> inertia{};
  for (int i = 0; i < 4; ++i) {
    const Point3 p = bearing.corner[i] - middle;
    row.rho[first + i] = p;
    inertia = inertia + find_inertia(p);
  }
  row.inverse_inertia = invert(inertia);
}

/// Copies from its touch what a row keeps unchanged.
KOKKOS_INLINE_FUNCTION void take_touch(const RowTouch& touch, ContactRow& row) {
  for (int slot = 0; slot < touch.count; ++slot) row.weight[slot] = touch.weight[slot];
  row.count = touch.count;
  row.key = touch.key;
  row.kind = touch.kind;
  row.face = touch.face;
  row.record = touch.record;
  row.is_caught = touch.is_caught;
  row.normal = touch.normal;
  row.gap_gradient = touch.normal;
  row.friction = touch.friction;
  row.pair = touch.pair;
  row.size = touch.size;
  row.has_thickness = touch.has_thickness;
  row.gap_start = touch.gap_start;
}

/// The record that a touch continues.
KOKKOS_INLINE_FUNCTION LastContact load_last_contact(const ContactHistory& history, const RowTouch& touch) {
  if (touch.old_record < 0) return {};
  return touch.kind == RowKind::edges ? load_record(history.edges, touch.old_record)
                                      : load_record(history, touch.old_record);
}

/// Cosine between the push that the check found and the line between two sheets from which on that line counts: not
/// where they have gone through one another.
inline constexpr double least_line_cosine = 0.5;

/// Measures a spring between two sheets by the distance of the node from the mid-surface at n. The push is the gradient
/// of this distance, at the closest point, so that it has a potential and needs no couple. Along the normals of the
/// check it would turn with faces on which it does not act, and sheets that are pressed together node over node would
/// flutter. place: of the nodes.
KOKKOS_INLINE_FUNCTION void measure_between_sheets(const RowNodes& at, double dt, const int* place, RowTouch& touch) {
  const Point3 origin = load_row(at.x, place[0]);
  double weight[row_nodes];
  for (int slot = 0; slot < row_nodes; ++slot) weight[slot] = touch.weight[slot];
  if (touch.kind == RowKind::face) {
    FacePoints face;
    for (int i = 0; i < 4; ++i) face.corner[i] = load_row(at.x, place[i + 1]) - origin;
    const FacePoint closest = find_closest_point(face);
    for (int i = 0; i < 4; ++i) weight[i + 1] = -closest.weight[i];
  }
  Point3 arm{}, velocity{};
  for (int slot = 0; slot < touch.count; ++slot) {
    arm = arm + weight[slot] * (load_row(at.x, place[slot]) - origin);
    velocity = velocity + weight[slot] * load_row(at.v_checked, place[slot]);
  }
  const double distance = norm(arm);
  if (!(dot(arm, touch.normal) > least_line_cosine * distance)) return;
  for (int slot = 0; slot < row_nodes; ++slot) touch.weight[slot] = weight[slot];
  touch.normal = (1 / distance) * arm;
  touch.gap_start = distance - touch.offset;
  touch.gap_end = touch.gap_start + dt * dot(touch.normal, velocity);
}

/// The row of a touch whose places are set.
KOKKOS_INLINE_FUNCTION void fill_touch_row(const ContactHistory& history, const RowInputs& inputs, const RowNodes& at,
                                           const RowTouch& touch, ContactRow& row) {
  take_touch(touch, row);
  set_arms(at.x, row);
  const RowWays ways = find_ways(at, inputs.motion.dt, row);
  if (touch.old_record >= 0)
    row.normal = row.gap_gradient =
        find_discrete_gradient(touch.normal, ways.checked, touch.gap_end - touch.gap_start,
                               (row.has_spring ? least_slide_of_springs : least_slide) * touch.size);
  row.gap = touch.gap_end + dot(row.gap_gradient, ways.predicted - ways.checked);
  // Depth that no contact has seen arise cost nothing: it is held.
  if (touch.old_record < 0 && row.gap_start < 0) row.reference = -row.gap_start;
  complete_row(inputs, at, touch.old_record >= 0, load_last_contact(history, touch), row);
  limit_recovery(ways, row);
  limit_closing(at, inputs.motion.dt, row);
}

/// The row of pair p of a wall and a node, whose place is set.
KOKKOS_INLINE_FUNCTION void fill_wall_row(const WallPairs& walls, const ContactHistory& history,
                                          const RowInputs& inputs, const RowNodes& at, int p, ContactRow& row) {
  const ContactWall& wall = walls.walls(walls.wall(p));
  row.key = make_wall_row_key(inputs.node_numbers(walls.node(p)), walls.wall(p));
  row.record = static_cast<int>(history.face.extent(0)) + p;  // behind those of faces
  row.friction = wall.friction;
  row.pair = inputs.num_pairs;
  row.size = walls.size(p);
  const SurfaceMotion& motion = inputs.motion;
  const WallGap gap =
      wall.shape == WallShape::plane
          ? WallGap{find_wall_gap(walls, motion, p, 0), find_wall_gap(walls, motion, p, 1), wall.normal, wall.normal}
          : find_round_gap(walls, motion, p);
  row.normal = gap.normal;
  row.gap_gradient = gap.gradient;
  row.gap_start = gap.start;
  row.gap = gap.end;
  complete_row(inputs, at, true, load_record(history, row.record), row);
  // A plane moves along its normal; what moves along its surface takes nodes along.
  if (wall.shape == WallShape::plane || !(row.friction > 0)) return;
  for (int d = 0; d < 2; ++d) row.slide[d] -= inputs.motion.dt * wall.speed * dot(wall.direction, row.tangent[d]);
}

}  // namespace percuss
