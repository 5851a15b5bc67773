#pragma once
// The hexahedron as a thick shell over one step: several points across the thickness in 2x2 columns, and strains that
// do not lock where the element is thin.
//
// zeta runs across the thickness, from corners 1 to 4 to corners 5 to 8. Strains are those of the element's coordinates
// E_kl = (d_k . v_l + d_l . v_k) / 2 with d_k = dx/dxi_k. Transverse shear is that of the middles of the edges (Dvorkin
// and Bathe 1984), strain across the thickness that of the four corners (Betsch and Stein 1995). In each column a
// further strain is linear in zeta (Buechter, Ramm and Roehl 1994), as large as leaves the stress across the thickness
// without a moment: a correction a step, of which the moment that is left is part of the next (docs/theory.md).

#include "kernels/element/hex8/hex8_full.hpp"
#include "kernels/element/hex8/point_mean.hpp"

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

/// 64 times the strains of the element's coordinates that are assumed, by their share in 1, xi, eta and xi eta.
template <class T>
struct AssumedRates {
  T thickness[4];  // E_33
  T to_xi[2];      // 2 E_13, in 1 and eta
  T to_eta[2];     // 2 E_23, in 1 and xi
};

/// Of the velocities v on the geometry a.
template <class T>
PERCUSS_FORCE_INLINE AssumedRates<T> find_assumed_rates(const VectorModes<T>& a, const VectorModes<T>& v) {
  const auto both = [&](int i, int j) { return dot(a[i], v[j]) + dot(a[j], v[i]); };
  return {{dot(a[3], v[3]) + dot(a[4], v[4]) + dot(a[5], v[5]) + dot(a[7], v[7]), both(3, 5) + both(4, 7),
           both(3, 4) + both(5, 7), both(3, 7) + both(4, 5)},
          {both(1, 3) + both(4, 6), both(1, 4) + both(3, 6)},
          {both(2, 3) + both(5, 6), both(2, 5) + both(3, 6)}};
}

/// What works on them: the transpose, added to 512 times the modes of the forces.
template <class T>
PERCUSS_FORCE_INLINE void add_assumed_forces(const VectorModes<T>& a, const AssumedRates<T>& s, VectorModes<T>& f) {
  const auto both = [&](int i, int j, const T& of) {
    f[i] = f[i] + of * a[j];
    f[j] = f[j] + of * a[i];
  };
  for (const int m : {3, 4, 5, 7}) f[m] = f[m] + s.thickness[0] * a[m];
  both(3, 5, s.thickness[1]);
  both(4, 7, s.thickness[1]);
  both(3, 4, s.thickness[2]);
  both(5, 7, s.thickness[2]);
  both(3, 7, s.thickness[3]);
  both(4, 5, s.thickness[3]);
  both(1, 3, s.to_xi[0]);
  both(4, 6, s.to_xi[0]);
  both(1, 4, s.to_xi[1]);
  both(3, 6, s.to_xi[1]);
  both(2, 3, s.to_eta[0]);
  both(5, 6, s.to_eta[0]);
  both(2, 5, s.to_eta[1]);
  both(3, 6, s.to_eta[1]);
}

/// The points above one another at xi, eta. A field's derivatives there are 1/8 of middle + zeta slope, by xi and eta,
/// and of `across`, by zeta.
template <class T>
struct ColumnField {
  Vector3<T> middle[2], slope[2], across;
  PERCUSS_FORCE_INLINE Vector3<T> get(int k, const T& zeta) const { return middle[k] + zeta * slope[k]; }
};
template <class T>
PERCUSS_FORCE_INLINE ColumnField<T> find_column(const VectorModes<T>& a, const GaussPoint& at) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta);
  return {{a[1] + eta * a[6], a[2] + xi * a[6]},
          {a[5] + eta * a[7], a[4] + xi * a[7]},
          a[3] + eta * a[4] + xi * (a[5] + eta * a[7])};
}

/// Geometry at a point of a column: g[k] = grad xi_k / 8, and 512 det J.
template <class T>
struct LayerGeometry {
  Vector3<T> d[2];  // of the column, by xi and eta
  Vector3<T> g[3];
  T volume;
};
template <class T>
PERCUSS_FORCE_INLINE LayerGeometry<T> find_layer_geometry(const ColumnField<T>& column, const T& zeta) {
  LayerGeometry<T> out{{column.get(0, zeta), column.get(1, zeta)}, {}, T(0)};
  const Vector3<T> c = cross(out.d[1], column.across);
  out.volume = dot(out.d[0], c);
  const T over = T(1) / out.volume;
  out.g[0] = over * c;
  out.g[1] = over * cross(column.across, out.d[0]);
  out.g[2] = over * cross(out.d[0], out.d[1]);
  return out;
}

/// The assumed strains of a column: 64 E_33, 64 E_13 and 64 E_23.
template <class T>
struct ColumnRates {
  T thickness, to_xi, to_eta;
};
template <class T>
PERCUSS_FORCE_INLINE ColumnRates<T> find_column_rates(const AssumedRates<T>& rates, const GaussPoint& at) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta), half = number<T>(0.5);
  return {rates.thickness[0] + xi * rates.thickness[1] + eta * (rates.thickness[2] + xi * rates.thickness[3]),
          half * (rates.to_xi[0] + eta * rates.to_xi[1]), half * (rates.to_eta[0] + xi * rates.to_eta[1])};
}

