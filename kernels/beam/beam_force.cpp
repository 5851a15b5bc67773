#include "kernels/beam/beam_force.hpp"

#include "kernels/beam/beam_nodes.hpp"
#include "kernels/element/chunk_launcher.hpp"

namespace percuss {
namespace {

KOKKOS_INLINE_FUNCTION BeamState load_state(const ElementRecord& record) {
  const auto value = [&](int i) { return record.get(i); };
  constexpr int e2 = BeamRecord::e2, f = BeamRecord::forces;
  return {value(BeamRecord::mass),
          value(BeamRecord::gyration_square),
          {value(e2), value(e2 + 1), value(e2 + 2)},
          {value(f), value(f + 1), value(f + 2), value(f + 3), value(f + 4), value(f + 5)}};
}

KOKKOS_INLINE_FUNCTION void store_state(const BeamState& s, const LaneRecord<Real>& record) {
  const BeamForces<double>& f = s.forces;
  const double values[] = {s.e2.x, s.e2.y, s.e2.z, f.normal, f.shear_y, f.shear_z, f.torque, f.moment_y, f.moment_z};
  for (int i = 0; i < BeamRecord::fibres - BeamRecord::e2; ++i)
    record[BeamRecord::e2 + i] = static_cast<Real>(values[i]);
}

/// Body of ElementKernel: element by element.
struct BeamBody {
  using Block = BeamBlock;
  using Parameters = const BeamParameters&;
  using Scratch = BeamScratch;
  using Sums = ChunkTotals;
  using Lives = LivingLanes<Real>;
  static constexpr int largest_record = BeamRecord::largest * pack_width;
  const BlockStep<BeamBlock>& of;
  const TeamChunk& chunk;
  const BeamScratch& scratch;

  KOKKOS_FUNCTION BeamBody(const BlockStep<BeamBlock>& of_step, const TeamChunk& of_team, const BeamScratch& own)
      : of(of_step), chunk(of_team), scratch(own) {}

  KOKKOS_FUNCTION static Parameters find_parameters(const BlockStep<BeamBlock>& of, int c) {
    return of.block.parameters(of.chunks.parameters(c));
  }
  KOKKOS_FUNCTION static bool may_rest(const BlockStep<BeamBlock>&, int) { return true; }
  KOKKOS_FUNCTION int find_record_size() const { return chunk.chunks.record_size(chunk.c) * pack_width; }

  /// Lanes past the end repeat the last element.
  KOKKOS_FUNCTION void advance(Parameters parameters, const ChunkPack& pack, const Lives& lives, Sums& sums) const {
    for (int lane = 0; lane < pack_width; ++lane) {
      if (lives.can_fail() && lives.is_dead(lane)) continue;
      const BeamSlots slots = find_beam_slots(chunk, pack.first + lane);
      BeamResult result = advance_element(parameters, find_beam_motion(scratch, slots, of.motion.dt),
                                          LaneRecord<Real>{pack.record + lane});
      if (lane >= pack.lanes) continue;
      if (lives.can_fail()) {
        result.on = scale_beam_forces(lives.find_force_share(lane), result.on);
        lives.take_work(lane, WorkKind::internal, result.work);
      }
      add_beam_forces(result.on, slots, scratch);
      sums.work[WorkKind::internal] += result.work;
      const int element = pack.first + lane;
      if (of.motion.bound.extent(0) > 0) of.motion.bound(chunk.first_element + element) = result.stable_step;
      sums.take_step(result.stable_step, result.length, element);
    }
  }

  KOKKOS_FUNCTION static BeamResult advance_element(const BeamParameters& parameters, const BeamMotion& motion,
                                                    const LaneRecord<Real>& record) {
    BeamState now = load_state(record);
    const BeamResult result = parameters.fibres.count > 0 ? advance_with_fibres(parameters, motion, record, now)
                                                          : advance_beam(parameters, motion, now, nullptr);
    store_state(now, record);
    return result;
  }

  /// Advances a section with fibres, which are read and stored too.
  KOKKOS_FUNCTION static BeamResult advance_with_fibres(const BeamParameters& parameters, const BeamMotion& motion,
                                                        const LaneRecord<Real>& record, BeamState& now) {
    double fibres[(1 + most_fibre_history) * most_beam_fibres] = {};
    const int scalars = (2 + count_more_history(parameters)) * parameters.fibres.count;
    const LaneRecord<Real> stored = record.from(BeamRecord::fibres);
    for (int k = 0; k < scalars; ++k) fibres[k] = stored[k];
    const BeamResult result = advance_beam(parameters, motion, now, fibres);
    for (int k = 0; k < scalars; ++k) stored[k] = static_cast<Real>(fibres[k]);
    return result;
  }

  KOKKOS_FUNCTION void leave() const {}
};

}  // namespace

void advance_beams(const ExecSpace& space, const ElementChunks& chunks, const BeamBlock& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  launch_elements<BeamBody>("percuss::advance_beams", space, chunks, block, motion, fields);
}

}  // namespace percuss
