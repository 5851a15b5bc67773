// Outcome of the impulses of a step: velocities, work, residuals, history.

#include "kernels/contact/enforcement/enforcement.hpp"
#include "kernels/contact/enforcement/push_out.hpp"
#include "kernels/contact/rows/row_geometry.hpp"
#include "kernels/contact/rows/tie_row.hpp"

namespace percuss {
namespace {

/// Mean of the velocities before and after the step.
struct MeanVelocity {
  Rows3<const double> before, predicted, dv;
  const ContactRow& row;
  KOKKOS_INLINE_FUNCTION Point3 operator()(int slot) const {
    const int a = row.place[slot];
    return 0.5 * (load_row(before, a) + (load_row(predicted, a) + load_row(dv, a)));
  }
};

/// Work of the normal and of the tangential impulse of a row.
struct RowWork {
  double normal = 0, friction = 0;
};
KOKKOS_INLINE_FUNCTION RowWork find_work(const ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                         const Array<const TurningRow>& turning) {
  if (row.impulse.normal == 0 && row.impulse.tangential[0] == 0 && row.impulse.tangential[1] == 0) return {};
  const Point3 mean = find_work_velocity(row, MeanVelocity{at.v_before, at.v, dv, row});
  RowWork work;
  if (is_tie(row)) {
    const Point3 own = ties_rotation(row) ? find_mean_spin(row, turning(row.record)) : Point3{};
    work.normal = dot(row.force, mean + own);
    return work;
  }
  if (row.impulse.normal > 0) work.normal = row.impulse.normal * dot(row.normal, mean);
  if (row.friction > 0)
    work.friction =
        row.impulse.tangential[0] * dot(row.tangent[0], mean) + row.impulse.tangential[1] * dot(row.tangent[1], mean);
  return work;
}

/// Energy in the tangential springs of a penalty row at n+1/2. One whose stretch changes sign has given all it held.
KOKKOS_INLINE_FUNCTION double find_friction_energy(const ContactRow& row, const RowNodes& at,
                                                   const Rows3<const double>& dv, double dt) {
  if (!(row.friction > 0)) return 0;
  const Point3 predicted = dt * find_slip_velocity(row, TouchedVelocity{at.v, row});
  const Point3 corrected = dt * find_slip_velocity(row, TouchedVelocity{dv, row});
  double energy = 0;
  for (int d = 0; d < 2; ++d)
    energy += 0.5 * row.spring * (row.slide[d] - dot(predicted, row.tangent[d])) *
              (row.slide[d] + dot(corrected, row.tangent[d]));
  return energy > 0 ? energy : 0;
}

KOKKOS_INLINE_FUNCTION void add_tie_outcome(const ContactRow& row, double work, const Rows3<const double>& dv,
                                            const Point3& own_change, double dt, EnforcementSums& sums) {
  sums.pushes += ties_rotation(row) ? 0 : 1;
  if (work != 0) sums.normal_work.add(work);
  const Point3 moved = dt * (find_work_velocity(row, TouchedVelocity{dv, row}) + own_change);
  const Point3 left{row.gap + moved.x, row.slide[0] + moved.y, row.slide[1] + moved.z};
  const double residual = max_component(left) / row.size;
  sums.residual = residual > sums.residual ? residual : sums.residual;
  sums.add_held_apart(row.held_apart / row.size, row.key);
}

/// Bound of the square of the frequency that the springs of a row add: by masses without damping, which leaves the
/// largest stable step as it is.
KOKKOS_INLINE_FUNCTION double find_rate(const ContactRow& row, const RowNodes& at) {
  double growth = 1;
  for (const int place : row.place)
    if (place >= 0 && at.growth(place) > growth) growth = at.growth(place);
  const bool is_slip = row.friction > 0 && row.tangential_stiffness > row.stiffness;
  return row.spring * growth * (is_slip ? row.tangential_stiffness : row.stiffness);
}

/// The gap at n+1.
KOKKOS_INLINE_FUNCTION double find_gap(const ContactRow& row, const Rows3<const double>& dv, double dt) {
  return row.gap + dt * dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{dv, row}));
}

