#pragma once
// Weight and inertia of fluid elements at their centroids: the forces that lumped masses lack, chunk by chunk.

#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_lives.hpp"

namespace percuss {

/// Chunks of hexahedra, wedges and pyramids of fluids; const after set-up. They leave the forces in slots of their own,
/// in the order of the chunk's slots.
struct FluidChunks {
  Array<int> list;             // [count] chunks, ascending
  Array<int> first_element;    // [count + 1] elements of fluids are numbered by chunk
  Array<int> first_slot;       // [count]
  Array<double> bulk_modulus;  // [count] at the start
  Array<double> start_weight;  // [count] share of gravity that counts at time 0: 1: the fluid rests, 0: it falls

  int count() const { return static_cast<int>(list.extent(0)); }
};

/// What the forces of a chunk amount to: their moment, and the power of those before and of those now.
struct CentroidSum {
  enum : int { moment, old_power = moment + 3, power, count };
};
using CentroidSums = Kokkos::View<double * [CentroidSum::count], Kokkos::LayoutRight, MemSpace>;

/// What the forces at n+1 follow from.
struct CentroidMotion {
  Rows3<const double> x, v;  // at n+1, at n+1/2
  double dt_mean = 0;        // from n-1/2 to n+1/2; 0: time 0, nothing is accelerated
  double gravity[3] = {};    // at n+1
  double center[3] = {};     // about which moments are taken
  Array<const double> mass;  // [elements]
  FailingChunks failing;     // elements that can fail count by their lives
  ElementLives lives;
};

/// What they leave.
struct CentroidFields {
  Rows3<double> velocity;    // [elements of fluids] of the mass at their corners, in: at n-1/2, out: at n+1/2
  Rows3<double> slot_force;  // out
  CentroidSums sums;         // out, by chunk of `FluidChunks`
};

/// The force of the energy -m (g - a) . (xc - mean of the corners) of each element, a: mean acceleration of its
/// corners (find_centroid_forces()).
void apply_centroid_forces(const ExecSpace& space, const ElementChunks& chunks, const FluidChunks& fluids,
                           const CentroidMotion& motion, const CentroidFields& fields);

}  // namespace percuss
