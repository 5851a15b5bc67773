#pragma once
// Rows as the iteration reads them: packs of rows, one a lane, with what a correction needs and nothing else.
//
// A row of any kind is brought to one form: a point that bears nothing (slot 0), then four bearing nodes. What it does
// not have of these has the weight zero and stands at a place where nothing ever moves. The arithmetic is that of
// contact_row.hpp, lane by lane.

#include "kernels/contact/geometry/packed_point.hpp"
#include "kernels/contact/rows/contact_row.hpp"
#include "kernels/core/transpose.hpp"

namespace percuss {

struct alignas(64) RowPack {
  static constexpr int lanes = packed_lanes;
  static constexpr int bearing = row_nodes - 1;  // slots that bear: those after the first

  double weight[row_nodes][lanes];
  double rho[bearing][3][lanes];
  double inverse_inertia[6][lanes];
  double arm[3][lanes];
  double normal[3][lanes], gap_gradient[3][lanes], tangent[2][3][lanes];
  double missing[lanes];                         // gap - target, below 0 where something is to be closed
  double slide[2][lanes];                        // as in ContactRow
  double friction[lanes];                        // likewise; 0 for a tie
  double tied[lanes];                            // 1: a tie, which has no sign and no limit; a frozen row
  double stiffness[2][lanes];                    // D of the normal and of both tangents
  double impulse[3][lanes], previous[3][lanes];  // along normal and tangents, iterates k and k-1
  double lever[lanes];                           // as in ContactRow
  double own[3][lanes];                          // TurningRow::compliance; 0 for others
  int place[row_nodes][lanes];                   // of the nodes in RowPacks::dv
  int share[row_nodes][lanes];                   // of the impulses in RowSystem::shares, -1: nowhere
  int row[lanes];                                // -1: no row
  int has_friction;                              // whether any row has friction, or is a tie
  int ties;                                      // whether any row is a tie, or frozen
  int tilted;                                    // whether any gap gradient is not the normal; without, none is set
  int turning;                                   // whether any row ties a rotation; without, lever and own are not set
};

/// The rows of a step in packs.
struct RowPacks {
  int count = 0;
  Array<RowPack> pack = Array<RowPack>("contact::row_packs", 0);
  Array<int> active = Array<int>("contact::active_packs", 0);    // [count] whether any row was ever to be corrected
  Array<int> order = Array<int>("contact::pack_order", 0);       // [rows] the rows of the lanes
  Rows4<double> dv = Rows4<double>("contact::extrapolated", 0);  // [places + 1] of the extrapolated iterate; last: 0
  Array<int> moved = Array<int>("contact::moved_places", 0);     // [places + 1] whether dv is not zero
  Array<int> active_nodes = Array<int>("contact::active_nodes", 0);  // [places + 1] whether an active row touches it
};

/// The rows of `rows` at the places of the lanes.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint load_places(const Rows4<const double>& rows,
                                                    const int (&place)[RowPack::lanes]) {
  alignas(64) double packs[4][RowPack::lanes];
  load_rows_of_four(rows.data(), place, packs);
  return load_point(packs);
}

/// P of the impulses p along the directions of a pack's rows.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint sum_impulse(const RowPack& pack, const Packed (&p)[3]) {
  const PackedPoint push = p[0] * load_point(pack.normal);
  if (pack.has_friction == 0) return push;
  return push + (p[1] * load_point(pack.tangent[0]) + p[2] * load_point(pack.tangent[1]));
}

/// A force P on the pushed points of a pack's rows and its couple q, and what they give each slot.
struct PackedForce {
  PackedPoint force, couple;

  KOKKOS_FORCEINLINE_FUNCTION PackedForce(const RowPack& pack, const PackedPoint& of) : force(of) {
    const Symmetric3<Packed> inverse_inertia = {load_pack(pack.inverse_inertia[0]), load_pack(pack.inverse_inertia[1]),
                                                load_pack(pack.inverse_inertia[2]), load_pack(pack.inverse_inertia[3]),
                                                load_pack(pack.inverse_inertia[4]), load_pack(pack.inverse_inertia[5])};
    const PackedPoint moment = cross(load_point(pack.arm), force);
    couple = inverse_inertia * (pack.turning == 0 ? moment : moment + load_pack(pack.lever) * force);
  }

  KOKKOS_FORCEINLINE_FUNCTION PackedPoint spread(const RowPack& pack, int slot) const {
    const PackedPoint straight = load_pack(pack.weight[slot]) * force;
    return slot == 0 ? straight : straight - cross(couple, load_point(pack.rho[slot - 1]));
  }
};

