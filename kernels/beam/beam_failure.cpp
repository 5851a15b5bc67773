#include "kernels/beam/beam_failure.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/element/life.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION BeamForces<double> read_forces(const ElementRecord& record) {
  const ElementRecord f = record.from(BeamRecord::forces);
  return {f.get(0), f.get(1), f.get(2), f.get(3), f.get(4), f.get(5)};
}

/// Whether fibres of the share of the section have reached the plastic strain at which they fail.
KOKKOS_INLINE_FUNCTION bool do_fibres_fail(const FailureLimits& limits, const BeamFibres& fibres,
                                           const ElementRecord& record) {
  constexpr double round_off = 1e-9;
  if (!(limits.plastic_strain < FailureLimits::none)) return false;
  const ElementRecord states = record.from(BeamRecord::fibres);
  double failed = 0, all = 0;
  for (int i = 0; i < fibres.count; ++i) {
    all += fibres.fibre[i].area;
    if (states.get(2 * i + 1) >= limits.plastic_strain) failed += fibres.fibre[i].area;
  }
  return all > 0 && failed >= (limits.layers - round_off) * all;
}

}  // namespace

FailureCounts find_beam_failures(const ExecSpace& space, const ElementChunks& chunks, const JudgedBeams& beams,
                                 const FailingElements& elements, const ChunkResults& results) {
  const FailingChunks failing = elements.chunks;
  const ElementLives lives = elements.lives;
  const Array<Real> records = elements.records;
  FailureCounts counts;
  if (beams.parameters.extent(0) == 0) return counts;
  parallel_reduce(
      "percuss::find_beam_failures", RangeOf(space, 0, static_cast<int>(failing.list.extent(0))),
      KOKKOS_LAMBDA(const int i, int& sum_failing) {
        const int c = failing.list(i);
        if (!is_beam(chunks, c)) return;
        const BeamParameters& par = beams.parameters(chunks.parameters(c));
        const FailingRecords of = find_records(chunks, failing, records, c);
        const int count = count_elements(chunks, c);
        bool changed = false;
        for (int e = 0; e < count; ++e) {
          const int lane = of.first_lane + e;
          if (lives.steps_left(lane) != ElementLives::whole) continue;
          const ElementRecord record = of.find(e);
          const FailureLimits& limits = failing.find_limits(c, e);
          if (find_beam_load(par.limits, read_forces(record)) < 1 && beams.time < par.limits.time &&
              !do_fibres_fail(limits, par.fibres, record))
            continue;
          find_life(lives, lane).set_left(limits.fade_steps, limits.fade_steps);
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
