#pragma once
// How the launchers of beams read the motion of an element's nodes, and sum up by slot what it exerts on them.

#include "kernels/beam/beam_force.hpp"
#include "kernels/element/chunk_records.hpp"
#include "kernels/element/element_records.hpp"

namespace percuss {

inline constexpr int beam_force_record = 6;  // force, moment
using BeamScratch = ChunkScratch<0, beam_force_record>;

/// Of an element, within its chunk.
struct BeamSlots {
  int first, second;
};

KOKKOS_INLINE_FUNCTION BeamSlots find_beam_slots(const ElementChunks& chunks, int c, int lane) {
  return {find_corner_slot(chunks, c, lane, 0), find_corner_slot(chunks, c, lane, 1)};
}

KOKKOS_INLINE_FUNCTION Vector3<double> load_vector(const Rows3<const double>& rows, int n) {
  return {rows(n, 0), rows(n, 1), rows(n, 2)};
}

KOKKOS_INLINE_FUNCTION BeamMotion find_beam_motion(const ElementChunks& chunks, int c, const BeamSlots& slots,
                                                   const BeamStep& step) {
  const int a = chunks.slots_to_nodes(chunks.first_slot(c) + slots.first),
            b = chunks.slots_to_nodes(chunks.first_slot(c) + slots.second);
  BeamMotion motion{{load_vector(step.x, a), load_vector(step.x, b)},
                    {load_vector(step.v, a), load_vector(step.v, b)},
                    {{0, 0, 0}, {0, 0, 0}},
                    step.dt};
  if (step.w.extent(0) > 0) motion.w = {load_vector(step.w, a), load_vector(step.w, b)};
  return motion;
}

KOKKOS_INLINE_FUNCTION BeamNodalForces<double> scale_beam_forces(double share, const BeamNodalForces<double>& on) {
  return {share * on.force_on_second, {share * on.moment.first, share * on.moment.second}};
}

KOKKOS_INLINE_FUNCTION void subtract_vector(const Vector3<double>& u, double* sum) {
  sum[0] -= u.x;
  sum[1] -= u.y;
  sum[2] -= u.z;
}

/// sums: [slots][beam_force_record], what the nodes feel.
KOKKOS_INLINE_FUNCTION void add_beam_forces(const BeamNodalForces<double>& on, const BeamSlots& slots, double* sums) {
  double* const first = sums + beam_force_record * slots.first;
  double* const second = sums + beam_force_record * slots.second;
  subtract_vector(-1.0 * on.force_on_second, first);
  subtract_vector(on.force_on_second, second);
  subtract_vector(on.moment.first, first + 3);
  subtract_vector(on.moment.second, second + 3);
}

}  // namespace percuss
