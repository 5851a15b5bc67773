#include "kernels/contact/enforcement.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION Point3 multiply(const Point3& a, const Point3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Change of one impulse from y to `fresh`, `old` the iterate before: its size as a displacement, how far it points
/// back.
struct ImpulseChange {
  double size = 0, backwards = 0;

  KOKKOS_INLINE_FUNCTION void add(double y, double fresh, double old, double stiffness, double dt) {
    const double moved = dt * stiffness * (fresh > y ? fresh - y : y - fresh);
    size = moved > size ? moved : size;
    backwards += stiffness * (y - fresh) * (fresh - old);
  }
};

/// Whether a row has no push, needs none as things lie, and none of its nodes is moved: it stays as it is.
KOKKOS_INLINE_FUNCTION bool is_at_rest(const ContactRow& row, const Rows3<const double>& dv) {
  if (row.gap < row.target) return false;
  for (int slot = 0; slot < count_nodes(row); ++slot) {
    const int a = row.place[slot];
    if (dv(a, 0) != 0 || dv(a, 1) != 0 || dv(a, 2) != 0) return false;
  }
  return true;
}

/// Corrects the impulses of one row from its extrapolated iterate.
KOKKOS_INLINE_FUNCTION ImpulseChange correct_row(ContactRow& row, const Rows3<const double>& dv, double beta,
                                                 double dt) {
  RowImpulse y = row.impulse;
  y.push += beta * (row.impulse.push - row.previous.push);
  for (int d = 0; d < 2; ++d) y.rub[d] += beta * (row.impulse.rub[d] - row.previous.rub[d]);
  const Point3 u = find_work_velocity(row, TouchedVelocity{dv, row});
  const RowImpulse p = correct_impulse(row, y, u, dt);
  ImpulseChange change;
  change.add(y.push, p.push, row.impulse.push, row.stiffness, dt);
  if (row.friction > 0)
    for (int d = 0; d < 2; ++d) change.add(y.rub[d], p.rub[d], row.impulse.rub[d], row.rub_stiffness, dt);
  row.previous = row.impulse;
  row.impulse = p;
  row.force = sum_impulse(row, p);
  row.couple = find_couple(row, row.force);
  return change;
}

KOKKOS_INLINE_FUNCTION int find_awake(const ContactRow& row) {
  return (row.impulse.push > 0 ? pushes_now : 0) | (row.previous.push > 0 ? pushed_before : 0);
}

}  // namespace

template <class Space>
PredictedGaps find_predicted_gaps(const Space& space, const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  return sum_rows<PredictedGaps>(space, system.num_rows, memory.gaps, [rows] KOKKOS_FUNCTION(int r, PredictedGaps& s) {
    const double missing = rows(r).target - rows(r).gap;
    s.merge({missing > 0 ? missing : 0, rows(r).size, 1});
  });
}

template <class Space>
void find_corrections(const Space& space, const RowSystem& system) {
  const EntryLists lists(system);
  const Rows3<double> correction = system.correction, before = system.extrapolated;
  const Rows3<const double> inverse_mass = system.at.inverse_mass;
  Kokkos::parallel_for(
      "contact::move_nodes", RangeOf<Space>(space, 0, system.num_places()), KOKKOS_LAMBDA(int a) {
        store_row(before, a, load_row(correction, a));
        if (a >= lists.num_owned) return;
        store_row(correction, a, multiply(load_row(inverse_mass, a), lists.gather_impulse(a)));
      });
}

template <class Space>
void extrapolate_corrections(const Space& space, double beta, const RowSystem& system) {
  const Rows3<double> extrapolated = system.extrapolated;
  const Rows3<const double> correction = system.correction;
  Kokkos::parallel_for(
      "contact::extrapolate", RangeOf<Space>(space, 0, system.num_places()), KOKKOS_LAMBDA(int a) {
        const Point3 dv = load_row(correction, a), before = load_row(extrapolated, a);
        store_row(extrapolated, a, beta > 0 ? dv + beta * (dv - before) : dv);
      });
}

template <class Space>
PassSums correct_rows(const Space& space, double beta, double dt, const RowSystem& system, RowSumMemory& memory) {
  const Array<ContactRow> rows = system.rows;
  const Array<int> awake = system.awake;
  const Rows3<const double> dv = system.extrapolated;
  return sum_rows<PassSums>(space, system.num_rows, memory.pass,
                            [rows, awake, dv, beta, dt] KOKKOS_FUNCTION(int r, PassSums& s) {
                              if (awake(r) == 0 && is_at_rest(rows(r), dv)) return;
                              const ImpulseChange change = correct_row(rows(r), dv, beta, dt);
                              s.change = change.size > s.change ? change.size : s.change;
                              if (change.backwards != 0) s.backwards.add(change.backwards);
                              awake(r) = find_awake(rows(r));
                            });
}

template <class Space>
void straighten_gaps(const Space& space, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  Kokkos::parallel_for(
      "contact::straighten_gaps", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r) { rows(r).gap_gradient = rows(r).normal; });
}

#define PERCUSS_INSTANTIATE(Space)                                                           \
  template PredictedGaps find_predicted_gaps(const Space&, const RowSystem&, RowSumMemory&); \
  template void find_corrections(const Space&, const RowSystem&);                            \
  template void extrapolate_corrections(const Space&, double, const RowSystem&);             \
  template void straighten_gaps(const Space&, const RowSystem&);                             \
  template PassSums correct_rows(const Space&, double, double, const RowSystem&, RowSumMemory&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
