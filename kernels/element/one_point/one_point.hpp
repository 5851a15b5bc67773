#pragma once
// The one-point wedge or pyramid over one step: from corner motion to corner forces, as a pure function.
//
// Place in the step: (1.3) strain rate, (1.4) stress, (1.5) internal force of the paper. Positions are at n+1,
// velocities at n+1/2; rates are taken on the geometry of the mid-point and turned half way, forces act on the geometry
// of n+1, as of the hexahedron (kernels/element/hex8). Hourglass control is the stiffness form of Flanagan and
// Belytschko (1981), with two modes of a wedge and one of a pyramid.

#include "kernels/element/hex8/bulk_viscosity.hpp"
#include "kernels/element/hex8/hex8.hpp"
#include "kernels/element/one_point/stable_step.hpp"

namespace percuss {

/// State of one element, or of a pack of them, between steps; stress and history are in the unrotated frame. The
/// members lie like the scalars of a record (OnePointRecord), the first ones like those of a hexahedron.
template <class T, class Material, class Shape>
struct OnePointState {
  T mass;                           // constant
  T viscous_pressure;               // q at n, for the trapezoid of its work
  Polar<T> polar;                   // R and V at n
  Symmetric3<T> stress;             // Cauchy, unrotated, at n
  ModeVectors<T, Shape> hourglass;  // Q at n
  [[no_unique_address]] MaterialHistory<T, Material, 1> history;
};

/// Energy that one step put into the element [energy].
template <class T>
struct OnePointWork {
  T internal, hourglass, viscous;
};

template <class T>
struct OnePointResult {
  OnePointWork<T> work;
  T stable_step;  // bound for the next step, without the deck's scale
  T volume;       // at n+1; not positive: the element is inverted
};

/// The motion over the step on the geometry of its mid-point.
template <class T, class Shape>
struct OnePointMotion {
  T volume;
  Matrix3<T> l;
  Symmetric3<T> de;  // strain increment in the unrotated frame
  T trace_d;
  Matrix3<T> turn;                  // of advance_polar()
  ModeVectors<T, Shape> hourglass;  // rates of the modes without those of the mean gradient: V_h - L X_h
};

template <class T, class Shape>
PERCUSS_FORCE_INLINE OnePointMotion<T, Shape> follow_one_point(const CornerField<T, Shape>& x,
                                                               const CornerField<T, Shape>& v, const T& dt,
                                                               Polar<T>& polar) {
  const T half_dt = T(0.5) * dt;
  CornerField<T, Shape> middle;
  repeat<Shape::corners>([&](auto i) { middle[i] = x[i] - half_dt * v[i]; });
  const CornerGradient<T, Shape> g = find_corner_gradient(middle);
  OnePointMotion<T, Shape> m;
  m.volume = g.volume;
  m.l = find_mean_gradient(v, g);
  const Symmetric3<T> d = symmetric_part(m.l);
  m.trace_d = trace(d);
  const ModeVectors<T, Shape> places = find_modes(middle), rates = find_modes(v);
  repeat<Shape::modes>([&](auto h) { m.hourglass.at[h] = rates.at[h] - m.l * places.at[h]; });
  const Matrix3<T> before = polar.rotation;
  advance_polar(m.l, dt, polar, m.turn);
  m.de = (T(0.25) * dt) * pull_back(before + polar.rotation, d);
  return m;
}

/// kappa of Q_dot = kappa u for modes of unit length, 2 k mu B:B / V with k the `coefficient`: that of the hexahedron,
/// whose modes have the length sqrt(8).
template <class T, class Shape>
PERCUSS_FORCE_INLINE T find_mode_stiffness(const CornerGradient<T, Shape>& g, double mu, double coefficient) {
  T square(0);
  repeat<Shape::corners>([&](auto i) { square = square + dot(g.b[i], g.b[i]); });
  return T(2 * coefficient * mu) * square / g.volume;
}

/// Q from n to n+1, turned with the material and relaxed by the plastic return; returns its work in the step.
template <class Material, class T, class Shape, class Response>
PERCUSS_FORCE_INLINE T advance_modes(const OnePointMotion<T, Shape>& m, const T& kappa, const T& dt,
                                     [[maybe_unused]] const Response& response, ModeVectors<T, Shape>& q) {
  const T half_dt = T(0.5) * dt, rate = half_dt * kappa;
  T work(0);
  repeat<Shape::modes>([&](auto h) {
    const Vector3<T> old = q.at[h];
    q.at[h] = advance_hourglass(m.turn, old, rate * m.hourglass.at[h]);
    if constexpr (Material::can_yield) q.at[h] = response.share * q.at[h];
    work = work + half_dt * dot(old + q.at[h], m.hourglass.at[h]);
  });
  return work;
}

/// Internal forces f_I = P B_I + sum_h gamma_h(I) Q_h (they resist the motion: a node feels their negative). Their
/// power is V P : D + sum_h Q_h . u_h, they and their moments sum to zero.
template <class T, class Shape>
PERCUSS_FORCE_INLINE void find_corner_forces(const Symmetric3<T>& p, const ModeVectors<T, Shape>& q,
                                             const CornerGradient<T, Shape>& g, const HourglassVectors<T, Shape>& gamma,
                                             CornerField<T, Shape>& f) {
  repeat<Shape::corners>([&](auto i) {
    f[i] = p * g.b[i];
    repeat<Shape::modes>([&](auto h) { f[i] = f[i] + gamma.of[h][i] * q.at[h]; });
  });
}

/// lambda + 2 mu at n.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE T find_modulus_at_start(const HexParameters<Material>& par, [[maybe_unused]] const State& state) {
  if constexpr (is_called<Material>)
    return find_longitudinal_modulus<T>(state.history);
  else
    return T(par.lambda + 2 * par.mu);
}

