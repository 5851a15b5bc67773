#pragma once
// What sees the material of tetrahedra, wedges and pyramids: compiled for each.

#include "kernels/tet/tet_force.hpp"
#include "kernels/tet/tet_packs.hpp"

namespace percuss {

template <class Block>
void advance_stresses_of(const ExecSpace& space, const ElementChunks& chunks, const Block& block, const TetStep& step,
                         const ChunkFields& fields) {
  launch_pass<StressPass<Block>>("percuss::advance_stresses", space, chunks, block, step, fields);
}

template <class Block>
void advance_plain_of(const ExecSpace& space, const ElementChunks& chunks, const Block& block,
                      const ElementMotion& motion, const ChunkFields& fields) {
  launch_elements<SolidBody<Block>>("percuss::advance_plain", space, chunks, block, motion, fields);
}

/// Compiles both for a block.
#define PERCUSS_COMPILE_SOLIDS(...)                                                                                \
  template void advance_stresses_of(const ExecSpace&, const ElementChunks&, const __VA_ARGS__&, const TetStep&,    \
                                    const ChunkFields&);                                                           \
  template void advance_plain_of(const ExecSpace&, const ElementChunks&, const __VA_ARGS__&, const ElementMotion&, \
                                 const ChunkFields&);

}  // namespace percuss
