#pragma once
// The hourglass controls of the one-point hexahedron, over one step.

#include <type_traits>

#include "kernels/element/hex8/assumed_strain.hpp"
#include "kernels/element/hex8/bulk_viscosity.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/hex8/hourglass.hpp"
#include "kernels/element/hex8/kinematics.hpp"
#include "kernels/element/hex8/material_point.hpp"
#include "kernels/element/hex8/plastic_bending.hpp"

namespace percuss {

/// Numbers that are the same for all elements of a block.
template <class Material>
struct SolidParameters {
  Material material;
  double lambda = 0, mu = 0;  // bound of the elastic stiffness; a negative lambda counts as 0
  double hourglass = 0.05;    // coefficient of the stiffness and the viscous form
  BulkViscosity viscosity;
  double time = 0;  // at n+1; set for each step
};

/// The motion over the step as hourglass control sees it.
template <class T>
struct HourglassMotion {
  const VectorModes<T>& middle;    // positions at n+1/2
  const VectorModes<T>& end;       // positions at n+1
  const VectorModes<T>& velocity;  // at n+1/2
  const HourglassModes<T>& rate;   // u at n+1/2
  const Matrix3<T>& turn;          // of advance_polar()
  T dt;
  const Matrix3<T>& l;           // velocity gradient at n+1/2
  const Symmetric3<T>& stretch;  // V at n+1/2
};

/// The element that it stabilises.
template <class T>
struct HourglassElement {
  T mass;
  T gradient_square;                // B:B at n+1
  T volume;                         // at n+1
  const VolumeGradient<T>& middle;  // at n+1/2
};

template <class T>
struct HourglassStep {
  T work;
  T stiffness;  // bounds of the largest eigenvalue of dQ/du and of
  T viscosity;  // dQ/d(u rate), for the step
};

struct NoHourglass {};

/// Q between steps, for the forms that keep it.
template <class T, HexKind Kind>
using StoredHourglass = std::conditional_t<Kind == HexKind::viscous, NoHourglass, HourglassModes<T>>;

/// Storage of Q of the step: its record, or else a local of the step.
template <class T>
PERCUSS_FORCE_INLINE HourglassModes<T>& find_hourglass_place(HourglassModes<T>& stored, HourglassModes<T>& /*own*/) {
  return stored;
}
template <class T>
PERCUSS_FORCE_INLINE HourglassModes<T>& find_hourglass_place(NoHourglass& /*stored*/, HourglassModes<T>& own) {
  return own;
}

/// How stored forces follow a step of plastic flow where the element does not yield as a section (plastic_bending.hpp),
/// and the guard of near-inverted elements.
///
/// They are scaled by the radial return of the centre. New ones use the plastic tangent, approximated by the share
/// `flowing`. The stress that they represent at the surface is limited to the yield stress left by the centre's own
/// stress; otherwise a single element through the thickness would never yield. Without the guard, corner nodes of
/// crushed elements meet no resistance. The constants are tuned on Taylor bars, plastic cantilevers and crushed cubes.
template <class T>
struct PlasticHourglass {
  static constexpr double flowing = 0.1, headroom = 1.5, least_headroom = 0.1, guard_coefficient = 0.1;

  T guard;

