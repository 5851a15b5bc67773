#pragma once
// How the launchers of beams read the motion of an element's nodes, and sum up by slot what it exerts on them.

#include "kernels/beam/beam_force.hpp"
#include "kernels/element/chunk_records.hpp"
#include "kernels/element/element_records.hpp"

namespace percuss {

using BeamScratch = ChunkScratch<3, 2>;

/// Slots of an element's two nodes within its chunk.
struct BeamSlots {
  int first, second;
};

KOKKOS_INLINE_FUNCTION BeamSlots find_beam_slots(const TeamChunk& chunk, int lane) {
  return {find_corner_slot(chunk.chunks, chunk.c, lane, 0), find_corner_slot(chunk.chunks, chunk.c, lane, 1)};
}

KOKKOS_INLINE_FUNCTION BeamMotion find_beam_motion(const BeamScratch& scratch, const BeamSlots& slots, double dt) {
  const auto load = [&](int k, int slot) {
    const double* const from = scratch.nodes + BeamScratch::node_size * slot + 4 * k;
    return Vector3<double>{from[0], from[1], from[2]};
  };
  return {{load(0, slots.first), load(0, slots.second)},
          {load(1, slots.first), load(1, slots.second)},
          {load(2, slots.first), load(2, slots.second)},
          dt};
}

KOKKOS_INLINE_FUNCTION BeamNodalForces<double> scale_beam_forces(double share, const BeamNodalForces<double>& on) {
  return {share * on.force_on_second, {share * on.moment.first, share * on.moment.second}};
}

KOKKOS_INLINE_FUNCTION void subtract_vector(const Vector3<double>& u, double* sum) {
  sum[0] -= u.x;
  sum[1] -= u.y;
  sum[2] -= u.z;
}

/// Adds the forces and moments of a beam to those on its nodes.
KOKKOS_INLINE_FUNCTION void add_beam_forces(const BeamNodalForces<double>& on, const BeamSlots& slots,
                                            const BeamScratch& scratch) {
  double* const first = scratch.forces + BeamScratch::force_size * slots.first;
  double* const second = scratch.forces + BeamScratch::force_size * slots.second;
  subtract_vector(-1.0 * on.force_on_second, first);
  subtract_vector(on.force_on_second, second);
  subtract_vector(on.moment.first, first + 4);
  subtract_vector(on.moment.second, second + 4);
}

}  // namespace percuss
