#pragma once
// A beam of two nodes with one integration point: shear flexible, in axes that turn with it.
//
// The rates are those of Timoshenko's beam with linear velocities and spins, at the middle of the element (Hughes and
// Liu, Comput. Methods Appl. Mech. Engrg. 28, 1981, with one point along the axis). The axes follow the line between
// the nodes and the mean spin about it (Belytschko, Schwer and Klein, Int. J. Numer. Methods Engrg. 11, 1977): large
// turns are free, deformation within an element is small. One point leaves no locking in shear: an end load bends n
// elements by L^3/(3 E I) (1 - 1/(4 n^2)) + L/(G A_s), a moment exactly.

#include "kernels/beam/beam_section.hpp"
#include "kernels/core/tensor.hpp"

namespace percuss {

template <class T>
struct BeamFrame {
  Vector3<T> e1, e2, e3;
  T length;
};

/// Rates of strain at the middle: stretch and shears [1 / time], twist and curvatures [1 / (length time)].
template <class T>
struct BeamRates {
  T stretch, shear_y, shear_z, twist, curvature_y, curvature_z;
};

/// Forces and moments conjugate to these rates, over the section.
template <class T>
struct BeamForces {
  T normal, shear_y, shear_z, torque, moment_y, moment_z;
};

template <class T>
struct BeamEnds {
  Vector3<T> first, second;
};

/// The axes between two places, e2 as near to `toward` as it can be. toward: not along the beam.
template <class T>
PERCUSS_FORCE_INLINE BeamFrame<T> find_beam_frame(const BeamEnds<T>& place, const Vector3<T>& toward) {
  BeamFrame<T> frame;
  const Vector3<T> line = place.second - place.first;
  frame.length = norm(line);
  frame.e1 = (T(1) / frame.length) * line;
  const Vector3<T> across = toward - dot(toward, frame.e1) * frame.e1;
  frame.e2 = (T(1) / norm(across)) * across;
  frame.e3 = cross(frame.e1, frame.e2);
  return frame;
}

/// A vector turned by the spin over a time: the midpoint rule, which keeps its length.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> turn_by_spin(const Vector3<T>& u, const Vector3<T>& spin, const T& time) {
  const Vector3<T> half = (T(0.5) * time) * spin;
  const Vector3<T> moved = u + cross(half, u);
  return u + (T(2) / (T(1) + dot(half, half))) * cross(half, moved);
}

/// velocity, spin: of the nodes. Zero for rigid motion.
template <class T>
PERCUSS_FORCE_INLINE BeamRates<T> find_beam_rates(const BeamFrame<T>& frame, const BeamEnds<T>& velocity,
                                                  const BeamEnds<T>& spin) {
  const T over_length = T(1) / frame.length;
  const Vector3<T> dv = over_length * (velocity.second - velocity.first), dw = over_length * (spin.second - spin.first),
                   mean = T(0.5) * (spin.first + spin.second);
  return {dot(dv, frame.e1),
          dot(dv, frame.e2) - dot(mean, frame.e3),
          dot(dv, frame.e3) + dot(mean, frame.e2),
          dot(dw, frame.e1),
          dot(dw, frame.e2),
          dot(dw, frame.e3)};
}

/// Forces and moments that the nodes exert on the beam: their power is length times that of the section. The forces of
/// both nodes are opposite, and no moment is left.
template <class T>
struct BeamNodalForces {
  Vector3<T> force_on_second;  // minus this on the first
  BeamEnds<T> moment;
};

template <class T>
PERCUSS_FORCE_INLINE BeamNodalForces<T> find_beam_nodal_forces(const BeamFrame<T>& frame, const BeamForces<T>& f) {
  const Vector3<T> bending = f.torque * frame.e1 + (f.moment_y * frame.e2 + f.moment_z * frame.e3);
  const Vector3<T> lever = (T(0.5) * frame.length) * (f.shear_z * frame.e2 - f.shear_y * frame.e3);
  return {f.normal * frame.e1 + (f.shear_y * frame.e2 + f.shear_z * frame.e3), {lever - bending, lever + bending}};
}

