#include "kernels/beam/beam_failure.hpp"

#include "kernels/element/dying_lanes.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION BeamForces<double> read_forces(const ElementRecord& record) {
  const ElementRecord f = record.from(BeamRecord::forces);
  return {f.get(0), f.get(1), f.get(2), f.get(3), f.get(4), f.get(5)};
}

}  // namespace

FailureCounts find_beam_failures(const ExecSpace& space, const ElementChunks& chunks, const JudgedBeams& beams,
                                 const FailingElements& elements, const ChunkResults& results) {
  const FailingChunks failing = elements.chunks;
  const ElementLives lives = elements.lives;
  const Array<Real> records = elements.records;
  FailureCounts counts;
  if (beams.parameters.extent(0) == 0) return counts;
  Kokkos::parallel_reduce(
      "percuss::find_beam_failures", Range(space, 0, static_cast<int>(failing.list.extent(0))),
      KOKKOS_LAMBDA(const int i, int& sum_failing) {
        const int c = failing.list(i);
        if (!is_beam(chunks, c)) return;
        const BeamLimits limits = beams.parameters(chunks.parameters(c)).limits;
        const FailingRecords of = find_records(chunks, failing, records, c);
        const int count = count_elements(chunks, c);
        bool changed = false;
        for (int e = 0; e < count; ++e) {
          const int lane = of.first_lane + e;
          if (lives.steps_left(lane) != ElementLives::whole) continue;
          if (find_beam_load(limits, read_forces(of.find(e))) < 1 && beams.time < limits.time) continue;
          const FailureLimits& fading = failing.find_limits(c, e);
          set_left(lives, lane, fading.fade_steps, fading);
          ++sum_failing;
          changed = true;
        }
        if (!changed) return;
        results.is_settled(c) = 0;
        end_lanes_past_end(lives, of, count);
      },
      counts.failing);
  return counts;
}

}  // namespace percuss
