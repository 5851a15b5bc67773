#include "kernels/beam/beam_force.hpp"

#include "kernels/beam/beam_nodes.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/element/chunk_rest.hpp"
#include "kernels/element/chunk_sums.hpp"

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

/// Returns whether a bit has changed.
KOKKOS_INLINE_FUNCTION bool store_state(const BeamState& s, const LaneRecord<Real>& record) {
  const BeamForces<double>& f = s.forces;
  const double values[] = {s.e2.x, s.e2.y, s.e2.z, f.normal, f.shear_y, f.shear_z, f.torque, f.moment_y, f.moment_z};
  bool changed = false;
  for (int i = 0; i < BeamRecord::fibres - BeamRecord::e2; ++i) {
    Real& stored = record[BeamRecord::e2 + i];
    const Real value = static_cast<Real>(values[i]);
    changed = changed || !has_same_bits(stored, value);
    stored = value;
  }
  return changed;
}

struct AdvanceBeamChunk {
  ElementChunks chunks;
  BeamBlock block;
  BeamStep step;
  Array<Real> state;
  Rows3<double> slot_force, slot_moment;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = block.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c), slot_count = chunks.first_slot(c + 1) - first_slot;
    const ChunkRest rest(chunks, results, c, step.skips_rest, step.v, step.w);
    if (rest.skips()) return;
    const BeamScratch scratch(member, slot_count);
    double* const sums = scratch.forces;
    for (int i = 0; i < beam_force_record * slot_count; ++i) sums[i] = 0;
    rest.leave(advance_elements(c, sums));
    for (int s = 0; s < slot_count; ++s) {
      const double* const sum = sums + beam_force_record * s;
      for (int k = 0; k < 3; ++k) {
        slot_force(first_slot + s, k) = sum[k];
        if (slot_moment.extent(0) > 0) slot_moment(first_slot + s, k) = sum[3 + k];
      }
    }
  }

  /// Returns whether a bit of the records has changed.
  KOKKOS_FUNCTION bool advance_elements(int c, double* sums) const {
    const BeamParameters& parameters = block.parameters(chunks.parameters(c));
    const int first = chunks.first_element(c), count = count_elements(chunks, c), lanes = count_lanes(chunks, c);
    const int first_lane = step.find_first_lane(c);
    ChunkTotals totals;
    bool changed = false;
    for (int i = 0; i < lanes; ++i) {  // lanes past the end repeat the last element
      if (first_lane >= 0 && step.lives.force_share(first_lane + i) < 0) continue;
      const BeamSlots slots = find_beam_slots(chunks, c, i);
      BeamResult result = advance_element(parameters, find_beam_motion(chunks, c, slots, step),
                                          find_record(chunks, state, c, i), changed);
      if (i >= count) continue;
      if (first_lane >= 0) settle(first_lane + i, result);
      add_beam_forces(result.on, slots, sums);
      totals.work[WorkKind::internal] += result.work;
      if (step.bound.extent(0) > 0) step.bound(first + i) = result.stable_step;
      totals.take_step(result.stable_step, result.length, i);
    }
    totals.leave_work(c, results);
    totals.leave_step(c, first, results);
    return changed;
  }

  /// Forces and work by their shares.
  KOKKOS_FUNCTION void settle(int lane, BeamResult& result) const {
    result.on = scale_beam_forces(static_cast<double>(step.lives.force_share(lane)), result.on);
    result.work *= static_cast<double>(step.lives.work_share(lane));
    step.lives.work(find_work_place(static_cast<std::size_t>(lane), 0)) += result.work;
  }

  /// changed: true from here on if a bit of the record does.
  KOKKOS_FUNCTION static BeamResult advance_element(const BeamParameters& parameters, const BeamMotion& motion,
                                                    const LaneRecord<Real>& record, bool& changed) {
    BeamState now = load_state(record);
    const BeamResult result = parameters.fibres.count > 0
                                  ? advance_with_fibres(parameters, motion, record, now, changed)
                                  : advance_beam(parameters, motion, now, nullptr);
    changed = store_state(now, record) || changed;
    return result;
  }

  /// The same of a section with fibres, which are read and stored too.
  KOKKOS_FUNCTION static BeamResult advance_with_fibres(const BeamParameters& parameters, const BeamMotion& motion,
                                                        const LaneRecord<Real>& record, BeamState& now, bool& changed) {
    double fibres[(1 + most_fibre_history) * most_beam_fibres] = {};
    const int scalars = (2 + count_more_history(parameters)) * parameters.fibres.count;
    const LaneRecord<Real> stored = record.from(BeamRecord::fibres);
    for (int k = 0; k < scalars; ++k) fibres[k] = stored[k];
    const BeamResult result = advance_beam(parameters, motion, now, fibres);
    for (int k = 0; k < scalars; ++k) {
      const Real value = static_cast<Real>(fibres[k]);
      changed = changed || !has_same_bits(stored[k], value);
      stored[k] = value;
    }
    return result;
  }
};

}  // namespace

void advance_beams(const ExecSpace& space, const ElementChunks& chunks, const BeamBlock& block, const BeamStep& step,
                   const ChunkFields& fields) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  Kokkos::parallel_for(
      "percuss::advance_beams", BeamScratch::make_policy(space, count, chunks.largest_slot_count),
      AdvanceBeamChunk{chunks, block, step, fields.state, fields.slot_force, fields.slot_moment, fields.results});
}

}  // namespace percuss
