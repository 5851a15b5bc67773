#pragma once
// What the layers of shells carry that can fail: places in ElementLives::layers, and how the element step reads them.
//
// A layer that meets a criterion loses its stress in equal parts over the evaluations that come, as an element does.
// Forces that belong to no layer (transverse shear, hourglass) lose as much as the layers have lost of the membrane's
// or of the bending's stiffness.

#include "kernels/element/element_lives.hpp"
#include "kernels/shell/shell_rates.hpp"
#include "kernels/shell/thickness_points.hpp"

namespace percuss {

/// Rows of a pack, W scalars each: of the element the strain of its middle xx, yy, 2 xy and what its bending adds at
/// the top, both as sums of their increments in the frame of the element; then layer after layer, bottom first, what is
/// named below.
struct LayerLives {
  static constexpr int membrane = 0, bending = 3, layers = 6;
  static constexpr int force_share = 0,
                       work_share = 1;  // of its stress at the next evaluation, of the work up to there
  static constexpr int left = 2;        // evaluations until its stress is gone; ElementLives::whole
  static constexpr int plastic_strain = 3, damage = 4, second = 5;  // at n, as ElementLives
  static constexpr int layer_size = 6;
  static constexpr int count_rows(int points) { return layers + points * layer_size; }
};

/// The layers of an element that cannot fail.
struct WholeLayers {
  static constexpr bool can_fail = false;
};

/// Layers that can fail, of an element or a pack of elements. rows: of LayerLives; T stands for a row.
template <class T>
struct FailingLayers {
  static constexpr bool can_fail = true;
  T* rows;

  PERCUSS_FORCE_INLINE const T& force_share(int p) const { return find(p)[LayerLives::force_share]; }
  PERCUSS_FORCE_INLINE const T& work_share(int p) const { return find(p)[LayerLives::work_share]; }
  PERCUSS_FORCE_INLINE void add_strain(const ShellRates<T>& rate, const T& dt, const T& half_thickness) const {
    for (int k = 0; k < 3; ++k) {
      rows[LayerLives::membrane + k] = rows[LayerLives::membrane + k] + dt * rate.membrane[k];
      rows[LayerLives::bending + k] = rows[LayerLives::bending + k] + dt * half_thickness * rate.curvature[k];
    }
  }

 private:
  PERCUSS_FORCE_INLINE const T* find(int p) const { return rows + LayerLives::layers + p * LayerLives::layer_size; }
};

/// What failed layers leave of a section's stiffness in its plane and in bending: at n+1, and in the mean of the step.
/// Exactly 1 while all layers are whole.
template <class T>
struct SectionLeft {
  T membrane, bending, mean_membrane, mean_bending;

  PERCUSS_FORCE_INLINE void take(const ThicknessPoints& points, int p, const T& force_share, const T& work_share) {
    const T weight = T(points.weight[p]), in_bending = T(points.bending[p]);
    membrane = membrane - weight * (T(1) - force_share);
    bending = bending - in_bending * (T(1) - force_share);
    mean_membrane = mean_membrane - weight * (T(1) - work_share);
    mean_bending = mean_bending - in_bending * (T(1) - work_share);
  }
};

}  // namespace percuss
