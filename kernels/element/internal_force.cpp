#include "kernels/element/internal_force.hpp"

namespace percuss {

void advance_elements(const ExecSpace& space, const HexChunks& chunks, const HexBlocks& blocks,
                      const ElementMotion& motion, const Array<Real>& state, const Rows3<double>& slot_force,
                      const ChunkResults& results) {
  std::apply(
      [&](const auto&... block) { (advance_block(space, chunks, block, motion, state, slot_force, results), ...); },
      blocks);
}

}  // namespace percuss
