#include "kernels/contact/rows/row_packs.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION Point3 multiply(const Point3& a, const Point3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// A lane without a row: its impulse is 0 and stays so.
KOKKOS_INLINE_FUNCTION void clear_lane(RowPack& pack, int lane, int nowhere) {
  for (int slot = 0; slot < row_nodes; ++slot) {
    pack.weight[slot][lane] = 0;
    pack.place[slot][lane] = nowhere;
    pack.share[slot][lane] = -1;
  }
  for (auto& rho : pack.rho) set_lane(rho, lane, {});
  for (auto& value : pack.inverse_inertia) value[lane] = 0;
  for (auto* values :
       {pack.arm, pack.normal, pack.gap_gradient, pack.tangent[0], pack.tangent[1], pack.impulse, pack.previous})
    set_lane(values, lane, {});
  for (auto* value : {pack.missing, pack.slide[0], pack.slide[1], pack.friction, pack.tied}) value[lane] = 0;
  pack.stiffness[0][lane] = pack.stiffness[1][lane] = 1;
  pack.row[lane] = -1;
}

/// Copies the geometry of a row into its lane.
KOKKOS_INLINE_FUNCTION void set_geometry(RowPack& pack, int lane, const ContactRow& row, int r,
                                         const Array<const int>& share_of_slot) {
  const int first = row.count == RowPack::bearing ? 1 : 0;
  for (int slot = 0; slot < row.count; ++slot) {
    pack.weight[first + slot][lane] = row.weight[slot];
    pack.place[first + slot][lane] = row.place[slot];
    pack.share[first + slot][lane] = share_of_slot(r * row_nodes + slot);
    if (first + slot > 0) set_lane(pack.rho[first + slot - 1], lane, row.rho[slot]);
  }
  const Symmetric3<double>& j = row.inverse_inertia;
  const double inverse_inertia[6] = {j.xx, j.yy, j.zz, j.xy, j.yz, j.zx};
  for (int i = 0; i < 6; ++i) pack.inverse_inertia[i][lane] = inverse_inertia[i];
  set_lane(pack.arm, lane, row.arm);
  set_lane(pack.normal, lane, row.normal);
  for (int d = 0; d < 2; ++d) set_lane(pack.tangent[d], lane, row.tangent[d]);
  pack.tied[lane] = is_tie(row) ? 1 : 0;
  pack.row[lane] = r;
  const Point3 tilt = row.gap_gradient - row.normal;
  if (tilt.x != 0 || tilt.y != 0 || tilt.z != 0) pack.tilted = 1;
  if (row.friction > 0) pack.has_friction = 1;
  if (is_tie(row)) pack.ties = 1;
  if (ties_rotation(row)) pack.turning = 1;
}

/// Sets what a pack with rows that tie rotations has besides.
KOKKOS_FUNCTION void set_turning(RowPack& pack, const Array<const ContactRow>& rows,
                                 const Array<const TurningRow>& turning) {
  for (int lane = 0; lane < RowPack::lanes; ++lane) {
    const int r = pack.row[lane];
    const bool turns = r >= 0 && ties_rotation(rows(r));
    pack.lever[lane] = turns ? rows(r).lever : 0;
    set_lane(pack.own, lane, turns ? turning(rows(r).record).compliance : Point3{});
  }
}

/// Marks the nodes of the pack as active. is_alone: no other thread does so at the same time.
KOKKOS_INLINE_FUNCTION void activate_nodes(const RowPack& pack, bool is_alone, const Array<int>& active_nodes) {
  for (const auto& places : pack.place)
    for (const int place : places) {
      if (is_alone)
        active_nodes(place) = 1;
      else
        Kokkos::atomic_fetch_or(&active_nodes(place), 1);
    }
}

KOKKOS_INLINE_FUNCTION bool is_moved(const RowPack& pack, const Array<const int>& moved) {
  int any = 0;
  for (const auto& places : pack.place)
    for (const int place : places) any |= moved(place);
  return any != 0;
}

