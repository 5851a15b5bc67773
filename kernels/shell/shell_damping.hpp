#pragma once
// Damping of shells in proportion to their elastic stiffness, as of solids (kernels/element/stiffness_damping.hpp):
// membrane, bending and transverse shear, at the thickness of n+1.

#include "kernels/element/stiffness_damping.hpp"
#include "kernels/shell/shell_force.hpp"

namespace percuss {

/// What the shells of a chunk are damped with.
struct DampedSection {
  PlaneElasticity elasticity;
  double beta = 0;            // [time]
  double bending_square = 0;  // of the places of the points in half the thickness, their weighted mean
  double offset = 0;          // as ShellParameters::offset
  bool is_membrane = false;
};

/// Chunks of damped shells; const after set-up.
struct DampedShells {
  Array<int> chunks;                                // ascending chunk ids
  Kokkos::View<DampedSection*, MemSpace> sections;  // [chunks of the rank]
  bool has_triangles = false;                       // among their elements
};

/// Damps every listed chunk, after its internal forces.
void damp_shells(const ExecSpace& space, const ElementChunks& chunks, const DampedShells& damped,
                 const ElementMotion& motion, const DampingFields& fields);

}  // namespace percuss
