#pragma once
// Advances the wedges or pyramids of a chunk, pack by pack, and the chunks of a block in parallel.
//
// Sources that include this are compiled with the same options (kernels/one_point/CMakeLists.txt).

#include "kernels/element/solid_packs.hpp"
#include "kernels/one_point/one_point_chunks.hpp"

namespace percuss {

template <class Material, class Shape>
struct AdvanceOnePoints {
  using Living = LivingSolids<Material>;
  using State = OnePointState<Lanes, Material, Shape>;
  using Field = CornerField<Lanes, Shape>;
  HexChunks chunks;
  OnePointBlock<Material, Shape> block;
  ElementMotion motion;
  Array<Real> state;
  Rows3<double> slot_force;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const SolidChunk chunk(chunks, block.chunks(member.league_rank()));
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_nodes(motion, scratch.nodes);
    for (int s = 0; s < chunk.slot_count; ++s) clear_record(scratch.forces + force_record * s);
    HexParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    parameters.time = motion.time;
    SolidChunkSums sums;
    Living living(motion.failing, motion.lives, chunk.c);
    const auto size = static_cast<std::size_t>(chunks.record_size(chunk.c)) * solid_width;
    Real* record = &state(chunks.first_state(chunk.c));
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      auto& of_pack = *reinterpret_cast<State*>(record + size * static_cast<std::size_t>(pack));
      if (living.can_fail() && !living.take_pack(corners)) return;
      advance_pack(parameters, {chunk, pack, lanes, corners, scratch}, living, of_pack, sums);
    });
    sums.leave_work(chunk.c, results);
    sums.leave_step(chunk.c, chunk.first_element, results);
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(chunk.c) = 0;
    copy_force_rows(scratch.forces, chunk.slot_count, &slot_force(chunk.first_slot, 0));
  }

  struct Work {
    const SolidChunk& chunk;
    int pack, lanes;
    const std::uint16_t* corners;
    const SolidScratch& scratch;
  };

  KOKKOS_FUNCTION void advance_pack(const HexParameters<Material>& parameters, const Work& on, const Living& living,
                                    State& of, SolidChunkSums& sums) const {
    Field x, v, f;
    gather_corners<Shape::corners>(on.scratch.nodes, node_record, on.corners, x);
    gather_corners<Shape::corners>(on.scratch.nodes + 4, node_record, on.corners, v);
    OnePointResult<Lanes> result = advance_one_point(parameters, x, v, Lanes(motion.dt), of, f);
    if (living.can_fail()) settle(living, result, f);
    scatter_corners<Shape::corners>(f, on.corners, on.lanes, on.scratch.forces);
    sums.take_work(0, result.work.internal, on.lanes);
    sums.take_work(1, result.work.hourglass, on.lanes);
    sums.take_work(2, result.work.viscous, on.lanes);
    sums.take_step(result.stable_step, result.volume, on.chunk.first_element + on.pack * solid_width, on.lanes);
    if (motion.watch.bound.extent(0) > 0)
      store_pack(&motion.watch.bound(static_cast<std::size_t>(chunks.first_pack(on.chunk.c) + on.pack) * solid_width),
                 result.stable_step);
  }

  /// Forces and work by the shares of the lanes; nothing from inactive lanes and from those that must stop.
  static PERCUSS_FORCE_INLINE void settle(const Living& living, OnePointResult<Lanes>& result, Field& f) {
    const Lanes zero(0.0), share = living.take_force_share(result.stable_step, result.volume);
    const auto lives = !(share < zero);
    for (int i = 0; i < Shape::corners; ++i)
      f[i] = {select(lives, share * f[i].x, zero), select(lives, share * f[i].y, zero),
              select(lives, share * f[i].z, zero)};
    living.take_work(share, 0, result.work.internal);
    living.take_work(share, 1, result.work.hourglass);
    living.take_work(share, 2, result.work.viscous);
    result.stable_step = select(lives, result.stable_step, Lanes(1e300));
    result.volume = select(lives, result.volume, Lanes(1.0));
  }
};

template <class Material, class Shape>
void advance_block(const ExecSpace& space, const HexChunks& chunks, const OnePointBlock<Material, Shape>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  if constexpr (!is_single_precision) {
    static_assert(sizeof(OnePointState<double, Elastic, Shape>) ==
                  OnePointRecord<Shape>::find_size(0) * sizeof(double));
    launch_solids(
        "percuss::advance_one_points", space, chunks, block.chunks,
        AdvanceOnePoints<Material, Shape>{chunks, block, motion, fields.state, fields.slot_force, fields.results});
  }
}

/// Compiles both shapes for a material.
#define PERCUSS_COMPILE_ONE_POINTS(MATERIAL)                                                                \
  template void advance_block(const ExecSpace&, const HexChunks&, const OnePointBlock<MATERIAL, Wedge6>&,   \
                              const ElementMotion&, const ChunkFields&);                                    \
  template void advance_block(const ExecSpace&, const HexChunks&, const OnePointBlock<MATERIAL, Pyramid5>&, \
                              const ElementMotion&, const ChunkFields&);

}  // namespace percuss
