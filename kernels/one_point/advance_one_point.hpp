#pragma once
// Advances the wedges or pyramids of a chunk, pack by pack, and the chunks of a block in parallel: of the form without
// averages all at once, of the mixed form the second pass.
//
// Sources that include this are compiled with the same options (kernels/one_point/CMakeLists.txt).

#include "kernels/element/solid_packs.hpp"
#include "kernels/one_point/one_point_chunks.hpp"
#include "kernels/tet/tet_packs.hpp"

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
        member, [&](const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
                    SolidSums& sums) { advance_pack(parameters, on, living, of, sums); });
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(block.chunks(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void advance_pack(const SolidParameters<Material>& parameters, const SolidPack& on,
                                    const Living& living, State& of, SolidSums& sums) const {
    Field x, v, f;
    on.fetch_third(0);
    gather_corners<Shape::corners>(on.scratch.nodes, node_record, on.corners, x);
    on.fetch_third(1);
    gather_corners<Shape::corners>(on.scratch.nodes + 4, node_record, on.corners, v);
    on.fetch_third(2);
    OnePointResult<Lanes> result = advance_one_point(parameters, x, v, Lanes(motion.dt), of, f);
    if (living.can_fail()) settle(living, result, f);
    scatter_corners<Shape::corners>(f, on.corners, on.lanes, on.scratch.forces);
    sums.take_work(result.work, on.lanes);
    on.take_step(result.stable_step, result.volume, sums);
    on.leave_bound(motion.watch, result.stable_step);
  }

  static PERCUSS_FORCE_INLINE void settle(const Living& living, OnePointResult<Lanes>& result, Field& f) {
    const Lanes share = living.take_force_share(result.stable_step, result.volume);
    settle_forces<Shape::corners>(share, f);
    living.take_work(share, result.work);
    settle_step(share, result.stable_step, result.volume);
  }
};

/// Second pass of the mixed form.
template <class Material, class Shape>
struct AdvanceOnePointStresses : StressPass<Material, OnePointBlock<Material, Shape>> {
  using Base = StressPass<Material, OnePointBlock<Material, Shape>>;
  using Base::chunks;
  using Base::launch;
  using Base::motion;
  using typename Base::Living;
  using typename Base::Scratch;
  using State = OnePointState<Lanes, Material, Shape>;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->template advance_chunk<State, false>(
        member,
        [&](const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
            SolidSums& sums, const Scratch& scratch) { leave_pack(parameters, on, living, of, sums, scratch); });
  }

  KOKKOS_FUNCTION void leave_pack(const SolidParameters<Material>& parameters, const SolidPack& on,
                                  const Living& living, State& of, SolidSums& sums, const Scratch& scratch) const {
    CornerField<Lanes, Shape> x, v;
    on.fetch_third(0);
    gather_corners<Shape::corners>(scratch.nodes, node_record, on.corners, x);
    on.fetch_third(1);
    gather_corners<Shape::corners>(scratch.nodes + 4, node_record, on.corners, v);
    on.fetch_third(2);
    const Lanes dt(motion.dt), zero(0.0);
    const OnePointMotion<Lanes, Shape> own = follow_one_point(x, v, dt);
    const Symmetric3<Lanes> mean = TetGather{scratch.means}.template find_mean<Shape::corners>(on.corners);
    OnePointPoint<Lanes, Shape> point = advance_point<true>(parameters, x, own, blend(own.d, mean), dt, of);
    Lanes share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(Lanes(1e300), point.geometry.volume);
      living.take_work(share, point.work);
    }
    sums.take_work(point.work, on.lanes);
    const Lanes guard = find_guard_modulus(of.guard, parameters.lambda + 2.0 / 3.0 * parameters.mu);
    double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    store_pack(scalars + TetPasses::shear * solid_width, point.own.mu);
    store_pack(scalars + TetPasses::tangent * solid_width, point.own.tangent);
    store_pack(scalars + TetPasses::guard_modulus * solid_width, guard);
    store_pack(scalars + TetPasses::hourglass * solid_width, point.own.hourglass);
    OwnStress(point.stress, of.guard, of.viscous_pressure).leave(scalars);
    // Their mass is not shared with others.
    GivenStress::leave<Shape::corners>({share * add_to_diagonal(point.stress, zero - of.guard),
                                        point.own.lambda + Lanes(2.0 / 3.0) * point.own.mu + guard, point.own.mu},
                                       point.geometry.volume, !(share < zero), zero, {zero, zero, zero, zero},
                                       scratch.find_given(on.pack));
  }
};

template <class Material, class Shape>
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
                      const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  if constexpr (!is_single_precision) {
    launch_pass("percuss::advance_one_point_stresses", space, chunks, block.chunks,
                AdvanceOnePointStresses<Material, Shape>{{chunks, block, step.motion, step.launch, state, results}});
  }
}

template <class Material, class Shape>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const OnePointBlock<Material, Shape>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  if constexpr (!is_single_precision) {
    static_assert(sizeof(OnePointState<double, Elastic, Shape>) ==
                  OnePointRecord<Shape>::find_size(0) * sizeof(double));
    launch_solids("percuss::advance_one_points", space, chunks, block.chunks,
                  AdvanceOnePoints<Material, Shape>{{chunks, block, motion, fields}});
  }
}

/// Compiles both shapes for a material.
#define PERCUSS_COMPILE_ONE_POINT(MATERIAL, SHAPE)                                                              \
  template void advance_block(const ExecSpace&, const ElementChunks&, const OnePointBlock<MATERIAL, SHAPE>&,    \
                              const ElementMotion&, const ChunkFields&);                                        \
  template void advance_stresses(const ExecSpace&, const ElementChunks&, const OnePointBlock<MATERIAL, SHAPE>&, \
                                 const TetStep&, const Array<Real>&, const ChunkResults&);
#define PERCUSS_COMPILE_ONE_POINTS(MATERIAL)  \
  PERCUSS_COMPILE_ONE_POINT(MATERIAL, Wedge6) \
  PERCUSS_COMPILE_ONE_POINT(MATERIAL, Pyramid5)

}  // namespace percuss
