#pragma once
// The hexahedron as a thick shell over one step: several points across the thickness in 2x2 columns, and strains that
// do not lock where the element is thin.
//
// In each column a further strain is linear in zeta (Buechter, Ramm and Roehl 1994), as large as leaves the stress
// across the thickness without a moment: a correction a step, of which the moment that is left is part of the next
// (docs/theory.md).

#include "kernels/element/hex8/hex8_full.hpp"
#include "kernels/element/hex8/point_mean.hpp"
#include "kernels/element/hex8/thick_flow.hpp"
#include "kernels/element/hex8/thick_size.hpp"

namespace percuss {

/// Volumes of the points over those at the start, over the same of the element, less 1.
template <class T, int Points, bool Keeps>
struct VolumeRatios {
  static constexpr bool keeps = true;
  T excess[Points];
};
template <class T, int Points>
struct VolumeRatios<T, Points, false> {
  static constexpr bool keeps = false;
};

/// What a column of a law that yields needs beyond an elastic one: the part of the moment across that elastic moduli
/// did not foresee in the last step, over that which they foresaw.
template <class T, bool Yields>
struct ThicknessFlow {
  static constexpr bool keeps = true;
  T share[4];
};
template <class T>
struct ThicknessFlow<T, false> {
  static constexpr bool keeps = false;
};

template <class T, class Material, HexKind Kind>
requires(is_thick<Kind>) struct HexState<T, Material, Kind> {
  static constexpr int points = 4 * layers_of<Kind>;
  T mass;                                                      // constant
  T viscous_pressure;                                          // q at n
  Polar<T> polar;                                              // R and V of the mean gradient, at n
  Symmetric3<T> stress[points];                                // Cauchy, unrotated, at n: 4 l + column
  [[no_unique_address]] StressRestsOf<T, points> stress_rest;  // in float
  [[no_unique_address]] VolumeRatios<T, points, has_own_moduli<Material>> volume;  // at n
  [[no_unique_address]] ThicknessFlow<T, Material::can_yield> flow;                // at n
  [[no_unique_address]] MaterialHistory<T, Material, points> history;
};

/// Where assumed strains leave it to a column: its strain that is linear in zeta.
template <class T, int N>
struct ColumnStep {
  LayerGeometry<T> at[N];  // at n+1/2
  Symmetric3<T> de[N];     // of the nodes
  Vector3<T> normal;       // of the middle layer
  Vector3<T> turn;         // beyond that of the mean, axial vector
};

/// How far a point has changed its volume beyond the element's mean, and what its material gets.
template <class T, class Ratios>
PERCUSS_FORCE_INLINE void set_material_volume(int p, const T& excess_de, Ratios& ratios, PointMotion<T>& motion) {
  if constexpr (Ratios::keeps) {
    const T before = T(1) + ratios.excess[p];
    ratios.excess[p] = ratios.excess[p] + before * excess_de / (T(1) - number<T>(0.5) * excess_de);
    const T after = T(1) + ratios.excess[p], mean_before = T(1) / motion.change.inverse - motion.change.growth;
    motion.volume_ratio = motion.volume_ratio * after;
    motion.change.growth = motion.change.growth * after + mean_before * (after - before);
    motion.change.inverse = motion.change.inverse / after;
  }
}

/// The motion of an element as its columns see it, in the unrotated frame. The mean of two rotations is none: rates
/// that it takes to the frame on both sides, as those of the mean, are those of places that its inverse takes there.
template <class T>
struct ThickMotion {
  VectorModes<T> middle, rates, end;
  T volume_scale;  // of places at n+1/2
  AssumedRates<T> assumed;
  FrameTurn<T> frame;
  const PointMotion<T>& mean;
};

template <class T>
PERCUSS_FORCE_INLINE ThickMotion<T> find_thick_motion(const VectorModes<T>& a, const VectorModes<T>& v,
                                                      const StepMotion<T>& step, const Polar<T>& polar,
                                                      const PointMotion<T>& mean) {
  const Matrix3<T> turn = number<T>(0.5) * step.rotations;
  const Matrix3<T> back = inverse(turn);
  ThickMotion<T> out{{},
                     pull_back(turn, v),
                     pull_back(polar.rotation, a),
                     determinant(turn),
                     {},
                     find_frame_turn(step, turn, mean.dt),
                     mean};
  for (int m = 1; m <= 7; ++m) out.middle[m] = back * step.middle[m];
  out.assumed = find_assumed_rates(out.middle, out.rates);
  return out;
}

template <int N, class T>
PERCUSS_FORCE_INLINE void follow_column(const ThickMotion<T>& motion, const GaussPoint& at, ColumnStep<T, N>& column) {
  const ColumnField<T> x = find_column(motion.middle, at), w = find_column(motion.rates, at);
  const ColumnRates<T> assumed = find_column_rates(motion.assumed, at);
  for (int l = 0; l < N; ++l) {
    const T zeta = number<T>(LayerRule<N>::place[l]);
    column.at[l] = find_layer_geometry(x, zeta);
    column.de[l] = motion.mean.dt * find_layer_rate(column.at[l], w, zeta, assumed);
  }
  const LayerGeometry<T>& middle = column.at[N / 2];
  column.normal = (T(1) / norm(middle.g[2])) * middle.g[2];
  const Vector3<T> twist =
      cross(middle.g[0], w.middle[0]) + cross(middle.g[1], w.middle[1]) + cross(middle.g[2], w.across);
  column.turn = motion.frame.half_dt * (twist - motion.frame.mean_twist) - motion.frame.by_strain;
}

/// The strain across of a column and what it answers to: moments of the stress across the thickness.
template <class T>
struct ColumnRelaxation {
  T held;       // at n
  T grown;      // what the strains of the step add to elastic moduli
  T stiffness;  // of the strain across
  T strain;     // linear in zeta, times 512 det J
};

/// The strain by which the moment vanishes: that of n, and what the step adds with what it lacked in the last step. A
/// column at rest is left as it is.
template <int N, class T, class State>
PERCUSS_FORCE_INLINE ColumnRelaxation<T> relax_column(int c, const ColumnStep<T, N>& column, const Moduli<T>& moduli,
                                                      const State& state) {
  const Vector3<T>& n = column.normal;
  ColumnRelaxation<T> out{T(0), T(0), T(0), T(0)};
  T motion(0);
  for (int l = 0; l < N; ++l) {
    const double place = LayerRule<N>::place[l], weight = LayerRule<N>::weight[l];
    const T share = number<T>(weight * place);
    out.held = out.held + share * dot(n, state.stress[4 * l + c] * n);
    out.grown = out.grown +
                share * (moduli.lambda * trace(column.de[l]) + number<T>(2.0) * moduli.mu * dot(n, column.de[l] * n));
    out.stiffness = out.stiffness + number<T>(weight * place * place) / column.at[l].volume;
    motion = motion + contract(column.de[l], column.de[l]);
  }
  out.stiffness = (moduli.lambda + number<T>(2.0) * moduli.mu) * out.stiffness;
  T more = out.grown;
  if constexpr (decltype(state.flow)::keeps) more = more + state.flow.share[c] * out.grown;
  out.strain = (T(0) - (select(motion > T(0), out.held, T(0)) + more)) / out.stiffness;
  return out;
}

/// Flow without change of volume asks for (lambda + 2 mu) / lambda times the elastic strain across, 2.3 at a Poisson's
/// ratio of 0.3; more beyond it than this is not taken for flow.
inline constexpr double largest_flow_share = 3;

/// Keeps what the column of a law that yields lacked. moment: of the stress at n+1.
template <class T, class State>
PERCUSS_FORCE_INLINE void keep_flow([[maybe_unused]] int c, [[maybe_unused]] const ColumnRelaxation<T>& column,
                                    [[maybe_unused]] const T& moment, [[maybe_unused]] State& state) {
  if constexpr (decltype(state.flow)::keeps) {
    const T lacked = moment - column.held - column.grown - column.stiffness * column.strain;
    const T square = larger(column.grown * column.grown, number<T>(next_to_nothing<T>));
    const T share = larger(smaller(lacked * column.grown / square, number<T>(largest_flow_share)), T(0));
    state.flow.share[c] = select(column.grown == T(0), state.flow.share[c], share);
  }
}

/// Moduli that the next strain across is found with: of a called material as stiff as its stiffest point at n.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE Moduli<T> find_relaxing_moduli(const SolidParameters<Material>& par, const T& modulus,
                                                    const State& /*state*/) {
  const T scale = modulus * number<T>(1 / (par.lambda + 2 * par.mu));
  return {number<T>(par.lambda) * scale, number<T>(par.mu) * scale};
}

