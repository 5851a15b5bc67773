#pragma once
// The pass over beams that can fail: after that of other elements, which also brings failed ones nearer to death.

#include "kernels/beam/beam_force.hpp"
#include "kernels/element/failure.hpp"

namespace percuss {

/// Inputs of the failure pass over beams.
struct JudgedBeams {
  Kokkos::View<BeamParameters*, MemSpace> parameters;  // of BeamBlock
  double time = 0;                                     // at n+1
};

/// Tests the undamaged beams. results: chunks in which anything changed are no longer settled.
FailureCounts find_beam_failures(const ExecSpace& space, const ElementChunks& chunks, const JudgedBeams& beams,
                                 const FailingElements& elements, const ChunkResults& results);

}  // namespace percuss
