#pragma once
// Layers of shells that differ: plies of orthotropic or isotropic materials, each with a thickness and an angle.

#include "kernels/shell/hardening_layer.hpp"
#include "kernels/shell/metal_ply.hpp"
#include "kernels/shell/ply.hpp"
#include "kernels/shell/thickness_points.hpp"

namespace percuss {

/// Stiffness in transverse shear by the reference axes of a laminate [stress]: xz, yz, and what couples them.
struct ShearStiffness {
  double xx = 0, yy = 0, xy = 0;
};

/// A material of plies: exactly one of the four.
struct PlyMaterial {
  enum class Kind { orthotropic, linear_hardening, hardening, anisotropic_metal };
  Kind kind = Kind::orthotropic;
  OrthotropicPly orthotropic;
  J2Layer linear_hardening;
  HardeningLayer hardening;
  MetalPly anisotropic_metal;

  template <class T>
  PERCUSS_NO_INLINE PlyResponse<T> update(const PlaneDirection<T>& axes, T (&stress)[3], T* history, const T (&de)[3],
                                          const PlyStep<T>& step) const {
    if (kind == Kind::orthotropic) return orthotropic.update(axes, stress, history, de, step);
    if (kind == Kind::anisotropic_metal)
      return {anisotropic_metal.update(axes, stress, history, de, step.dt), T(1), T(1)};
    const LayerResponse<T> metal = kind == Kind::linear_hardening
                                       ? linear_hardening.update(stress, history, de, step.dt)
                                       : hardening.update(stress, history, de, step.dt);
    return {metal, T(1), T(1)};
  }
};

/// The layers of a laminate, bottom first: one for each point across the thickness. History: PlyHistory.
struct LaminateLayer {
  static constexpr int most_history = PlyHistory::count;
  static constexpr bool can_yield = true;
  static constexpr bool has_plies = true;
  static constexpr int most_materials = 6;

  PlaneElasticity elasticity;  // isotropic mean over all directions and plies, for what belongs to no layer
  PlaneElasticity bound;       // isotropic, nowhere softer than a ply
  ShearStiffness shear;
  struct Point {
    int material = 0;
    double cosine = 1, sine = 0;  // of the ply's axis 1 against the reference axis
  };
  Point points[most_layers];
  PlyMaterial materials[most_materials];

  static constexpr int count_history() { return PlyHistory::count; }
  PERCUSS_FORCE_INLINE const LaminateLayer* find_laminate() const { return this; }

  /// The reference axis in the frame of the element. history: of any point.
  template <class T>
  PERCUSS_FORCE_INLINE static PlaneDirection<T> find_reference(const T* history) {
    return {history[PlyHistory::cosine], history[PlyHistory::sine]};
  }

  template <class T>
  PERCUSS_FORCE_INLINE PlyResponse<T> update(int p, T (&stress)[3], T* history, const T (&de)[3],
                                             const PlyStep<T>& step) const {
    const Point& point = points[p];
    const PlaneDirection<T> reference = find_reference(history);
    const T c = T(point.cosine), s = T(point.sine);
    const PlaneDirection<T> axes{c * reference.cosine - s * reference.sine, s * reference.cosine + c * reference.sine};
    return materials[point.material].update(axes, stress, history, de, step);
  }

  /// Stress rate of transverse shear, xz and yz in the frame of the element, of the rates there.
  template <class T>
  PERCUSS_FORCE_INLINE void find_shear(const PlaneDirection<T>& reference, const T (&rate)[2], T (&stress)[2]) const {
    const T &c = reference.cosine, &s = reference.sine;
    const T x = c * rate[0] + s * rate[1], y = c * rate[1] - s * rate[0];
    const T on_x = T(shear.xx) * x + T(shear.xy) * y, on_y = T(shear.xy) * x + T(shear.yy) * y;
    stress[0] = c * on_x - s * on_y;
    stress[1] = s * on_x + c * on_y;
  }
};

}  // namespace percuss
