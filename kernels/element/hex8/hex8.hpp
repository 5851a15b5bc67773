#pragma once
// The one-point hexahedron over one step: from corner motion to corner forces, as a pure function.
//
// Place in the step: (1.3) strain rate, (1.4) stress, (1.5) internal force of the paper. Positions are at
// n+1, velocities at n+1/2; rates are taken on the geometry of the mid-point and turned half way, forces act on the
// geometry of n+1 (Flanagan and Belytschko 1981; Flanagan and Taylor 1987).

#include "kernels/core/work_kinds.hpp"
#include "kernels/element/hex8/bulk_viscosity.hpp"
#include "kernels/element/hex8/hourglass_control.hpp"
#include "kernels/element/hex8/kinematics.hpp"
#include "kernels/element/hex8/stable_step.hpp"

namespace percuss {

/// State of one element, or of a pack of them, between steps; stress and history are in the unrotated frame. The
/// members lie like the scalars of a record (HexRecord), so that a record of packs is read and written in place.
template <class T, class Material, HexKind Kind>
struct HexState {
  T mass;                                                    // constant
  T viscous_pressure;                                        // q at n, for the trapezoid of its work
  Polar<T> polar;                                            // R and V at n
  Symmetric3<T> stress;                                      // Cauchy, unrotated, at n
  [[no_unique_address]] StoredHourglass<T, Kind> hourglass;  // Q at n
  [[no_unique_address]] StressRestsOf<T, 1> stress_rest;     // in float
  [[no_unique_address]] MaterialHistory<T, Material, 1> history;
};

/// Energy that one step put into the element [energy].
template <class T>
struct HexWork {
  T internal, hourglass, viscous;
  T folding = T(0);  // of fold_resistance.hpp, which the launcher adds where it is needed

  /// Calls take(kind, work) for each kind but folding.
  template <class Take>
  KOKKOS_FORCEINLINE_FUNCTION void visit(const Take& take) {
    take(WorkKind::internal, internal);
    take(WorkKind::hourglass, hourglass);
    take(WorkKind::viscous, viscous);
  }
};

template <class T>
struct HexResult {
  HexWork<T> work;
  T stable_step;  // bound for the next step, without the deck's scale
  T size;         // volume at n+1; not positive: the element is inverted
  T obliqueness;  // at n+1
};

/// Where the forces of an element go: out, by corner, in float by mode.
template <class T>
struct CornerForces {
  T (&x)[8], (&y)[8], (&z)[8];
};

/// Forces by corner from those by mode. In float they stay by mode: who adds them up turns them to corners in double,
/// where those of an element add up to nothing to the last digit of a double.
template <class T>
PERCUSS_FORCE_INLINE void finish_forces(const CornerForces<T>& out) {
  if constexpr (!is_short<T>) {
    to_corners(out.x);
    to_corners(out.y);
    to_corners(out.z);
  }
}

/// Corner forces from Cauchy stress t and hourglass forces q on the end geometry.
/// Power balance: sum_I f_I . v_I = V t:D + sum_h Q_h . u_h, and sum_I x_I cross f_I = 0.
template <class T>
PERCUSS_FORCE_INLINE void find_corner_forces(const Symmetric3<T>& t, const HourglassModes<T>& q,
                                             const VectorModes<T>& a, const VolumeGradient<T>& b,
                                             const CornerForces<T>& out) {
  const T over_64 = number<T>(1.0 / 64.0), over_64_volumes = over_64 * (T(1) / b.volume);
  Matrix3<T> p{{q.mode[0].x * a[4], q.mode[0].y * a[4], q.mode[0].z * a[4]}};
  for (int h = 1; h < 4; ++h) {
    p.row[0] = p.row[0] + q.mode[h].x * a[4 + h];
    p.row[1] = p.row[1] + q.mode[h].y * a[4 + h];
    p.row[2] = p.row[2] + q.mode[h].z * a[4 + h];
  }
  p = full(over_64 * t) - over_64_volumes * p;
  out.x[0] = out.y[0] = out.z[0] = T(0);
  for (int m = 1; m <= 6; ++m) {
    const Vector3<T> f = p * b[m];
    out.x[m] = f.x;
    out.y[m] = f.y;
    out.z[m] = f.z;
  }
  out.x[7] = out.y[7] = out.z[7] = T(0);
  for (int h = 0; h < 4; ++h) {
    out.x[4 + h] = out.x[4 + h] + q.mode[h].x;
    out.y[4 + h] = out.y[4 + h] + q.mode[h].y;
    out.z[4 + h] = out.z[4 + h] + q.mode[h].z;
  }
  finish_forces(out);
}

/// Input of a material for the step, and lambda + 2 mu at n.
template <class T>
struct PointInput {
  PointMotion<T> point;
  T modulus;
};

/// A called material gets the geometry at the end of the step. Others are compiled without it, so that their stress is
/// complete before the end geometry needs the registers.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE PointInput<T> find_point_input(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                                    [[maybe_unused]] const State& state, const StepMotion<T>& step,
                                                    const T& dt) {
  PointInput<T> input{{step.de, dt, T(1), T(1), T(0), par.time}, number<T>(par.lambda + 2 * par.mu)};
  input.point.change = step.change;
  if constexpr (is_called<Material>) {
    const VolumeGradient<T> b = find_volume_gradient(a);
    input.modulus = find_longitudinal_modulus<T>(state.history);
    input.point.length = find_thickness(find_gradient_size(b), b.volume);
    input.point.volume_ratio = find_volume_ratio(par, state, b.volume);
    const T density = state.mass * (T(1) / b.volume),
            speed = square_root(input.modulus * b.volume * (T(1) / state.mass));
    const T pressure = find_viscous_pressure(par.viscosity, density, input.point.length, speed, step.trace_d).pressure;
    input.point.viscosity = number<T>(0.5) * (state.viscous_pressure + pressure);
  }
  return input;
}

