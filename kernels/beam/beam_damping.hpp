#pragma once
// Damping of beams in proportion to their elastic stiffness, as of solids (kernels/element/stiffness_damping.hpp).

#include "kernels/beam/beam_force.hpp"
#include "kernels/element/stiffness_damping.hpp"

namespace percuss {

/// Chunks of damped beams; const after set-up.
struct DampedBeams {
  Array<int> chunks;                                   // ascending chunk ids
  Array<double> beta;                                  // [chunks of the rank, damped or not] [time]
  Kokkos::View<BeamParameters*, MemSpace> parameters;  // as BeamBlock::parameters
};

/// What a beam exerts on its nodes at n+1 by the rates of n+1/2. e2: the axis y of the section at n+1.
KOKKOS_INLINE_FUNCTION BeamNodalForces<double> find_beam_damping(const BeamParameters& par, double beta,
                                                                 const BeamMotion& m, const Vector3<double>& e2) {
  if (!par.bends) {
    const Vector3<double> line = m.x.second - m.x.first;
    const double rate = dot(line, m.v.second - m.v.first) / dot(line, line);
    return {(beta * par.stiffness.axial * rate / norm(line)) * line, {}};
  }
  const BeamFrame<double> frame = find_beam_frame(m.x, e2);
  BeamRates<double> rate = find_beam_rates(frame, m.v, m.w);
  rate = {beta * rate.stretch, beta * rate.shear_y,     beta * rate.shear_z,
          beta * rate.twist,   beta * rate.curvature_y, beta * rate.curvature_z};
  return find_beam_nodal_forces(frame, add_elastic(BeamForces<double>{}, par.stiffness, rate));
}

/// Damps every listed chunk, after its internal forces.
void damp_beams(const ExecSpace& space, const ElementChunks& chunks, const DampedBeams& damped,
                const ElementMotion& motion, const DampingFields& fields);

}  // namespace percuss
