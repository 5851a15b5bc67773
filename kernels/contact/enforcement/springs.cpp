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

KOKKOS_INLINE_FUNCTION double find_spring_push(const ContactRow& row, double dt_mean) {
  const double depth = find_floor(row) - row.gap_start;
  return depth > 0 ? row.spring * depth * dt_mean : 0;
}

KOKKOS_INLINE_FUNCTION void set_push(ContactRow& row, const RowImpulse& impulse) {
  row.impulse = row.previous = impulse;
  row.force = sum_impulse(row, row.impulse);
  row.couple = find_couple(row, row.force);
}

/// The impulse of the springs of one row and, of the slip, what Coulomb's limit leaves.
KOKKOS_INLINE_FUNCTION RowImpulse push_row(ContactRow& row, const RowNodes& at, double dt, double dt_mean) {
  RowImpulse impulse;
  impulse.push = find_spring_push(row, dt_mean);
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

}  // namespace

template <class Space>
double push_springs(const Space& space, double scale, double dt, double dt_mean, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  double excess = 0;
  Kokkos::parallel_reduce(
      "contact::push_springs", RangeOf<Space>(space, 0, system.num_rows),
      KOKKOS_LAMBDA(int r, double& most) {
        ContactRow& row = rows(r);
        row.spring = row.is_held ? 0 : scale * find_spring(row, at.spring);
        set_push(row, row.spring > 0 ? push_row(row, at, dt, dt_mean) : RowImpulse{});
        const double here = row.spring > 0 ? find_excess(row, row.gap) : 0;
        most = here > most ? here : most;
      },
      Kokkos::Max<double>(excess));
  return excess > 0 ? excess : 0;
}

template <class Space>
void push_stops(const Space& space, double dt, double dt_mean, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const Rows3<const double> dv = system.correction;
  Kokkos::parallel_for(
      "contact::push_stops", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        ContactRow& row = rows(r);
        if (!(row.spring > 0 && row.stiffness > 0)) return;
        const double gap = row.gap + dt * dot(row.gap_gradient, find_work_velocity(row, TouchedVelocity{dv, row}));
        const double least = find_spring_push(row, dt_mean);
        RowImpulse impulse = row.impulse;
        impulse.push += find_excess(row, gap) / (dt * row.stiffness);
        if (impulse.push < least) impulse.push = least;
        set_push(row, impulse);
      });
}

#define PERCUSS_INSTANTIATE(Space)                                                      \
  template double push_springs(const Space&, double, double, double, const RowSystem&); \
  template void push_stops(const Space&, double, double, const RowSystem&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
