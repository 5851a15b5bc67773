#pragma once
// The one-point four-node shell over one step: from corner motion to corner forces and moments, as a pure function.
//
// Place in the step: (1.3) to (1.5) of the paper. Positions are at n+1, velocities and angular velocities at
// n+1/2. Rates are taken on the geometry of n+1/2, forces act on that of n+1: with either geometry for both, a warped
// element in free spin gains energy. Stresses are components in the frame of the element, which turns with it. Formulas
// and their reasons: docs/theory_shells.md.

#include "kernels/core/work_kinds.hpp"
#include "kernels/shell/laminate.hpp"
#include "kernels/shell/shell_forces.hpp"
#include "kernels/shell/shell_hourglass.hpp"
#include "kernels/shell/shell_step.hpp"
#include "kernels/shell/thickness_points.hpp"

namespace percuss {

/// Numbers that are the same for all elements of a part.
template <class Material>
struct ShellParameters {
  Material material;
  ThicknessPoints points;
  double offset = 0;         // of the middle of the section from the corners along the normal [length]
  double stabilization = 1;  // share of the stiffness of the stored forces (shell_hourglass.hpp)
  bool is_membrane = false;  // nothing bends (membrane.hpp)
};

/// Energy that one step put into the element [energy].
template <class T>
struct ShellWork {
  T internal, hourglass;

