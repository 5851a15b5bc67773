#pragma once
// Recursive coordinate bisection by one process, for any number of ranks that need not exist: what Rcb
// (comm/rcb/rcb.hpp) finds from a cold start, when all points are in one place. For plans of a run, not for its steps.

#include <array>
#include <cstdint>
#include <vector>

#include "comm/rcb/cut_tree.hpp"

namespace percuss {

/// A point to be divided, all of them of equal weight.
struct PlacedPoint {
  std::array<double, 3> x{};  // position [length], finite
  std::int64_t id = 0;        // global id, each once
};

/// The cuts of the points for `rank_count` ranks, as Rcb::cuts() has them after its first bisection; [rank_count].
/// O(n log rank_count). Throws std::invalid_argument if rank_count is not positive.
std::vector<Cut> bisect_points(std::vector<PlacedPoint> points, int rank_count);

}  // namespace percuss
