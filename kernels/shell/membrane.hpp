#pragma once
// A membrane over one step: a shell without bending, transverse shear, rotations and moments, as a pure function.
//
// Geometry, layers and the hourglass modes in the plane are those of shells (shell4.hpp), with one point across a
// layer. What a shell holds flat by bending only tension holds here: the mean strain of the warped surface x = z xi eta
// has a part z^2 (xi_x^2 + eta_x^2) / 6 (Green's strain of a bilinear surface), whose rate and transpose are taken, so
// that tension resists the warp of an element exactly as it does that of the surface. Formulas: docs/theory_shells.md.

#include <array>

#include "kernels/shell/fabric.hpp"
#include "kernels/shell/shell4.hpp"

namespace percuss {

/// Rates of a membrane; all of ShellRates that bends is 0.
template <class T>
struct MembraneRates {
  ShellRates<T> shell;
  T warp;  // of the heights of the corners, z
};

/// Mean strains xx, yy, 2 xy of the surface for each unit of z dz.
template <class T>
struct WarpStrains {
  T of[3];
};

template <class T>
PERCUSS_FORCE_INLINE WarpStrains<T> find_warp_strains(const ShellGeometry<T>& g) {
  const T third = T(1.0 / 3.0) * g.z;
  return {{third * (g.xi_x * g.xi_x + g.eta_x * g.eta_x), third * (g.xi_y * g.xi_y + g.eta_y * g.eta_y),
           T(2) * third * (g.xi_x * g.xi_y + g.eta_x * g.eta_y)}};
}

/// Rates from the differences of the velocity in the element's frame, of a surface that stretches as it warps.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE MembraneRates<T> find_membrane_rates(const ShellGeometry<T>& g,
                                                          const ShellDifferences<T>& velocity, const Shapes& shapes) {
  const T none(0);
  const Vector3<T> still[4] = {{none, none, none}, {none, none, none}, {none, none, none}, {none, none, none}};
  const ShellRates<T> all = find_shell_rates(g, velocity, still, shapes);
  const T z_x = g.b1[0] * velocity.r.z + g.b1[1] * velocity.s.z, z_y = g.b2[0] * velocity.r.z + g.b2[1] * velocity.s.z;
  MembraneRates<T> rate{{}, T(0.25) * (velocity.h.z - g.hx * z_x - g.hy * z_y)};
  const WarpStrains<T> strain = find_warp_strains(g);
  for (int k = 0; k < 3; ++k) {
    rate.shell.membrane[k] = all.membrane[k] + strain.of[k] * rate.warp;
    rate.shell.curvature[k] = none;
  }
  for (int k = 0; k < 2; ++k) {
    rate.shell.membrane_hourglass[k] = all.membrane_hourglass[k];
    rate.shell.shear[k] = rate.shell.bending_hourglass[k] = rate.shell.shear_hourglass[k] = none;
    rate.shell.corner_drilling[k] = none;
  }
  rate.shell.drilling = none;
  return rate;
}

/// Corner forces in space axes, the transpose of these rates. on: what does work on them; only the membrane's.
template <class T>
PERCUSS_FORCE_INLINE void find_membrane_forces(const ShellGeometry<T>& g, const ShellRates<T>& on,
                                               const CornerLoads<T>& out) {
  const WarpStrains<T> strain = find_warp_strains(g);
  const T none(0);
  T on_warp = none;
  for (int k = 0; k < 3; ++k) on_warp = on_warp + strain.of[k] * on.membrane[k];
  ShellCornerField<T> f, m;
  set_gradient_forces(g, on.membrane[0], on.membrane[2], on.membrane_hourglass[0], f.x);
  set_gradient_forces(g, on.membrane[2], on.membrane[1], on.membrane_hourglass[1], f.y);
  set_gradient_forces(g, none, none, on_warp, f.z);
  for (int i = 0; i < 4; ++i) m.x[i] = m.y[i] = m.z[i] = none;
  balance_moments(g, f, m);
  for (int i = 0; i < 4; ++i) {
    out.force[i] = transpose_times(g.frame, Vector3<T>{f.x[i], f.y[i], f.z[i]});
    out.moment[i] = {none, none, none};
  }
}

