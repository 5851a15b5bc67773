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
  using State = TetState<Lanes, Material>;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->template advance_chunk<State>(
        member, [&](const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living, State& of,
                    ChunkSums& sums) { add_pack(parameters, on, living, of, sums); });
  }

  KOKKOS_FUNCTION void add_pack(const SolidParameters<Material>& parameters, const SolidPack& on, const Living& living,
                                State& of, ChunkSums& sums) const {
    TetCorners<Lanes> x, v;
    on.fetch_third(0);
    gather_corners<4>(on.scratch.nodes, node_record, on.corners, x);
    gather_corners<4>(on.scratch.nodes + 4, node_record, on.corners, v);
    const Lanes dt(motion.dt), zero(0.0);
    const TetMotion<Lanes> own = follow_tet(x, v, dt);
    const TetGather gather{launch.passes.rates.data(), TetSums::rate_row,
                           &launch.nodes.slots_to_records(on.chunk.first_slot)};
    const Symmetric3<Lanes> seen = blend(own.d, gather.find_mean<4>(on.corners));
    on.fetch_third(1);
    TetPoint<Lanes> point = advance_tet4<true>(parameters, x, own, seen, dt, of);
    on.fetch_third(2);
    Lanes share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(Lanes(1e300), point.geometry.volume);
      living.take_work(share, WorkKind::internal, point.work.internal);
      living.take_work(share, WorkKind::viscous, point.work.viscous);
      living.take_work(share, WorkKind::folding, point.work.guard);
    }
    sums.take_work(WorkKind::internal, point.work.internal, on.lanes);
    sums.take_work(WorkKind::viscous, point.work.viscous, on.lanes);
    sums.take_work(WorkKind::folding, point.work.guard, on.lanes);
    const Lanes guard_modulus = find_guard_modulus(of.guard, parameters.lambda + 2.0 / 3.0 * parameters.mu);
    double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    store_pack(scalars + TetPasses::shear * solid_width, point.own.shear);
    store_pack(scalars + TetPasses::tangent * solid_width, point.own.tangent);
    store_pack(scalars + TetPasses::guard_modulus * solid_width, guard_modulus);
    OwnStress(point.stress, of.guard, of.viscous_pressure).leave(scalars);
    const Symmetric3<Lanes> given = add_to_diagonal(point.stress, zero - of.guard);
    give(on, point, share * given, of.mass, point.own.bulk + guard_modulus, !(share < zero));
  }

  /// What the elements of a pack give to their nodes.
  template <class Mask>
  KOKKOS_FUNCTION void give(const SolidPack& on, const TetPoint<Lanes>& point, const Symmetric3<Lanes>& stress,
                            const Lanes& mass, const Lanes& bulk, const Mask& lives) const {
    const Lanes zero(0.0), quarter(0.25);
    const auto given = give_stress<4>(point.geometry.volume, lives);
    const auto& counts = given.counts;
    LaneRows low, high, of_corner[4];
    given.set(stress, bulk, low, high);
    const Lanes shear = given.weigh(point.own.shear), share = select(counts, quarter * mass, zero);
    for (int i = 0; i < 4; ++i) {
      const Vector3<Lanes>& b = point.geometry.b[i];
      of_corner[i].set(shear, share, select(counts, dot(b, b) / point.geometry.volume, zero), zero);
    }
    double* const rows = this->find_rows(on.chunk);
    for (int lane = 0; lane < on.lanes; ++lane) {
      for (int i = 0; i < 4; ++i) {
        double* const row = rows + TetSums::stress_row * static_cast<std::size_t>(on.corners[i * solid_width + lane]);
        add_record(low.row[lane], row);
        add_record(high.row[lane], row + 4);
        add_record(of_corner[i].row[lane], row + 8);
      }
    }
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
                    ChunkSums& sums) { advance_pack(parameters, on, living, of, sums); });
    const StepWatch& watch = this->motion.watch;
    if (watch.bound.extent(0) > 0) watch.growth(this->block.chunks(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void advance_pack(const SolidParameters<Material>& parameters, const SolidPack& on,
                                    const Living& living, State& of, ChunkSums& sums) const {
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
      living.take_work(share, WorkKind::internal, point.work.internal);
      living.take_work(share, WorkKind::viscous, point.work.viscous);
      settle_step(share, step, volume);
    }
    scatter_corners<4>(f, on.corners, on.lanes, on.scratch.forces);
    sums.take_work(WorkKind::internal, point.work.internal, on.lanes);
    sums.take_work(WorkKind::viscous, point.work.viscous, on.lanes);
    sums.take_work(WorkKind::folding, point.work.guard, on.lanes);
    on.take_step(step, volume, sums);
    on.leave_bound(this->motion.watch, step);
  }
};

template <class Material>
void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlock<Material>& block,
                      const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  if constexpr (!is_single_precision) {
    static_assert(sizeof(TetState<double, Elastic>) == TetRecord::find_size(0) * sizeof(double));
    launch_solids("percuss::advance_tet_stresses", space, chunks, block.chunks,
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
