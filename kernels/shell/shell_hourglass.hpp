#pragma once
// Forces of a shell element that belong to no layer: against the hourglass modes of its point, and against drilling.
//
// They are stored, and advanced by the rates of the step; their work is booked as that of the hourglass modes.

#include "kernels/shell/layer_lives.hpp"
#include "kernels/shell/plane_stress.hpp"
#include "kernels/shell/ply.hpp"
#include "kernels/shell/shell_rates.hpp"
#include "kernels/shell/shell_state.hpp"

namespace percuss {

/// Shear correction of a homogeneous section (Reissner 1945).
inline constexpr double shell_shear_correction = 5.0 / 6.0;

/// Smallest share of the membrane's hourglass stiffness on a warped element, where it would lock.
inline constexpr double shell_least_membrane_hourglass = 0.05;

template <class T>
PERCUSS_FORCE_INLINE T find_membrane_fade(const ShellGeometry<T>& g, const T& thickness) {
  const T square = thickness * thickness;
  return T(shell_least_membrane_hourglass) +
         T(1 - shell_least_membrane_hourglass) * square * (T(1) / (square + T(16) * g.z * g.z));
}

/// Stiffness against drilling, in units of the shear modulus (Hughes and Brezzi 1989): of the mean of the corners,
/// which bending in the plane does not meet; and of a triangle that of what its corners turn beyond the mean, which
/// only has to tell them apart: more of it would hinder bending in the plane.
inline constexpr double shell_drilling = 0.1, triangle_corner_drilling = 0.01;

/// What plastic flow leaves of stored forces and of the stiffness against new ones: the means of the layers' radial
/// returns and secant moduli, in proportion to what each contributes to the membrane and to bending.
template <class T>
struct FlowShares {
  T membrane = T(0), bending = T(0);
  T membrane_secant = T(1), bending_secant = T(1);  // to the last bit where no layer has flowed
  T shear = T(1), shear_secant = T(1);              // of plies alone: of what is across the layers

  PERCUSS_FORCE_INLINE void add(const ThicknessPoints& points, int p, const LayerResponse<T>& response) {
    const T weight = T(points.weight[p]), of_bending = T(points.bending[p]), lost = T(1) - response.secant;
    membrane = membrane + weight * response.share;
    bending = bending + of_bending * response.share;
    membrane_secant = membrane_secant - weight * lost;
    bending_secant = bending_secant - of_bending * lost;
  }
};

/// Flow of plies: stored forces keep the share that damage leaves of their stiffness, so that their energy does
/// not grow by it.
template <class T>
struct PlyFlow {
  T membrane = T(0), bending = T(0), left = T(0);  // by damage: at n, at n, at n+1

  PERCUSS_FORCE_INLINE void add(const ThicknessPoints& points, int p, const PlyResponse<T>& ply, FlowShares<T>& flow) {
    membrane = membrane + T(points.weight[p]) * ply.left_before;
    bending = bending + T(points.bending[p]) * ply.left_before;
    left = left + T(points.weight[p]) * ply.left;
    LayerResponse<T> weighted = ply.layer;
    weighted.share = ply.left_before * ply.layer.share;
    flow.add(points, p, weighted);
  }
  PERCUSS_FORCE_INLINE void finish(FlowShares<T>& flow) const {
    flow.membrane = flow.membrane / larger(membrane, T(1e-300));
    flow.bending = flow.bending / larger(bending, T(1e-300));
    flow.shear = left / larger(membrane, T(1e-300));
    flow.shear_secant = left;
  }
};

/// Advances stored forces by what their rates add, and sums their work.
template <bool CanYield, bool CanFail, class T>
struct StoredForces {
  const FlowShares<T>& flow;
  const SectionLeft<T>& left;
  bool has_plies;  // those in shear follow the layers too
  T work = T(0);

  PERCUSS_FORCE_INLINE void add_work(const T& added, [[maybe_unused]] const T& counted) {
    if constexpr (CanFail) {
      work = work + counted * added;
    } else {
      work = work + added;
    }
  }

  PERCUSS_FORCE_INLINE void advance_in_shear(T& force, const T& change, const T& along) {
    if (has_plies) return advance_flowing(force, change, along, flow.shear, left.mean_membrane);
    add_work((force + T(0.5) * change) * along, left.mean_membrane);
    force = force + change;
  }

  PERCUSS_FORCE_INLINE void advance_in_plane(T& force, const T& change, const T& along) {
    advance_flowing(force, change, along, flow.membrane, left.mean_membrane);
  }

  PERCUSS_FORCE_INLINE void advance_in_bending(T& force, const T& change, const T& along) {
    advance_flowing(force, change, along, flow.bending, left.mean_bending);
  }

 private:
  PERCUSS_FORCE_INLINE void advance_flowing(T& force, const T& change, const T& along, [[maybe_unused]] const T& share,
                                            const T& counted) {
    T after = force + change;
    if constexpr (CanYield) after = share * after;
    add_work(T(0.5) * (force + after) * along, counted);
    force = after;
  }
};

/// Integral of the square of the first hourglass mode of shear, over a third of the area; of a triangle that of what
/// turns around it, by the second moments of its area, with the share of the stiffness that it keeps.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE T find_shear_hourglass(const ShellGeometry<T>& g, [[maybe_unused]] const T& thickness,
                                            [[maybe_unused]] const Shapes& shapes) {
  const T along_xi = g.xi_x * g.xi_x + g.xi_y * g.xi_y;
  if constexpr (Shapes::has_triangles) {
    const GradientProducts<T> b = find_gradient_products(g, shapes);
    return select(shapes.is_triangle, T(4.0 / 9.0) * find_shear_share(g, thickness, shapes) * (b.xx + b.yy), along_xi);
  } else {
    return along_xi;
  }
}