/// Adds up how the rows of a pack changed. Ties are judged by themselves.
KOKKOS_FORCEINLINE_FUNCTION void add_change(const RowPack& pack, const PackedChange& change, const PassQuery& query,
                                            PassSums& sums) {
  const Packed dt_squared(query.dt * query.dt), zero(0), backwards = dt_squared * change.backwards;
  const auto find_most = [](double most, const Packed& values) {
    const double largest = find_largest_lane(values);
    return largest > most ? largest : most;
  };
  sums.change = find_most(sums.change, choose_tied(pack, zero, change.size));
  if (pack.ties != 0) sums.tie_change = find_most(sums.tie_change, choose_tied(pack, change.size, zero));
  sums.backwards += query.unit.count(backwards);
  const Packed term = select(backwards < zero, -backwards, backwards);
  sums.largest_term = find_most(sums.largest_term, select(term > zero, term, zero));  // none of what is no number
  const Packed work = dt_squared * choose_tied(pack, zero, change.work);
  sums.changed_work += query.work_unit.count(dt_squared * choose_tied(pack, zero, change.changed_work));
  sums.work += query.work_unit.count(work);
  sums.largest_work = find_most(sums.largest_work, work);
}

/// Corrects the rows of an active pack and adds up how they changed. Flattened: a call in here would spill all
/// registers.
PERCUSS_FLATTEN KOKKOS_FUNCTION void advance_pack(RowPack& pack, const Rows4<double>& dv, const Rows4<double>& shares,
                                                  const PassQuery& query, PassSums& sums) {
  const PackedChange change = correct_pack(pack, dv, query.beta, query.dt);
  share_pack(pack, shares);
  add_change(pack, change, query, sums);
}

/// Puts the rows marked in `wants` first in each stretch of rows, so that packs of others may rest; both kinds
/// ascending. The stretches are short, so that threads share the work evenly, each of rows that have nodes in common.
void order_rows(const WorkSpace& space, const Array<const int>& wants, int num_rows, RowPacks& packs) {
  constexpr int stretch = 64 * RowPack::lanes;
  reserve(packs.order, num_rows);
  const Array<int> order = packs.order;
  parallel_for(
      "contact::order_rows", RangeOf(space, 0, (num_rows + stretch - 1) / stretch), KOKKOS_LAMBDA(int s) {
        const int first = s * stretch, end = first + stretch < num_rows ? first + stretch : num_rows;
        int place = first;
        for (const int wanting : {1, 0})
          for (int r = first; r < end; ++r)
            if (wants(r) == wanting) order(place++) = r;
      });
}

}  // namespace

void pack_geometry(const WorkSpace& space, RowSystem& system) {
  RowPacks& packs = system.packs;
  const int num_rows = system.num_rows, nowhere = system.num_places();
  packs.count = (num_rows + RowPack::lanes - 1) / RowPack::lanes;
  order_rows(space, system.wants, num_rows, packs);
  reserve(packs.pack, packs.count);
  const RowPacks p = packs;
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> share_of_slot = system.share_of_slot;
  const Array<const TurningRow> turning = system.turning;
  parallel_for(
      "contact::pack_geometry", RangeOf(space, 0, packs.count), KOKKOS_LAMBDA(int i) {
        RowPack& pack = p.pack(i);
        pack.has_friction = pack.ties = pack.tilted = pack.turning = 0;
        for (int lane = 0; lane < RowPack::lanes; ++lane) {
          const int place = i * RowPack::lanes + lane;
          const int r = place < num_rows ? p.order(place) : -1;
          if (r < 0 || rows(r).count < row_nodes) clear_lane(pack, lane, nowhere);
          if (r >= 0) set_geometry(pack, lane, rows(r), r, share_of_slot);
        }
        if (pack.turning != 0) set_turning(pack, rows, turning);
      });
}

