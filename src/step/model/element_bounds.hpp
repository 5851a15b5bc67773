#pragma once
// The stable step of each element, which the launchers write for who gives elements mass.

#include <vector>

#include "kernels/element/element_motion.hpp"
#include "kernels/element/element_records.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

struct ElementBounds {
  explicit ElementBounds(const Model& model);

  ElementChunks chunks;
  StepWatch watch;       // of solids, by lane
  Array<double> others;  // [elements] of shells and beams; empty: there are none

  /// Bound of element i of chunk c; 0: not evaluated, as in rigid parts.
  KOKKOS_INLINE_FUNCTION double operator()(int c, int i) const {
    if (!is_shell(chunks, c) && !is_beam(chunks, c)) return static_cast<double>(watch.bound(number_lane(chunks, c, i)));
    return others.extent(0) > 0 ? others(chunks.first_element(c) + i) : 0;
  }

  /// [elements] of this rank, on the host.
  std::vector<double> list() const;
};

}  // namespace percuss