/// What the columns give together.
template <class T>
struct ThickSums {
  ThickForces<T> force;
  ThickSize<T> size;
  T work = T(0), smallest_volume = number<T>(beyond_all<T>);
  Moduli<T> moduli{T(0), T(0)};
};

/// The strain of point p, and what its column turns.
template <class T>
struct LayerStep {
  int p;
  Symmetric3<T> de;
  const Vector3<T>& turn;
};

/// Stress of a point at n+1. Returns PlasticReturn::share.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE T advance_layer(const SolidParameters<Material>& par, const LayerStep<T>& layer,
                                     const ThickMotion<T>& motion, State& state, ThickSums<T>& sums) {
  const int p = layer.p;
  const Symmetric3<T>& de = layer.de;
  PointMotion<T> point = motion.mean;
  point.de = de;
  set_material_volume(p, trace(de) - trace(motion.mean.de), state.volume, point);
  if constexpr (is_called<Material>) {
    point.is_apart = true;
    point.spin = layer.turn;
  }
  const Vector3<T> whole = layer.turn + motion.frame.find_turn(de);
  turn_stress(whole, state.stress[p], state.stress_rest[p]);
  if constexpr (!is_called<Material>) point.de = turn_half(whole, de);
  const auto response = update_stress(par.material, state.stress[p], state.stress_rest[p], state.history, p, point);
  const auto moduli = find_moduli(par, response);
  take_larger(sums.moduli, {number<T>(moduli.lambda), number<T>(moduli.mu)});
  if constexpr (Material::can_yield)
    return response.share;
  else
    return T(1);
}

