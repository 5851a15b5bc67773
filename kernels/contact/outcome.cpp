// What the impulses of a step did: velocities, work, what is left over, history.

#include "kernels/contact/enforcement.hpp"

namespace percuss {
namespace {

/// Sums of apply_impulses() as doubles; counts and nodes are exact in them.
struct OutcomeSums {
  double pushes = 0, normal_work = 0, friction_work = 0, residual = 0, deepest = 0, deepest_node = -1;

  KOKKOS_INLINE_FUNCTION void add_depth(double depth, double node) {
    if (!(depth > deepest) && !(depth == deepest && depth > 0 && node < deepest_node)) return;
    deepest = depth;
    deepest_node = node;
  }
  KOKKOS_INLINE_FUNCTION void add(const OutcomeSums& other) {
    pushes += other.pushes;
    normal_work += other.normal_work;
    friction_work += other.friction_work;
    residual = other.residual > residual ? other.residual : residual;
    add_depth(other.deepest, other.deepest_node);
  }
};

/// Mean of the velocities before and after the step.
struct MeanVelocity {
  Rows3<const double> before, after;
  const ContactRow& row;
  KOKKOS_INLINE_FUNCTION Point3 operator()(int slot) const {
    return 0.5 * (load_row(before, row.node[slot]) + load_row(after, row.node[slot]));
  }
};

KOKKOS_INLINE_FUNCTION void sum_outcome(const ContactRow& row, const Rows3<const double>& before,
                                        const Rows3<const double>& after, const Rows3<const double>& dv, double dt,
                                        OutcomeSums& sums) {
  const Point3 mean = find_work_velocity(row, MeanVelocity{before, after, row});
  OutcomeSums own;
  own.pushes = row.impulse.push > 0 ? 1 : 0;
  own.normal_work = row.impulse.push * dot(row.normal, mean);
  if (row.friction > 0)
    own.friction_work = row.impulse.rub[0] * dot(row.tangent[0], mean) + row.impulse.rub[1] * dot(row.tangent[1], mean);
  const double gap = row.gap + dt * dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{dv, row}));
  own.residual = row.target > gap ? (row.target - gap) / row.size : 0;
  own.add_depth((-row.gap_start - row.reference) / row.size, row.node[0]);
  sums.add(own);
}

/// The tangential displacement that sticking owes after the step; nothing when it slides.
KOKKOS_INLINE_FUNCTION Point3 find_owed_slip(const ContactRow& row, const Rows3<const double>& dv, double dt) {
  constexpr double sticking = 1 - 1e-9;  // share of Coulomb's limit, below which a rub was not shortened
  const double* rub = row.impulse.rub;
  const double limit = sticking * row.friction * row.impulse.push;
  if (!(rub[0] * rub[0] + rub[1] * rub[1] < limit * limit)) return {};
  const Point3 moved = dt * find_relative_velocity(row, TouchedVelocity{dv, row});
  return (row.slide[0] + dot(moved, row.tangent[0])) * row.tangent[0] +
         (row.slide[1] + dot(moved, row.tangent[1])) * row.tangent[1];
}

KOKKOS_INLINE_FUNCTION void write_record(const ContactRow& row, const Rows3<const double>& dv, double dt,
                                         const ContactHistory& history) {
  store_row(history.impulse, row.record, row.force);
  store_row(history.slip, row.record, row.friction > 0 ? find_owed_slip(row, dv, dt) : Point3{});
  history.reference(row.record) = row.reference;
  if (row.face >= 0 && (row.impulse.push > 0 || row.reference > 0 || row.is_caught))
    history.face(row.record) = row.face;
}

}  // namespace

template <class Space>
EnforcementSums apply_impulses(const Space& space, const Rows3<const double>& v_before, double dt, RowSystem& system,
                               const Rows3<double>& v, const Rows3<double>& impulse) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> offset = system.offset, entry = system.entry, nodes = system.nodes, awake = system.awake;
  const Rows3<const double> dv = system.correction;
  Kokkos::parallel_for(
      "contact::apply_impulses", RangeOf<Space>(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        store_row(v, nodes(a), load_row(v, nodes(a)) + load_row(dv, a));
        store_row(impulse, nodes(a), gather_impulse(rows, awake, offset, entry, a));
      });
  const Rows3<const double> after = v, before = v_before;
  const OutcomeSums sums = sum_rows<OutcomeSums>(space, system.num_rows, system.sums,
                                                 [rows, before, after, dv, dt] KOKKOS_FUNCTION(int r, OutcomeSums& s) {
                                                   sum_outcome(rows(r), before, after, dv, dt, s);
                                                 });
  return {static_cast<int>(sums.pushes),      sums.normal_work, sums.friction_work, sums.residual, sums.deepest,
          static_cast<int>(sums.deepest_node)};
}

template <class Space>
void write_history(const Space& space, const CandidateList& candidates, const WallPairs& walls, double dt,
                   const RowSystem& system, const ContactHistory& history) {
  const ContactHistory h = history;
  const Array<const int> nodes = candidates.nodes;
  Kokkos::parallel_for(
      "contact::clear_history", RangeOf<Space>(space, 0, candidates.num_nodes), KOKKOS_LAMBDA(int i) {
        for (int slot = 0; slot < contact_limits::max_touches; ++slot)
          h.face(contact_limits::max_touches * nodes(i) + slot) = -1;
      });
  const int first = static_cast<int>(h.face.extent(0));
  Kokkos::parallel_for(
      "contact::clear_wall_history", RangeOf<Space>(space, 0, static_cast<int>(walls.node.extent(0))),
      KOKKOS_LAMBDA(int p) {
        store_row(h.impulse, first + p, Point3{});
        store_row(h.slip, first + p, Point3{});
        h.reference(first + p) = 0;
      });
  const Array<const ContactRow> rows = system.rows;
  const Rows3<const double> dv = system.correction;
  Kokkos::parallel_for(
      "contact::write_history", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r) { write_record(rows(r), dv, dt, h); });
}

template <class Space>
void drop_history(const Space& space, const ContactSurface& surface, const CandidateList& candidates,
                  const ContactHistory& history) {
  const ContactHistory h = history;
  const Array<const int> offset = candidates.offset;
  Kokkos::parallel_for(
      "contact::drop_history", RangeOf<Space>(space, 0, surface.num_nodes), KOKKOS_LAMBDA(int n) {
        if (offset(n) < offset(n + 1)) return;
        for (int slot = 0; slot < contact_limits::max_touches; ++slot)
          h.face(contact_limits::max_touches * n + slot) = -1;
      });
}

template <class Space>
void clear_impulses(const Space& space, const RowSystem& system, const Rows3<double>& impulse) {
  const Array<const int> nodes = system.nodes;
  Kokkos::parallel_for(
      "contact::clear_impulses", RangeOf<Space>(space, 0, system.num_nodes),
      KOKKOS_LAMBDA(int a) { store_row(impulse, nodes(a), Point3{}); });
}

#define PERCUSS_INSTANTIATE(Space)                                                                              \
  template EnforcementSums apply_impulses(const Space&, const Rows3<const double>&, double, RowSystem&,         \
                                          const Rows3<double>&, const Rows3<double>&);                          \
  template void write_history(const Space&, const CandidateList&, const WallPairs&, double, const RowSystem&,   \
                              const ContactHistory&);                                                           \
  template void drop_history(const Space&, const ContactSurface&, const CandidateList&, const ContactHistory&); \
  template void clear_impulses(const Space&, const RowSystem&, const Rows3<double>&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
