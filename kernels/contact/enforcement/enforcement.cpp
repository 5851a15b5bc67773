#include "kernels/contact/enforcement/enforcement.hpp"

namespace percuss {

PredictedGaps find_predicted_gaps(const WorkSpace& space, const RowSystem& system, RowSumMemory& memory) {
  const Array<const ContactRow> rows = system.rows;
  return sum_rows<PredictedGaps>(space, system.num_rows, memory.gaps, [rows] KOKKOS_FUNCTION(int r, PredictedGaps& s) {
    const ContactRow& row = rows(r);
    if (is_tie(row)) {
      const double way = max_component({row.gap, row.slide[0], row.slide[1]});
      s.merge({0, way, row.size, 1, 0, 0});
      return;
    }
    const double missing = is_frozen(row) ? 0 : row.target - row.gap;
    const bool is_spring = row.has_spring && !row.is_rigid;
    const bool is_iterated = row.is_rigid && !row.is_solved;
    s.merge({missing > 0 ? missing : 0, 0, row.size, 1, is_iterated ? 1 : 0, is_spring ? 1 : 0});
  });
}

void find_corrections(const WorkSpace& space, const RowSystem& system) {
  place_remote_shares(space, system);
  const ShareSums sums(system);
  const Rows3<double> correction = system.correction;
  const Rows3<const double> inverse_mass = system.at.inverse_mass;
  parallel_for(
      "contact::find_corrections", RangeOf(space, 0, system.num_places()), KOKKOS_LAMBDA(int a) {
        const Point3 impulse = sums(a), w = load_row(inverse_mass, a);
        store_row(correction, a, {w.x * impulse.x, w.y * impulse.y, w.z * impulse.z});
      });
}

}  // namespace percuss
