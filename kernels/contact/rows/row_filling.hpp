#pragma once
// Rows of nodes on faces, made a pack at a time, one a lane. The arithmetic is that of fill_touch_row()
// (row_geometry.hpp), lane by lane to the same bits.

#include "kernels/contact/geometry/packed_point.hpp"
#include "kernels/contact/rows/row_geometry.hpp"

namespace percuss {

/// Touches of nodes with faces, by lane, and the records that they continue.
struct alignas(64) TouchPack {
  static constexpr int lanes = packed_lanes;
  static constexpr int bearing = row_nodes - 1;

  double weight[bearing][lanes];  // of the corners, <= 0; that of the node is 1
  double normal[3][lanes], gap_start[lanes], gap_end[lanes], size[lanes], friction[lanes];
  double thickness[lanes];  // 1 where it is between the two sides, else 0
  double spring[lanes];     // 1: ContactRow::has_spring, else 0
  double continues[lanes];  // 1: a record, which follows; 0: none
  double impulse[3][lanes], slip[3][lanes], reference[lanes], held[lanes], to_push[lanes];  // LastContact
  int place[row_nodes][lanes];
  int row[lanes];
  int count = 0;
  int has_friction = 0;  // whether any does

  KOKKOS_INLINE_FUNCTION void add(const RowTouch& touch, int r, const int* places, const LastContact& record,
                                  bool has_spring) {
    const int lane = count++;
    spring[lane] = has_spring ? 1 : 0;
    for (int i = 0; i < bearing; ++i) weight[i][lane] = touch.weight[i + 1];
    gap_start[lane] = touch.gap_start;
    gap_end[lane] = touch.gap_end;
    size[lane] = touch.size;
    friction[lane] = touch.friction;
    thickness[lane] = touch.has_thickness ? 1 : 0;
    continues[lane] = touch.old_record >= 0 ? 1 : 0;
    set(normal, lane, touch.normal);
    set(impulse, lane, record.impulse);
    set(slip, lane, record.slip);
    reference[lane] = record.reference;
    held[lane] = record.held;
    to_push[lane] = record.to_push;
    for (int slot = 0; slot < row_nodes; ++slot) place[slot][lane] = places[slot];
    row[lane] = r;
    if (touch.friction > 0) has_friction = 1;
  }