/// Advances the element from n to n+1. a, v: modes of x(n+1) and v(n+1/2). out: the internal forces (they resist the
/// motion: the node feels their negative). With dt = 0 it evaluates forces and step only.
template <class T, class Material, HexKind Kind>
PERCUSS_FORCE_INLINE HexResult<T> advance_hex8(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                               const VectorModes<T>& v, const T& dt, HexState<T, Material, Kind>& state,
                                               const CornerForces<T>& out) {
  const T half = number<T>(0.5);
  const StepMotion<T> step = follow_motion(a, v, dt, state.polar);  // (1.3) strain rate

  // (1.4) stress
  const Symmetric3<T> old_stress = state.stress;
  const PointInput<T> input = find_point_input(par, a, state, step, dt);
  const auto response = update_stress(par.material, state.stress, state.stress_rest[0], state.history, 0, input.point);
  const auto moduli = find_moduli(par, response);

  // end geometry
  const VolumeGradient<T> b = find_volume_gradient(a);
  const GradientSize<T> size = find_gradient_size(b);
  const T density = state.mass * (T(1) / b.volume);
  const T speed = square_root(input.modulus * b.volume * (T(1) / state.mass));

  const ViscousPressure<T> viscous =
      find_viscous_pressure(par.viscosity, density, find_thickness(size, b.volume), speed, step.trace_d);
  const T old_viscous_pressure = state.viscous_pressure;
  state.viscous_pressure = viscous.pressure;

  const HourglassModes<T> rates = find_hourglass_rates(v, step.middle, step.l);
  const HourglassMotion<T> motion{step.middle, a, v, rates, step.turn, dt, step.l, step.stretch};
  const HourglassElement<T> element{state.mass, size.trace, b.volume, step.b};
  HourglassModes<T> own_force;
  HourglassModes<T>& force = find_hourglass_place(state.hourglass, own_force);
  const HourglassStep<T> hourglass = control_hourglass<Kind>(par, response, motion, element, force, state);

  Symmetric3<T> t = push_forward(state.polar.rotation, state.stress);
  t.xx = t.xx - viscous.pressure;
  t.yy = t.yy - viscous.pressure;
  t.zz = t.zz - viscous.pressure;
  find_corner_forces(t, force, a, b, out);  // (1.5) internal forces

  const T oblique = find_obliqueness(a, size, b.volume);
  const T frequency_square =
      join_hourglass_frequency(find_frequency_square(size, b.volume, state.mass, moduli.lambda, moduli.mu),
                               hourglass.stiffness, state.mass, oblique);
  const T damping_rate = find_damping_rate(size, b.volume, state.mass, viscous.tangent) +
                         T(64) * hourglass.viscosity * oblique * (T(1) / state.mass);
  const T half_volume = half * step.b.volume;
  return {{half_volume * contract(old_stress + state.stress, step.de), hourglass.work,
           -half_volume * (old_viscous_pressure + viscous.pressure) * dt * step.trace_d},
          find_stable_step(frequency_square, damping_rate),
          b.volume,
          oblique};
}

}  // namespace percuss
