#pragma once
// The one-point wedge or pyramid over one step: from corner motion to stress, and from stress to corner forces, as pure
// functions. Between the two the mixed form averages over nodes (kernels/tet/mixing.hpp).
//
// Place in the step: (1.3) strain rate, (1.4) stress, (1.5) internal force of the paper. Positions are at n+1,
// velocities at n+1/2; rates are taken on the geometry of the mid-point and turned half way, forces act on the geometry
// of n+1, as of the hexahedron (kernels/element/hex8). Hourglass control is the stiffness form of Flanagan and
// Belytschko (1981), with two modes of a wedge and one of a pyramid.

#include "kernels/core/work_kinds.hpp"
#include "kernels/element/hex8/bulk_viscosity.hpp"
#include "kernels/element/hex8/hex8.hpp"
#include "kernels/one_point/stable_step.hpp"
#include "kernels/tet/mixing.hpp"

namespace percuss {

/// State of one element, or of a pack of them, between steps; stress and history are in the unrotated frame. The
/// members lie like the scalars of a record (OnePointRecord), the first ones like those of a hexahedron.
template <class T, class Material, class Shape>
struct OnePointState {
  T mass;                           // constant
  T viscous_pressure;               // q at n, for the trapezoid of its work
  Polar<T> polar;                   // R and V at n
  Symmetric3<T> stress;             // Cauchy, unrotated, at n
  T log_volume, gap, guard;         // of the mixed form, as of a tetrahedron (TetState)
  ModeVectors<T, Shape> hourglass;  // Q at n
  [[no_unique_address]] MaterialHistory<T, Material, 1> history;
};

/// Energy that one step put into the element [energy].
template <class T>
struct OnePointWork {
  T internal, hourglass, viscous, guard;

