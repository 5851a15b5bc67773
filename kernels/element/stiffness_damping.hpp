#pragma once
// Damping of solids in proportion to their elastic stiffness: the stress beta C : D beside that of the material.
//
// Place in the step: after (1.5) internal forces, to the same slots. D is the rate of strain of the velocities at n+1/2
// on the geometry of n+1, where the forces act: their power is V beta D : C : D >= 0. One-point hexahedra take the mean
// rate, those of 2x2x2 points that of each point, with the mean dilatation, thick shells that which they assume
// (docs/theory.md).

#include <cmath>
#include <cstdint>

#include "kernels/element/elastic_operator.hpp"

namespace percuss {

/// Whose rates the damping of hexahedra takes.
enum class DampedKind : std::uint8_t { mean, full, thick };

/// Chunks of damped solids; const after set-up.
struct DampedSolids {
  Array<int> chunks;         // ascending chunk ids
  Array<double> lambda, mu;  // [chunks of the rank] Lame's constants at the start times beta [pressure x time]
  Array<DampedKind> kind;    // [chunks of the rank]
};

/// Forces of damping by slot (what nodes feel), and what they are added to.
struct DampingFields {
  Rows3<double> force;                    // in: at n, out: at n+1
  Rows3<double> slot_force;               // added to
  WorkRows work;                          // viscous: added to, with the mean of the forces at n and n+1
  Rows3<double> moment{}, slot_moment{};  // as force and slot_force, of elements whose nodes turn
  Array<Real> state{};                    // records of the elements: in
};

/// Damps every listed chunk, after its internal forces.
void damp_solids(const ExecSpace& space, const ElementChunks& chunks, const DampedSolids& damped,
                 const ElementMotion& motion, const DampingFields& fields);

/// Lame's constants times beta.
struct DampingModuli {
  double lambda = 0, mu = 0;
};

/// Forces at the corners that resist the velocities u on the geometry a, both as modes, of one-point hexahedra.
template <class T>
PERCUSS_FORCE_INLINE void find_mean_damping(const DampingModuli& moduli, const VectorModes<T>& a,
                                            const VectorModes<T>& u, const CornerForces<T>& out) {
  const VolumeGradient<T> b = find_volume_gradient(a);
  const Symmetric3<T> d = symmetric_part(find_velocity_gradient(u, b));
  const T pressure = number<T>(moduli.lambda) * trace(d);
  const Symmetric3<T> t = number<T>(2 * moduli.mu) * d + Symmetric3<T>{pressure, pressure, pressure, T(0), T(0), T(0)};
  const Vector3<T> none{T(0), T(0), T(0)};
  find_corner_forces(t, HourglassModes<T>{{none, none, none, none}}, a, b, out);
}

/// Damping forces of elements with 2x2x2 points and mean dilatation.
template <class T>
PERCUSS_FORCE_INLINE void find_full_damping(const DampingModuli& moduli, const VectorModes<T>& a,
                                            const VectorModes<T>& u, const CornerForces<T>& out) {
  const VolumeGradient<T> b = find_volume_gradient(a);
  const VectorModes<T> force = probe_points(number<T>(moduli.mu), a, u, T(1));
  const T bulk = number<T>(moduli.lambda + 2.0 / 3.0 * moduli.mu);
  find_full_forces(force, identity_matrix<T>(), bulk * trace(symmetric_part(find_velocity_gradient(u, b))), b, out);
}

/// Damping forces of thick shells; three points across integrate it for any number.
template <class T>
PERCUSS_FORCE_INLINE void find_thick_damping(const DampingModuli& moduli, const VectorModes<T>& a,
                                             const VectorModes<T>& u, const CornerForces<T>& out) {
  const VectorModes<T> force = probe_columns<3>(Moduli<T>{number<T>(moduli.lambda), number<T>(moduli.mu)}, a, u);
  find_full_forces(force, identity_matrix<T>(), T(0), find_volume_gradient(a), out);
}

/// Largest step of central differences with the damping of the whole stiffness, which lags half a step, from that
/// without: omega^2 (dt^2 / 4 + beta dt / 2) <= 1 with omega = 2 / step, which is dt = step (sqrt(1 + xi^2) - xi) with
/// xi = beta omega / 2. With a viscosity within `step` it is a lower bound.
KOKKOS_INLINE_FUNCTION double find_damped_step(double step, double beta) {
  return step / (std::sqrt(1 + (beta / step) * (beta / step)) + beta / step);
}

}  // namespace percuss
