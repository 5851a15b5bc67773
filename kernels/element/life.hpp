#pragma once
// The life of an element from its failure to its end, lane by lane: shared by the loops over solids, shells and beams.

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

/// The life of an element, or of a layer of one, where its owner keeps it.
template <class Count, class Share>
struct Life {
  Count& left;   // evaluations until the force is gone; ElementLives::whole
  Share& force;  // share of it at the next evaluation
  Share& work;   // share of that of the step up to there

  KOKKOS_INLINE_FUNCTION void set_left(int evaluations, int fade_steps) const {
    const LifeShares shares = find_life_shares(evaluations, fade_steps);
    left = evaluations;
    force = static_cast<Share>(shares.force);
    work = static_cast<Share>(shares.work);
  }

  /// It has failed: it loses the force that it has, over the steps of its fade or, where it softens, at once.
  KOKKOS_INLINE_FUNCTION void begin_to_die(const FailureLimits& limits) const {
    const Share before = force;
    set_left(limits.fade_steps, limits.fade_steps);
    if (limits.softens()) work = static_cast<Share>(0.5) * before;
  }

  /// Gives it the force that its damage leaves; returns whether that is another one than before.
  KOKKOS_INLINE_FUNCTION bool soften(double share) const {
    const Share before = force, of_work = static_cast<Share>(0.5) * (before + static_cast<Share>(share));
    const bool changed = static_cast<Share>(share) != before || of_work != work;
    force = static_cast<Share>(share);
    work = of_work;
    return changed;
  }
};

KOKKOS_INLINE_FUNCTION Life<int, Real> find_life(const ElementLives& lives, int lane) {
  return {lives.steps_left(lane), lives.force_share(lane), lives.work_share(lane)};
}

/// Brings an element that has failed, or that its evaluation has taken out, one evaluation nearer to death. Returns
/// whether it is one.
KOKKOS_INLINE_FUNCTION bool go_on_dying(const ElementLives& lives, int lane, const FailureLimits& limits,
                                        FailureCounts& counts) {
  const Life<int, Real> life = find_life(lives, lane);
  const int left = life.left;
  if (life.force < 0 || left == 1) {
    life.set_left(0, limits.fade_steps);
    ++counts.died;
    return true;
  }
  if (left > 1) life.set_left(left - 1, limits.fade_steps);
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