KOKKOS_INLINE_FUNCTION void add_outcome(const ContactRow& row, const RowNodes& at, const Rows3<const double>& dv,
                                        const Array<const TurningRow>& turning, double dt, EnforcementSums& sums) {
  const RowWork work = find_work(row, at, dv, turning);
  if (is_tie(row)) {
    const Point3 own = ties_rotation(row) ? find_own_change(row, turning(row.record)) : Point3{};
    add_tie_outcome(row, work.normal, dv, own, dt, sums);
    return;
  }
  sums.pushes += row.impulse.normal > 0 ? 1 : 0;
  if (work.normal != 0) sums.normal_work.add(work.normal);
  sums.add_given(work.normal, row.key);
  if (row.friction > 0) sums.friction_work.add(work.friction);
  const double gap = find_gap(row, dv, dt);
  if (row.spring > 0) {
    const double slip = find_friction_energy(row, at, dv, dt);
    sums.stored.add(row.held + slip);
    if (slip != 0) sums.stored_slip.add(slip);
    const double rate = find_rate(row, at);
    sums.rate = rate > sums.rate ? rate : sums.rate;
  }
  const double residual = row.target > gap ? (row.target - gap) / row.size : 0;
  sums.residual = residual > sums.residual ? residual : sums.residual;
  sums.add_depth((find_floor(row) - row.gap_start) / row.size, row.key);
}

/// The tangential displacement that sticking owes after the step, or that stretches a spring; nothing when it slides.
KOKKOS_INLINE_FUNCTION Point3 find_owed_slip(const ContactRow& row, const Rows3<const double>& dv, double dt) {
  if (!(row.spring > 0) && !is_sticking(row)) return {};
  const Point3 moved = dt * find_slip_velocity(row, TouchedVelocity{dv, row});
  return (row.slide[0] + dot(moved, row.tangent[0])) * row.tangent[0] +
         (row.slide[1] + dot(moved, row.tangent[1])) * row.tangent[1];
}

/// Values of a row that its record keeps besides impulses. A spring is compressed by the overlap that its row releases.
struct KeptValues {
  Point3 slip{};
  double reference = 0, held = 0, to_push = 0;

  KOKKOS_INLINE_FUNCTION KeptValues(const ContactRow& row, const Rows3<const double>& dv, double dt)
      : reference(row.reference), held(row.held), to_push(row.to_push) {
    if (row.friction > 0) slip = find_owed_slip(row, dv, dt);
    if (!(row.to_push > 0)) return;
    const double gap = find_gap(row, dv, dt), release = find_release(row, gap, dt);
    const double before = find_floor(row) - row.gap_start, after = find_floor(row) - gap;
    reference -= release;
    if (row.held > 0 && before > 0 && after > 0)
      held += 0.5 * row.spring * ((before + release) * (after + release) - before * after);
  }

  template <class History>
  KOKKOS_INLINE_FUNCTION void store(const History& history, int record) const {
    store_row(history.slip, record, slip);
    history.reference(record) = reference;
    if (history.held.extent(0) > 0) history.held(record) = held;
    if (history.to_push.extent(0) > 0) history.to_push(record) = to_push;
  }
};

KOKKOS_INLINE_FUNCTION void write_edge_record(const ContactRow& row, const Rows3<const double>& dv, double dt,
                                              const EdgeHistory& history) {
  const int r = row.record;
  history.a(r) = find_key_edge(row.key);
  history.b(r) = row.face;
  history.holds(r) = row.impulse.normal > 0 || row.reference > 0 || row.is_caught ? 1 : 0;
  store_row(history.normal, r, row.normal);
  store_row(history.impulse, r, row.force);
  KeptValues(row, dv, dt).store(history, r);
}

