#pragma once
// Chunks of wedges and pyramids as their launcher sees them: in the tables of all chunks
// (kernels/element/element_chunks.hpp), of whose eight corners an element takes the first ones.

#include <tuple>

#include "kernels/core/common_record.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/one_point/one_point.hpp"
#include "kernels/tet/tet_force.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of OnePointState.
template <class Shape>
struct OnePointRecord : SolidRecord {
  static constexpr int log_volume = 23, gap = 24, guard = 25, hourglass = 26, history = hourglass + 3 * Shape::modes;
  /// Scalars that a record holds with so many of history.
  static constexpr int find_size(int count) { return history + count; }
};

/// Chunks of one material of one shape, and what a pack of them works with.
template <class M, class Shape_>
struct OnePointBlock : SolidBlock<M> {
  using Shape = Shape_;
  using State = OnePointState<Pack<double>, M, Shape>;
  using Field = CornerField<Pack<double>, Shape>;
};

template <class List>
struct AllOnePointBlocks;
template <class... Material>
struct AllOnePointBlocks<TypeList<Material...>> {
  using type = std::tuple<OnePointBlock<Material, Wedge6>..., OnePointBlock<Material, Pyramid5>...>;
};
/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using OnePointBlocks = AllOnePointBlocks<CompiledMaterials>::type;

/// The plain form and the three passes of the mixed form, as of tetrahedra (kernels/tet/tet_force.hpp), whose averages
/// these share.
void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                   const ElementMotion& motion, const ChunkFields& fields);
void sum_rates(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks, const TetStep& step,
               const ChunkFields& fields);
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                      const TetStep& step, const ChunkFields& fields);
void sum_forces(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks, const TetStep& step,
                const ChunkFields& fields);

}  // namespace percuss