/// Rate of deformation at a point; w: of the velocities of its column.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> find_layer_rate(const LayerGeometry<T>& at, const ColumnField<T>& w, const T& zeta,
                                                   const ColumnRates<T>& assumed) {
  const Vector3<T> w0 = w.get(0, zeta), w1 = w.get(1, zeta);
  const T e00 = dot(at.d[0], w0), e11 = dot(at.d[1], w1), e01 = number<T>(0.5) * (dot(at.d[0], w1) + dot(at.d[1], w0));
  const Vector3<T> t0 = e00 * at.g[0] + e01 * at.g[1] + assumed.to_xi * at.g[2],
                   t1 = e01 * at.g[0] + e11 * at.g[1] + assumed.to_eta * at.g[2],
                   t2 = assumed.to_xi * at.g[0] + assumed.to_eta * at.g[1] + assumed.thickness * at.g[2];
  const auto sum = [&](auto of, auto other) {
    return of(t0) * other(at.g[0]) + of(t1) * other(at.g[1]) + of(t2) * other(at.g[2]);
  };
  const auto x = [](const Vector3<T>& u) { return u.x; };
  const auto y = [](const Vector3<T>& u) { return u.y; };
  const auto z = [](const Vector3<T>& u) { return u.z; };
  return {sum(x, x), sum(y, y), sum(z, z), sum(x, y), sum(y, z), sum(z, x)};
}

/// What the points of a column work on, 512 times.
template <class T>
struct ColumnForces {
  Vector3<T> middle[2], slope[2];
  T thickness, to_xi, to_eta;
};

/// Adds a stress that counts for so much of a volume, 512 times.
template <class T>
PERCUSS_FORCE_INLINE void add_layer(const Symmetric3<T>& stress, const LayerGeometry<T>& at, const T& zeta,
                                    const T& volume, ColumnForces<T>& f) {
  const Vector3<T> t0 = volume * (stress * at.g[0]), t1 = volume * (stress * at.g[1]), t2 = volume * (stress * at.g[2]);
  const T s01 = dot(at.g[0], t1);
  const Vector3<T> p[2] = {dot(at.g[0], t0) * at.d[0] + s01 * at.d[1], s01 * at.d[0] + dot(at.g[1], t1) * at.d[1]};
  for (int k = 0; k < 2; ++k) {
    f.middle[k] = f.middle[k] + p[k];
    f.slope[k] = f.slope[k] + zeta * p[k];
  }
  f.thickness = f.thickness + dot(at.g[2], t2);
  f.to_xi = f.to_xi + dot(at.g[0], t2);
  f.to_eta = f.to_eta + dot(at.g[1], t2);
}

/// Adds a column: to 512 times the modes of the forces, and to what works on assumed strains.
template <class T>
PERCUSS_FORCE_INLINE void add_column(const ColumnForces<T>& c, const GaussPoint& at, VectorModes<T>& f,
                                     AssumedRates<T>& assumed) {
  const T xi = number<T>(at.xi), eta = number<T>(at.eta);
  f[1] = f[1] + c.middle[0];
  f[2] = f[2] + c.middle[1];
  f[4] = f[4] + c.slope[1];
  f[5] = f[5] + c.slope[0];
  f[6] = f[6] + eta * c.middle[0] + xi * c.middle[1];
  f[7] = f[7] + eta * c.slope[0] + xi * c.slope[1];
  const T by_xi = xi * c.thickness;
  assumed.thickness[0] = assumed.thickness[0] + c.thickness;
  assumed.thickness[1] = assumed.thickness[1] + by_xi;
  assumed.thickness[2] = assumed.thickness[2] + eta * c.thickness;
  assumed.thickness[3] = assumed.thickness[3] + eta * by_xi;
  assumed.to_xi[0] = assumed.to_xi[0] + c.to_xi;
  assumed.to_xi[1] = assumed.to_xi[1] + eta * c.to_xi;
  assumed.to_eta[0] = assumed.to_eta[0] + c.to_eta;
  assumed.to_eta[1] = assumed.to_eta[1] + xi * c.to_eta;
}

template <class T>
PERCUSS_FORCE_INLINE ColumnForces<T> begin_column() {
  const Vector3<T> none{T(0), T(0), T(0)};
  return {{none, none}, {none, none}, T(0), T(0), T(0)};
}

/// Forces of the points of an element, 512 times, while they are added up.
template <class T>
struct ThickForces {
  VectorModes<T> modes;
  AssumedRates<T> assumed;

  PERCUSS_FORCE_INLINE ThickForces() : assumed{{T(0), T(0), T(0), T(0)}, {T(0), T(0)}, {T(0), T(0)}} {
    for (int m = 1; m <= 7; ++m) modes[m] = {T(0), T(0), T(0)};
  }
};