  /// Lanes to spare repeat the first.
  KOKKOS_INLINE_FUNCTION void fill_up() {
    for (int lane = count; lane < lanes; ++lane) {
      for (auto& values : weight) values[lane] = values[0];
      for (auto* values : {normal, impulse, slip})
        for (int axis = 0; axis < 3; ++axis) values[axis][lane] = values[axis][0];
      for (auto* values : {gap_start, gap_end, size, friction, thickness, spring, continues, reference})
        values[lane] = values[0];
      for (auto& values : place) values[lane] = values[0];
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION Packed choose_by_spring(double of_springs, double of_others) const {
    return select(load_pack(spring) > Packed(0), Packed(of_springs), Packed(of_others));
  }

 private:
  KOKKOS_INLINE_FUNCTION static void set(double (&values)[3][lanes], int lane, const Point3& a) {
    values[0][lane] = a.x;
    values[1][lane] = a.y;
    values[2][lane] = a.z;
  }
};

/// Geometry of the rows of a pack, as in ContactRow.
struct FilledRows {
  PackedPoint rho[TouchPack::bearing], arm, normal, tangent[2], force, couple;
  Symmetric3<Packed> inverse_inertia;
  Packed gap, target, reference, slide[2], impulse[3];
};

namespace filling {

KOKKOS_FORCEINLINE_FUNCTION PackedPoint no_points() { return {Packed(0), Packed(0), Packed(0)}; }

/// Vectors shortened to `longest`.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint shorten_lanes(const PackedPoint& a, const Packed& longest) {
  const Packed length = norm(a);
  const auto is_long = length > longest;
  const Packed factor = longest / select(is_long, length, Packed(1));
  return select_point(is_long, factor * a, a);
}

/// invert() of point3.hpp.
KOKKOS_FORCEINLINE_FUNCTION Symmetric3<Packed> invert_lanes(const Symmetric3<Packed>& a) {
  const Packed xx = a.yy * a.zz - a.yz * a.yz, xy = a.yz * a.zx - a.xy * a.zz, zx = a.xy * a.yz - a.yy * a.zx;
  const Packed yy = a.xx * a.zz - a.zx * a.zx, yz = a.xy * a.zx - a.xx * a.yz, zz = a.xx * a.yy - a.xy * a.xy;
  const Packed determinant = a.xx * xx + a.xy * xy + a.zx * zx, zero(0);
  const auto is_regular = determinant > zero;
  const Packed s = Packed(1) / select(is_regular, determinant, Packed(1));
  const auto choose = [&](const Packed& value) { return select(is_regular, s * value, zero); };
  return {choose(xx), choose(yy), choose(zz), choose(xy), choose(yz), choose(zx)};
}

/// set_arms().
KOKKOS_FORCEINLINE_FUNCTION void set_arms(const TouchPack& touch, const Rows3<const double>& x, FilledRows& row) {
  const PackedPoint origin = load_points(x, touch.place[0]);
  FaceOf<Packed> face;
  row.arm = no_points();
  for (int i = 0; i < TouchPack::bearing; ++i) {
    face.corner[i] = load_points(x, touch.place[i + 1]) - origin;
    row.arm = row.arm + load_pack(touch.weight[i]) * face.corner[i];
  }
  const PackedPoint middle = Packed(0.25) * ((face.corner[0] + face.corner[1]) + (face.corner[2] + face.corner[3]));
  const Packed zero(0);
  Symmetric3<Packed> inertia{zero, zero, zero, zero, zero, zero};
  for (int i = 0; i < TouchPack::bearing; ++i) {
    const PackedPoint p = face.corner[i] - middle;
    row.rho[i] = p;
    inertia = inertia + Symmetric3<Packed>{p.y * p.y + p.z * p.z, p.z * p.z + p.x * p.x, p.x * p.x + p.y * p.y,
                                           -(p.x * p.y),          -(p.y * p.z),          -(p.z * p.x)};
  }
  row.inverse_inertia = invert_lanes(inertia);
}

/// Velocities of the two sides relative to each other.
struct SideVelocities {
  PackedPoint relative, work;  // find_relative_velocity(), find_work_velocity()

  KOKKOS_FORCEINLINE_FUNCTION SideVelocities(const TouchPack& touch, const FilledRows& row,
                                             const Rows3<const double>& v) {
    PackedPoint spin = no_points();
    relative = spin + load_points(v, touch.place[0]);
    for (int i = 0; i < TouchPack::bearing; ++i) {
      const PackedPoint corner = load_points(v, touch.place[i + 1]);
      relative = relative + load_pack(touch.weight[i]) * corner;
      spin = spin + cross(row.rho[i], corner);
    }
    work = relative - cross(row.inverse_inertia * spin, row.arm);
  }
};

/// find_discrete_gradient().
KOKKOS_FORCEINLINE_FUNCTION PackedPoint find_gradient(const PackedPoint& normal, const PackedPoint& way,
                                                      const Packed& change, const Packed& least) {
  constexpr double most_turn = 0.2;
  const Packed along = dot(normal, way), missing = change - along;
  const PackedPoint slide = way - along * normal;
  const Packed slid = dot(slide, slide);
  const Packed square = slid + along * along + least * least;
  const Packed turn = missing / square, most(most_turn * most_turn), steep = turn * turn * slid;
  const auto is_steep = steep > most;
  const Packed shorter = turn * square_root(most / select(is_steep, steep, Packed(1)));
  return normalize(normal + select(is_steep, shorter, turn) * slide);
}

/// set_tangents().
KOKKOS_FORCEINLINE_FUNCTION void set_tangents(FilledRows& row) {
  const PackedPoint& n = row.normal;
  const Packed zero(0), one(1);
  const auto find_abs = [&](const Packed& a) { return select(a < zero, -a, a); };
  const Packed x = find_abs(n.x), y = find_abs(n.y), z = find_abs(n.z);
  const auto is_x = x <= y && x <= z, is_y = !is_x && y <= z;
  const auto is_z = !is_x && !is_y;
  const PackedPoint axis = {select(is_x, one, zero), select(is_y, one, zero), select(is_z, one, zero)};
  row.tangent[0] = normalize(cross(n, axis));
  row.tangent[1] = cross(n, row.tangent[0]);
}

/// Sets the part of friction: tangents, slide and tangential impulses; zeros without friction. last: impulse of the
/// record. In: push.
KOKKOS_FORCEINLINE_FUNCTION void set_friction(const TouchPack& touch, const SideVelocities& velocity,
                                              const RowInputs& inputs, const PackedPoint& last, FilledRows& row) {
  const Packed zero(0), friction = load_pack(touch.friction);
  const auto has_friction = friction > zero;
  const auto goes_on = load_pack(touch.continues) > zero;
  set_tangents(row);
  const PackedPoint v = select_point(load_pack(touch.thickness) > zero, velocity.work, velocity.relative);
  const Packed longest = touch.choose_by_spring(longest_slip_of_springs, longest_slip) * load_pack(touch.size);
  const PackedPoint owed = shorten_lanes(load_point(touch.slip), longest);
  for (int d = 0; d < 2; ++d) {
    row.tangent[d] = select_point(has_friction, row.tangent[d], no_points());
    const Packed slide = Packed(inputs.motion.dt) * dot(v, row.tangent[d]);
    row.slide[d] = select(has_friction, select(goes_on, slide + dot(owed, row.tangent[d]), slide), zero);
    row.impulse[d + 1] = dot(last, row.tangent[d]);
  }
  limit_friction(friction, row.impulse);
}

/// complete_row().
KOKKOS_FORCEINLINE_FUNCTION void complete_rows(const TouchPack& touch, const SideVelocities& velocity,
                                               const RowInputs& inputs, FilledRows& row) {
  const Packed zero(0), gap_start = load_pack(touch.gap_start), recovery(contact_limits::recovery);
  const auto goes_on = load_pack(touch.continues) > zero;
  const PackedPoint last = Packed(inputs.impulse_scale) * load_point(touch.impulse);
  const Packed push = dot(last, row.normal), overlap = select(gap_start < zero, -gap_start, zero);
  const Packed reference = load_pack(touch.reference);
  const Packed accepted = select(reference < overlap, reference, overlap);
  row.reference = select(goes_on, accepted, overlap);
  row.impulse[0] = select(goes_on && push > zero, push, zero);
  row.force = row.impulse[0] * row.normal;
  for (int d = 0; d < 2; ++d) {
    row.tangent[d] = no_points();
    row.slide[d] = row.impulse[d + 1] = zero;
  }
  if (touch.has_friction != 0) {
    set_friction(touch, velocity, inputs, last, row);
    const PackedPoint tangential = row.impulse[1] * row.tangent[0] + row.impulse[2] * row.tangent[1];
    row.force = select_point(load_pack(touch.friction) > zero, row.force + tangential, row.force);
  }
  const Packed depth_tolerance(inputs.depth_tolerance),
      floor = select(row.reference > depth_tolerance, -row.reference, -depth_tolerance);
  const Packed recovered = gap_start + recovery * load_pack(touch.size);
  row.target = select(recovered < floor, recovered, floor);
  row.couple = row.inverse_inertia * cross(row.arm, row.force);
}

/// limit_recovery(). predicted: way of the step.
KOKKOS_FORCEINLINE_FUNCTION void limit_recovery(const TouchPack& touch, const PackedPoint& predicted, FilledRows& row) {
  const Packed recovered = Packed(contact_limits::recovery) * load_pack(touch.size);
  const Packed reachable = row.gap - dot(row.normal, predicted) + recovered;
  const auto is_lower = !(load_pack(touch.gap_start) >= recovered) && reachable < row.target;
  row.target = select(is_lower, reachable, row.target);
}

/// limit_closing().
KOKKOS_FORCEINLINE_FUNCTION void limit_closing(const TouchPack& touch, const RowNodes& at, double dt, FilledRows& row) {
  const Packed recovered = Packed(contact_limits::recovery) * load_pack(touch.size);
  const auto is_asked = !(row.gap + recovered >= row.target);
  if (!any(is_asked)) return;
  const PackedPoint v = load_points(at.v, touch.place[0]);
  Packed fastest(0);
  for (int i = 0; i < TouchPack::bearing; ++i) {
    const Packed speed = norm(v - load_points(at.v, touch.place[i + 1]));
    fastest = select(speed > fastest, speed, fastest);
  }
  const Packed turn = select(load_pack(touch.thickness) > Packed(0), Packed(longest_turn), Packed(1));
  const Packed reachable = row.gap + turn * norm(row.normal) * Packed(dt) * fastest + recovered;
  row.target = select(is_asked && reachable < row.target, reachable, row.target);
}

}  // namespace filling

/// Fills the rows of a pack whose lanes to spare are filled up.
KOKKOS_FORCEINLINE_FUNCTION FilledRows fill_face_rows(const TouchPack& touch, const RowInputs& inputs,
                                                      const RowNodes& at) {
  FilledRows row;
  filling::set_arms(touch, at.x, row);
  const Packed dt(inputs.motion.dt), gap_end = load_pack(touch.gap_end);
  const filling::SideVelocities velocity(touch, row, at.v), checked(touch, row, at.v_checked);
  const PackedPoint predicted = dt * velocity.work, checked_way = dt * checked.work, normal = load_point(touch.normal);
  const Packed least = touch.choose_by_spring(least_slide_of_springs, least_slide) * load_pack(touch.size);
  const PackedPoint gradient = filling::find_gradient(normal, checked_way, gap_end - load_pack(touch.gap_start), least);
  row.normal = select_point(load_pack(touch.continues) > Packed(0), gradient, normal);
  row.gap = gap_end + dot(row.normal, predicted - checked_way);
  filling::complete_rows(touch, velocity, inputs, row);
  filling::limit_recovery(touch, predicted, row);
  filling::limit_closing(touch, at, inputs.motion.dt, row);
  return row;
}

/// FilledRows by lane.
struct FilledLanes {
  LanePoints rho[TouchPack::bearing], arm, normal, tangent[2], force, couple;
  LaneValues inverse_inertia[6], gap, target, reference, slide[2], impulse[3];

