#pragma once
// Chunks of wedges and pyramids as their launcher sees them: in the tables of all chunks
// (kernels/element/element_chunks.hpp), of whose eight corners an element takes the first ones.

#include <tuple>

#include "kernels/element/internal_force.hpp"
#include "kernels/one_point/one_point.hpp"
#include "kernels/tet/tet_force.hpp"

namespace percuss {

/// Where things lie in a record, in scalars of one lane: those of OnePointState.
template <class Shape>
struct OnePointRecord {
  static constexpr int mass = 0, viscous_pressure = 1, rotation = 2, stress = 17, log_volume = 23, gap = 24, guard = 25,
                       hourglass = 26, history = hourglass + 3 * Shape::modes;
  /// Scalars that a record holds with so many of history.
  static constexpr int find_size(int count) { return history + count; }
};

/// Chunks of one material of one shape.
template <class Material, class Shape>
struct OnePointBlock {
  Array<int> chunks;                                              // ascending chunk ids
  Kokkos::View<SolidParameters<Material>*, MemSpace> parameters;  // by ElementChunks::parameters
};

template <class List>
struct AllOnePointBlocks;
template <class... Material>
struct AllOnePointBlocks<TypeList<Material...>> {
  using type = std::tuple<OnePointBlock<Material, Wedge6>..., OnePointBlock<Material, Pyramid5>...>;
};
/// Every compiled variant; those that a scene does not use have no chunks and cost nothing.
using OnePointBlocks = AllOnePointBlocks<CompiledMaterials>::type;

/// (1.3) to (1.5): advances every wedge and pyramid of the blocks from n to n+1, none of which averages.
void advance_one_points(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields);

/// The three passes of the mixed form, as those of tetrahedra (kernels/tet/tet_force.hpp), whose averages they share.
void sum_one_point_rates(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                         const TetStep& step, const ChunkResults& results);
void advance_one_point_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                                const TetStep& step, const Array<Real>& state, const ChunkResults& results);
void sum_one_point_forces(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlocks& blocks,
                          const TetStep& step, const ChunkFields& fields);

/// The same for one variant; compiled in files of their own.
template <class Material, class Shape>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
                   const ElementMotion& motion, const ChunkFields& fields);
template <class Material, class Shape>
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
                      const TetStep& step, const Array<Real>& state, const ChunkResults& results);

}  // namespace percuss
