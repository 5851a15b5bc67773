#pragma once
// When a search has found more pairs than come from a sound motion (a runaway node makes every box hold every node).

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "src/contact/surface_share.hpp"
#include "src/error.hpp"

namespace percuss {

/// Most pairs of a node and a face on all ranks together.
inline std::int64_t find_pair_limit(const SurfaceShare& share) {
  constexpr std::int64_t most_indexed = 1'400'000'000;  // pairs are numbered by int, and memory grows by half
  return std::min(std::int64_t{1'000'000} + 2000 * share.total_nodes, most_indexed);
}

inline void refuse_too_many_pairs(std::int64_t pairs, std::int64_t limit, double margin) {
  if (pairs <= limit) return;
  throw RunError(fmt::format(
      "contact search found {} pairs of a node and a face (capture boxes are {:.3g} wide beyond their faces: "
      "nodes move many faces a step) is the run unstable? try a smaller time.step_scale",
      pairs, margin));
}

}  // namespace percuss