KOKKOS_INLINE_FUNCTION void write_record(const ContactRow& row, const Rows3<const double>& dv, double dt,
                                         const ContactHistory& history) {
  if (row.kind == RowKind::edges) {
    write_edge_record(row, dv, dt, history.edges);
    return;
  }
  if (is_tie(row)) {
    store_row(history.ties, row.record, row.force);
    return;
  }
  store_row(history.impulse, row.record, row.force);
  KeptValues(row, dv, dt).store(history, row.record);
  if (row.kind == RowKind::face && (row.impulse.normal > 0 || row.reference > 0 || row.is_caught))
    history.face(row.record) = row.face;
}

/// Empties a record of a face or a wall; -1: of neither.
KOKKOS_INLINE_FUNCTION void clear_record(int record, const ContactHistory& history) {
  if (record < 0) return;
  if (record < static_cast<int>(history.face.extent(0))) {
    history.face(record) = -1;
    return;
  }
  store_row(history.impulse, record, Point3{});
  store_row(history.slip, record, Point3{});
  history.reference(record) = 0;
  if (history.held.extent(0) > 0) history.held(record) = 0;
  if (history.to_push.extent(0) > 0) history.to_push(record) = 0;
}

void reserve_edge_history(EdgeHistory& history, int records) {
  history.count = records;
  for (Array<std::int64_t>* list : {&history.a, &history.b}) reserve(*list, records);
  for (Rows3<double>* rows : {&history.normal, &history.impulse, &history.slip}) reserve(*rows, records);
  reserve(history.holds, records);
  for (Array<double>* values : {&history.reference, &history.held, &history.to_push}) reserve(*values, records);
}

}  // namespace

void apply_impulses(const WorkSpace& space, const RowSystem& system, const Rows3<double>& v,
                    const Rows3<double>& impulse) {
  const ShareSums sums(system);
  const Array<const int> nodes = system.nodes;
  const Rows3<const double> dv = system.correction;
  const Rows3<double> out_v = v, out_impulse = impulse;
  parallel_for(
      "contact::apply_impulses", RangeOf(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        store_row(out_v, nodes(a), load_row(out_v, nodes(a)) + load_row(dv, a));
        store_row(out_impulse, nodes(a), sums(a));
      });
}

void apply_moments(const WorkSpace& space, const RowSystem& system, const SpinInputs& spins) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const TurningRow> turning = system.turning;
  const Array<const int> nodes = system.nodes;
  const Rows3<double> out = spins.spin, moment = spins.moment;
  parallel_for(
      "contact::apply_moments", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        const ContactRow& row = rows(r);
        if (!ties_rotation(row)) return;
        const int node = nodes(row.place[0]);
        store_row(out, node, load_row(out, node) + (1 / row.lever) * find_own_change(row, turning(row.record)));
        store_row(moment, node, row.lever * row.force);
      });
}

EnforcementSums sum_outcome(const WorkSpace& space, double dt, const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const TurningRow> turning = system.turning;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  return sum_rows<EnforcementSums>(space, system.num_rows, memory.outcome,
                                   [rows, at, dv, turning, dt] KOKKOS_FUNCTION(int r, EnforcementSums& s) {
                                     add_outcome(rows(r), at, dv, turning, dt, s);
                                   });
}

PairWork sum_pair_work(const WorkSpace& space, int pair, const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const TurningRow> turning = system.turning;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  return sum_rows<PairWork>(space, system.num_rows, memory.pair,
                            [rows, at, dv, turning, pair] KOKKOS_FUNCTION(int r, PairWork& s) {
                              if (rows(r).pair != pair) return;
                              const RowWork work = find_work(rows(r), at, dv, turning);
                              if (work.normal != 0) s.normal.add(work.normal);
                              if (work.friction != 0) s.friction.add(work.friction);
                            });
}