/// Bounds l, where 2 c sqrt(l) is above the largest frequency (shell_step.hpp): what a quadrilateral moves in its
/// plane, what its hourglass modes take of deflections by the warp, and what the warp stretches. Exact for a triangle.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE T bound_membrane(const ShellGeometry<T>& g, const T& thickness, double poissons_ratio,
                                      [[maybe_unused]] const Shapes& shapes) {
  const double stiffness = 1 - poissons_ratio * poissons_ratio, a = (1 - poissons_ratio) / 2;
  const GradientProducts<T> b = find_gradient_products(g, Quadrilaterals{});
  const T trace = b.xx + b.yy, uniform = find_largest_product(b, stiffness), deflection = smaller(uniform, trace);
  const T skew = g.hx * g.hx * b.xx + T(2) * g.hx * g.hy * b.xy + g.hy * g.hy * b.yy;
  const T hourglass = T(1.0 / 12.0) * (T(a) * trace + T(1 - a) * deflection);
  const T plane = join_modes(uniform, hourglass * (T(4) + skew), uniform * hourglass * skew), square = g.z * g.z;
  const T by_warp = T(4 * stiffness / 3) * deflection * deflection * find_membrane_fade(g, thickness) * square;
  const T by_stretch = T(1.0 / 9.0) * trace * trace * square * (T(4) + skew);
  T bound = plane + by_warp + by_stretch;
  if constexpr (Shapes::has_triangles) {
    const T of_triangle = find_largest_product(find_gradient_products(g, shapes), stiffness);
    bound = select(shapes.is_triangle, of_triangle, bound);
  }
  return bound;
}

/// Largest step of central differences. stiffening: FabricResponse::stiffening, 1 of small strains.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE T find_membrane_step(const ShellGeometry<T>& g, const ShellSection<T>& section,
                                          const PlaneElasticity& elastic, const Shapes& shapes,
                                          const T& stiffening = T(1)) {
  const double nu = elastic.poissons_ratio;
  const T bound = bound_membrane(g, section.thickness, nu, shapes);
  const T modulus = T(elastic.youngs_modulus / (1 - nu * nu)) * stiffening;
  return square_root(section.mass * (T(1) / (modulus * section.thickness * g.area * bound)));
}

/// The threads of an element where it is, from its diagonals; and Green's strain by its warp, 11, 22, 12.
template <class T>
struct PlacedThreads {
  Threads<T> threads;
  T warp_strain[3];
};

template <class T>
PERCUSS_FORCE_INLINE PlacedThreads<T> place_threads(const ShellGeometry<T>& g, const T* history) {
  using H = FabricHistory;
  const T r[2] = {g.x[2] - g.x[0], g.y[2] - g.y[0]}, s[2] = {g.x[3] - g.x[1], g.y[3] - g.y[1]};
  const T &ar = history[H::warp_r], &as = history[H::warp_s], &br = history[H::weft_r], &bs = history[H::weft_s];
  PlacedThreads<T> placed;
  for (int k = 0; k < 2; ++k) {
    placed.threads.warp[k] = ar * r[k] + as * s[k];
    placed.threads.weft[k] = br * r[k] + bs * s[k];
  }
  placed.threads.start_area = T(0.5) / (ar * bs - as * br);
  placed.threads.area_ratio = g.area / placed.threads.start_area;
  // A unit of a thread goes 2 (a_r - a_s) along xi and 2 (a_r + a_s) along eta.
  const T square = T(4.0 / 3.0) * (g.z * g.z - history[H::start_warp]);
  placed.warp_strain[0] = square * (ar * ar + as * as);
  placed.warp_strain[1] = square * (br * br + bs * bs);
  placed.warp_strain[2] = square * (ar * br + as * bs);
  return placed;
}

/// History at the start of a membrane whose warp has this direction in its frame, and its weft one at a right angle.
inline std::array<double, FabricHistory::count> lay_threads(const ShellGeometry<double>& g,
                                                            const PlaneDirection<double>& warp) {
  const double r[2] = {g.x[2] - g.x[0], g.y[2] - g.y[0]}, s[2] = {g.x[3] - g.x[1], g.y[3] - g.y[1]};
  const double over = 1 / (r[0] * s[1] - r[1] * s[0]);
  const auto along_r = [&](double x, double y) { return over * (x * s[1] - y * s[0]); };
  const auto along_s = [&](double x, double y) { return over * (r[0] * y - r[1] * x); };
  return {along_r(warp.cosine, warp.sine),
          along_s(warp.cosine, warp.sine),
          along_r(-warp.sine, warp.cosine),
          along_s(-warp.sine, warp.cosine),
          0,
          g.z * g.z};
}