/// find_work_velocity() of contact_row.hpp.
KOKKOS_FORCEINLINE_FUNCTION PackedPoint find_work_velocity(const RowPack& pack, const Rows4<const double>& dv) {
  PackedPoint relative = load_pack(pack.weight[0]) * load_places(dv, pack.place[0]);
  PackedPoint spin = {Packed(0), Packed(0), Packed(0)};
  for (int k = 0; k < RowPack::bearing; ++k) {
    const PackedPoint v = load_places(dv, pack.place[k + 1]);
    relative = relative + load_pack(pack.weight[k + 1]) * v;
    spin = spin + cross(load_point(pack.rho[k]), v);
  }
  const Symmetric3<Packed> inverse_inertia = {load_pack(pack.inverse_inertia[0]), load_pack(pack.inverse_inertia[1]),
                                              load_pack(pack.inverse_inertia[2]), load_pack(pack.inverse_inertia[3]),
                                              load_pack(pack.inverse_inertia[4]), load_pack(pack.inverse_inertia[5])};
  const PackedPoint turn = inverse_inertia * spin, u = relative - cross(turn, load_point(pack.arm));
  return pack.turning == 0 ? u : u - load_pack(pack.lever) * turn;
}

/// Shortens the tangential p[1], p[2] to Coulomb's limit.
KOKKOS_FORCEINLINE_FUNCTION void limit_friction(const Packed& friction, Packed (&p)[3]) {
  const Packed limit = friction * p[0];
  const Packed length = square_root(p[1] * p[1] + p[2] * p[2]);
  const auto is_long = length > limit;
  const Packed factor = select(is_long, limit / length, Packed(1));
  // Without a push there is no friction, even where the square of a tiny one is zero: a row that rests must not depend
  // on whether its pack is looked at.
  for (int d = 1; d < 3; ++d) p[d] = select(limit > Packed(0), p[d] * factor, Packed(0));
}

/// Chooses the value of a tie, without sign and limit, or that of any other row.
KOKKOS_FORCEINLINE_FUNCTION Packed choose_tied(const RowPack& pack, const Packed& of_tie, const Packed& of_others) {
  return pack.ties == 0 ? of_others : select(load_pack(pack.tied) > Packed(0), of_tie, of_others);
}

/// Change of the impulses of a pack from y: its size as a displacement, how far it points back; the work of the change
/// and that of the impulses, over dt^2.
struct PackedChange {
  Packed size = Packed(0), backwards = Packed(0), changed_work = Packed(0), work = Packed(0);

  KOKKOS_FORCEINLINE_FUNCTION void add(const Packed& y, const Packed& fresh, const Packed& old, const Packed& stiffness,
                                       double dt) {
    const Packed back = y - fresh, momentum = stiffness * back;
    const Packed moved = Packed(dt) * select(back < Packed(0), -momentum, momentum);
    size = select(moved > size, moved, size);
    backwards = backwards + momentum * (fresh - old);
    const Packed changed = momentum * fresh;
    changed_work = changed_work + select(changed < Packed(0), -changed, changed);
    work = work + stiffness * fresh * fresh;
  }
};

/// One corrected force of the iteration for the rows of a pack: the impulse that would close a row if its neighbours
/// followed, pushing only (but for ties), within Coulomb's limit. From their iterate extrapolated by beta and the
/// motion dv that it causes.
KOKKOS_FORCEINLINE_FUNCTION PackedChange correct_pack(RowPack& pack, const Rows4<const double>& dv, double beta,
                                                      double dt) {
  PackedPoint u = find_work_velocity(pack, dv);
  const Packed step(dt);
  PackedChange change;
  Packed y[3], p[3] = {Packed(0), Packed(0), Packed(0)};
  const int directions = pack.has_friction != 0 ? 3 : 1;
  for (int d = 0; d < directions; ++d) {
    const Packed now = load_pack(pack.impulse[d]);
    y[d] = now + Packed(beta) * (now - load_pack(pack.previous[d]));
  }
  if (pack.turning != 0) {
    const PackedPoint own = load_point(pack.own);
    u = u + PackedPoint{own.x * y[0], own.y * y[1], own.z * y[2]};
  }
  const Packed stiffness = load_pack(pack.stiffness[0]);
  const Packed push =
      y[0] - (load_pack(pack.missing) + step * dot(load_point(pack.tilted != 0 ? pack.gap_gradient : pack.normal), u)) /
                 (step * stiffness);
  p[0] = choose_tied(pack, push, select(push > Packed(0), push, Packed(0)));
  change.add(y[0], p[0], load_pack(pack.impulse[0]), stiffness, dt);
  if (pack.has_friction != 0) {
    const Packed tangential_stiffness = load_pack(pack.stiffness[1]);
    for (int d = 1; d < 3; ++d)
      p[d] = y[d] - (load_pack(pack.slide[d - 1]) + step * dot(load_point(pack.tangent[d - 1]), u)) /
                        (step * tangential_stiffness);
    const Packed free[2] = {p[1], p[2]};
    limit_friction(load_pack(pack.friction), p);
    for (int d = 1; d < 3; ++d) p[d] = choose_tied(pack, free[d - 1], p[d]);
    for (int d = 1; d < 3; ++d) change.add(y[d], p[d], load_pack(pack.impulse[d]), tangential_stiffness, dt);
  }
  for (int d = 0; d < directions; ++d) {
    store_pack(pack.previous[d], load_pack(pack.impulse[d]));
    store_pack(pack.impulse[d], p[d]);
  }
  return change;
}