WallSums sum_wall_impulses(const WorkSpace& space, int first_row, const Rows3<const double>& x, const Point3& center,
                           const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> nodes = system.nodes;
  const Rows3<const double> places = x;
  return sum_rows<WallSums>(space, system.num_rows - first_row, memory.wall,
                            [rows, nodes, places, center, first_row] KOKKOS_FUNCTION(int i, WallSums& s) {
                              const ContactRow& row = rows(first_row + i);
                              if (row.kind != RowKind::wall) return;
                              const Point3 j = row.force;
                              const Point3 moment = cross(load_row(places, nodes(row.place[0])) - center, j);
                              s.impulse[0].add(j.x);
                              s.impulse[1].add(j.y);
                              s.impulse[2].add(j.z);
                              s.moment[0].add(moment.x);
                              s.moment[1].add(moment.y);
                              s.moment[2].add(moment.z);
                            });
}

WallPush sum_wall_push(const WorkSpace& space, int first_row, int wall, const Point3& direction,
                       const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  const bool is_along_normal = dot(direction, direction) == 0;
  return sum_rows<WallPush>(space, system.num_rows - first_row, memory.push,
                            [rows, first_row, wall, direction, is_along_normal] KOKKOS_FUNCTION(int i, WallPush& s) {
                              const ContactRow& row = rows(first_row + i);
                              if (row.kind != RowKind::wall || find_key_wall(row.key) != wall) return;
                              if (row.impulse.normal == 0) return;
                              const double push = is_along_normal ? row.impulse.normal
                                                                  : row.impulse.normal * dot(row.normal, direction);
                              s.push.add(push);
                              if (!is_along_normal) s.friction.add(dot(row.force, direction) - push);
                            });
}

WallMeeting sum_wall_meeting(const WorkSpace& space, int wall, const WallPairs& walls, const RowInputs& inputs,
                             RowSumMemory& memory) {
  const WallPairs w = walls;
  const RowInputs in = inputs;
  return sum_rows<WallMeeting>(
      space, walls.count_looked_at(), memory.meeting, [w, in, wall] KOKKOS_FUNCTION(int i, WallMeeting& s) {
        const int p = w.look_at(i);
        if (w.wall(p) != wall || (!in.looks_inside && w.is_inner(p) != 0)) return;
        const ContactWall& of = w.walls(wall);
        const Point3 n = of.normal, inverse = load_row(in.inverse_mass, w.node(p));
        const double mobility = dot(n, {inverse.x * n.x, inverse.y * n.y, inverse.z * n.z});
        const double gap = find_wall_gap(w, in.motion, p, 0);
        const double touching = dot(n, load_row(in.motion.v, w.node(p))) + (gap > 0 ? gap / in.motion.dt : 0);
        if (!(mobility > 0) || !(touching < of.speed) || !can_stop(w, in.motion, p)) return;
        s.mass.add(1 / mobility);
        s.momentum.add(touching / mobility);
      });
}

void write_history(const WorkSpace& space, double dt, RowSystem& system, ContactHistory& history) {
  reserve_edge_history(history.edges, system.num_edge_rows);
  const ContactHistory h = history;
  const bool is_known = system.num_written >= 0;
  const int records = is_known ? system.num_written : static_cast<int>(h.reference.extent(0));
  const Array<const int> old = system.written;
  parallel_for(
      "contact::clear_history", RangeOf(space, 0, records),
      KOKKOS_LAMBDA(int i) { clear_record(is_known ? old(i) : i, h); });
  reserve(system.written, system.num_rows);
  system.num_written = system.num_rows;
  const Array<int> written = system.written;
  const Array<const ContactRow> rows = system.rows;
  const Rows3<const double> dv = system.correction;
  parallel_for(
      "contact::write_history", RangeOf(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        write_record(rows(r), dv, dt, h);
        written(r) = rows(r).kind == RowKind::face || rows(r).kind == RowKind::wall ? rows(r).record : -1;
      });
}

void clear_impulses(const WorkSpace& space, const Array<const int>& nodes, int num_nodes,
                    const Rows3<double>& impulse) {
  const Rows3<double> out = impulse;
  parallel_for(
      "contact::clear_impulses", RangeOf(space, 0, num_nodes),
      KOKKOS_LAMBDA(int a) { store_row(out, nodes(a), Point3{}); });
}

}  // namespace percuss