void pack_rows(const WorkSpace& space, RowSystem& system) {
  RowPacks& packs = system.packs;
  const int nowhere = system.num_places();
  reserve(packs.active, packs.count);
  reserve(packs.dv, nowhere + 1);
  reserve(packs.moved, nowhere + 1);
  reserve(packs.active_nodes, nowhere + 1);
  const RowPacks p = packs;
  const Rows3<double> correction = system.correction;
  parallel_for(
      "contact::clear_places", RangeOf(space, 0, nowhere + 1), KOKKOS_LAMBDA(int a) {
        set_dv(p, a, Point3{});
        p.active_nodes(a) = 0;
        if (a < nowhere) store_row(correction, a, Point3{});
      });
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> wants = system.wants;
  const Rows4<double> shares = system.shares;
  const bool is_alone = space.concurrency() == 1;
  // Rows may have changed since sum_stiffness(): by hold_rows_within_bodies(), or springs push them.
  const bool have_changed = system.bodies.count() > 0 || system.has_springs;
  parallel_for(
      "contact::pack_rows", RangeOf(space, 0, packs.count), KOKKOS_LAMBDA(int i) {
        RowPack& pack = p.pack(i);
        p.active(i) = 0;
        for (int lane = 0; lane < RowPack::lanes; ++lane) {
          const int r = pack.row[lane];
          if (r < 0) continue;
          if (have_changed) set_state(pack, lane, rows(r));
          if (wants(r) != 0 || is_frozen(rows(r))) p.active(i) = 1;
        }
        share_pack(pack, shares);
        if (p.active(i) != 0) activate_nodes(pack, is_alone, p.active_nodes);
      });
  const Array<const int> remote_place = system.remote_place;
  parallel_for(
      "contact::activate_remote", RangeOf(space, 0, system.num_remote),
      KOKKOS_LAMBDA(int k) { Kokkos::atomic_fetch_or(&p.active_nodes(remote_place(k)), 1); });
}

void move_nodes(const WorkSpace& space, double beta, const RowSystem& system) {
  place_remote_shares(space, system);
  const ShareSums sums(system);
  const RowPacks p = system.packs;
  const Rows3<double> correction = system.correction;
  const Rows3<const double> inverse_mass = system.at.inverse_mass;
  const bool has_bodies = system.bodies.count() > 0;
  const Array<const int> body_of_place = system.bodies.of_place;
  parallel_for(
      "contact::move_nodes", RangeOf(space, 0, system.num_places()), KOKKOS_LAMBDA(int a) {
        if (p.active_nodes(a) == 0 || (has_bodies && body_of_place(a) >= 0)) return;
        const Point3 before = load_row(correction, a);
        const Point3 dv = multiply(load_row(inverse_mass, a), sums(a));
        store_row(correction, a, dv);
        set_dv(p, a, extrapolate(dv, before, beta));
      });
}

PassSums correct_rows(const WorkSpace& space, const PassQuery& query, const RowSystem& system, RowSumMemory& memory) {
  const RowPacks p = system.packs;
  const Rows4<double> shares = system.shares;
  const bool is_alone = space.concurrency() == 1;
  return sum_rows<PassSums>(space, p.count, memory.pass,
                            [p, shares, query, is_alone] KOKKOS_FUNCTION(int i, PassSums& s) {
                              RowPack& pack = p.pack(i);
                              if (p.active(i) == 0) {
                                if (!is_moved(pack, p.moved)) return;
                                p.active(i) = 1;
                                activate_nodes(pack, is_alone, p.active_nodes);
                              }
                              advance_pack(pack, p.dv, shares, query, s);
                            });
}

void straighten_gaps(const WorkSpace& space, const RowSystem& system) {
  const RowPacks p = system.packs;
  const Array<ContactRow> rows = system.rows;
  parallel_for(
      "contact::straighten_gaps", RangeOf(space, 0, p.count), KOKKOS_LAMBDA(int i) {
        RowPack& pack = p.pack(i);
        for (int lane = 0; lane < RowPack::lanes; ++lane) {
          if (pack.row[lane] < 0) continue;
          ContactRow& row = rows(pack.row[lane]);
          row.gap_gradient = row.normal;
          set_lane(pack.gap_gradient, lane, row.normal);
        }
      });
}

void unpack_rows(const WorkSpace& space, const RowSystem& system) {
  const RowPacks p = system.packs;
  const Array<ContactRow> rows = system.rows;
  parallel_for(
      "contact::unpack_rows", RangeOf(space, 0, p.count), KOKKOS_LAMBDA(int i) {
        if (p.active(i) == 0) return;
        const RowPack& pack = p.pack(i);
        for (int lane = 0; lane < RowPack::lanes; ++lane) {
          if (pack.row[lane] < 0 || is_frozen(rows(pack.row[lane]))) continue;
          ContactRow& row = rows(pack.row[lane]);
          row.previous = {pack.previous[0][lane], {pack.previous[1][lane], pack.previous[2][lane]}};
          row.impulse = {pack.impulse[0][lane], {pack.impulse[1][lane], pack.impulse[2][lane]}};
          row.force = sum_impulse(row, row.impulse);
          row.couple = find_couple(row, row.force);
        }
      });
}

}  // namespace percuss
