#pragma once
// When a search has found more pairs than come from a sound motion (a runaway node makes every box hold every node).

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "src/contact/surface/surface_share.hpp"
#include "src/error.hpp"

namespace percuss {

/// Most pairs of a node and a face that one rank can number by int, in memory that grows by half.
inline constexpr std::int64_t most_indexed_pairs = 1'400'000'000;

/// Most pairs on all ranks together that a sound motion gives.
inline std::int64_t find_pair_limit(const SurfaceShare& share) {
  return std::int64_t{1'000'000} + 2000 * share.total_nodes;
}

/// Limit of the pairs of edges' points and boxes.
inline std::int64_t find_edge_pair_limit(const SurfaceShare& share) {
  return std::int64_t{1'000'000} + 4000 * share.total_edges;
}

inline void refuse_too_many_pairs(std::int64_t pairs, std::int64_t limit, double margin) {
  if (pairs <= limit) return;
  throw RunError(fmt::format(
      "contact search found {} pairs of nodes and faces or of edges (capture boxes extend {:.3g} beyond their faces: "
      "nodes cross many faces per step): the run is probably unstable; try a smaller time.step_scale",
      pairs, margin));
}

/// crowded: how many ranks found more pairs than they can number.
inline void refuse_crowded_ranks(std::int64_t crowded) {
  if (crowded == 0) return;
  throw RunError("contact search found more node-face pairs than a rank can hold (1.4e9): use more ranks");
}

}  // namespace percuss
