#pragma once
// The hexahedron with 2x2x2 points and mean dilatation (B-bar; Hughes, Int. J. Num. Meth. Eng. 15, 1980) over one step.
//
// The volume change is that of the mean gradient everywhere, so that nothing locks as the material becomes
// incompressible. Stress and history belong to points, in one frame, which turns with the mean gradient; elastic stress
// and stretch turn apart from it as their points do. The stress of a point counts for the volume that it had at the
// start times the mean change of volume: then forces are the gradient of an energy, and a body that is stretched far
// keeps its shape (docs/theory.md).

#include "kernels/element/hex8/gauss_points.hpp"
#include "kernels/element/hex8/hex8.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/material/stretch.hpp"

namespace percuss {

/// Whether the volumes of its points at the start count: where stress is elastic, or follows from an energy, so that
/// the material may be stretched far.
template <class Material>
PERCUSS_FORCE_INLINE bool counts_point_volumes([[maybe_unused]] const Material& material) {
  if constexpr (is_called<Material>)
    return material.stores_energy;
  else
    return is_elastic<Material>;
}

/// The volumes of the points at the start, each over an eighth of the element's, less 1.
template <class T, bool Keeps>
struct PointVolumes {
  T excess[8];
  /// 512 times the part of a volume that belongs to point p; counts: by the start, else as it is now.
  PERCUSS_FORCE_INLINE T share(int p, const T& volume, const T& now, bool counts) const {
    return counts ? number<T>(64.0) * volume * (T(1) + excess[p]) : now;
  }
};
template <class T>
struct PointVolumes<T, false> {
  PERCUSS_FORCE_INLINE const T& share(int, const T&, const T& now, bool) const { return now; }
};

/// PointVolumes::excess of an element with corners at `a` at the start.
template <class T>
KOKKOS_INLINE_FUNCTION void find_point_volumes(const VectorModes<T>& a, T (&excess)[8]) {
  const T eighth = T(64) * find_volume_gradient(a).volume;
  for (int p = 0; p < 8; ++p) excess[p] = find_point_geometry(a, find_gauss_point(p)).volume / eighth - T(1);
}

template <class T, class Material>
struct HexState<T, Material, HexKind::full> {
  T mass;                                                                 // constant
  T viscous_pressure;                                                     // q at n, for the trapezoid of its work
  Polar<T> polar;                                                         // R and V of the mean gradient, at n
  Symmetric3<T> stress[8];                                                // Cauchy, unrotated, at n, by point
  [[no_unique_address]] StressRestsOf<T, 8> stress_rest;                  // in float
  [[no_unique_address]] PointVolumes<T, has_own_moduli<Material>> start;  // constant
  [[no_unique_address]] MaterialHistory<T, Material, 8> history;
};

/// `turn` transposed times each mode: a vector field in the unrotated frame.
template <class T>
PERCUSS_FORCE_INLINE VectorModes<T> pull_back(const Matrix3<T>& turn, const VectorModes<T>& a) {
  VectorModes<T> out;
  for (int m = 1; m <= 7; ++m) out[m] = transpose_times(turn, a[m]);
  return out;
}

/// Velocity gradient at a point of the mid-point geometry, turned to the unrotated frame; v: already turned.
template <class T>
PERCUSS_FORCE_INLINE Matrix3<T> find_point_gradient(const PointGeometry<T>& point, const GaussPoint& at,
                                                    const VectorModes<T>& v, const Matrix3<T>& turn) {
  Vector3<T> d[3];
  find_derivatives(v, at, d);
  const T scale = T(1) / point.volume;
  Matrix3<T> l{{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, {T(0), T(0), T(0)}}};
  for (int k = 0; k < 3; ++k) {
    const Vector3<T> g = scale * transpose_times(turn, point.c[k]);
    l.row[0] = l.row[0] + d[k].x * g;
    l.row[1] = l.row[1] + d[k].y * g;
    l.row[2] = l.row[2] + d[k].z * g;
  }
  return l;
}

/// The stress of a point turned with it, and the digits of it that a float does not hold. turn: axial vector, small.
template <class T, class Rest>
PERCUSS_FORCE_INLINE void turn_stress(const Vector3<T>& turn, Symmetric3<T>& stress, [[maybe_unused]] Rest& rest) {
  const Matrix3<T> q = find_turn(T(1), number<T>(0.5) * turn), one_side = q * full(stress);
  const Symmetric3<T> more = number<T>(2.0) * symmetric_part(one_side) + symmetric_product(one_side, q);
  if constexpr (is_short<T>)
    add_to(stress, rest, more);
  else
    stress = stress + more;
}

/// de turned by half of a small turn about w.
template <class T>
PERCUSS_FORCE_INLINE Symmetric3<T> turn_half(const Vector3<T>& w, const Symmetric3<T>& de) {
  return de + symmetric_part(antisymmetric(w) * full(de));
}

/// How a point turns apart from the element's frame, which turns with the mean gradient.
template <class T>
struct FrameTurn {
  Vector3<T> mean_twist;  // twice the spin of the mean gradient
  T half_dt;
  Symmetric3<T> stretch;   // of the mean, half way
  Matrix3<T> flexibility;  // of find_turn_resistance()
  Vector3<T> by_strain;    // of the mean, dt; beside its spin

