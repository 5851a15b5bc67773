#pragma once
// Where the median search looks next: pure functions from what is left of a search to the probes of a round.

#include <cstdint>
#include <vector>

#include "comm/rcb/cut_tree.hpp"
#include "comm/rcb/probe_counts.hpp"

namespace percuss {

/// Once at most so many points are left, their keys are gathered instead of probed.
inline constexpr int gathered_keys = 256;

/// Bracket of a search: the points that are left, over all ranks, one of which is the cut.
struct Bracket {
  CoordinateKey lowest, highest;  // of the points
  bool keys_are_exact = true;     // false: only the coordinates of the two are those of points
  std::int64_t points = 0;
  std::int64_t weight = 0;
  std::int64_t target = 0;  // weight to be passed before the cut, 0 <= target < weight
};

/// One point that stands for several.
struct KeySample {
  CoordinateKey key;
  double weight = 0;  // 0: no sample
};

/// The previous cut itself and, on both sides, its coordinate +- q r^j. q spans so many points that a cut that stays
/// within 4 q leaves few enough to be gathered; r is 4, or more where the probes would else not reach beyond four times
/// the cut's recent travel.
Probes probe_around(const Cut& previous);

/// Evenly between the lowest and the highest coordinate; between their ids if all coordinates are equal.
Probes probe_evenly(const Bracket& bracket);

/// Probes at the quantiles of samples; progress is certain because the highest key is a probe too. For points that
/// crowd: on few coordinates, or on widely different scales. samples: of all ranks, in any order.
Probes probe_quantiles(std::vector<KeySample> samples, const Bracket& bracket);

/// The bin with the target, with its target, out of the bracket that was counted.
Bracket narrow(const Bracket& bracket, const ProbeCounts& counts, int& bin);

/// The mean distance of points in a bin and, as far as it takes to see a few hundred that do not all coincide, in its
/// neighbours; 0 if all counted points coincide.
double measure_spacing(const ProbeCounts& counts, int bin);

/// Reduces a bracket to the cut alone, if the cut is known without another look because it must be the bracket's lowest
/// or highest point. Returns whether it is.
bool find_at_ends(Bracket& bracket);

}  // namespace percuss
