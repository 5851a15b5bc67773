#pragma once
// Active lanes of a chunk's packs, as the launcher of the element step sees them. Inactive lanes gather the data of an
// active lane and add nothing; a failed lane adds its remaining share.

#include <cstdint>

#include "kernels/core/precision.hpp"
#include "kernels/core/short_scalar.hpp"
#include "kernels/core/tensor.hpp"
#include "kernels/core/widen.hpp"
#include "kernels/element/element_records.hpp"

namespace percuss {

/// Forces by the shares that lanes leave of them, corner by corner or axis by axis; nothing from inactive lanes and
/// from those that must stop.
template <int N>
PERCUSS_FORCE_INLINE void settle_forces(const Pack<double>& share, Vector3<Pack<double>> (&f)[N]) {
  const Pack<double> zero(0.0);
  const auto lives = !(share < zero);
  for (auto& at : f)
    at = {select(lives, share * at.x, zero), select(lives, share * at.y, zero), select(lives, share * at.z, zero)};
}
PERCUSS_FORCE_INLINE void settle_forces(const Pack<Real>& share, Pack<Real> (&f)[3][8]) {
  const Pack<Real> zero(0);
  const auto lives = !(share < zero);
  for (auto& of_axis : f) {
    for (auto& force : of_axis) force = select(lives, share * force, zero);
  }
}

/// Step bound and volume, area or length of the lanes that live; harmless ones of the others.
template <class T>
PERCUSS_FORCE_INLINE void settle_step(const T& share, T& step, T& size) {
  const auto lives = !(share < T(0));
  step = select(lives, step, number<T>(beyond_all<T>));
  size = select(lives, size, T(1));
}

/// The lanes of a chunk, pack by pack from its first, of elements that work in Scalar. Of a chunk that cannot fail all
/// live, and nothing is read. MayFail: some chunks can fail.
template <class Scalar, bool MayFail = true>
class LivingLanes {
 public:
  using Lanes = Pack<Scalar>;
  static constexpr int width = pack_size<Scalar>;

  KOKKOS_FUNCTION LivingLanes(const FailingChunks& failing, const ElementLives& lives, int chunk)
      : next_(failing.find_pack(chunk)) {
    if (next_ < 0) return;
    lives_ = &lives;
    limits_ = &failing.limits(failing.row(chunk));
  }

  KOKKOS_FUNCTION bool can_fail() const { return MayFail && lives_ != nullptr; }

  /// Continues to the next pack; returns whether any lane is active. corners: [8][W]; out: those to gather from.
  KOKKOS_FUNCTION bool take_pack(const std::uint16_t*& corners) {
    const int pack = next_++;
    first_ = pack * width;
    int living = -1, count = 0;
    for (int lane = width - 1; lane >= 0; --lane) {
      if (is_dead(lane)) continue;
      living = lane;
      ++count;
    }
    if (count == 0) return false;
    if (count < width) corners = replace_dead(corners, living);
    return true;
  }

  /// What a pack leaves: forces and work by their shares; nothing from inactive lanes and from those that must stop.
  /// size: not positive where the element is inverted. Returns the shares.
  template <class Result, class... Forces>
  KOKKOS_FUNCTION Lanes settle(Result& result, const Lanes& size, Forces&... forces) const {
    const Lanes share = take_force_share(result.stable_step, size);
    (settle_forces(share, forces), ...);
    take_work(share, result.work);
    settle_step(share, result.stable_step, result.size);
    return share;
  }

  /// Shares of its force that each lane leaves at this evaluation, as far as the last one says; negative: eroded.
  KOKKOS_FUNCTION Lanes load_force_share() const { return load_pack(&lives_->force_share(first_)); }

  /// Shares of the force at this evaluation; negative also where the element must stop.
  KOKKOS_FUNCTION Lanes take_force_share(const Lanes& step, const Lanes& size) const {
    const Lanes zero(0), dead(static_cast<Scalar>(ElementLives::dead));
    Lanes share = load_force_share();
    auto lost = step < Lanes(static_cast<Scalar>(limits_->least_step));
    if (limits_->takes_inverted) lost = lost | !((size > zero) & (step > zero));  // also for NaN
    share = select(lost, dead, share);
    store_pack(&lives_->force_share(first_), share);
    return share;
  }

  /// State of one lane: whether it is inactive, and the share of its force that is left.
  KOKKOS_FUNCTION bool is_dead(int lane) const { return lives_->force_share(first_ + lane) < 0; }
  KOKKOS_FUNCTION double find_force_share(int lane) const {
    return static_cast<double>(lives_->force_share(first_ + lane));
  }
  /// Makes its work what counts of it, and adds it to that of the lane.
  KOKKOS_FUNCTION void take_work(int lane, int kind, double& work) const {
    work *= static_cast<double>(lives_->work_share(first_ + lane));
    const std::size_t of_all = static_cast<std::size_t>(first_) + static_cast<std::size_t>(lane);
    lives_->work(find_work_place(of_all, static_cast<std::size_t>(kind))) += work;
  }

  /// Makes work what counts of it, and adds it to that of the lanes.
  template <class Work>
  KOKKOS_FUNCTION void take_work(const Lanes& force_share, Work& of) const {
    of.visit([&](int kind, Lanes& work) { take_work(force_share, kind, work); });
  }
  KOKKOS_FUNCTION void take_work(const Lanes& force_share, int kind, Lanes& work) const {
    const Lanes work_share = load_pack(&lives_->work_share(first_));
    double* const total =
        &lives_->work(work_kinds * static_cast<std::size_t>(first_) + static_cast<std::size_t>(kind * width));
    work = select(!(force_share < Lanes(0)), work_share * work, Lanes(0));
    visit_parts<Lanes>([&](auto part) {
      double* const sum = total + part * pack_size<double>;
      store_pack(sum, load_pack(sum) + widen<part>(work));
    });
  }

 private:
  KOKKOS_FUNCTION const std::uint16_t* replace_dead(const std::uint16_t* corners, int living) {
    for (int i = 0; i < 8; ++i) {
      for (int lane = 0; lane < width; ++lane) {
        corners_[i * width + lane] = corners[i * width + (is_dead(lane) ? living : lane)];
      }
    }
    return corners_;
  }

  const ElementLives* lives_ = nullptr;
  const FailureLimits* limits_ = nullptr;
  int next_;
  int first_ = 0;  // lane of the pack, among those that can fail
  std::uint16_t corners_[8 * width];
};

}  // namespace percuss