/// Stresses of a column at n+1.
template <int N, class T, class Material, class State>
PERCUSS_FORCE_INLINE ColumnFlow<T> advance_column(const SolidParameters<Material>& par, int c,
                                                  const ThickMotion<T>& motion, const Moduli<T>& moduli, State& state,
                                                  ThickSums<T>& sums) {
  ColumnStep<T, N> column;
  follow_column(motion, find_gauss_point(c), column);
  const ColumnRelaxation<T> relaxation = relax_column(c, column, moduli, state);
  T moment(0);
  const Vector3<T>& n = column.normal;
  const Symmetric3<T> dyad{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  ColumnFlow<T> flow;
  flow.volume = column.at[N / 2].volume;
  for (int l = 0; l < N; ++l) {
    const int p = 4 * l + c;
    const T zeta = number<T>(LayerRule<N>::place[l]), weight = number<T>(LayerRule<N>::weight[l]);
    const Symmetric3<T> before = state.stress[p];
    const T volume = column.at[l].volume;
    const Symmetric3<T> de = column.de[l] + (zeta * relaxation.strain / volume) * dyad;
    const T share = advance_layer(par, LayerStep<T>{p, de, column.turn}, motion, state, sums);
    sums.work = sums.work + weight * motion.volume_scale * volume * contract(before + state.stress[p], column.de[l]);
    if constexpr (Material::can_yield) {
      moment = moment + weight * zeta * dot(n, state.stress[p] * n);
      flow.take(weight, before, state.stress[p], motion.volume_scale * volume * trace(column.de[l]), share);
    }
  }
  keep_flow(c, relaxation, moment, state);
  return flow;
}

/// Forces of the stresses of a column at n+1, and how large its gradients are.
template <int N, class T, class State>
PERCUSS_FORCE_INLINE void push_column(int c, const ThickMotion<T>& motion, const State& state, ThickSums<T>& sums) {
  const GaussPoint at = find_gauss_point(c);
  const ColumnField<T> end = find_column(motion.end, at);
  ColumnForces<T> force = begin_column<T>();
  for (int l = 0; l < N; ++l) {
    const T zeta = number<T>(LayerRule<N>::place[l]), weight = number<T>(LayerRule<N>::weight[l]);
    const LayerGeometry<T> now = find_layer_geometry(end, zeta);
    add_layer(state.stress[4 * l + c], now, zeta, weight * now.volume, force);
    sums.size.take(c, now, end.across, weight * now.volume);
    sums.smallest_volume = smaller(sums.smallest_volume, now.volume);
  }
  add_column(force, at, sums.force.modes, sums.force.assumed);
}

/// As advance_hex8 of 2x2x2 points. Work is that of the nodes: what the further strain takes meets no stress but that
/// which the correction of the next step removes.
template <class T, class Material, HexKind Kind>
requires(is_thick<Kind>) PERCUSS_FORCE_INLINE HexResult<T> advance_hex8(const SolidParameters<Material>& par,
                                                                        const VectorModes<T>& a,
                                                                        const VectorModes<T>& v, const T& dt,
                                                                        HexState<T, Material, Kind>& state,
                                                                        const CornerForces<T>& out) {
  const StepMotion<T> step = follow_motion(a, v, dt, state.polar);
  const PointInput<T> input = find_point_input(par, a, state, step, dt);
  const ThickMotion<T> motion = find_thick_motion(a, v, step, state.polar, input.point);
  const Moduli<T> moduli = find_relaxing_moduli(par, input.modulus, state);
  constexpr int layers = layers_of<Kind>;
  ThickSums<T> sums;
  ColumnFlow<T> flow[4];
  for (int c = 0; c < 4; ++c) flow[c] = advance_column<layers>(par, c, motion, moduli, state, sums);
  if constexpr (Material::can_yield) sums.work = sums.work + join_columns<layers>(par, flow, state);
  for (int c = 0; c < 4; ++c) push_column<layers>(c, motion, state, sums);
  add_assumed_forces(motion.end, sums.force.assumed, sums.force.modes);

  const VolumeGradient<T> b = find_volume_gradient(a);
  const GradientSize<T> size = find_gradient_size(b);
  const T speed = square_root(input.modulus * b.volume / state.mass);
  const ViscousPressure<T> viscous =
      find_viscous_pressure(par.viscosity, state.mass / b.volume, find_thickness(size, b.volume), speed, step.trace_d);
  const T viscous_work =
      number<T>(-0.5) * step.b.volume * (state.viscous_pressure + viscous.pressure) * dt * step.trace_d;
  state.viscous_pressure = viscous.pressure;
  find_full_forces(sums.force.modes, state.polar.rotation, T(0) - viscous.pressure, b, out);
  return {{number<T>(0.5 / 512.0) * sums.work, T(0), viscous_work},
          find_stable_step(sums.size.bound(a, sums.moduli, state.mass),
                           find_damping_rate(size, b.volume, state.mass, viscous.tangent)),
          number<T>(1.0 / 64.0) * sums.smallest_volume,
          find_obliqueness(a, size, b.volume)};
}

/// Modes of the forces, 512 times, of an elastic element in the rates u on the geometry a, without the further strain
/// across, which only softens it.
template <int N, class T>
PERCUSS_FORCE_INLINE VectorModes<T> probe_columns(const Moduli<T>& moduli, const VectorModes<T>& a,
                                                  const VectorModes<T>& u) {
  const AssumedRates<T> assumed = find_assumed_rates(a, u);
  ThickForces<T> sums;
  for (int c = 0; c < 4; ++c) {
    const GaussPoint at = find_gauss_point(c);
    const ColumnField<T> x = find_column(a, at), w = find_column(u, at);
    const ColumnRates<T> rates = find_column_rates(assumed, at);
    ColumnForces<T> force = begin_column<T>();
    for (int l = 0; l < N; ++l) {
      const T zeta = number<T>(LayerRule<N>::place[l]);
      const LayerGeometry<T> layer = find_layer_geometry(x, zeta);
      const Symmetric3<T> d = find_layer_rate(layer, w, zeta, rates);
      const T pressure = moduli.lambda * trace(d);
      const Symmetric3<T> t =
          number<T>(2.0) * moduli.mu * d + Symmetric3<T>{pressure, pressure, pressure, T(0), T(0), T(0)};
      add_layer(t, layer, zeta, number<T>(LayerRule<N>::weight[l]) * layer.volume, force);
    }
    add_column(force, at, sums.modes, sums.assumed);
  }
  add_assumed_forces(a, sums.assumed, sums.modes);
  return sums.modes;
}

}  // namespace percuss
