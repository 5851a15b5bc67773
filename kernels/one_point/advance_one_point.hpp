#pragma once
// Advances the wedges or pyramids of a chunk, pack by pack, and the chunks of a block in parallel.
//
// Sources that include this are compiled with the same options (kernels/one_point/CMakeLists.txt).

#include "kernels/element/solid_packs.hpp"
#include "kernels/one_point/one_point_chunks.hpp"

namespace percuss {

template <class Material, class Shape>
struct AdvanceOnePoints : SolidKernel<Material, OnePointBlock<Material, Shape>> {
  using Base = SolidKernel<Material, OnePointBlock<Material, Shape>>;
  using Base::block;
  using Base::chunks;
  using Base::motion;
  using typename Base::Living;
  using State = OnePointState<Lanes, Material, Shape>;
  using Field = CornerField<Lanes, Shape>;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->template advance_chunk<State>(
        member, [&](const HexParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
                    SolidChunkSums& sums) { advance_pack(parameters, on, living, of, sums); });
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(block.chunks(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void advance_pack(const HexParameters<Material>& parameters, const SolidPack& on,
                                    const Living& living, State& of, SolidChunkSums& sums) const {
    Field x, v, f;
    gather_corners<Shape::corners>(on.scratch.nodes, node_record, on.corners, x);
    gather_corners<Shape::corners>(on.scratch.nodes + 4, node_record, on.corners, v);
    OnePointResult<Lanes> result = advance_one_point(parameters, x, v, Lanes(motion.dt), of, f);
    if (living.can_fail()) settle(living, result, f);
    scatter_corners<Shape::corners>(f, on.corners, on.lanes, on.scratch.forces);
    sums.take_work(0, result.work.internal, on.lanes);
    sums.take_work(1, result.work.hourglass, on.lanes);
    sums.take_work(2, result.work.viscous, on.lanes);
    sums.take_step(result.stable_step, result.volume, on.first_element(), on.lanes);
    if (motion.watch.bound.extent(0) > 0) {
      const auto pack = static_cast<std::size_t>(chunks.first_pack(on.chunk.c) + on.pack);
      store_pack(&motion.watch.bound(pack * solid_width), result.stable_step);
    }
  }

  static PERCUSS_FORCE_INLINE void settle(const Living& living, OnePointResult<Lanes>& result, Field& f) {
    const Lanes share = living.take_force_share(result.stable_step, result.volume);
    settle_forces<Shape::corners>(share, f);
    living.take_work(share, 0, result.work.internal);
    living.take_work(share, 1, result.work.hourglass);
    living.take_work(share, 2, result.work.viscous);
    settle_step(share, result.stable_step, result.volume);
  }
};

template <class Material, class Shape>
void advance_block(const ExecSpace& space, const HexChunks& chunks, const OnePointBlock<Material, Shape>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  if constexpr (!is_single_precision) {
    static_assert(sizeof(OnePointState<double, Elastic, Shape>) ==
                  OnePointRecord<Shape>::find_size(0) * sizeof(double));
    launch_solids("percuss::advance_one_points", space, chunks, block.chunks,
                  AdvanceOnePoints<Material, Shape>{{chunks, block, motion, fields}});
  }
}

/// Compiles both shapes for a material.
#define PERCUSS_COMPILE_ONE_POINTS(MATERIAL)                                                                \
  template void advance_block(const ExecSpace&, const HexChunks&, const OnePointBlock<MATERIAL, Wedge6>&,   \
                              const ElementMotion&, const ChunkFields&);                                    \
  template void advance_block(const ExecSpace&, const HexChunks&, const OnePointBlock<MATERIAL, Pyramid5>&, \
                              const ElementMotion&, const ChunkFields&);

}  // namespace percuss