  PERCUSS_FORCE_INLINE T rate_share(const PlasticReturn<T>& plastic) const {
    return larger(select(plastic.share < T(1), number<T>(flowing), T(1)), guard);
  }
  PERCUSS_FORCE_INLINE T force_share(const PlasticReturn<T>& plastic, const T& surface_stress_square) const {
    const T room = larger(larger(T(1) - plastic.loading, number<T>(least_headroom)), guard);
    const T most = number<T>(headroom) * plastic.flow_stress * room;
    return smaller(T(1), most / square_root(larger(surface_stress_square, number<T>(next_to_nothing<T>))));
  }
};

/// Q turned with the material over the step, with half of what the step adds turned along: the mean of R(n) and R(n+1)
/// takes an increment of the mid-point to the unrotated frame, R(n+1) takes it from there to the end.
template <class T>
PERCUSS_FORCE_INLINE Vector3<T> advance_hourglass(const Matrix3<T>& turn, const Vector3<T>& old,
                                                  const Vector3<T>& half_increment) {
  return turn_along(turn, old + half_increment) + half_increment;
}

/// The assumed-strain stabilisation of the shape at the start, for materials that keep their energy. Q follows the
/// deformation as the gradient of a field does, so that its components along the axes of the element stay.
template <class T>
PERCUSS_FORCE_INLINE HourglassStep<T> control_elastic_assumed_strain(const LameConstants& constants,
                                                                     const HourglassMotion<T>& motion, const T& volume,
                                                                     HourglassModes<T>& q) {
  const StartShape<T> start = find_start_shape(motion.middle, motion.stretch, volume);
  const HourglassResponse<T> response =
      find_assumed_strain_response(find_plate_moduli(constants), start.axes, start.volume, motion.rate);
  const Matrix3<T> carry = find_force_increment(motion.l, motion.dt);
  const T half_dt = number<T>(0.5) * motion.dt;
  HourglassModes<T> sum;  // Q(n) + Q(n+1)
  for (int h = 0; h < 4; ++h) {
    const Vector3<T> old = q.mode[h];
    q.mode[h] = advance_hourglass(carry, old, half_dt * response.force.mode[h]);
    sum.mode[h] = old + q.mode[h];
  }
  return {find_hourglass_work(sum, motion.rate, motion.dt), start.gain * response.stiffness, T(0)};
}

/// The assumed-strain stabilisation of materials that yield. state: Q at n, out at n+1, and the centre's stress, which
/// yields with Q.
template <class T, class Material, class Plastic, class State>
PERCUSS_FORCE_INLINE HourglassStep<T> control_yielding_assumed_strain(const Material& material, const Plastic& plastic,
                                                                      const HourglassMotion<T>& motion,
                                                                      const HourglassElement<T>& element,
                                                                      State& state) {
  HourglassModes<T>& q = state.hourglass;
  const ElementAxes<T> axes = find_element_axes(motion.middle);
  const PlateModuli moduli = find_plate_moduli(material.moduli());
  HourglassResponse<T> response = find_assumed_strain_response(moduli, axes, element.middle.volume, motion.rate);
  HourglassModes<T> sum;  // Q(n) + Q(n+1)
  const PlasticHourglass<T> rule{find_guard(motion.middle, element.middle)};
  const T guard = rule.guard * find_hourglass_stiffness(element.gradient_square, element.volume, material.moduli().mu,
                                                        rule.guard_coefficient);
  response.stiffness = response.stiffness + guard;
  constexpr bool bends = bends_plastically<Material>();
  const T rate = number<T>(0.5) * motion.dt * rule.rate_share(plastic);
  for (int h = 0; h < 4; ++h) {
    const Vector3<T> increment = response.force.mode[h] + guard * motion.rate.mode[h];
    sum.mode[h] = q.mode[h];
    q.mode[h] = advance_hourglass(motion.turn, q.mode[h], rate * increment);
    if constexpr (!bends) q.mode[h] = plastic.share * q.mode[h];
  }
  const T square = find_surface_stress_square(axes, motion.end, element.middle.volume, q);
  if constexpr (bends) {
    if (any(find_yielding(plastic, square))) {
      yield_as_section(material, plastic,
                       {motion.end, motion.velocity, motion.dt, element.middle.volume, square, rule.guard}, state);
    }
  } else {
    const T share = rule.force_share(plastic, square);
    for (int h = 0; h < 4; ++h) q.mode[h] = share * q.mode[h];
  }
  for (int h = 0; h < 4; ++h) sum.mode[h] = sum.mode[h] + q.mode[h];
  return {find_hourglass_work(sum, motion.rate, motion.dt), response.stiffness, T(0)};
}

/// The assumed-strain stabilisation. state: Q at n, out at n+1.
template <class T, class Material, class Plastic, class State>
PERCUSS_FORCE_INLINE HourglassStep<T> control_by_assumed_strain(const Material& material,
                                                                [[maybe_unused]] const Plastic& plastic,
                                                                const HourglassMotion<T>& motion,
                                                                const HourglassElement<T>& element, State& state) {
  if constexpr (!Material::can_yield) {
    return control_elastic_assumed_strain(material.moduli(), motion, element.middle.volume, state.hourglass);
  } else {
    if constexpr (is_called<Material>) {
      if (material.stores_energy)
        return control_elastic_assumed_strain(material.moduli(), motion, element.middle.volume, state.hourglass);
    }
    return control_yielding_assumed_strain(material, plastic, motion, element, state);
  }
}

/// The stiffness form of Flanagan and Belytschko, relaxed by plastic return. q: Q at n, out at n+1.
template <class T, class Material, class Plastic>
PERCUSS_FORCE_INLINE HourglassStep<T> control_by_stiffness(double mu, double coefficient,
                                                           [[maybe_unused]] const Plastic& plastic,
                                                           const HourglassMotion<T>& motion,
                                                           const HourglassElement<T>& element, HourglassModes<T>& q) {
  const T kappa = find_hourglass_stiffness(element.gradient_square, element.volume, mu, coefficient);
  const T rate = number<T>(0.5) * motion.dt * kappa;
  HourglassModes<T> sum;  // Q(n) + Q(n+1)
  for (int h = 0; h < 4; ++h) {
    const Vector3<T> old = q.mode[h];
    q.mode[h] = advance_hourglass(motion.turn, old, rate * motion.rate.mode[h]);
    if constexpr (Material::can_yield) q.mode[h] = plastic.share * q.mode[h];
    sum.mode[h] = old + q.mode[h];
  }
  return {find_hourglass_work(sum, motion.rate, motion.dt), kappa, T(0)};
}

/// The control of Kind over one step; mu and hourglass of the parameters size the forms of Flanagan and Belytschko. q:
/// Q at n where it is kept, out at n+1. state: that of the element, with its stress at n+1.
template <HexKind Kind, class T, class Material, class Plastic, class State>
PERCUSS_FORCE_INLINE HourglassStep<T> control_hourglass(const SolidParameters<Material>& par, const Plastic& plastic,
                                                        const HourglassMotion<T>& motion,
                                                        const HourglassElement<T>& element, HourglassModes<T>& q,
                                                        [[maybe_unused]] State& state) {
  if constexpr (Kind == HexKind::assumed_strain) {
    return control_by_assumed_strain(par.material, plastic, motion, element, state);
  } else if constexpr (Kind == HexKind::stiffness) {
    return control_by_stiffness<T, Material>(par.mu, par.hourglass, plastic, motion, element, q);
  } else {
    const T eta =
        find_hourglass_viscosity(element.gradient_square, element.volume, element.mass, par.mu, par.hourglass);
    for (int h = 0; h < 4; ++h) q.mode[h] = eta * motion.rate.mode[h];
    return {motion.dt * find_power(q, motion.rate), T(0), eta};
  }
}

}  // namespace percuss