  /// By strain alone, beside the spin.
  PERCUSS_FORCE_INLINE Vector3<T> find_turn(const Symmetric3<T>& de) const {
    return flexibility * find_turn_drive(de, stretch);
  }
  /// The spin of a point dt, beyond that of the mean gradient.
  PERCUSS_FORCE_INLINE Vector3<T> find_spin(const Matrix3<T>& gradient) const {
    return half_dt * (find_twist(gradient) - mean_twist);
  }
};

/// turn: what takes the unrotated frame half way to space.
template <class T>
PERCUSS_FORCE_INLINE FrameTurn<T> find_frame_turn(const StepMotion<T>& step, const Matrix3<T>& turn, const T& dt) {
  FrameTurn<T> frame;
  frame.mean_twist = find_twist(transpose(turn) * (step.l * turn));
  frame.half_dt = number<T>(0.5) * dt;
  frame.stretch = number<T>(0.25) * pull_back(step.rotations, step.stretch);
  frame.flexibility = inverse(full(find_turn_resistance(frame.stretch)));
  frame.by_strain = frame.find_turn(step.de);
  return frame;
}

/// Tells a material how its point turns apart from the frame; the stress of an elastic one goes along.
template <class Material, class T, class Rest>
PERCUSS_FORCE_INLINE void turn_point(const FrameTurn<T>& frame, const Matrix3<T>& gradient, PointMotion<T>& motion,
                                     Symmetric3<T>& stress, [[maybe_unused]] Rest& rest) {
  const Vector3<T> spin = frame.find_spin(gradient) - frame.by_strain;
  if constexpr (is_called<Material>) {
    motion.is_apart = true;
    motion.spin = spin;
  }
  if constexpr (is_elastic<Material>) {
    const Vector3<T> turn = spin + frame.find_turn(motion.de);
    turn_stress(turn, stress, rest);
    motion.de = turn_half(turn, motion.de);
  }
}

/// Corner forces from the modes of the deviatoric forces in the unrotated frame (512 times) and a uniform pressure.
template <class T>
PERCUSS_FORCE_INLINE void find_full_forces(const VectorModes<T>& modes, const Matrix3<T>& rotation, const T& tension,
                                           const VolumeGradient<T>& b, const CornerForces<T>& out) {
  const T scale = number<T>(1.0 / 64.0) * tension;
  out.x[0] = out.y[0] = out.z[0] = T(0);
  for (int m = 1; m <= 7; ++m) {
    Vector3<T> f = number<T>(1.0 / 512.0) * (rotation * modes[m]);
    if (m <= 6) f = f + scale * b[m];
    out.x[m] = f.x;
    out.y[m] = f.y;
    out.z[m] = f.z;
  }
  finish_forces(out);
}

/// What the points give together. S: double, or T where moduli change.
template <class T, class S>
struct PointSums {
  VectorModes<T> force;  // 512 times the modes of the deviatoric forces, unrotated
  T tension;             // V times the mean stress
  T work;
  T smallest_volume;  // 512 times the smallest det J
  PointMetrics<T> metrics;
  Moduli<S> moduli;  // the largest of a point
};

/// Adds a point with its stress, which counts for a volume (512 times). Keeps: it may differ from that of `point`.
template <bool Keeps, class T, class S>
PERCUSS_FORCE_INLINE void add_point(int p, const Symmetric3<T>& stress, const PointGeometry<T>& point, const T& volume,
                                    PointSums<T, S>& sums) {
  const T mean_stress = number<T>(1.0 / 3.0) * trace(stress);
  const Symmetric3<T> deviator{
      stress.xx - mean_stress, stress.yy - mean_stress, stress.zz - mean_stress, stress.xy, stress.yz, stress.zx};
  if constexpr (Keeps) {
    const T ratio = volume / point.volume;
    add_point_force(ratio * deviator, point, find_gauss_point(p), sums.force);
    sums.metrics.set(p, point, ratio / point.volume);
  } else {
    add_point_force(deviator, point, find_gauss_point(p), sums.force);
    sums.metrics.set(p, point, T(1) / point.volume);
  }
  sums.tension = sums.tension + volume * mean_stress;
  sums.smallest_volume = smaller(sums.smallest_volume, point.volume);
}

template <class T>
PERCUSS_FORCE_INLINE void take_larger(Moduli<T>& largest, const Moduli<T>& moduli) {
  largest = {larger(largest.lambda, moduli.lambda), larger(largest.mu, moduli.mu)};
}

/// Strains, stresses and forces point by point. a, v: modes of positions at n+1 and of velocities at n+1/2, spatial;
/// step, mean: the motion of the element's mean.
template <class T, class Material>
PERCUSS_FORCE_INLINE auto advance_points(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                         const VectorModes<T>& v, const StepMotion<T>& step, const PointMotion<T>& mean,
                                         HexState<T, Material, HexKind::full>& state) {
  const Matrix3<T> turn = number<T>(0.5) * step.rotations;
  const VectorModes<T> rates = pull_back(turn, v), end = pull_back(state.polar.rotation, a);
  const T trace_de = trace(mean.de), end_volume = find_volume_gradient(a).volume;
  const FrameTurn<T> frame = find_frame_turn(step, turn, mean.dt);
  const bool by_start = counts_point_volumes(par.material);
  PointSums<T, std::conditional_t<has_own_moduli<Material>, T, double>> sums;
  sums.moduli = {{}, {}};
  for (int m = 1; m <= 7; ++m) sums.force[m] = {T(0), T(0), T(0)};
  sums.tension = sums.work = T(0);
  sums.smallest_volume = number<T>(beyond_all<T>);
  for (int p = 0; p < 8; ++p) {
    const GaussPoint at = find_gauss_point(p);
    const PointGeometry<T> mid_point = find_point_geometry(step.middle, at);
    const Matrix3<T> gradient = find_point_gradient(mid_point, at, rates, turn);
    Symmetric3<T> de = mean.dt * symmetric_part(gradient);
    const T dilatation = number<T>(1.0 / 3.0) * (trace_de - trace(de));
    de = de + Symmetric3<T>{dilatation, dilatation, dilatation, T(0), T(0), T(0)};
    const Symmetric3<T> old_stress = state.stress[p];
    Symmetric3<T> stress = old_stress;
    PointMotion<T> motion = mean;
    motion.de = de;
    turn_point<Material>(frame, gradient, motion, stress, state.stress_rest[p]);
    const auto response = update_stress(par.material, stress, state.stress_rest[p], state.history, p, motion);
    take_larger(sums.moduli, find_moduli(par, response));
    state.stress[p] = stress;
    sums.work =
        sums.work + state.start.share(p, step.b.volume, mid_point.volume, by_start) * contract(old_stress + stress, de);

    const PointGeometry<T> point = find_point_geometry(end, at);
    const T volume = state.start.share(p, end_volume, point.volume, by_start);
    add_point<keeps_point_volumes<Material, HexKind::full>>(p, stress, point, volume, sums);
  }
  sums.tension = number<T>(1.0 / 512.0) * sums.tension;
  sums.work = number<T>(0.5 / 512.0) * sums.work;
  return sums;
}

/// As advance_hex8 of the one-point elements. HexResult::size is 8 times the smallest of a point: an element that is
/// inverted anywhere has failed.
template <class T, class Material>
PERCUSS_FORCE_INLINE HexResult<T> advance_hex8(const SolidParameters<Material>& par, const VectorModes<T>& a,
                                               const VectorModes<T>& v, const T& dt,
                                               HexState<T, Material, HexKind::full>& state,
                                               const CornerForces<T>& out) {
  const T half = number<T>(0.5);
  const StepMotion<T> step = follow_motion(a, v, dt, state.polar);
  const PointInput<T> input = find_point_input(par, a, state, step, dt);
  auto points = advance_points(par, a, v, step, input.point, state);

  const VolumeGradient<T> b = find_volume_gradient(a);
  const GradientSize<T> size = find_gradient_size(b);
  const T speed = square_root(input.modulus * b.volume / state.mass);
  const ViscousPressure<T> viscous =
      find_viscous_pressure(par.viscosity, state.mass / b.volume, find_thickness(size, b.volume), speed, step.trace_d);
  const T viscous_work = -half * step.b.volume * (state.viscous_pressure + viscous.pressure) * dt * step.trace_d;
  state.viscous_pressure = viscous.pressure;
  find_full_forces(points.force, state.polar.rotation, points.tension / b.volume - viscous.pressure, b, out);

  // 2 mu |dev D|^2 + K (tr D)^2 <= 2 mu |D|^2 + lambda (tr D)^2, as the mean dilatation has the smallest square
  const T frequency_square = T(8) / state.mass *
                             (number<T>(points.moduli.lambda) * size.trace / b.volume +
                              number<T>(2 * points.moduli.mu) * bound_largest_laplacian(points.metrics));
  return {{points.work, T(0), viscous_work},
          find_stable_step(frequency_square, find_damping_rate(size, b.volume, state.mass, viscous.tangent)),
          number<T>(1.0 / 64.0) * points.smallest_volume,
          find_obliqueness(a, size, b.volume)};
}

}  // namespace percuss
