#pragma once
// Launchers of the tetrahedra's part of a step: (1.3) to (1.5) of the paper.
//
// The mixed form has three passes with a swap of slots after each of the first two: rates to the nodes; stresses of the
// averaged rates to the nodes; forces of the averaged stresses. The plain form has one.

#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

/// Inputs of a pass besides chunks and records.
struct TetStep {
  ElementMotion motion;
  TetLaunch launch;
};

/// First pass: passes.slot_rates of these chunks. Settled chunks that rest, by the results of the step before, keep
/// their rows.
void sum_rates(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
               const ChunkFields& fields);

/// Nodes average what their elements have given: passes.rates.
void average_tet_rates(const ExecSpace& space, const TetLaunch& launch);

/// Second pass: advances stress and history from n to n+1, and books the work. Of the results work is added to, and
/// is_settled is out. Fills passes.slot_stresses, passes.elements and passes.is_left.
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                      const ChunkFields& fields);

/// passes.stresses from what the elements have given.
void average_tet_stresses(const ExecSpace& space, const TetLaunch& launch);

/// Third pass. fields: out, except for work.
void sum_forces(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                const ChunkFields& fields);

/// The plain form, all of it.
void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                   const ElementMotion& motion, const ChunkFields& fields);

/// Advances the stresses of one block; compiled for each material.
template <class Block>
void advance_stresses_of(const ExecSpace& space, const ElementChunks& chunks, const Block& block, const TetStep& step,
                         const ChunkFields& fields);
template <class Block>
void advance_plain_of(const ExecSpace& space, const ElementChunks& chunks, const Block& block,
                      const ElementMotion& motion, const ChunkFields& fields);

/// Calls run(block) for each block of a tuple.
template <class Blocks, class Run>
void for_each_block(const Blocks& blocks, const Run& run) {
  std::apply([&](const auto&... block) { (run(block), ...); }, blocks);
}

}  // namespace percuss