/// Thickness of the element and the viscous pressure in it.
template <class T>
struct OnePointViscosity {
  T length;
  ViscousPressure<T> q;
};

template <class T, class Material, class State>
PERCUSS_FORCE_INLINE OnePointViscosity<T> find_viscosity(const HexParameters<Material>& par, const State& state,
                                                         const GradientSizes<T>& size, const T& volume,
                                                         const T& trace_d) {
  const T density = state.mass / volume, length = find_thickness(size, volume);
  const T speed = square_root(find_modulus_at_start<T>(par, state) / density);
  return {length, find_viscous_pressure(par.viscosity, density, length, speed, trace_d)};
}

/// What the material is told of the step.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE PointMotion<T> tell_one_point(const HexParameters<Material>& par, const Symmetric3<T>& de,
                                                   const T& dt, [[maybe_unused]] const OnePointViscosity<T>& viscous,
                                                   [[maybe_unused]] const T& volume,
                                                   [[maybe_unused]] const State& state) {
  PointMotion<T> point{de, dt, T(1), T(1), T(0), par.time};
  if constexpr (is_called<Material>) {
    point.length = viscous.length;
    point.viscosity = T(0.5) * (state.viscous_pressure + viscous.q.pressure);
    point.volume_ratio = T(par.material.density) * volume / state.mass;
  }
  return point;
}

/// Advances the element from n to n+1. x, v: places at n+1 and velocities at n+1/2. f: out. With dt = 0 it evaluates
/// forces and step only.
template <class T, class Material, class Shape>
PERCUSS_FORCE_INLINE OnePointResult<T> advance_one_point(const HexParameters<Material>& par,
                                                         const CornerField<T, Shape>& x, const CornerField<T, Shape>& v,
                                                         const T& dt, OnePointState<T, Material, Shape>& state,
                                                         CornerField<T, Shape>& f) {
  const Symmetric3<T> stretch_before = state.polar.stretch;
  const OnePointMotion<T, Shape> motion = follow_one_point(x, v, dt, state.polar);
  const CornerGradient<T, Shape> g = find_corner_gradient(x);
  const HourglassVectors<T, Shape> gamma = find_hourglass_vectors(x, g);
  const GradientSizes<T> size = find_gradient_sizes(g, gamma);

  const OnePointViscosity<T> viscous = find_viscosity(par, state, size, g.volume, motion.trace_d);
  PointMotion<T> point = tell_one_point(par, motion.de, dt, viscous, g.volume, state);
  point.change = find_volume_change(stretch_before, state.polar.stretch);
  const Symmetric3<T> old_stress = state.stress;
  NoStressRests<T> no_rest;
  const auto response = update_stress(par.material, state.stress, no_rest, state.history, 0, point);
  const auto moduli = find_moduli(par, response);

  const T kappa = find_mode_stiffness(g, par.mu, par.hourglass);
  const T half_volume = T(0.5) * motion.volume;
  OnePointResult<T> out;
  out.work.hourglass = advance_modes<Material>(motion, kappa, dt, response, state.hourglass);
  out.work.internal = half_volume * contract(old_stress + state.stress, motion.de);
  out.work.viscous = -half_volume * (state.viscous_pressure + viscous.q.pressure) * dt * motion.trace_d;
  state.viscous_pressure = viscous.q.pressure;

  Symmetric3<T> p = push_forward(state.polar.rotation, state.stress);
  p.xx = p.xx - state.viscous_pressure;
  p.yy = p.yy - state.viscous_pressure;
  p.zz = p.zz - state.viscous_pressure;
  find_corner_forces(p, state.hourglass, g, gamma, f);
  out.volume = g.volume;
  out.stable_step =
      find_one_point_step(size, g.volume, state.mass, {T(moduli.lambda), T(moduli.mu), kappa, viscous.q.tangent});
  return out;
}

}  // namespace percuss