  /// Calls take(kind, work) for each kind.
  template <class Take>
  KOKKOS_FORCEINLINE_FUNCTION void visit(const Take& take) {
    take(WorkKind::internal, internal);
    take(WorkKind::hourglass, hourglass);
  }
};

template <class T>
struct ShellResult {
  ShellWork<T> work;
  T stable_step;   // bound for the next step, without the deck's scale
  T size;          // area at n+1
  T least_cosine;  // ShellGeometry::least_cosine at n+1
};

/// What the layers of a step give: stress over the thickness and its first moment, about the middle and in units of
/// half the thickness; their work per volume; the mean strain across the thickness; how they flow.
template <class T>
struct LayerSums {
  T force[3], moment[3], work, across;
  FlowShares<T> flow;
  SectionLeft<T> left;
};

/// Whether the points across the thickness differ by more than their place.
template <class Material>
inline constexpr bool has_plies = requires {
  requires Material::has_plies;
};

/// The step of an element.
template <class T>
struct ElementStep {
  const ShellRates<T>& rate;
  T dt, half_thickness;
  const ShellGeometry<T>& middle;  // at n+1/2
};

/// Advances the layers' stresses. layer: where the records of the points begin; they lie `width` scalars apart where
/// the record is one of packs, which T stands for.
template <class T, class Material, class Lives>
PERCUSS_FORCE_INLINE LayerSums<T> advance_layers(const ShellParameters<Material>& par, const ElementStep<T>& step,
                                                 T* layer, [[maybe_unused]] const Lives& lives) {
  const auto& [rate, dt, half_thickness, middle] = step;
  LayerSums<T> sums{{T(0), T(0), T(0)}, {T(0), T(0), T(0)}, T(0), T(0), {}, {T(1), T(1), T(1), T(1)}};
  const T half = T(0.5);
  [[maybe_unused]] PlyFlow<T> plies;
  for (int p = 0; p < par.points.count; ++p, layer += 3 + par.material.count_history()) {
    const T place = T(par.points.place[p]), weight = T(par.points.weight[p]);
    T de[3], stress[3];
    for (int k = 0; k < 3; ++k) {
      de[k] = dt * (rate.membrane[k] + half_thickness * place * rate.curvature[k]);
      stress[k] = layer[k];
    }
    LayerResponse<T> response;
    if constexpr (has_plies<Material>) {
      const PlyStep<T> of_ply{dt, {middle.b1[0], middle.b1[1]}, {middle.b2[0], middle.b2[1]}};
      const PlyResponse<T> ply = par.material.update(p, stress, layer + 3, de, of_ply);
      plies.add(par.points, p, ply, sums.flow);
      response = ply.layer;
    } else {
      response = par.material.update(stress, layer + 3, de, dt);
    }
    sums.across = sums.across + weight * response.across;
    if constexpr (Material::can_yield && !has_plies<Material>) sums.flow.add(par.points, p, response);
    T acting = weight, working = weight;
    if constexpr (Lives::can_fail) {
      acting = weight * lives.force_share(p);
      working = weight * lives.work_share(p);
      sums.left.take(par.points, p, lives.force_share(p), lives.work_share(p));
    }
    for (int k = 0; k < 3; ++k) {
      sums.work = sums.work + working * half * (layer[k] + stress[k]) * de[k];
      layer[k] = stress[k];
      sums.force[k] = sums.force[k] + acting * stress[k];
      sums.moment[k] = sums.moment[k] + acting * place * stress[k];
    }
  }
  if constexpr (has_plies<Material>) plies.finish(sums.flow);
  if constexpr (Lives::can_fail) lives.add_strain(rate, dt, half_thickness);
  return sums;
}

/// Rates at the middle of a section that lies off the corners, a fibre of the same director.
template <class T>
PERCUSS_FORCE_INLINE void move_to_middle(const T& offset, ShellRates<T>& rate) {
  for (int k = 0; k < 3; ++k) rate.membrane[k] = rate.membrane[k] + offset * rate.curvature[k];
  for (int k = 0; k < 2; ++k) {
    rate.membrane_hourglass[k] = rate.membrane_hourglass[k] + offset * rate.bending_hourglass[k];
  }
}

/// The transpose for forces: what acts at the middle bends the section about the corners.
template <class T>
PERCUSS_FORCE_INLINE void move_to_corners(const T& offset, ShellRates<T>& on) {
  for (int k = 0; k < 3; ++k) on.curvature[k] = on.curvature[k] + offset * on.membrane[k];
  for (int k = 0; k < 2; ++k) {
    on.bending_hourglass[k] = on.bending_hourglass[k] + offset * on.membrane_hourglass[k];
  }
}

/// Positions half a step before n+1.
template <class T>
PERCUSS_FORCE_INLINE ShellDifferences<T> step_back(const ShellDifferences<T>& x, const ShellDifferences<T>& v,
                                                   const T& half_dt) {
  return {x.r - half_dt * v.r, x.s - half_dt * v.s, x.h - half_dt * v.h};
}

/// Forces on the rates of the element at n+1.
template <bool CanFail, class T, class Shapes>
PERCUSS_FORCE_INLINE ShellRates<T> join_stresses(const ShellState<T>& state, const LayerSums<T>& layers, const T& area,
                                                 [[maybe_unused]] const Shapes& shapes) {
  const T volume = area * state.thickness, lever = T(0.5) * state.thickness * volume;
  ShellRates<T> on;
  for (int k = 0; k < 3; ++k) {
    on.membrane[k] = volume * layers.force[k];
    on.curvature[k] = lever * layers.moment[k];
  }
  for (int k = 0; k < 2; ++k) {
    on.shear[k] = volume * state.shear[k];
    on.membrane_hourglass[k] = state.membrane_hourglass[k];
    on.bending_hourglass[k] = state.bending_hourglass[k];
    on.shear_hourglass[k] = state.shear_hourglass[k];
    if constexpr (CanFail) {
      on.shear[k] = layers.left.membrane * on.shear[k];
      on.membrane_hourglass[k] = layers.left.membrane * on.membrane_hourglass[k];
      on.bending_hourglass[k] = layers.left.bending * on.bending_hourglass[k];
      on.shear_hourglass[k] = layers.left.membrane * on.shear_hourglass[k];
    }
    on.corner_drilling[k] = T(0);
    if constexpr (Shapes::has_triangles) {
      on.corner_drilling[k] = select(shapes.is_triangle, on.membrane_hourglass[k], T(0));
      on.membrane_hourglass[k] = select(shapes.is_triangle, T(0), on.membrane_hourglass[k]);
    }
  }
  on.drilling = state.drilling;
  if constexpr (CanFail) on.drilling = layers.left.membrane * on.drilling;
  return on;
}

/// The laminate that layers are; null: they are none.
template <class Material>
PERCUSS_FORCE_INLINE const LaminateLayer* find_laminate([[maybe_unused]] const Material& material) {
  if constexpr (requires { material.find_laminate(); })
    return material.find_laminate();
  else
    return nullptr;
}

/// Advances the stress in transverse shear. share: of the stiffness that the shape leaves. Returns the work of the step
/// per volume, with that of the layers.
template <class T, class Material, class Lives>
PERCUSS_FORCE_INLINE T advance_shear(const Material& material, const ElementStep<T>& step, const LayerSums<T>& layers,
                                     [[maybe_unused]] const T* layer, const T& share, T (&shear)[2]) {
  const auto& [rate, dt, half_thickness, middle] = step;
  const T half = T(0.5);
  T work = layers.work;
  if (const LaminateLayer* const laminate = find_laminate(material); laminate != nullptr) {
    // Damage of plies takes its share, as of other forces that belong to no layer.
    T change[2];
    laminate->find_shear(LaminateLayer::find_reference(layer + 3), rate.shear, change);
    for (int k = 0; k < 2; ++k) {
      const T moved = shear[k] + layers.flow.shear_secant * share * dt * change[k];
      const T after = layers.flow.shear * moved;
      T added = half * (shear[k] + after) * dt * rate.shear[k];
      if constexpr (Lives::can_fail) added = layers.left.mean_membrane * added;
      work = work + added;
      shear[k] = after;
    }
  } else {
    const T modulus = share * T(shell_shear_correction * material.elasticity.shear_modulus);
    for (int k = 0; k < 2; ++k) {
      const T change = modulus * dt * rate.shear[k];
      T added = (shear[k] + half * change) * dt * rate.shear[k];
      if constexpr (Lives::can_fail) added = layers.left.mean_membrane * added;
      work = work + added;
      shear[k] = shear[k] + change;
    }
  }
  return work;
}

/// What bounds the stable step.
template <class Material>
PERCUSS_FORCE_INLINE const PlaneElasticity& find_bound(const Material& material) {
  if constexpr (requires { material.bound; })
    return material.bound;
  else
    return material.elasticity;
}

/// The motion of an element's corners in a step, in space axes.
template <class T>
struct CornerMotion {
  const ShellDifferences<T>& x;  // of the positions at n+1
  const ShellDifferences<T>& v;  // of the velocities at n+1/2
  const Vector3<T> (&w)[4];      // angular velocities at n+1/2
  T dt;
};

/// Where an element's record lies, in and out.
template <class T>
struct StoredShell {
  ShellState<T>& state;
  T* layer;  // the records of its points
};

/// Out: what resists the motion at the corners (the node feels the negative).
template <class T>
struct CornerLoads {
  Vector3<T> (&force)[4], (&moment)[4];
};

/// Advances the element from n to n+1. With dt = 0 it evaluates forces and step only. lives: of layers that can fail,
/// in and out. shapes: what of the pack is a triangle.
template <class T, class Material, class Lives = WholeLayers, class Shapes = Quadrilaterals>
PERCUSS_FORCE_INLINE ShellResult<T> advance_shell4(const ShellParameters<Material>& par, const CornerMotion<T>& motion,
                                                   const StoredShell<T>& stored, const CornerLoads<T>& out,
                                                   const Lives& lives = {}, const Shapes& shapes = {}) {
  const ShellDifferences<T>&x = motion.x, &v = motion.v;
  const Vector3<T>(&w)[4] = motion.w;
  const T& dt = motion.dt;
  ShellState<T>& state = stored.state;
  const PlaneElasticity& elastic = par.material.elasticity;
  const T half = T(0.5);
  const ShellGeometry<T> middle = find_shell_geometry(step_back(x, v, half * dt), shapes);
  const Vector3<T> turned[4] = {middle.frame * w[0], middle.frame * w[1], middle.frame * w[2], middle.frame * w[3]};
  ShellRates<T> rate = find_shell_rates(middle, turn(middle.frame, v), turned, shapes);  // (1.3) strain rate
  if (par.offset != 0) move_to_middle(T(par.offset), rate);

  const ElementStep<T> of_layers{rate, dt, half * state.thickness, middle};
  const LayerSums<T> layers = advance_layers(par, of_layers, stored.layer, lives);  // (1.4) stress
  T share = T(1);
  if constexpr (Shapes::has_triangles) share = find_shear_share(middle, state.thickness, shapes);
  const T work = advance_shear<T, Material, Lives>(par.material, of_layers, layers, stored.layer, share, state.shear);
  const StoredForces<Material::can_yield, Lives::can_fail, T> forces{layers.flow, layers.left,
                                                                     find_laminate(par.material) != nullptr};
  const ShellStep<T> step{middle, rate, dt, T(par.stabilization) * dt};
  const T hourglass_work = advance_hourglass(elastic, step, forces, shapes, state);
  const T old_thickness = state.thickness;
  const T half_across = half * layers.across;
  state.thickness = old_thickness * ((T(1) + half_across) * (T(1) / (T(1) - half_across)));

  const ShellGeometry<T> end = find_shell_geometry(x, shapes);
  ShellRates<T> on = join_stresses<Lives::can_fail>(state, layers, end.area, shapes);
  if (par.offset != 0) move_to_corners(T(par.offset), on);
  const ShellSection<T> section{state.thickness, state.mass, state.gyration_square, par.offset};
  find_shell_forces(end, on, out.force, out.moment, shapes);  // (1.5) internal forces
  return {{half * (old_thickness + state.thickness) * middle.area * work, hourglass_work},
          find_shell_step(end, section, find_bound(par.material), shapes),
          end.area,
          end.least_cosine};
}

}  // namespace percuss
