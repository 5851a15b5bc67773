#include "kernels/contact/enforcement.hpp"

namespace percuss {
namespace {

/// Iteration ends when no impulse changes by more than would close this share of the largest predicted penetration ...
constexpr double relative_tolerance = 1e-3;
/// ... or this share of the smallest h.
constexpr double absolute_tolerance = 1e-10;
constexpr int max_iterations = 1000;

/// New dv from the impulses, and its extrapolation by beta from the one before.
template <class Space>
void move_nodes(const Space& space, const Rows3<const double>& inverse_mass, double beta, const RowSystem& system) {
  const Array<const ContactRow> rows = system.rows;
  const Array<const int> offset = system.offset, entry = system.entry, nodes = system.nodes, awake = system.awake;
  const Rows3<double> correction = system.correction, extrapolated = system.extrapolated;
  Kokkos::parallel_for(
      "contact::move_nodes", RangeOf<Space>(space, 0, system.num_nodes), KOKKOS_LAMBDA(int a) {
        const Point3 p = gather_impulse(rows, awake, offset, entry, a), w = load_row(inverse_mass, nodes(a));
        const Point3 dv = {w.x * p.x, w.y * p.y, w.z * p.z};
        if (beta > 0)
          store_row(extrapolated, a, dv + beta * (dv - load_row(correction, a)));
        else
          store_row(extrapolated, a, dv);
        store_row(correction, a, dv);
      });
}

/// What one pass over the rows says about convergence.
struct PassSums {
  double change = 0;     // largest change of an impulse as a displacement: |p' - y| dt D
  double backwards = 0;  // sum of D (y - p') (p' - p): positive when the extrapolation points back
  KOKKOS_INLINE_FUNCTION void add(const PassSums& other) {
    change = other.change > change ? other.change : change;
    backwards += other.backwards;
  }
};

KOKKOS_INLINE_FUNCTION void add_change(double y, double fresh, double old, double stiffness, double dt,
                                       PassSums& sums) {
  const double change = fresh > y ? fresh - y : y - fresh;
  sums.add({dt * stiffness * change, stiffness * (y - fresh) * (fresh - old)});
}

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
KOKKOS_INLINE_FUNCTION void correct_row(ContactRow& row, const Rows3<const double>& dv, double beta, double dt,
                                        PassSums& sums) {
  RowImpulse y = row.impulse;
  y.push += beta * (row.impulse.push - row.previous.push);
  for (int d = 0; d < 2; ++d) y.rub[d] += beta * (row.impulse.rub[d] - row.previous.rub[d]);
  const Point3 u = find_work_velocity(row, TouchedVelocity{dv, row});
  const RowImpulse p = correct_impulse(row, y, u, dt);
  add_change(y.push, p.push, row.impulse.push, row.stiffness, dt, sums);
  if (row.friction > 0)
    for (int d = 0; d < 2; ++d) add_change(y.rub[d], p.rub[d], row.impulse.rub[d], row.rub_stiffness, dt, sums);
  row.previous = row.impulse;
  row.impulse = p;
  row.force = sum_impulse(row, p);
  row.couple = row.face < 0 ? Point3{} : find_couple(row, row.force);
}

KOKKOS_INLINE_FUNCTION int find_awake(const ContactRow& row) {
  return (row.impulse.push > 0 ? pushes_now : 0) | (row.previous.push > 0 ? pushed_before : 0);
}

/// What ends the iteration: a displacement.
template <class Space>
double find_tolerance(const Space& space, const RowSystem& system) {
  const Array<const ContactRow> rows = system.rows;
  double deepest = 0, smallest = 0;
  Kokkos::parallel_reduce(
      "contact::deepest_prediction", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& depth) {
        const double missing = rows(r).target - rows(r).gap;
        depth = missing > depth ? missing : depth;
      },
      Kokkos::Max<double>(deepest));
  Kokkos::parallel_reduce(
      "contact::smallest_face", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& size) { size = rows(r).size < size ? rows(r).size : size; },
      Kokkos::Min<double>(smallest));
  const double relative = relative_tolerance * deepest, absolute = absolute_tolerance * smallest;
  return relative > absolute ? relative : absolute;
}

}  // namespace

template <class Space>
SolveReport solve_rows(const Space& space, const Rows3<const double>& inverse_mass, double dt, RowSystem& system) {
  const double tolerance = find_tolerance(space, system);
  SolveReport report;
  report.converged = false;
  double beta = 0, t = 1;
  move_nodes(space, inverse_mass, beta, system);
  while (!report.converged && report.iterations < max_iterations) {
    const Array<ContactRow> rows = system.rows;
    const Array<int> awake = system.awake;
    const Rows3<const double> dv = system.extrapolated;
    const double step_beta = beta;
    const PassSums sums = sum_rows<PassSums>(space, system.num_rows, system.sums,
                                             [rows, awake, dv, step_beta, dt] KOKKOS_FUNCTION(int r, PassSums& s) {
                                               if (awake(r) == 0 && is_at_rest(rows(r), dv)) return;
                                               correct_row(rows(r), dv, step_beta, dt, s);
                                               awake(r) = find_awake(rows(r));
                                             });
    ++report.iterations;
    report.converged = sums.change <= tolerance;
    const double next_t = 0.5 * (1 + std::sqrt(1 + 4 * t * t));
    const bool restart = sums.backwards > 0 || report.converged;
    beta = restart ? 0 : (t - 1) / next_t;
    t = restart ? 1 : next_t;
    move_nodes(space, inverse_mass, beta, system);
  }
  return report;
}

template SolveReport solve_rows(const ExecSpace&, const Rows3<const double>&, double, RowSystem&);
#if defined(PERCUSS_SMALL_SPACE)
template SolveReport solve_rows(const SmallSpace&, const Rows3<const double>&, double, RowSystem&);
#endif

}  // namespace percuss