/// How large the gradient of the element is: sums over columns and extremes over points.
///
/// A velocity w3 along zeta strains as sym(w3 x grad zeta), which meets at most lambda + 2 mu. The assumed strain is a
/// mean of those of the corners, with the length of their edges. Each has two nodes of its own, so that the largest sum
/// of a corner bounds the square of the frequency. Where edges across lean against the layers, or layers are oblique,
/// assumed strains exceed it; the factors hold for random shapes (tests/kernels/element/hex8/thick_shell_test.cpp).
/// Strain within layers comes on top.
template <class T>
struct ThickSize {
  T across[4], along;
  T lean;     // largest tan^2 of the angle between an edge across and the normal of its layer
  T oblique;  // largest 1 / sin^2 of the angle between xi and eta

  PERCUSS_FORCE_INLINE ThickSize() : across{T(0), T(0), T(0), T(0)}, along(0), lean(0), oblique(1) {}

  /// weight: of the rule times 512 det J.
  PERCUSS_FORCE_INLINE void take(int column, const LayerGeometry<T>& at, const Vector3<T>& d3, const T& weight) {
    const T normal = dot(at.g[2], at.g[2]);
    across[column] = across[column] + weight * normal * normal;
    along = along + weight * (dot(at.g[0], at.g[0]) + dot(at.g[1], at.g[1]));
    lean = larger(lean, normal * dot(d3, d3) - T(1));
    const T area = at.volume * at.volume * normal;
    oblique = larger(oblique, dot(at.d[0], at.d[0]) * dot(at.d[1], at.d[1]) / area);
  }

  /// Bound of omega^2 of an element with the corners a and these moduli.
  PERCUSS_FORCE_INLINE T bound(const VectorModes<T>& a, const Moduli<T>& moduli, const T& mass) const {
    constexpr double near = 0.5 * (1 + 0.57735026918962576451), far = 1 - near;
    const T nn = number<T>(near * near), nf = number<T>(near * far), ff = number<T>(far * far);
    T largest(0);
    for (int c = 0; c < 4; ++c) {
      const Vector3<T> low = c < 2 ? a[3] - a[4] : a[3] + a[4], turn = c < 2 ? a[5] - a[7] : a[5] + a[7];
      const Vector3<T> edge = c == 1 || c == 2 ? low + turn : low - turn;
      largest = larger(largest, dot(edge, edge) * (nn * across[c] + nf * (across[(c + 1) % 4] + across[(c + 3) % 4]) +
                                                   ff * across[(c + 2) % 4]));
    }
    const T modulus = moduli.lambda + number<T>(2.0) * moduli.mu;
    const T leaning = T(1) + number<T>(lean_factor) * lean;
    const T own = larger(modulus, number<T>(oblique_factor) * moduli.mu * oblique) * leaning;
    // 8 / m times 64 / 512 of the sums of |g|^2, of which a half is of a node
    return (number<T>(0.5) * own * largest + number<T>(0.125) * modulus * oblique * along) / mass;
  }
  static constexpr double lean_factor = 4, oblique_factor = 2.2;
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

/// Stress of a point at n+1.
template <class T, class Material, class State>
PERCUSS_FORCE_INLINE void advance_layer(const SolidParameters<Material>& par, const LayerStep<T>& layer,
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
}

template <int N, class T, class Material, class State>
PERCUSS_FORCE_INLINE void advance_column(const SolidParameters<Material>& par, int c, const ThickMotion<T>& motion,
                                         const Moduli<T>& moduli, State& state, ThickSums<T>& sums) {
  const GaussPoint at = find_gauss_point(c);
  ColumnStep<T, N> column;
  follow_column(motion, at, column);
  const ColumnRelaxation<T> relaxation = relax_column(c, column, moduli, state);
  T moment(0);
  const Vector3<T>& n = column.normal;
  const Symmetric3<T> dyad{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
  const ColumnField<T> end = find_column(motion.end, at);
  ColumnForces<T> force = begin_column<T>();
  for (int l = 0; l < N; ++l) {
    const int p = 4 * l + c;
    const T zeta = number<T>(LayerRule<N>::place[l]), weight = number<T>(LayerRule<N>::weight[l]);
    const Symmetric3<T> before = state.stress[p];
    const T volume = column.at[l].volume;
    advance_layer(par, LayerStep<T>{p, column.de[l] + (zeta * relaxation.strain / volume) * dyad, column.turn}, motion,
                  state, sums);
    sums.work = sums.work + weight * motion.volume_scale * volume * contract(before + state.stress[p], column.de[l]);
    if constexpr (Material::can_yield) moment = moment + weight * zeta * dot(n, state.stress[p] * n);
    const LayerGeometry<T> now = find_layer_geometry(end, zeta);
    add_layer(state.stress[p], now, zeta, weight * now.volume, force);
    sums.size.take(c, now, end.across, weight * now.volume);
    sums.smallest_volume = smaller(sums.smallest_volume, now.volume);
  }
  keep_flow(c, relaxation, moment, state);
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
  ThickSums<T> sums;
  for (int c = 0; c < 4; ++c) advance_column<layers_of<Kind>>(par, c, motion, moduli, state, sums);
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
