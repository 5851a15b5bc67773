#pragma once
// Loss of force of failed elements, lane by lane: shared by the loops over solids, shells and beams.

#include <cstddef>

#include "kernels/element/element_lives.hpp"
#include "kernels/element/element_records.hpp"
#include "kernels/element/failure.hpp"

namespace percuss {

/// The chunk's records, and where its lanes begin among those that can fail.
struct FailingRecords {
  Real* records;
  int record_size;
  int first_lane;
  int packs;

  KOKKOS_INLINE_FUNCTION LaneRecord<Real> find(int i) const { return {records + find_record_place(i, record_size)}; }
};

KOKKOS_INLINE_FUNCTION FailingRecords find_records(const ElementChunks& chunks, const FailingChunks& failing,
                                                   const Array<Real>& elements, int c) {
  return {&elements(chunks.first_state(c)), chunks.record_size(c), failing.first_pack(c) * pack_width,
          chunks.first_pack(c + 1) - chunks.first_pack(c)};
}

/// The element has `left` evaluations until its force is gone.
KOKKOS_INLINE_FUNCTION void set_left(const ElementLives& lives, int lane, int left, const FailureLimits& limits) {
  const LifeShares shares = find_life_shares(left, limits.fade_steps);
  lives.steps_left(lane) = left;
  lives.force_share(lane) = static_cast<Real>(shares.force);
  lives.work_share(lane) = static_cast<Real>(shares.work);
}

/// An element has failed: it loses the force that it has, over the steps of its fade or, where it softens, at once.
KOKKOS_INLINE_FUNCTION void begin_to_die(const ElementLives& lives, int lane, const FailureLimits& limits) {
  const Real before = lives.force_share(lane);
  set_left(lives, lane, limits.fade_steps, limits);
  if (limits.softens()) lives.work_share(lane) = static_cast<Real>(0.5) * before;
}

/// Brings an element that has failed, or that its evaluation has taken out, one evaluation nearer to death. Returns
/// whether it is one.
KOKKOS_INLINE_FUNCTION bool go_on_dying(const ElementLives& lives, int lane, const FailureLimits& limits,
                                        FailureCounts& counts) {
  const int left = lives.steps_left(lane);
  if (lives.force_share(lane) < 0 || left == 1) {
    set_left(lives, lane, 0, limits);
    ++counts.died;
    return true;
  }
  if (left > 1) set_left(lives, lane, left - 1, limits);
  return left > 1;
}

/// Inactive lanes of each pack repeat the lowest active one: record and, in the evaluation, corners.
KOKKOS_INLINE_FUNCTION void repeat_living_lanes(const ElementLives& lives, const FailingRecords& of) {
  constexpr int width = pack_width;
  for (int p = 0; p < of.packs; ++p) {
    const int first = of.first_lane + p * width;
    int living = 0;
    while (living < width && lives.steps_left(first + living) == 0) ++living;
    if (living == width) continue;
    const ElementRecord of_living = of.find(p * width + living);
    for (int lane = 0; lane < width; ++lane) {
      if (lives.steps_left(first + lane) != 0) continue;
      const LaneRecord<Real> record = of.find(p * width + lane);
      for (int s = 0; s < of.record_size; ++s) record[s] = of_living[s];
    }
  }
}

/// Whether an element has begun to fail and is not eroded yet.
KOKKOS_INLINE_FUNCTION bool is_any_ending(const ElementLives& lives, int first_lane, int count) {
  for (int lane = first_lane; lane < first_lane + count; ++lane) {
    if (lives.steps_left(lane) > 0 || (lives.steps_left(lane) < 0 && lives.force_share(lane) < 0)) return true;
  }
  return false;
}

/// Lanes past the end are inactive when the last element is, so that they keep no pack active.
KOKKOS_INLINE_FUNCTION void end_lanes_past_end(const ElementLives& lives, const FailingRecords& of, int count) {
  const int last = of.first_lane + count - 1;
  for (int lane = last + 1; lane < of.first_lane + of.packs * pack_width; ++lane) {
    lives.steps_left(lane) = lives.steps_left(last);
    lives.force_share(lane) = lives.force_share(last);
    lives.work_share(lane) = lives.work_share(last);
  }
}

}  // namespace percuss
