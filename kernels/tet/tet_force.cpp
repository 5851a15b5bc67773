#include "kernels/tet/tet_force.hpp"

#include "kernels/tet/tet_packs.hpp"

namespace percuss {

namespace {

/// Third pass. L: Lanes.
template <class L>
struct FindForces : ForcePass<L, Tet4> {
  using Base = ForcePass<L, Tet4>;
  using Base::chunks;
  using Base::fields;
  using Base::launch;
  using Base::motion;
  using typename Base::Living;
  using typename Base::Scratch;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    this->sum_chunk(member, [&](const SolidPack& on, const Living& living, SolidSums& sums, const Scratch& scratch) {
      leave_pack(on, living, sums, scratch);
    });
    if (motion.watch.bound.extent(0) > 0) motion.watch.growth(this->list(member.league_rank())) = 0;
  }

  KOKKOS_FUNCTION void leave_pack(const SolidPack& on, const Living& living, SolidSums& sums,
                                  const Scratch& scratch) const {
    TetCorners<Lanes> x;
    Lanes shares[4];
    gather_corners<4>(scratch.nodes, node_record, on.corners, x, shares);
    const TetGeometry<Lanes> g = find_tet_geometry(x);
    const TetMeans<Lanes> means = TetGather{scratch.means}.template find_means<4>(on.corners);
    const double* const scalars = find_scalars(chunks, launch.passes, on.chunk.c, on.pack);
    const auto load = [&](int k) { return load_pack(scalars + k * solid_width); };
    const TetStiffness<Lanes> own{Lanes(0.0), load(TetPasses::shear), load(TetPasses::tangent)};
    const Lanes step = find_mixed_step(g, shares, mix_moduli(own, means, load(TetPasses::guard_modulus)));
    Base::leave_forces(settle(on, means, g, step, living, sums), scratch.find_given(on.pack));
  }

  /// Forces by the shares of the lanes; others' stresses act in full on a lane that lives.
  KOKKOS_FUNCTION TetCorners<Lanes> settle(const SolidPack& on, const TetMeans<Lanes>& means,
                                           const TetGeometry<Lanes>& g, Lanes step, const Living& living,
                                           SolidSums& sums) const {
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
    on.take_step(step, volume, sums);
    on.leave_bound(motion.watch, step);
    return f;
  }
};

/// Calls take(row) for the slots of a record in their order.
template <class Rows, class Take>
PERCUSS_FORCE_INLINE void visit_slots(const TetNodes& nodes, const Rows& rows, int record, const Take& take) {
  const int last = static_cast<int>(nodes.slots.extent(0)) - 1, size = static_cast<int>(rows.extent(1));
  for (int i = nodes.first(record); i < nodes.first(record + 1); ++i) {
    const double* const ahead = &rows(nodes.slots(i + node_rows_ahead < last ? i + node_rows_ahead : last), 0);
    fetch_ahead(ahead);
    fetch_ahead(ahead + size - 1);
    take(&rows(nodes.slots(i), 0));
  }
}

template <class Run>
void for_each_block(const TetBlocks& blocks, const Run& run) {
  std::apply([&](const auto&... block) { (run(block), ...); }, blocks);
}

}  // namespace

TetPasses make_tet_passes(const TetNodes& nodes, const ElementChunks& chunks, int slot_count) {
  const auto slots = static_cast<std::size_t>(slot_count), records = static_cast<std::size_t>(nodes.count);
  const auto packs = chunks.corner_slots.extent(0) / (8 * pack_size<Real>);
  return {Array<double>("percuss::tet_slot_nodes", nodes.slots_to_records.extent(0) * std::size_t{node_record}),
          TetRateRows("percuss::tet_slot_rates", slots),
          TetStressRows("percuss::tet_slot_stresses", slots),
          TetAverageRows("percuss::tet_rates", records),
          TetAverageRows("percuss::tet_stresses", records),
          Array<double>("percuss::tet_shares", records),
          Array<double>("percuss::tet_elements", packs * TetPasses::scalars * static_cast<std::size_t>(solid_width)),
          Array<int>("percuss::tet_rates_rest", records),
          Array<int>("percuss::tet_stresses_stay", records),
          Array<int>("percuss::tet_is_left", static_cast<std::size_t>(chunks.count))};
}

void sum_tet_rates(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                   const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) {
    if constexpr (!is_single_precision) {
      launch_pass("percuss::sum_tet_rates", space, chunks, block.chunks,
                  SumRates<Lanes, Tet4>{chunks, block.chunks, step.motion, step.launch, results});
    }
  });
}

void average_tet_rates(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetRateRows slots = launch.passes.slot_rates;
  const TetAverageRows means = launch.passes.rates;
  const Array<int> rates_rest = launch.passes.rates_rest;
  Kokkos::parallel_for(
      "percuss::average_tet_rates", Range(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
        RowSum<TetSums::rate_row> sum;
        visit_slots(nodes, slots, r, [&](const double* row) { sum.add(row); });
        double mean[TetSums::rate_row];
        sum.store(mean);
        const double volume = mean[TetSums::volume_of_rates];
        sum.scale(volume > 0 ? 1 / volume : 0);
        sum.store(mean);
        mean[TetSums::volume_of_rates] = 0;
        bool rests = have_same_bits(mean, &means(r, 0), TetSums::rate_row);
        for (int k = 0; rests && k < TetSums::rate_row; ++k) rests = mean[k] == 0;
        for (int k = 0; k < TetSums::rate_row; ++k) means(r, k) = mean[k];
        rates_rest(r) = rests ? 1 : 0;
      });
}

void advance_tet_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                          const TetStep& step, const Array<Real>& state, const ChunkResults& results) {
  for_each_block(blocks, [&](const auto& block) { advance_stresses(space, chunks, block, step, state, results); });
}

void average_tet_stresses(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetStressRows slots = launch.passes.slot_stresses;
  const TetAverageRows means = launch.passes.stresses;
  const Array<double> shares = launch.passes.shares;
  const Array<int> stresses_stay = launch.passes.stresses_stay;
  Kokkos::parallel_for(
      "percuss::average_tet_stresses", Range(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
        RowSum<TetSums::average_row> sum;
        RowSum<4> rest;
        visit_slots(nodes, slots, r, [&](const double* row) {
          sum.add(row);
          rest.add(row + TetSums::average_row);
        });
        double high[4], mean[TetSums::average_row];
        rest.store(high);
        const double volume = high[0], square = high[TetSums::square - TetSums::volume];
        sum.scale(volume > 0 ? 1 / volume : 0);
        sum.store(mean);
        const double share = square > 0 ? high[TetSums::mass - TetSums::volume] / square : 0;
        const bool stays = have_same_bits(mean, &means(r, 0), TetSums::average_row) && has_same_bits(share, shares(r));
        sum.store(&means(r, 0));
        shares(r) = share;
        stresses_stay(r) = stays ? 1 : 0;
      });
}

void sum_tet_forces(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                    const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) {
    if constexpr (!is_single_precision) {
      launch_pass("percuss::sum_tet_forces", space, chunks, block.chunks,
                  FindForces<Lanes>{{chunks, block.chunks, step.motion, step.launch, fields}});
    }
  });
}

void advance_plain_tets(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                        const ElementMotion& motion, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_plain(space, chunks, block, motion, fields); });
}

}  // namespace percuss