/// Stores what the rows of a pack add to the nodes in one of their slots.
KOKKOS_FORCEINLINE_FUNCTION void store_share(const RowPack& pack, int slot, const PackedPoint& value,
                                             const Rows4<double>& shares) {
  alignas(64) double packs[4][RowPack::lanes];
  store_pack(packs[0], value.x);
  store_pack(packs[1], value.y);
  store_pack(packs[2], value.z);
  store_pack(packs[3], Packed(0));
  store_rows_of_four(packs, pack.share[slot], shares.data());
}

/// Stores what the impulses of a pack give its slots: shares.
KOKKOS_FORCEINLINE_FUNCTION void share_pack(const RowPack& pack, const Rows4<double>& shares) {
  const Packed p[3] = {load_pack(pack.impulse[0]), load_pack(pack.impulse[1]), load_pack(pack.impulse[2])};
  const PackedForce force(pack, sum_impulse(pack, p));
  for (int slot = 0; slot < row_nodes; ++slot) store_share(pack, slot, force.spread(pack, slot), shares);
}

/// dv of a place in the extrapolated iterate of the packs.
KOKKOS_INLINE_FUNCTION void set_dv(const RowPacks& packs, int a, const Point3& dv) {
  store_row(packs.dv, a, dv);
  packs.dv(a, 3) = 0;
  packs.moved(a) = dv.x != 0 || dv.y != 0 || dv.z != 0 ? 1 : 0;
}

KOKKOS_INLINE_FUNCTION Point3 extrapolate(const Point3& dv, const Point3& before, double beta) {
  return beta > 0 ? dv + beta * (dv - before) : dv;
}

KOKKOS_INLINE_FUNCTION void set_lane(double (*values)[RowPack::lanes], int lane, const Point3& a) {
  values[0][lane] = a.x;
  values[1][lane] = a.y;
  values[2][lane] = a.z;
}

/// A row that is frozen: one push along its whole force, which nothing changes. Like a tie it has no part in the work
/// by which the convergence of the others is judged.
KOKKOS_INLINE_FUNCTION void set_frozen(RowPack& pack, int lane, const ContactRow& row) {
  constexpr double unmoved = 1e300;
  const double push = norm(row.force);
  const Point3 normal = push > 0 ? (1 / push) * row.force : Point3{};
  set_lane(pack.normal, lane, normal);
  if (pack.tilted != 0) set_lane(pack.gap_gradient, lane, normal);
  pack.missing[lane] = pack.friction[lane] = 0;
  pack.tied[lane] = pack.ties = 1;
  for (int d = 0; d < 2; ++d) {
    set_lane(pack.tangent[d], lane, Point3{});
    pack.stiffness[d][lane] = unmoved;
    pack.slide[d][lane] = 0;
  }
  set_lane(pack.impulse, lane, {push, 0, 0});
  set_lane(pack.previous, lane, {push, 0, 0});
}

/// Target and first iterate of a row. In: RowPack::tilted.
KOKKOS_INLINE_FUNCTION void set_state(RowPack& pack, int lane, const ContactRow& row) {
  if (is_frozen(row)) return set_frozen(pack, lane, row);
  if (pack.tilted != 0) set_lane(pack.gap_gradient, lane, row.gap_gradient);
  pack.missing[lane] = row.gap - row.target;
  pack.friction[lane] = is_tie(row) ? 0 : row.friction;
  pack.stiffness[0][lane] = row.stiffness;
  pack.stiffness[1][lane] = row.tangential_stiffness;
  for (int d = 0; d < 2; ++d) pack.slide[d][lane] = row.slide[d];
  set_lane(pack.impulse, lane, {row.impulse.normal, row.impulse.tangential[0], row.impulse.tangential[1]});
  set_lane(pack.previous, lane, {row.previous.normal, row.previous.tangential[0], row.previous.tangential[1]});
}

}  // namespace percuss