/// Changes of stored forces over a step, and the rates that they work on.
template <class T>
struct ModeChanges {
  T change[2], along[2];
};

/// Changes of the membrane's hourglass modes, which would lock on a warped element. A triangle has none: there they are
/// those of its corners' drilling beyond the mean.
template <class T, class Shapes>
PERCUSS_FORCE_INLINE ModeChanges<T> find_membrane_changes(const PlaneElasticity& e, const ShellGeometry<T>& g,
                                                          const ShellRates<T>& rate, const T& thickness, const T& dt,
                                                          [[maybe_unused]] const Shapes& shapes) {
  const HourglassIntegrals<T> h = integrate_hourglass(g);
  const T nu = T(e.poissons_ratio);
  const T stiffness = find_membrane_fade(g, thickness) * T(e.youngs_modulus) * thickness * dt;
  const T(&m)[2] = rate.membrane_hourglass;
  ModeChanges<T> of{{stiffness * (h.xx * m[0] - nu * h.xy * m[1]), stiffness * (h.yy * m[1] - nu * h.xy * m[0])},
                    {m[0], m[1]}};
  if constexpr (Shapes::has_triangles) {
    const T drilling = T(triangle_corner_drilling * e.shear_modulus) * thickness * g.area * dt;
    for (int k = 0; k < 2; ++k) {
      of.change[k] = select(shapes.is_triangle, drilling * rate.corner_drilling[k], of.change[k]);
      of.along[k] = select(shapes.is_triangle, rate.corner_drilling[k], of.along[k]);
    }
  }
  return of;
}

/// Changes of the hourglass modes of bending.
template <class T>
PERCUSS_FORCE_INLINE ModeChanges<T> find_bending_changes(const PlaneElasticity& e, const ShellGeometry<T>& g,
                                                         const ShellRates<T>& rate, const T& thickness, const T& dt) {
  const HourglassIntegrals<T> h = integrate_hourglass(g);
  const T t = thickness, a = T(0.5) * (T(1) - T(e.poissons_ratio));
  const T stiffness = T(e.youngs_modulus / (12 * (1 - e.poissons_ratio * e.poissons_ratio))) * t * t * t * dt;
  const T mixed = T(0.5) * (T(1) + T(e.poissons_ratio)) * h.xy;  // a + nu
  const T(&b)[2] = rate.bending_hourglass;
  return {
      {stiffness * ((h.xx + a * h.yy) * b[0] + mixed * b[1]), stiffness * ((h.yy + a * h.xx) * b[1] + mixed * b[0])},
      {b[0], b[1]}};
}

/// The motion that the stored forces follow.
template <class T>
struct ShellStep {
  const ShellGeometry<T>& middle;  // at n+1/2
  const ShellRates<T>& rate;       // on it
  T dt;
  T stiffening_dt;  // dt times the share of the stiffness that the part has
};

/// Advances the stored forces by their rates: the stiffness of the element's own membrane, bending and shear beyond
/// what its point sees (physical stabilisation, Belytschko and Leviatan 1994), and that against drilling, with what the
/// flow of its layers leaves of both (deformation theory of plasticity: its secant modulus). Returns their work.
template <bool CanYield, bool CanFail, class T, class Shapes>
PERCUSS_FORCE_INLINE T advance_hourglass(const PlaneElasticity& e, const ShellStep<T>& step,
                                         StoredForces<CanYield, CanFail, T> stored, const Shapes& shapes,
                                         ShellState<T>& state) {
  const ShellGeometry<T>& g = step.middle;
  const ShellRates<T>& rate = step.rate;
  T in_plane_dt = step.stiffening_dt, bending_dt = step.stiffening_dt;
  if constexpr (CanYield) {
    in_plane_dt = stored.flow.membrane_secant * in_plane_dt;
    bending_dt = stored.flow.bending_secant * bending_dt;
  }
  const T t = state.thickness, volume_dt = t * g.area * in_plane_dt;
  const ModeChanges<T> membrane = find_membrane_changes(e, g, rate, t, in_plane_dt, shapes);
  const ModeChanges<T> bending = find_bending_changes(e, g, rate, t, bending_dt);
  for (int k = 0; k < 2; ++k) {
    stored.advance_in_plane(state.membrane_hourglass[k], membrane.change[k], membrane.along[k]);
    stored.advance_in_bending(state.bending_hourglass[k], bending.change[k], bending.along[k]);
  }
  const T shear = T(shell_shear_correction * e.shear_modulus / 3) * volume_dt;
  const T(&s)[2] = rate.shear_hourglass;
  stored.advance_in_shear(state.shear_hourglass[0], shear * find_shear_hourglass(g, t, shapes) * s[0], s[0]);
  stored.advance_in_shear(state.shear_hourglass[1], shear * (g.eta_x * g.eta_x + g.eta_y * g.eta_y) * s[1], s[1]);
  const T drilling = T(shell_drilling * e.shear_modulus) * volume_dt;
  stored.advance_in_plane(state.drilling, drilling * rate.drilling, rate.drilling);
  return step.dt * stored.work;
}

}  // namespace percuss
