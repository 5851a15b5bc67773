#pragma once
// The passes over tetrahedra that see the material, compiled for each (advance_tets_*.cpp name them).

#include "kernels/tet/tet_force.hpp"
#include "kernels/tet/tet_packs.hpp"

namespace percuss {

/// Second pass of the mixed form.
template <class Material>
struct AdvanceTetStresses : StressPass<Material, TetBlock<Material>> {
  using Base = StressPass<Material, TetBlock<Material>>;
  using Base::chunks;
  using Base::launch;
  using Base::motion;
  using typename Base::Living;
  using typename Base::Scratch;
  using State = TetState<Lanes, Material>;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->template advance_chunk<State, true>(
        member,
        [&](const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
            SolidSums& sums, const Scratch& scratch) { leave_pack(parameters, on, living, of, sums, scratch); });
  }

  KOKKOS_FUNCTION void leave_pack(const SolidParameters<Material>& parameters, const SolidPack& on,
                                  const Living& living, State& of, SolidSums& sums, const Scratch& scratch) const {
    TetCorners<Lanes> x, v;
    on.fetch_third(0);
    gather_corners<4>(scratch.nodes, node_record, on.corners, x);
    gather_corners<4>(scratch.nodes + 4, node_record, on.corners, v);
    const Lanes dt(motion.dt), zero(0.0);
    const TetMotion<Lanes> own = follow_tet(x, v, dt);
    const Symmetric3<Lanes> seen = blend(own.d, TetGather{scratch.means}.find_mean<4>(on.corners));
    on.fetch_third(1);
    TetPoint<Lanes> point = advance_tet4<true>(parameters, x, own, seen, dt, of);
    on.fetch_third(2);
    Lanes share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(Lanes(1e300), point.geometry.volume);
      living.take_work(share, point.work);
    }
    sums.take_work(point.work, on.lanes);
    const Lanes guard_modulus = find_guard_modulus(of.guard, parameters.lambda + 2.0 / 3.0 * parameters.mu);
    double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    store_pack(scalars + TetPasses::shear * solid_width, point.own.shear);
    store_pack(scalars + TetPasses::tangent * solid_width, point.own.tangent);
    store_pack(scalars + TetPasses::guard_modulus * solid_width, guard_modulus);
    OwnStress(point.stress, of.guard, of.viscous_pressure).leave(scalars);
    const TetMeans<Lanes> given{share * add_to_diagonal(point.stress, zero - of.guard), point.own.bulk + guard_modulus,
                                point.own.shear};
    Lanes square[4];
    for (int i = 0; i < 4; ++i) square[i] = dot(point.geometry.b[i], point.geometry.b[i]) / point.geometry.volume;
    GivenStress::leave<4>(given, point.geometry.volume, !(share < zero), Lanes(0.25) * of.mass, square,
                          scratch.find_given(on.pack));
  }
};

/// The plain form.
template <class Material>
struct AdvancePlainTets : SolidKernel<Material, TetBlock<Material>> {
  using Base = SolidKernel<Material, TetBlock<Material>>;
  using typename Base::Living;
  using State = TetState<Lanes, Material>;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->template advance_chunk<State>(
        member, [&](const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
                    SolidSums& sums) { advance_pack(parameters, on, living, of, sums); });
    const StepWatch& watch = this->motion.watch;
    if (watch.bound.extent(0) > 0) watch.growth(this->block.chunks(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void advance_pack(const SolidParameters<Material>& parameters, const SolidPack& on,
                                    const Living& living, State& of, SolidSums& sums) const {
    TetCorners<Lanes> x, v;
    on.fetch_third(0);
    gather_corners<4>(on.scratch.nodes, node_record, on.corners, x);
    gather_corners<4>(on.scratch.nodes + 4, node_record, on.corners, v);
    on.fetch_third(1);
    const Lanes dt(this->motion.dt), zero(0.0);
    const TetMotion<Lanes> own = follow_tet(x, v, dt);
    TetPoint<Lanes> point = advance_tet4<false>(parameters, x, own, own.d, dt, of);
    on.fetch_third(2);
    Lanes step = find_plain_step(point.geometry, of.mass, point.own), volume = point.geometry.volume;
    TetCorners<Lanes> f = find_tet_forces(point.geometry, add_to_diagonal(point.stress, zero - of.viscous_pressure));
    if (living.can_fail()) {
      const Lanes share = living.take_force_share(step, volume);
      settle_forces<4>(share, f);
      living.take_work(share, point.work);
      settle_step(share, step, volume);
    }
    scatter_corners<4>(f, on.corners, on.lanes, on.scratch.forces);
    sums.take_work(point.work, on.lanes);
    on.take_step(step, volume, sums);
    on.leave_bound(this->motion.watch, step);
  }
};

template <class Material>
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlock<Material>& block,
                      const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  if constexpr (!is_single_precision) {
    static_assert(sizeof(TetState<double, Elastic>) == TetRecord::find_size(0) * sizeof(double));
    launch_pass("percuss::advance_tet_stresses", space, chunks, block.chunks,
                AdvanceTetStresses<Material>{{chunks, block, step.motion, step.launch, state, results}});
  }
}

template <class Material>
void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const TetBlock<Material>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  if constexpr (!is_single_precision) {
    launch_solids("percuss::advance_plain_tets", space, chunks, block.chunks,
                  AdvancePlainTets<Material>{{chunks, block, motion, fields}});
  }
}

/// Compiles both for a material.
#define PERCUSS_COMPILE_TETS(MATERIAL)                                                                                 \
  template void advance_stresses(const ExecSpace&, const ElementChunks&, const TetBlock<MATERIAL>&, const TetStep&,    \
                                 const Array<Real>&, const ChunkResults&);                                             \
  template void advance_plain(const ExecSpace&, const ElementChunks&, const TetBlock<MATERIAL>&, const ElementMotion&, \
                              const ChunkFields&);

}  // namespace percuss
