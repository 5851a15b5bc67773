#include "kernels/beam/beam_damping.hpp"

#include "kernels/beam/beam_nodes.hpp"
#include "kernels/element/damping_launcher.hpp"

namespace percuss {
namespace {

struct BeamDamping {
  using Damped = DampedBeams;
  using Scratch = BeamScratch;
  const DampingStep<DampedBeams>& of;
  const TeamChunk& chunk;
  const BeamScratch& scratch;

  KOKKOS_FUNCTION void damp() const {
    const BeamParameters& parameters = of.damped.parameters(chunk.chunks.parameters(chunk.c));
    LivingLanes<Real> living(of.motion.failing, of.motion.lives, chunk.c);
    chunk.for_each_pack(living, nullptr, 0, [&](const ChunkPack& pack) {
      for (int lane = 0; lane < pack.lanes; ++lane) {
        if (living.can_fail() && living.is_dead(lane)) continue;
        const double share = living.can_fail() ? living.find_force_share(lane) : 1;
        const BeamSlots slots = find_beam_slots(chunk, pack.first + lane);
        const ElementRecord e2 =
            find_record(chunk.chunks, of.fields.state, chunk.c, pack.first + lane).from(BeamRecord::e2);
        const BeamNodalForces<double> on =
            find_beam_damping(parameters, of.damped.beta(chunk.c), find_beam_motion(scratch, slots, of.motion.dt),
                              {e2.get(0), e2.get(1), e2.get(2)});
        add_beam_forces(scale_beam_forces(share, on), slots, scratch);
      }
    });
  }
};

}  // namespace

void damp_beams(const ExecSpace& space, const ElementChunks& chunks, const DampedBeams& damped,
                const ElementMotion& motion, const DampingFields& fields) {
  launch_damping<BeamDamping>("percuss::damp_beams", space, chunks, damped, motion, fields);
}

}  // namespace percuss