  /// Calls take(kind, work) for each kind.
  template <class Take>
  KOKKOS_FORCEINLINE_FUNCTION void visit(const Take& take) {
    take(WorkKind::internal, internal);
    take(WorkKind::hourglass, hourglass);
    take(WorkKind::viscous, viscous);
    take(WorkKind::folding, guard);
  }
};

/// The element's own motion over the step on the geometry of its mid-point.
template <class T, class Shape>
struct OnePointMotion {
  T volume;
  Matrix3<T> l;
  Symmetric3<T> d;
  ModeVectors<T, Shape> hourglass;  // rates of the modes without those of the mean gradient: V_h - L X_h
};

template <class T, class Shape>
PERCUSS_FORCE_INLINE OnePointMotion<T, Shape> follow_one_point(const CornerField<T, Shape>& x,
                                                               const CornerField<T, Shape>& v, const T& dt) {
  const CornerField<T, Shape> middle = find_middle(x, v, dt);
  const CornerGradient<T, Shape> g = find_corner_gradient(middle);
  OnePointMotion<T, Shape> m;
  m.volume = g.volume;
  m.l = find_mean_gradient(v, g);
  m.d = symmetric_part(m.l);
  const ModeVectors<T, Shape> places = find_modes(middle), rates = find_modes(v);
  repeat<Shape::modes>([&](auto h) { m.hourglass.at[h] = rates.at[h] - m.l * places.at[h]; });
  return m;
}

/// kappa of Q_dot = kappa u for modes of unit length, 2 k mu B:B / V with k the `coefficient`: that of the hexahedron,
/// whose modes have the length sqrt(8).
template <class T, class Shape>
PERCUSS_FORCE_INLINE T find_mode_stiffness(const CornerGradient<T, Shape>& g, const T& mu, double coefficient) {
  T square(0);
  repeat<Shape::corners>([&](auto i) { square = square + dot(g.b[i], g.b[i]); });
  return T(2 * coefficient) * mu * square / g.volume;
}

/// Q from n to n+1, turned with the material and relaxed by the plastic return; returns its work in the step.
template <class Material, class T, class Shape, class Response>
PERCUSS_FORCE_INLINE T advance_modes(const OnePointMotion<T, Shape>& m, const Matrix3<T>& turn, const T& kappa,
                                     const T& dt, [[maybe_unused]] const Response& response, ModeVectors<T, Shape>& q) {
  const T half_dt = T(0.5) * dt, rate = half_dt * kappa;
  T work(0);
  repeat<Shape::modes>([&](auto h) {
    const Vector3<T> old = q.at[h];
    q.at[h] = advance_hourglass(turn, old, rate * m.hourglass.at[h]);
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
PERCUSS_FORCE_INLINE T find_modulus_at_start(const SolidParameters<Material>& par,
                                             [[maybe_unused]] const State& state) {
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
PERCUSS_FORCE_INLINE OnePointViscosity<T> find_viscosity(const SolidParameters<Material>& par, const State& state,
                                                         const GradientSizes<T>& size, const T& volume,
                                                         const T& trace_d) {
  const T density = state.mass / volume, length = find_thickness(size, volume);
  const T speed = square_root(find_modulus_at_start<T>(par, state) / density);
  return {length, find_viscous_pressure(par.viscosity, density, length, speed, trace_d)};
}

/// Motion of the material point in the step.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE PointMotion<T> make_point_motion(const SolidParameters<Material>& par, const Symmetric3<T>& de,
                                                      const T& dt, [[maybe_unused]] const OnePointViscosity<T>& viscous,
                                                      [[maybe_unused]] const T& volume,
                                                      [[maybe_unused]] const State& state) {
  PointMotion<T> point{de, dt, T(1), T(1), T(0), par.time};
  if constexpr (is_called<Material>) {
    point.length = viscous.length;
    point.viscosity = T(0.5) * (state.viscous_pressure + viscous.q.pressure);
    point.volume_ratio = find_volume_ratio(par, state, volume);
  }
  return point;
}

/// State of an element at n+1, before its forces.
template <class T, class Shape>
struct OnePointPoint {
  CornerGradient<T, Shape> geometry;
  HourglassVectors<T, Shape> gamma;
  GradientSizes<T> size;
  Symmetric3<T> stress;      // Cauchy, in space axes, without viscosity and guard, in the volume of the element
  OnePointStiffness<T> own;  // of the material, likewise
  OnePointWork<T> work;
};

/// Advances stress, hourglass forces and history from n to n+1. material_rate: the rate of deformation that the
/// material sees, with Mixed one that is averaged, else m.d. Its integral is then the volume of the material, too. With
/// dt = 0 nothing changes.
template <bool Mixed, class T, class Material, class Shape>
PERCUSS_FORCE_INLINE OnePointPoint<T, Shape> advance_point(const SolidParameters<Material>& par,
                                                           const CornerField<T, Shape>& x,
                                                           const OnePointMotion<T, Shape>& m,
                                                           const Symmetric3<T>& material_rate, const T& dt,
                                                           OnePointState<T, Material, Shape>& state) {
  const Matrix3<T> before = state.polar.rotation;
  const Symmetric3<T> stretch_before = state.polar.stretch;
  Matrix3<T> turn;
  advance_polar(m.l, dt, state.polar, turn);
  const Symmetric3<T> de = (T(0.25) * dt) * pull_back(before + state.polar.rotation, material_rate);
  OnePointPoint<T, Shape> out;
  out.geometry = find_corner_gradient(x);
  out.gamma = find_hourglass_vectors(x, out.geometry);
  out.size = find_gradient_sizes(out.geometry, out.gamma);

  const T trace_d = trace(m.d);
  const OnePointViscosity<T> viscous = find_viscosity(par, state, out.size, out.geometry.volume, trace_d);
  PointMotion<T> point = make_point_motion(par, de, dt, viscous, out.geometry.volume, state);
  MaterialVolume<T> ratio{T(1), T(1)};
  out.work.guard = T(0);
  if constexpr (Mixed) {
    state.log_volume = state.log_volume + dt * trace(material_rate);
    ratio = advance_gap(par, dt * (trace_d - trace(material_rate)), T(0.5) * m.volume, state, out.work.guard);
  }
  point.change = find_volume_change(ratio, stretch_before, state.polar.stretch);
  if constexpr (Mixed && is_called<Material>) point.volume_ratio = exponential(state.log_volume);
  const Symmetric3<T> old_stress = state.stress;
  NoStressRests<T> no_rest;
  const auto response = update_stress(par.material, state.stress, no_rest, state.history, 0, point);
  const auto moduli = find_moduli(par, response);

  const T half_volume = T(0.5) * m.volume;
  const T shear = larger(T(par.mu), T(moduli.mu));  // the modulus of rubber grows with the stretch
  const T kappa = find_mode_stiffness(out.geometry, shear, par.hourglass);
  out.work.hourglass = advance_modes<Material>(m, turn, kappa, dt, response, state.hourglass);
  out.work.internal = half_volume * contract(ratio.before * old_stress + ratio.now * state.stress, de);
  out.work.viscous = -half_volume * (state.viscous_pressure + viscous.q.pressure) * dt * trace_d;
  state.viscous_pressure = viscous.q.pressure;
  out.stress = ratio.now * push_forward(state.polar.rotation, state.stress);
  out.own = {ratio.now * T(moduli.lambda), ratio.now * T(moduli.mu), kappa, viscous.q.tangent};
  return out;
}

/// Advances an element that averages nothing from n to n+1. x, v: places at n+1 and velocities at n+1/2. f: out. With
/// dt = 0 it evaluates forces and step only.
template <class T, class Material, class Shape>
PERCUSS_FORCE_INLINE ElementResult<OnePointWork<T>, T> advance_solid(const SolidParameters<Material>& par,
                                                                     const CornerField<T, Shape>& x,
                                                                     const CornerField<T, Shape>& v, const T& dt,
                                                                     OnePointState<T, Material, Shape>& state,
                                                                     CornerField<T, Shape>& f) {
  const OnePointMotion<T, Shape> motion = follow_one_point(x, v, dt);
  const OnePointPoint<T, Shape> point = advance_point<false>(par, x, motion, motion.d, dt, state);
  find_corner_forces(add_to_diagonal(point.stress, T(0) - state.viscous_pressure), state.hourglass, point.geometry,
                     point.gamma, f);
  return {point.work, find_one_point_step(point.size, point.geometry.volume, state.mass, point.own),
          point.geometry.volume};
}

/// Advances stress, hourglass forces and history of one that averages. mean: of the nodes' rates.
template <class T, class Material, class Shape>
PERCUSS_FORCE_INLINE OnePointPoint<T, Shape> advance_mixed(const SolidParameters<Material>& par,
                                                           const CornerField<T, Shape>& x,
                                                           const CornerField<T, Shape>& v, const MeanRate<T>& mean,
                                                           const T& dt, OnePointState<T, Material, Shape>& state) {
  const OnePointMotion<T, Shape> own = follow_one_point(x, v, dt);
  return advance_point<true>(par, x, own, blend(own.d, mean.rate, mean.deviator_share), dt, state);
}
template <class T, class Shape>
PERCUSS_FORCE_INLINE TetStiffness<T> find_stiffness(const OnePointPoint<T, Shape>& point) {
  return {point.own.lambda + T(2.0 / 3.0) * point.own.mu, point.own.mu, point.own.tangent};
}

}  // namespace percuss
