#pragma once
// The one-point tetrahedron over one step: from corner motion to stress, and from stress to corner forces, as pure
// functions.
//
// Place in the step: (1.3) strain rate, (1.4) stress, (1.5) internal force of the paper. Positions are at n+1,
// velocities at n+1/2; rates are taken on the geometry of the mid-point and turned half way, forces act on the geometry
// of n+1, as of the hexahedron (kernels/element/hex8). Between the two functions the mixed form averages over nodes.

#include "kernels/core/work_kinds.hpp"
#include "kernels/element/hex8/bulk_viscosity.hpp"
#include "kernels/element/hex8/hex8.hpp"
#include "kernels/tet/mixing.hpp"

namespace percuss {

/// State of one element, or of a pack of them, between steps; stress and history are in the unrotated frame. The
/// members lie like the scalars of a record (TetRecord), the first ones like those of a hexahedron.
template <class T, class Material>
struct TetState {
  T mass;                // constant
  T viscous_pressure;    // q at n, for the trapezoid of its work
  Polar<T> polar;        // R and V at n
  Symmetric3<T> stress;  // Cauchy, unrotated, at n
  T log_volume;          // integral of the volume rate that the material has seen
  T gap;                 // integral of the element's own volume rate, less that
  T guard;               // pressure of the guard at n
  [[no_unique_address]] MaterialHistory<T, Material, 1> history;
};

/// Energy that one step put into the element [energy].
template <class T>
struct TetWork {
  T internal, viscous, guard;

  /// Calls take(kind, work) for each kind.
  template <class Take>
  KOKKOS_FORCEINLINE_FUNCTION void visit(const Take& take) {
    take(WorkKind::internal, internal);
    take(WorkKind::viscous, viscous);
    take(WorkKind::folding, guard);
  }
};

/// State of an element at n+1, before its forces.
template <class T>
struct TetPoint {
  TetGeometry<T> geometry;
  Symmetric3<T> stress;  // Cauchy, in space axes, without viscosity and guard, in the volume of the element
  TetStiffness<T> own;   // moduli of the material, likewise; tangent of the viscosity
  TetWork<T> work;
};

/// The element's own motion over the step.
template <class T>
struct TetMotion {
  TetGeometry<T> middle;
  Matrix3<T> l;
  Symmetric3<T> d;
};
template <class T>
PERCUSS_FORCE_INLINE TetMotion<T> follow_tet(const TetCorners<T>& x, const TetCorners<T>& v, const T& dt) {
  TetMotion<T> m;
  m.middle = find_tet_geometry(find_middle(x, v, dt));
  m.l = (T(1) / m.middle.volume) * find_volume_times_gradient(v, m.middle);
  m.d = symmetric_part(m.l);
  return m;
}

/// lambda + 2 mu at n.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE T find_modulus_before(const SolidParameters<Material>& par, const State& state) {
  if constexpr (is_called<Material>)
    return find_longitudinal_modulus<T>(state.history);
  else
    return T(par.lambda + 2 * par.mu);
}

/// Elastic moduli at n+1 as K and mu, by lane.
template <class T, class Material, class Response>
PERCUSS_FORCE_INLINE TetStiffness<T> find_tet_moduli(const SolidParameters<Material>& par, const Response& response) {
  const auto moduli = find_moduli(par, response);
  const T shear = T(moduli.mu);
  return {T(moduli.lambda) + T(2.0 / 3.0) * shear, shear, T(0)};
}

/// Advances stress and history from n to n+1. material_rate: the rate of deformation that the material sees, with Mixed
/// one that is averaged, else m.d. Its integral is then the volume of the material, too. With dt = 0 nothing changes.
template <bool Mixed, class T, class Material>
PERCUSS_FORCE_INLINE TetPoint<T> advance_tet4(const SolidParameters<Material>& par, const TetCorners<T>& x,
                                              const TetMotion<T>& m, const Symmetric3<T>& material_rate, const T& dt,
                                              TetState<T, Material>& state) {
  const T half = T(0.5);
  TetPoint<T> out;
  out.geometry = find_tet_geometry(x);
  const Matrix3<T> before = state.polar.rotation;
  const Symmetric3<T> stretch_before = state.polar.stretch;
  Matrix3<T> turn;
  advance_polar(m.l, dt, state.polar, turn);
  const Symmetric3<T> de = (T(0.25) * dt) * pull_back(before + state.polar.rotation, material_rate);

  const T volume = out.geometry.volume, trace_d = trace(m.d), difference = trace_d - trace(material_rate);
  const T density = state.mass / volume, length = volume / square_root(find_largest_square(out.geometry));
  const T speed = square_root(find_modulus_before<T>(par, state) / density);
  const ViscousPressure<T> viscous = find_viscous_pressure(par.viscosity, density, length, speed, trace_d);
  PointMotion<T> point{de, dt, T(1), T(1), T(0), par.time};
  MaterialVolume<T> ratio{T(1), T(1)};
  out.work.guard = T(0);
  const T half_volume = half * m.middle.volume;
  if constexpr (Mixed) {
    state.log_volume = state.log_volume + dt * trace(material_rate);
    ratio = advance_gap(par, dt * difference, half_volume, state, out.work.guard);
  }
  point.change = find_volume_change(ratio, stretch_before, state.polar.stretch);
  if constexpr (is_called<Material>) {
    point.length = length;
    point.viscosity = half * (state.viscous_pressure + viscous.pressure);
    point.volume_ratio = Mixed ? exponential(state.log_volume) : find_volume_ratio(par, state, volume);
  }
  const Symmetric3<T> old_stress = state.stress;
  NoStressRests<T> no_rest;
  const auto response = update_stress(par.material, state.stress, no_rest, state.history, 0, point);
  const TetStiffness<T> own = find_tet_moduli<T>(par, response);
  out.own = {ratio.now * own.bulk, ratio.now * own.shear, viscous.tangent};
  out.stress = ratio.now * push_forward(state.polar.rotation, state.stress);
  out.work.internal = half_volume * contract(ratio.before * old_stress + ratio.now * state.stress, de);
  out.work.viscous = -half_volume * (state.viscous_pressure + viscous.pressure) * dt * trace_d;
  state.viscous_pressure = viscous.pressure;
  return out;
}

