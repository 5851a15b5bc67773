#pragma once
// Chunks of wedges and pyramids as their launcher sees them: in the tables of all chunks
// (kernels/element/hex_chunks.hpp), of whose eight corners an element takes the first ones.

#include <tuple>

#include "kernels/element/internal_force.hpp"
#include "kernels/element/one_point/one_point.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of OnePointState.
template <class Shape>
struct OnePointRecord {
  static constexpr int mass = 0, viscous_pressure = 1, rotation = 2, stress = 17, hourglass = 23,
                       history = hourglass + 3 * Shape::modes;
  /// Scalars that a record holds with so many of history.
  static constexpr int find_size(int count) { return history + count; }
};

/// Chunks of one material of one shape.
template <class Material, class Shape>
struct OnePointBlock {
  Array<int> chunks;                                            // ascending chunk ids
  Kokkos::View<HexParameters<Material>*, MemSpace> parameters;  // by HexChunks::parameters
};

template <class List>
struct AllOnePointBlocks;
template <class... Material>
struct AllOnePointBlocks<TypeList<Material...>> {
  using type = std::tuple<OnePointBlock<Material, Wedge6>..., OnePointBlock<Material, Pyramid5>...>;
};
/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using OnePointBlocks = AllOnePointBlocks<CompiledMaterials>::type;

/// (1.3) to (1.5): advances every wedge and pyramid of the blocks from n to n+1.
void advance_one_points(const ExecSpace& space, const HexChunks& chunks, const OnePointBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields);

/// The same for one variant; compiled in files of their own.
template <class Material, class Shape>
void advance_block(const ExecSpace& space, const HexChunks& chunks, const OnePointBlock<Material, Shape>& block,
                   const ElementMotion& motion, const ChunkFields& fields);

}  // namespace percuss
