#include "kernels/beam/beam_damping.hpp"

#include "kernels/beam/beam_nodes.hpp"

namespace percuss {
namespace {

struct DampBeamChunk {
  ElementChunks chunks;
  DampedBeams damped;
  BeamStep step;
  SpinDampingFields fields;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = damped.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c), slot_count = chunks.first_slot(c + 1) - first_slot;
    const BeamScratch scratch(member, slot_count);
    double* const sums = scratch.forces;
    for (int i = 0; i < beam_force_record * slot_count; ++i) sums[i] = 0;
    damp_elements(c, sums);
    const ChunkSlots slots{&chunks.slots_to_nodes(first_slot), first_slot, slot_count};
    double power = set_damping(step.v, slots, {sums, beam_force_record}, fields.force, fields.slot_force);
    if (step.w.extent(0) > 0)
      power += set_damping(step.w, slots, {sums + 3, beam_force_record}, fields.moment, fields.slot_moment);
    fields.work(c, viscous_work) -= 0.5 * step.dt * power;
  }

  KOKKOS_FUNCTION void damp_elements(int c, double* sums) const {
    const BeamParameters& parameters = damped.parameters(chunks.parameters(c));
    const int first_lane = step.find_first_lane(c);
    for (int i = 0; i < count_elements(chunks, c); ++i) {
      const double share = first_lane < 0 ? 1 : static_cast<double>(step.lives.force_share(first_lane + i));
      if (share < 0) continue;
      const ElementRecord e2 = find_record(chunks, fields.state, c, i).from(BeamRecord::e2);
      const Vector3<double> axis{e2.get(0), e2.get(1), e2.get(2)};
      const BeamSlots slots = find_beam_slots(chunks, c, i);
      const BeamNodalForces<double> on =
          find_beam_damping(parameters, damped.beta(c), find_beam_motion(chunks, c, slots, step), axis);
      add_beam_forces(scale_beam_forces(share, on), slots, sums);
    }
  }
};

}  // namespace

void damp_beams(const ExecSpace& space, const ElementChunks& chunks, const DampedBeams& damped, const BeamStep& step,
                const SpinDampingFields& fields) {
  const int count = static_cast<int>(damped.chunks.extent(0));
  if (count == 0) return;
  Kokkos::parallel_for("percuss::damp_beams", BeamScratch::make_policy(space, count, chunks.largest_slot_count),
                       DampBeamChunk{chunks, damped, step, fields});
}

}  // namespace percuss