/// Internal forces of the corners (they resist the motion: a node feels their negative) by the stress p.
template <class T>
PERCUSS_FORCE_INLINE TetCorners<T> find_tet_forces(const TetGeometry<T>& g, const Symmetric3<T>& p) {
  TetCorners<T> f;
  for (int i = 0; i < 4; ++i) f[i] = p * g.b[i];
  return f;
}

/// The stress whose forces act, with Mixed: own: that of the element, mean: of the nodes' averages, which have none of
/// the guard's pressure; share: of the averaged deviator; pressure: of guard and viscosity, positive in tension.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_mixed_stress(const Symmetric3<T>& own, const Symmetric3<T>& mean,
                                                     const T& share, const T& pressure) {
  return add_to_diagonal(blend(own, mean, share), pressure);
}

/// Stable step of a plain element: each corner has a quarter of its mass.
template <class T>
PERCUSS_FORCE_INLINE T find_plain_step(const TetGeometry<T>& g, const T& mass, const TetStiffness<T>& own) {
  const T weight = T(4) / mass;
  const T weights[4] = {weight, weight, weight, weight};
  const TetFrequency<T> frequency = bound_tet_frequency(g, weights, own);
  return find_stable_step(frequency.square, frequency.damping_rate);
}

/// The moduli that an element feels where stresses are averaged: means, twice averaged, of those of its neighbours, and
/// of the guard's what can act on it. A guard's power is that of tr D less its mean, of which the square is at most
/// twice the sum of both squares.
template <class T>
PERCUSS_FORCE_INLINE TetStiffness<T> mix_moduli(const TetStiffness<T>& own, const TetMeans<T>& means, const T& share,
                                                const T& guard_modulus) {
  return {means.bulk + guard_modulus, (T(1) - share) * own.shear + share * means.shear, own.tangent};
}

/// Bulk modulus of an acting guard, twice, as it counts in the bound.
template <class T>
PERCUSS_FORCE_INLINE T find_guard_modulus(const T& guard, double bulk_modulus) {
  return select(guard < T(0), T(2 * TetGuard::stiffness * bulk_modulus), T(0));
}

/// Stable step with the mass of the nodes shared by |B_I|^2 / V. share: by corner, the mass of its node over the sum of
/// |B|^2 / V there.
template <class T>
PERCUSS_FORCE_INLINE T find_mixed_step(const TetGeometry<T>& g, const T (&share)[4], const TetStiffness<T>& stiffness) {
  T weights[4];
  for (int i = 0; i < 4; ++i) weights[i] = g.volume / (dot(g.b[i], g.b[i]) * share[i]);
  const TetFrequency<T> frequency = bound_tet_frequency(g, weights, stiffness);
  return find_stable_step(frequency.square, frequency.damping_rate);
}

/// Advances an element that averages nothing from n to n+1. x, v: places at n+1 and velocities at n+1/2. f: out. With
/// dt = 0 it evaluates forces and step only.
template <class T, class Material>
PERCUSS_FORCE_INLINE ElementResult<TetWork<T>, T> advance_solid(const SolidParameters<Material>& par,
                                                                const TetCorners<T>& x, const TetCorners<T>& v,
                                                                const T& dt, TetState<T, Material>& state,
                                                                TetCorners<T>& f) {
  const TetMotion<T> own = follow_tet(x, v, dt);
  const TetPoint<T> point = advance_tet4<false>(par, x, own, own.d, dt, state);
  f = find_tet_forces(point.geometry, add_to_diagonal(point.stress, T(0) - state.viscous_pressure));
  return {point.work, find_plain_step(point.geometry, state.mass, point.own), point.geometry.volume};
}

/// Advances stress and history of one that averages. mean: of the nodes' rates.
template <class T, class Material>
PERCUSS_FORCE_INLINE TetPoint<T> advance_mixed(const SolidParameters<Material>& par, const TetCorners<T>& x,
                                               const TetCorners<T>& v, const MeanRate<T>& mean, const T& dt,
                                               TetState<T, Material>& state) {
  const TetMotion<T> own = follow_tet(x, v, dt);
  return advance_tet4<true>(par, x, own, blend(own.d, mean.rate, mean.deviator_share), dt, state);
}
template <class T>
PERCUSS_FORCE_INLINE const TetStiffness<T>& find_stiffness(const TetPoint<T>& point) {
  return point.own;
}

}  // namespace percuss
