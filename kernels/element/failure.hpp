#pragma once
// The pass over elements that can fail: after the elements of a step, before its reduction.

#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_lives.hpp"

namespace percuss {

/// What became of this rank's elements in a step.
struct FailureCounts {
  int failing = 0;  // met a criterion
  int died = 0;     // lost the last of their force
};

/// Tests the undamaged elements against the criteria and advances failing ones by one evaluation. results: chunks in
/// which anything changed are no longer settled. Inactive lanes of a pack become copies of an active lane.
FailureCounts find_failures(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements,
                            double dt, const ChunkResults& results);

/// The copies alone, for records from elsewhere.
void copy_into_dead_lanes(const ExecSpace& space, const ElementChunks& chunks, const FailingElements& elements);

}  // namespace percuss
