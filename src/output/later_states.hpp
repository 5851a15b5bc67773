#pragma once
// Content of result files after the point of a restart.

#include <cstdint>
#include <vector>

namespace percuss {

/// A row of the history, or a frame of the fields.
struct SavedState {
  double time = 0;
  std::int64_t step = 0;
};

using LaterStates = std::vector<SavedState>;

/// Relative; times that are this near are one.
inline constexpr double same_time = 1e-12;

}  // namespace percuss
