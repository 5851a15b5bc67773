#pragma once
// What is summed over the rows of contact: before the iteration, in each pass of it, and of what the impulses did.

#include <cmath>
#include <cstdint>

#include "kernels/contact/rows/wall_sums.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

/// Energies of rows as whole numbers of a unit, so that their sum does not depend on the order of the rows, whatever
/// threads and ranks they lie on, and costs an addition each. Exact sums of doubles (exact_sum.hpp) cost many times
/// that and are not needed where only magnitudes are compared.
struct EnergyUnit {
  static constexpr double most = 68719476736.0;  // 2^36 units a row: sums of 2^26 rows stay below 2^63

  double per_unit = 0;  // units per energy; 0: nothing is known of the magnitude, and everything counts as nothing

  /// largest: an energy that rows are expected not to exceed by much, >= 0; one that does counts as `most`.
  KOKKOS_INLINE_FUNCTION static EnergyUnit of_largest(double largest) {
    const double per_unit = most / largest;
    return {largest > 0 && std::isfinite(per_unit) ? per_unit : 0};
  }

  /// Unit of the pass after one whose largest term was this: terms shrink as the iteration converges, and the unit with
  /// them, so that none is lost that matters; terms that grow 256 times in a pass still count in full.
  KOKKOS_INLINE_FUNCTION static EnergyUnit after(double largest) {
    constexpr double growth = 256;
    return of_largest(growth * largest);
  }

  KOKKOS_INLINE_FUNCTION bool is_known() const { return per_unit > 0; }

  /// Whole units of an energy, or of a difference of energies, rounded towards zero; of a pack the sum of its lanes.
  /// What is no number counts as most.
  template <class T>
  KOKKOS_FORCEINLINE_FUNCTION std::int64_t count(const T& energy) const {
    const T units = energy * T(per_unit);
    const T bounded = select(units < T(most), units, T(most));
    // Whole numbers below 2^53: the sum of the lanes is exact, whatever their order.
    return static_cast<std::int64_t>(sum_lanes(truncate(select(bounded > T(-most), bounded, T(-most)))));
  }
};

/// Gaps that the rows have to close before the iteration.
struct PredictedGaps {
  double deepest = 0;        // largest penetration to be closed, but for springs [length]
  double farthest_tied = 0;  // largest distance of a tied node from its place, by component [length]
  double smallest_size = 0;  // smallest h of a row, 0: no rows
  std::int64_t rows = 0;
  std::int64_t rigid = 0;    // ContactRow::is_rigid among them
  std::int64_t springs = 0;  // rows that springs push, or would push if their nodes were free

  KOKKOS_INLINE_FUNCTION void merge(const PredictedGaps& other) {
    deepest = other.deepest > deepest ? other.deepest : deepest;
    farthest_tied = other.farthest_tied > farthest_tied ? other.farthest_tied : farthest_tied;
    if (other.rows > 0 && (rows == 0 || other.smallest_size < smallest_size)) smallest_size = other.smallest_size;
    rows += other.rows;
    rigid += other.rigid;
    springs += other.springs;
  }
};

/// Measures of convergence, from one pass over the rows.
struct PassSums {
  PredictedGaps gaps;          // before the first pass only
  double change = 0;           // largest change of an impulse as a displacement: |p' - y| dt D [length]
  double tie_change = 0;       // largest change of a tie's impulse, likewise
  std::int64_t backwards = 0;  // sum of D dt^2 (y - p') (p' - p): positive when the extrapolation points back [units]
  double largest_term = 0;     // of that sum, without its sign [energy time^2]
  // Without ties, D dt^2 |y - p'| p' and D dt^2 p'^2: the work of the change of impulses and that of the impulses.
  std::int64_t changed_work = 0, work = 0;  // sums [units]
  double largest_work = 0;                  // of the terms of `work` [energy time^2]

  KOKKOS_INLINE_FUNCTION void merge(const PassSums& other) {
    gaps.merge(other.gaps);
    change = other.change > change ? other.change : change;
    tie_change = other.tie_change > tie_change ? other.tie_change : tie_change;
    backwards += other.backwards;
    largest_term = other.largest_term > largest_term ? other.largest_term : largest_term;
    changed_work += other.changed_work;
    work += other.work;
    largest_work = other.largest_work > largest_work ? other.largest_work : largest_work;
  }
};

/// Work and impulses of the rows of a step.
struct EnforcementSums {
  std::int64_t pushes = 0;           // rows with a push; ties
  ExactSum normal_work;              // of the normal impulses
  ExactSum friction_work;            // of the tangential impulses
  ExactSum stored;                   // energy in the springs of penalty rows at n+1
  ExactSum stored_slip;              // of that, in the tangential ones
  double rate = 0;                   // bound of the square of the frequency that these springs add [1/time^2]
  double residual = 0;               // largest penetration, or way of a tied node to its place, left over / h
  double deepest = 0;                // deepest penetration at n / h beyond what was accepted at the start
  std::int64_t deepest_key = -1;     // of the row that has it, lowest of equals
  double given = 0;                  // largest work of the push of a row, where it gives energy
  std::int64_t given_key = -1;       // of the row that has it, lowest of equals
  double held_apart = 0;             // largest ContactRow::held_apart / h
  std::int64_t held_apart_key = -1;  // of the row that has it, lowest of equals

  KOKKOS_INLINE_FUNCTION void add_depth(double depth, std::int64_t key) {
    if (!(depth > deepest) && !(depth == deepest && depth > 0 && key < deepest_key)) return;
    deepest = depth;
    deepest_key = key;
  }
  KOKKOS_INLINE_FUNCTION void add_given(double work, std::int64_t key) {
    if (!(work > given) && !(work == given && work > 0 && key < given_key)) return;
    given = work;
    given_key = key;
  }
  KOKKOS_INLINE_FUNCTION void add_held_apart(double way, std::int64_t key) {
    if (!(way > held_apart) && !(way == held_apart && way > 0 && key < held_apart_key)) return;
    held_apart = way;
    held_apart_key = key;
  }
  KOKKOS_INLINE_FUNCTION void merge(const EnforcementSums& other) {
    pushes += other.pushes;
    normal_work.merge(other.normal_work);
    friction_work.merge(other.friction_work);
    stored.merge(other.stored);
    stored_slip.merge(other.stored_slip);
    rate = other.rate > rate ? other.rate : rate;
    residual = other.residual > residual ? other.residual : residual;
    add_depth(other.deepest, other.deepest_key);
    add_given(other.given, other.given_key);
    add_held_apart(other.held_apart, other.held_apart_key);
  }
};

/// Work of the rows of one pair of surfaces.
struct PairWork {
  ExactSum normal, friction;

  KOKKOS_INLINE_FUNCTION void merge(const PairWork& other) {
    normal.merge(other.normal);
    friction.merge(other.friction);
  }
};

/// Memory of the sums over rows.
struct RowSumMemory {
  Array<PredictedGaps> gaps = Array<PredictedGaps>("contact::gap_sums", 0);
  Array<PassSums> pass = Array<PassSums>("contact::pass_sums", 0);
  Array<EnforcementSums> outcome = Array<EnforcementSums>("contact::outcome_sums", 0);
  Array<PairWork> pair = Array<PairWork>("contact::pair_sums", 0);
  Array<WallSums> wall = Array<WallSums>("contact::wall_sums", 0);
  Array<WallPush> push = Array<WallPush>("contact::push_sums", 0);
  Array<WallMeeting> meeting = Array<WallMeeting>("contact::meeting_sums", 0);
};

}  // namespace percuss
