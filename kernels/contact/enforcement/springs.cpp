#include "kernels/contact/enforcement/springs.hpp"

namespace percuss {
namespace {

/// The impulse of the springs of one row and, of the slip, what Coulomb's limit leaves.
KOKKOS_INLINE_FUNCTION void push_row(ContactRow& row, const RowNodes& at, double dt, double dt_mean) {
  const double depth = find_floor(row) - row.gap_start;
  row.impulse = RowImpulse{};
  if (depth > 0) row.impulse.push = row.spring * depth * dt_mean;
  if (row.friction > 0) {
    double step[2];
    for (int d = 0; d < 2; ++d) {
      step[d] = find_predicted_slide(row, at, d, dt);
      row.impulse.rub[d] = -row.spring * dt_mean * (row.slide[d] - step[d]);
    }
    limit_rub(row, row.impulse);
    for (int d = 0; d < 2; ++d) row.slide[d] = step[d] - row.impulse.rub[d] / (row.spring * dt_mean);
  }
  // What goes in by the end of the step is pushed in the next one: the contact must not be forgotten.
  if (row.gap < find_floor(row)) row.is_caught = true;
}

}  // namespace

template <class Space>
void push_springs(const Space& space, double scale, double dt, double dt_mean, const RowSystem& system) {
  const Array<ContactRow> rows = system.rows;
  const RowNodes at = system.at;
  Kokkos::parallel_for(
      "contact::push_springs", RangeOf<Space>(space, 0, system.num_rows), KOKKOS_LAMBDA(int r) {
        ContactRow& row = rows(r);
        row.spring = row.is_held ? 0 : scale * find_spring(row, at.spring);
        if (row.spring > 0) {
          push_row(row, at, dt, dt_mean);
        } else {
          row.impulse = RowImpulse{};
        }
        row.previous = row.impulse;
        row.force = sum_impulse(row, row.impulse);
        row.couple = find_couple(row, row.force);
      });
}

#define PERCUSS_INSTANTIATE(Space) template void push_springs(const Space&, double, double, double, const RowSystem&);
PERCUSS_INSTANTIATE(ExecSpace)
#if defined(PERCUSS_SMALL_SPACE)
PERCUSS_INSTANTIATE(SmallSpace)
#endif
#undef PERCUSS_INSTANTIATE

}  // namespace percuss