  KOKKOS_FORCEINLINE_FUNCTION explicit FilledLanes(const FilledRows& row)
      : rho{LanePoints(row.rho[0]), LanePoints(row.rho[1]), LanePoints(row.rho[2]), LanePoints(row.rho[3])},
        arm(row.arm),
        normal(row.normal),
        tangent{LanePoints(row.tangent[0]), LanePoints(row.tangent[1])},
        force(row.force),
        couple(row.couple),
        inverse_inertia{LaneValues(row.inverse_inertia.xx), LaneValues(row.inverse_inertia.yy),
                        LaneValues(row.inverse_inertia.zz), LaneValues(row.inverse_inertia.xy),
                        LaneValues(row.inverse_inertia.yz), LaneValues(row.inverse_inertia.zx)},
        gap(row.gap),
        target(row.target),
        reference(row.reference),
        slide{LaneValues(row.slide[0]), LaneValues(row.slide[1])},
        impulse{LaneValues(row.impulse[0]), LaneValues(row.impulse[1]), LaneValues(row.impulse[2])} {}

  KOKKOS_INLINE_FUNCTION void store(int lane, ContactRow& row) const {
    for (int i = 0; i < TouchPack::bearing; ++i) row.rho[i + 1] = rho[i][lane];
    const auto& j = inverse_inertia;
    row.inverse_inertia = {j[0][lane], j[1][lane], j[2][lane], j[3][lane], j[4][lane], j[5][lane]};
    row.arm = arm[lane];
    row.normal = row.gap_gradient = normal[lane];
    row.gap = gap[lane];
    row.target = target[lane];
    row.reference = reference[lane];
    for (int d = 0; d < 2; ++d) {
      row.tangent[d] = tangent[d][lane];
      row.slide[d] = slide[d][lane];
    }
    row.impulse = {impulse[0][lane], {impulse[1][lane], impulse[2][lane]}};
    row.previous = row.impulse;
    row.force = force[lane];
    row.couple = couple[lane];
  }
};

/// Makes the rows of a pack. touches: [rows].
PERCUSS_FLATTEN KOKKOS_FUNCTION inline void make_face_rows(const TouchPack& pack, const RowInputs& inputs,
                                                           const RowNodes& at, const Array<const RowTouch>& touches,
                                                           const Array<ContactRow>& rows) {
  const FilledLanes filled(fill_face_rows(pack, inputs, at));
  for (int lane = 0; lane < pack.count; ++lane) {
    ContactRow& row = rows(pack.row[lane]);
    row = ContactRow{};
    take_touch(touches(pack.row[lane]), row);
    for (int slot = 0; slot < row_nodes; ++slot) row.place[slot] = pack.place[slot][lane];
    for (int i = 0; i < TouchPack::bearing; ++i) row.weight[i + 1] = pack.weight[i][lane];
    row.gap_start = pack.gap_start[lane];
    row.depth_tolerance = inputs.depth_tolerance;
    row.held = pack.held[lane];
    row.has_spring = pack.spring[lane] > 0;
    filled.store(lane, row);
    row.to_push = find_to_push(pack.to_push[lane], row.reference);
  }
}

}  // namespace percuss
