#pragma once
// Launchers of the tetrahedra's part of a step: (1.3) to (1.5) of the paper.
//
// The mixed form has three passes with a swap of slots after each of the first two: rates to the nodes; stresses of the
// averaged rates to the nodes; forces of the averaged stresses. The plain form has one.

#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

/// What a pass reads besides chunks and records.
struct TetStep {
  ElementMotion motion;
  TetLaunch launch;
};

/// First pass: passes.slot_rates of these chunks. results: of the step before; settled chunks that rest keep their
/// rows.
void sum_tet_rates(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                   const ChunkResults& results);

/// Nodes average what their elements have given: passes.rates.
void average_tet_rates(const ExecSpace& space, const TetLaunch& launch);

/// Second pass: advances stress and history from n to n+1, and books the work. state: element records, in and out.
/// results: work is added to, and is_settled is out. Fills passes.slot_stresses, passes.elements and passes.is_left.
void advance_tet_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                          const TetStep& step, const Array<Real>& state, const ChunkResults& results);

/// passes.stresses from what the elements have given.
void average_tet_stresses(const ExecSpace& space, const TetLaunch& launch);

/// Third pass. slot_force: out, the chunk's share of the force on its nodes (minus the internal force). results: out,
/// except for work.
void sum_tet_forces(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                    const ChunkFields& fields);

/// The plain form, all of it.
void advance_plain_tets(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields);

/// The same for one material; compiled in files of their own.
template <class Material>
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlock<Material>& block,
                      const TetStep& step, const Array<Real>& state, const ChunkResults& results);
template <class Material>
void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const TetBlock<Material>& block,
                   const ElementMotion& motion, const ChunkFields& fields);

}  // namespace percuss
