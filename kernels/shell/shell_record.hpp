#pragma once
// Where the record of a shell holds what.

#include "kernels/core/common_record.hpp"
#include "kernels/element/element_chunks.hpp"
#include "kernels/shell/shell_state.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of ShellState, then point after point the stress xx, yy,
/// xy in the element's frame and the history.
struct ShellRecord : CommonRecord {
  static constexpr int gyration_square = 1, thickness = 2, layers = sizeof(ShellState<double>) / sizeof(double);
  static constexpr int stress_count = 3;
};

/// Scalars that one element's record holds.
constexpr int find_shell_record_size(int points, int history_count) {
  return ShellRecord::layers + points * (ShellRecord::stress_count + history_count);
}

/// Scalars of a point of the shells of a chunk.
KOKKOS_INLINE_FUNCTION int find_layer_size(const ElementChunks& chunks, int c) {
  return (chunks.record_size(c) - ShellRecord::layers) / chunks.points(c);
}

}  // namespace percuss