/// What advance_layers() does, of fabric: its stress is that of where the corners are. Its work is that over the area
/// at n+1/2, which the element multiplies with.
template <class T, class Lives>
PERCUSS_NO_INLINE LayerSums<T> advance_fabric(const ShellParameters<FabricLayer>& par, const ElementStep<T>& step,
                                              const ShellGeometry<T>& end, T* layer,
                                              [[maybe_unused]] const Lives& lives, T& stiffening) {
  LayerSums<T> sums{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, T(0), T(0), {}, {T(1), T(1), T(1), T(1)}};
  const PlacedThreads<T> placed = place_threads(end, layer + 3);
  const FabricResponse<T> response = par.material.update(placed.threads, placed.warp_strain, layer + 3);
  stiffening = response.stiffening;
  T acting(1), working(1);
  if constexpr (Lives::can_fail) {
    acting = lives.force_share(0);
    working = lives.work_share(0);
    sums.left.take(par.points, 0, acting, working);
    lives.add_strain(step.rate, step.dt, step.half_thickness);
  }
  sums.work = working * response.energy * (response.start_area / step.middle.area);
  for (int k = 0; k < 3; ++k) {
    layer[k] = response.stress[k];
    sums.force[k] = acting * response.stress[k];
  }
  return sums;
}

/// Advances the forces against the hourglass modes in the plane. Returns their work.
template <class Stored, class T, class Shapes>
PERCUSS_FORCE_INLINE T advance_membrane_hourglass(const PlaneElasticity& e, const ShellStep<T>& step,
                                                  const FlowShares<T>& flow, Stored stored, const Shapes& shapes,
                                                  ShellState<T>& state) {
  const T in_plane_dt = flow.membrane_secant * step.stiffening_dt;
  const ModeChanges<T> mode = find_membrane_changes(e, step.middle, step.rate, state.thickness, in_plane_dt, shapes);
  for (int k = 0; k < 2; ++k) stored.advance_in_plane(state.membrane_hourglass[k], mode.change[k], mode.along[k]);
  return step.dt * stored.work;
}

/// Advances the membrane from n to n+1, as advance_shell4(). A function of its own, so that shells stay as they are.
template <class T, class Material, class Lives = WholeLayers, class Shapes = Quadrilaterals>
PERCUSS_NO_INLINE ShellResult<T> advance_membrane(const ShellParameters<Material>& par, const CornerMotion<T>& motion,
                                                  const StoredShell<T>& stored, const CornerLoads<T>& out,
                                                  const Lives& lives = {}, const Shapes& shapes = {}) {
  const T &dt = motion.dt, half = T(0.5);
  ShellState<T>& state = stored.state;
  const ShellGeometry<T> middle = find_shell_geometry(step_back(motion.x, motion.v, half * dt), shapes);
  const ShellGeometry<T> end = find_shell_geometry(motion.x, shapes);
  const ShellRates<T> rate = find_membrane_rates(middle, turn(middle.frame, motion.v), shapes).shell;
  const ElementStep<T> of_layers{rate, dt, half * state.thickness, middle};
  T stiffening(1);
  LayerSums<T> layers;
  if constexpr (requires { advance_fabric(par, of_layers, end, stored.layer, lives, stiffening); })
    layers = advance_fabric(par, of_layers, end, stored.layer, lives, stiffening);
  else
    layers = advance_layers(par, of_layers, stored.layer, lives);
  const StoredForces<Material::can_yield, Lives::can_fail, T> forces{layers.flow, layers.left, false};
  const ShellStep<T> step{middle, rate, dt, T(par.stabilization) * dt};
  const T hourglass_work =
      advance_membrane_hourglass(par.material.elasticity, step, layers.flow, forces, shapes, state);
  const T old_thickness = state.thickness, half_across = half * layers.across;
  state.thickness = old_thickness * ((T(1) + half_across) * (T(1) / (T(1) - half_across)));
  find_membrane_forces(end, join_stresses<Lives::can_fail>(state, layers, end.area, shapes), out);
  const ShellSection<T> section{state.thickness, state.mass, state.gyration_square, 0};
  return {{half * (old_thickness + state.thickness) * middle.area * layers.work, hourglass_work},
          find_membrane_step(end, section, find_bound(par.material), shapes, stiffening),
          end.area,
          end.least_cosine};
}

}  // namespace percuss
