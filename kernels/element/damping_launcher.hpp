#pragma once
// The one launcher of damping in proportion to stiffness, for all families.
//
// A family has a body, which is made anew for each chunk: Damped, the chunks that are damped; Scratch (ChunkScratch);
// damp(), which leaves the forces of damping in the scratch.

#include "kernels/element/chunk_records.hpp"
#include "kernels/element/element_motion.hpp"
#include "kernels/element/living_lanes.hpp"
#include "kernels/element/stiffness_damping.hpp"

namespace percuss {

template <class List>
struct DampingStep {
  ElementChunks chunks;
  List damped;
  ElementMotion motion;
  DampingFields fields;
};

template <class Body>
struct DampingKernel : DampingStep<typename Body::Damped> {
  using Of = DampingStep<typename Body::Damped>;
  using Scratch = typename Body::Scratch;
  using Of::fields;
  using Of::motion;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(Of::chunks, Of::damped.chunks(member.league_rank()));
    const Scratch scratch(member, chunk.slot_count);
    scratch.fill(chunk, motion);
    scratch.clear(chunk);
    Body{*this, chunk, scratch}.damp();
    double power = set_damping(chunk, motion.v, scratch.forces, fields.force, fields.slot_force);
    if (Scratch::has_spins && motion.w.extent(0) > 0)
      power += set_damping(chunk, motion.w, scratch.forces + 4, fields.moment, fields.slot_moment);
    fields.work(chunk.c, WorkKind::viscous) -= 0.5 * motion.dt * power;
  }

  /// Makes `now`, by slot, the damping of each slot, in place of that of the step before, and adds it to `all`. Returns
  /// the sum of old and new times the velocities, slot by slot.
  KOKKOS_FUNCTION static double set_damping(const TeamChunk& chunk, const Rows3<const double>& v, const double* now,
                                            const Rows3<double>& damping, const Rows3<double>& all) {
    double power = 0;
    for (int s = 0; s < chunk.slot_count; ++s) {
      const int n = chunk.nodes()[s], slot = chunk.first_slot + s;
      for (int k = 0; k < 3; ++k) {
        const double force = now[Scratch::force_size * s + k];
        power += v(n, k) * (damping(slot, k) + force);
        damping(slot, k) = force;
        all(slot, k) += force;
      }
    }
    return power;
  }
};

/// Damps every listed chunk.
template <class Body>
void launch_damping(const char* label, const ExecSpace& space, const ElementChunks& chunks,
                    const typename Body::Damped& damped, const ElementMotion& motion, const DampingFields& fields) {
  if (damped.chunks.extent(0) == 0) return;
  launch_chunks(label, space, chunks, damped.chunks, DampingKernel<Body>{{chunks, damped, motion, fields}});
}

}  // namespace percuss
