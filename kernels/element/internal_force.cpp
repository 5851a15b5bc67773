#include "kernels/element/internal_force.hpp"

namespace percuss {

void advance_elements(const ExecSpace& space, const ElementChunks& chunks, const HexBlocks& blocks,
                      const ElementMotion& motion, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (advance_block(space, chunks, block, motion, fields), ...); }, blocks);
}

}  // namespace percuss
