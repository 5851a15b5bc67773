#pragma once
// Launcher of the part of beams in a step: (1.3) to (1.5) of the paper.
//
// They lie in the tables of all chunks (kernels/element/element_chunks.hpp) and write to the same slots. A beam takes
// the first two of the eight corners there. There are few of them beside solids and shells: lanes are computed one by
// one.

#include "kernels/beam/beam_step.hpp"
#include "kernels/core/common_record.hpp"
#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_motion.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of BeamState, then stress and plastic strain of each
/// fibre, then what else each fibre remembers.
struct BeamRecord : CommonRecord {
  static constexpr int gyration_square = 1, e2 = 2, forces = 5, fibres = 11;
  static constexpr int find_size(int fibre_count, int more_history) {
    return fibres + (2 + more_history) * fibre_count;
  }
  static constexpr int largest = fibres + (1 + most_fibre_history) * most_beam_fibres;
};

/// Chunks of beams.
struct BeamBlock {
  Array<int> chunks;                                   // ascending chunk ids
  Kokkos::View<BeamParameters*, MemSpace> parameters;  // by ElementChunks::parameters
};

/// Advances every beam from n to n+1.
void advance_beams(const ExecSpace& space, const ElementChunks& chunks, const BeamBlock& block,
                   const ElementMotion& motion, const ChunkFields& fields);

}  // namespace percuss
