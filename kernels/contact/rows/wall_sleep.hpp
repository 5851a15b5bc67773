#pragma once
// Nodes that are far from a wall are not looked at until they can have come near: they sleep.
//
// For each pair of a wall and a node it is known how far node and wall may go before they can have a row. No node goes
// farther in a step than the fastest one, so that a list of the pairs within reach holds until that way is used up.

#include <cstdint>

#include "kernels/contact/rows/wall_pairs.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// How far this rank's nodes, and the walls, go at most [length]; negative: not known.
struct WallWays {
  double last = -1;  // in the step to n
  double next = -1;  // in that from n as predicted
};

/// Pairs of a wall and a node in all steps.
struct WallCounts {
  std::int64_t pairs = 0, looked_at = 0;
};

/// Lists the pairs that can have a row within `reach` of node and wall together [length], at n; returns how many.
int list_pairs_in_reach(const WorkSpace& space, const WallPairs& walls, const Rows3<const double>& x, double reach,
                        const Array<int>& list);

class WallSleep {
 public:
  /// enabled: whether any pair may sleep at all.
  explicit WallSleep(bool enabled) : enabled_(enabled) {}

  /// The next step looks at all pairs: walls, nodes or their places are others now.
  void wake() { is_valid_ = false; }

  /// Begins a step: which pairs it looks at. walls: as they stand at n; out: `awake` of these.
  void enter_step(const WallWays& ways, const Rows3<const double>& x, WallPairs& walls);

  const WallCounts& counts() const { return counts_; }
  void clear_counts() { counts_ = {}; }

 private:
  void list_again(double way, const Rows3<const double>& x, WallPairs& walls);

  bool enabled_;
  bool is_valid_ = false;          // the list is that of the pairs as they are
  double reach_ = 0, travel_ = 0;  // of the list, and what of it is used up at n
  int steps_ = 0;                  // since then
  WallCounts counts_;
};

}  // namespace percuss
