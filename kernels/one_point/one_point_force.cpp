#include "kernels/one_point/one_point_chunks.hpp"

namespace percuss {

void advance_one_points(const ExecSpace& space, const HexChunks& chunks, const OnePointBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields) {
  std::apply([&](const auto&... block) { (advance_block(space, chunks, block, motion, fields), ...); }, blocks);
}

}  // namespace percuss
