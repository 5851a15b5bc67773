#include "kernels/contact/enforcement/springs.hpp"

namespace percuss {
namespace {

/// What is deeper, as the element behind a face is crushed, comes back by this share of h a step: more may add energy.
constexpr double recovery = 1e-3;

/// How far a row would go in deeper than its cushion, or than it is, if it ended the step at `gap`.
KOKKOS_INLINE_FUNCTION double find_excess(const ContactRow& row, double gap) {
  const double least = find_floor(row) - contact_limits::spring_cushion * row.size,
               reached = row.gap_start + recovery * row.size;
  return (reached < least ? reached : least) - gap;
}

/// Depth of a row at n-1, from the velocities of the sides at n-1/2; what moves a wall moved it likewise.
KOKKOS_INLINE_FUNCTION double find_depth_before(const ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const double predicted = dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{at.v, row}));
  const double before = dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{at.v_before, row}));
  const double drift = (row.gap - row.gap_start) / times.dt - predicted;
  return find_floor(row) - row.gap_start + times.before() * (before + drift);
}

/// Whether the whole push of the spring conserves energy in the step: it begins or ends in none.
KOKKOS_INLINE_FUNCTION bool stays_pressed(double depth_before, double depth_after) {
  return depth_before >= 0 && depth_after >= 0;
}

/// The push of a spring of depth d(n) that takes from the sides what the spring then stores, k d(n) d(n+1) / 2 where
/// both are pressed and else nothing:
///     P = k d(n) dt (d+(n+1) - d+(n-1)) / (d(n+1) - d(n-1)),    d+ = max(0, d),
/// with d(n+1) = free - dt D P. free: d(n+1) without the push.
KOKKOS_INLINE_FUNCTION double find_spring_push(const ContactRow& row, double before, double free,
                                               const SpringTimes& times) {
  const double depth = find_floor(row) - row.gap_start;
  if (!(depth > 0)) return 0;
  const double whole = row.spring * depth * times.dt_mean, way = times.dt * row.stiffness * whole;
  if (stays_pressed(before, free - way)) return whole;
  if (before == 0) return free > 0 ? whole * (free / way) : 0;  // just touched at both ends
  if (before < 0) {  // begins: the positive root of d (d - before) = free (d - before) - way d
    if (!(free > 0)) return 0;
    const double half = 0.5 * (way - before - free), after = std::sqrt(half * half - before * free) - half;
    return after > 0 ? whole * (after / (after - before)) : 0;
  }
  // ends: the negative root of d (before - d) = free (before - d) - way before
  const double half = 0.5 * (before + free), after = half - std::sqrt(half * half + before * (way - free));
  return whole * (before / (before - after));
}

KOKKOS_INLINE_FUNCTION void set_push(ContactRow& row, const RowImpulse& impulse) {
  row.impulse = row.previous = impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// The impulse of the springs of one row and, of the slip, what Coulomb's limit leaves.
KOKKOS_INLINE_FUNCTION RowImpulse push_row(ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const double dt = times.dt, dt_mean = times.dt_mean;
  RowImpulse impulse;
  impulse.push = find_spring_push(row, find_depth_before(row, at, times), find_floor(row) - row.gap, times);
  if (row.friction > 0) {
    double step[2];
    for (int d = 0; d < 2; ++d) {
      step[d] = find_predicted_slide(row, at, d, dt);
      impulse.rub[d] = -row.spring * dt_mean * (row.slide[d] - step[d]);
    }
    limit_rub(row, impulse);
    for (int d = 0; d < 2; ++d) row.slide[d] = step[d] - impulse.rub[d] / (row.spring * dt_mean);
  }
  // What goes in by the end of the step is pushed in the next one: the contact must not be forgotten.
  if (row.gap < find_floor(row)) row.is_caught = true;
  return impulse;
}

/// How far a row would go beyond its cushion without other pushes, or beyond what its spring bears whole [length].
KOKKOS_INLINE_FUNCTION double find_unsettled(const ContactRow& row, const RowNodes& at, const SpringTimes& times) {
  const double excess = find_excess(row, row.gap), depth = find_floor(row) - row.gap_start;
  if (!(depth > 0)) return excess;
  const double after = find_floor(row) - row.gap - times.dt * row.stiffness * row.spring * depth * times.dt_mean;
  const double most = excess > 0 ? excess : 0;
  return stays_pressed(find_depth_before(row, at, times), after) ? most : most + depth;
}

}  // namespace

template <class Space>
double push_springs(const Space& space, double scale, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  double unsettled = 0;
  Kokkos::parallel_reduce(
      "contact::push_springs", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (row.is_rigid) return;
        row.spring = row.is_held ? 0 : scale * find_spring(row, at.spring);
        set_push(row, row.spring > 0 ? push_row(row, at, times) : RowImpulse{});
        const double here = row.spring > 0 ? find_unsettled(row, at, times) : 0;
        most = here > most ? here : most;
      },
      Kokkos::Max<double>(unsettled));
  return unsettled > 0 ? unsettled : 0;
}

template <class Space>
double settle_springs(const Space& space, const SpringTimes& times, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  const Rows3<const double> dv = system.correction;
  const double dt = times.dt;
  double change = 0;
  Kokkos::parallel_reduce(
      "contact::settle_springs", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        if (!(row.spring > 0 && row.stiffness > 0)) return;
        const double gap = row.gap + dt * dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{dv, row}));
        const double free = find_floor(row) - gap + dt * row.stiffness * row.impulse.push;
        const double least = find_spring_push(row, find_depth_before(row, at, times), free, times);
        RowImpulse impulse = row.impulse;
        impulse.push += find_excess(row, gap) / (dt * row.stiffness);
        if (impulse.push < least) impulse.push = least;
        const double moved = dt * row.stiffness * std::fabs(impulse.push - row.impulse.push);
        most = moved > most ? moved : most;
        limit_rub(row, impulse);
        set_push(row, impulse);
      },
      Kokkos::Max<double>(change));
  return change > 0 ? change : 0;
}

#define PERCUSS_INSTANTIATE(Space)                                                          \
  template double push_springs(const Space&, double, const SpringTimes&, const RowSystem&); \
  template double settle_springs(const Space&, const SpringTimes&, const RowSystem&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