/// Stiffness of an elastic section.
struct BeamStiffness {
  double axial = 0;                     // E A
  double shear_y = 0, shear_z = 0;      // G A_s
  double torsion = 0;                   // G J
  double bending_y = 0, bending_z = 0;  // E I
};

inline BeamStiffness find_beam_stiffness(const BeamSection& s, double youngs_modulus, double shear_modulus) {
  return {youngs_modulus * s.area,   shear_modulus * s.shear_area_y, shear_modulus * s.shear_area_z,
          shear_modulus * s.torsion, youngs_modulus * s.inertia_y,   youngs_modulus * s.inertia_z};
}

/// Second moment of the area about the beam, by which it turns.
inline double find_polar_moment(const BeamSection& s) {
  return s.polar_inertia > 0 ? s.polar_inertia : s.inertia_y + s.inertia_z;
}

/// Forces after a strain.
template <class T>
PERCUSS_FORCE_INLINE BeamForces<T> add_elastic(const BeamForces<T>& f, const BeamStiffness& k,
                                               const BeamRates<T>& strain) {
  return {f.normal + T(k.axial) * strain.stretch,           f.shear_y + T(k.shear_y) * strain.shear_y,
          f.shear_z + T(k.shear_z) * strain.shear_z,        f.torque + T(k.torsion) * strain.twist,
          f.moment_y + T(k.bending_y) * strain.curvature_y, f.moment_z + T(k.bending_z) * strain.curvature_z};
}

/// Rotary inertia of a node across the beam: the least with which neither bending nor shear shortens the step
/// below that of the axial wave, nor twist where a node has it about the beam too. Of a long element it is about mass *
/// length^2 / 15, which bending over several elements hardly feels. least_ratio: of E A to G A_s, where a section has
/// none above 1.
inline double find_beam_inertia(const BeamStiffness& k, double mass, double length) {
  constexpr double least_ratio = 1.25;
  const double turn = std::fmax(k.torsion, std::fmax(k.bending_y, k.bending_z)) / (2 * k.axial);
  const double ratio = std::fmax(k.axial / std::fmax(k.shear_y, k.shear_z), least_ratio);
  return mass * std::fmax(turn, length * length / (8 * (ratio - 1)));
}

/// The largest eigenvalue of a truss with half its mass at each node: along it, or across under a force that pulls.
KOKKOS_INLINE_FUNCTION double find_truss_eigenvalue(double axial, double mass, double length, double normal = 0) {
  return 4 * std::fmax(axial, normal) / (mass * length);
}

/// Rotary inertia of a node of a beam.
struct BeamInertia {
  double across = 0, about = 0;  // any axis across the beam; its own axis
};

/// The largest eigenvalue of a beam with half its mass and the rotary inertia at each node [1 / time^2]. Exact: the six
/// rates have gradients that are orthogonal in the inverse masses, so that each gives one eigenvalue. A force that
/// pulls adds to the stiffness across the axis; yielding only lowers the stiffness.
KOKKOS_INLINE_FUNCTION double find_beam_eigenvalue(const BeamStiffness& k, double mass, const BeamInertia& inertia,
                                                   double length, double normal = 0) {
  const double pull = std::fmax(normal, 0.0);
  const double across = 4 / (mass * length) + length / (2 * inertia.across);
  const double shear = std::fmax(k.shear_y, k.shear_z) * across + pull * 4 / (mass * length);
  const double bending = std::fmax(k.bending_y, k.bending_z) * 2 / (length * inertia.across);
  const double twist = k.torsion * 2 / (length * inertia.about);
  return std::fmax(std::fmax(4 * k.axial / (mass * length), twist), std::fmax(shear, bending));
}

}  // namespace percuss
