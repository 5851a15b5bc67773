#pragma once
// Which lanes of a chunk of shells live, as its launcher sees it (kernels/element/living_lanes.hpp).

#include "kernels/element/living_lanes.hpp"
#include "kernels/shell/shell4.hpp"

namespace percuss {

/// Cosine between the normal of a corner and that of its element, slope 10, at which an element that can fail counts as
/// folded, and dies. One that cannot goes on.
inline constexpr double shell_folded_cosine = 0.0995;

/// T: packs of doubles; where solids are in single precision no shell gets here.
template <class T>
class LivingShells : public LivingLanes {
 public:
  KOKKOS_FUNCTION LivingShells(const FailingChunks& failing, const ElementLives& lives, int chunk, int points)
      : LivingLanes(failing, lives, chunk), row_count_(LayerLives::count_rows(points)) {
    if (can_fail()) rows_ = &lives.layers(failing.first_layer(chunk)) - row_count_ * width_of_doubles;
  }

  KOKKOS_FUNCTION bool take_pack(const std::uint16_t*& corners) {
    rows_ += row_count_ * width_of_doubles;
    return LivingLanes::take_pack(corners);
  }

  /// Of the pack's layers.
  KOKKOS_FUNCTION FailingLayers<T> layers() const { return {reinterpret_cast<T*>(rows_)}; }

  /// What the pack leaves: forces, moments and work by their shares, nothing of dead lanes and of those that must not
  /// go on.
  KOKKOS_FUNCTION void settle(ShellResult<T>& result, Vector3<T> (&force)[4], Vector3<T> (&moment)[4]) const {
    const auto is_open = T(shell_folded_cosine) < result.least_cosine;
    const T share = take_force_share(result.stable_step, select(is_open, result.area, T(0.0)));
    settle_forces<4>(share, force);
    settle_forces<4>(share, moment);
    take_work(share, result.work);
    settle_step(share, result.stable_step, result.area);
  }

 private:
  static constexpr int width_of_doubles = pack_size<double>;
  int row_count_;
  double* rows_ = nullptr;
};

}  // namespace percuss
