#include "kernels/tet/tet_force.hpp"

#include "kernels/tet/tet_packs.hpp"

namespace percuss {

namespace {

/// Third pass. L: Lanes.
template <class L>
struct FindForces : ForcePass<L> {
  using Base = ForcePass<L>;
  using Base::chunks;
  using Base::fields;
  using Base::launch;
  using Base::motion;
  using typename Base::Living;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->sum_chunk(member,
                    [&](const SolidPack& on, const Living& living, ChunkSums& sums) { add_pack(on, living, sums); });
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(this->list(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void add_pack(const SolidPack& on, const Living& living, ChunkSums& sums) const {
    TetCorners<Lanes> x;
    gather_corners<4>(on.scratch.nodes, node_record, on.corners, x);
    const TetGeometry<Lanes> g = find_tet_geometry(x);
    const TetMeans<Lanes> means = this->gather_stresses(on.chunk).template find_means<4>(on.corners);
    const double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    const auto load = [&](int k) { return load_pack(scalars + k * solid_width); };
    const TetStiffness<Lanes> own{Lanes(0.0), load(TetPasses::shear), load(TetPasses::tangent)};
    const Lanes step = find_mixed_step(g, means, mix_moduli(own, means, load(TetPasses::guard_modulus)));
    settle(on, means, g, step, living, sums);
  }

  /// Forces by the shares of the lanes; others' stresses act in full on a lane that lives.
  KOKKOS_FUNCTION void settle(const SolidPack& on, const TetMeans<Lanes>& means, const TetGeometry<Lanes>& g,
                              Lanes step, const Living& living, ChunkSums& sums) const {
    OwnStress own(find_scalars(chunks, launch.passes, on.chunk.c, on.pack));
    Lanes volume = g.volume, share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(step, volume);
      own.scale(share);
    }
    TetCorners<Lanes> f =
        find_tet_forces(g, find_mixed_stress(own.stress, means.stress, own.guard, own.viscous_pressure));
    if (living.can_fail()) {
      settle_forces<4>(select(share < Lanes(0.0), share, Lanes(1.0)), f);
      settle_step(share, step, volume);
    }
    scatter_corners<4>(f, on.corners, on.lanes, on.scratch.forces);
    on.take_step(step, volume, sums);
    on.leave_bound(motion.watch, step);
  }
};

/// Sum over the slots of a record in their order.
template <int Size>
struct SlotSum {
  double value[Size];

  template <class Rows>
  KOKKOS_FUNCTION SlotSum(const TetNodes& nodes, const Rows& rows, int record) {
    for (int k = 0; k < Size; ++k) value[k] = 0;
    const int last = static_cast<int>(nodes.slots.extent(0)) - 1;
    for (int i = nodes.first(record); i < nodes.first(record + 1); ++i) {
      const double* const ahead = &rows(nodes.slots(i + node_rows_ahead < last ? i + node_rows_ahead : last), 0);
      fetch_ahead(ahead);
      fetch_ahead(ahead + Size - 1);
      const double* const row = &rows(nodes.slots(i), 0);
      for (int k = 0; k < Size; ++k) value[k] += row[k];
    }
  }
};

template <class Run>
void for_each_block(const TetBlocks& blocks, const Run& run) {
  std::apply([&](const auto&... block) { (run(block), ...); }, blocks);
}

}  // namespace

TetPasses make_tet_passes(const TetNodes& nodes, const ElementChunks& chunks, int slot_count) {
  const auto slots = static_cast<std::size_t>(slot_count), records = static_cast<std::size_t>(nodes.count);
  const auto packs = chunks.corner_slots.extent(0) / (8 * pack_size<Real>);
  return {TetRateRows("percuss::tet_slot_rates", slots),
          TetStressRows("percuss::tet_slot_stresses", slots),
          TetRateRows("percuss::tet_rates", records),
          TetStressRows("percuss::tet_stresses", records),
          Array<double>("percuss::tet_elements", packs * TetPasses::scalars * static_cast<std::size_t>(solid_width)),
          Array<int>("percuss::tet_rates_rest", records),
          Array<int>("percuss::tet_stresses_stay", records),
          Array<int>("percuss::tet_is_left", static_cast<std::size_t>(chunks.count))};
}

void sum_tet_rates(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                   const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) {
    if constexpr (!is_single_precision) {
      launch_solids("percuss::sum_tet_rates", space, chunks, block.chunks,
                    SumRates<Lanes, Tet4>{chunks, block.chunks, step.motion, step.launch.passes.slot_rates, results});
    }
  });
}

void average_tet_rates(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetRateRows slots = launch.passes.slot_rates, means = launch.passes.rates;
  const Array<int> rates_rest = launch.passes.rates_rest;
  Kokkos::parallel_for(
      "percuss::average_tet_rates", Range(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
        const SlotSum<TetSums::rate_row> sum(nodes, slots, r);
        const double scale = sum.value[TetSums::volume] > 0 ? 1 / sum.value[TetSums::volume] : 0;
        bool rests = true;
        for (int k = 0; k < TetSums::rate_row; ++k) {
          if (k == TetSums::volume) continue;
          const double mean = scale * sum.value[k];
          rests = rests && mean == 0 && has_same_bits(mean, means(r, k));
          means(r, k) = mean;
        }
        rates_rest(r) = rests ? 1 : 0;
      });
}

void advance_tet_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                          const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) { advance_stresses(space, chunks, block, step, state, results); });
}

void average_tet_stresses(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetStressRows slots = launch.passes.slot_stresses, means = launch.passes.stresses;
  const Array<int> stresses_stay = launch.passes.stresses_stay;
  Kokkos::parallel_for(
      "percuss::average_tet_stresses", Range(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
        const SlotSum<TetSums::stress_row> sum(nodes, slots, r);
        const double volume = sum.value[TetSums::volume], scale = volume > 0 ? 1 / volume : 0;
        bool stays = true;
        const auto set = [&](int k, double mean) {
          stays = stays && has_same_bits(mean, means(r, k));
          means(r, k) = mean;
        };
        for (const int k : {0, 1, 2, 4, 5, 6}) set(k, scale * sum.value[k]);
        set(TetAverages::bulk, scale * sum.value[TetSums::bulk]);
        set(TetAverages::shear, scale * sum.value[TetSums::shear]);
        const double square = sum.value[TetSums::square];
        set(TetAverages::share, square > 0 ? sum.value[TetSums::mass] / square : 0);
        stresses_stay(r) = stays ? 1 : 0;
      });
}

void sum_tet_forces(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                    const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) {
    if constexpr (!is_single_precision) {
      launch_solids("percuss::sum_tet_forces", space, chunks, block.chunks,
                    FindForces<Lanes>{{chunks, block.chunks, step.motion, step.launch, fields}});
    }
  });
}

void advance_plain_tets(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_plain(space, chunks, block, motion, fields); });
}

}  // namespace percuss
