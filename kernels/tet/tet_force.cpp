#include "kernels/tet/tet_force.hpp"

#include "kernels/core/small_space.hpp"
#include "kernels/tet/tet_packs.hpp"

namespace percuss {

namespace {

/// A pack of tetrahedra in the third pass (ForcePass).
template <class Shape>
struct TetForces {
  TetGeometry<Lanes> g;
  Lanes shares[4];  // of the mass of the corners

  KOKKOS_FUNCTION TetForces(const SolidScratch& scratch, const ChunkPack& pack) {
    TetCorners<Lanes> x;
    for (int i = 0; i < 4; ++i) {
      Lanes packs[4];
      gather_corner(scratch.nodes, SolidScratch::node_size, pack.corners + i * solid_width, packs);
      x[i] = {packs[0], packs[1], packs[2]};
      shares[i] = packs[3];
    }
    g = find_tet_geometry(x);
  }

  KOKKOS_FUNCTION const Lanes& volume() const { return g.volume; }
  KOKKOS_FUNCTION Lanes find_step(const TetStiffness<Lanes>& felt, const double*) const {
    return find_mixed_step(g, shares, felt);
  }
  KOKKOS_FUNCTION void scale(const Lanes&) {}
  KOKKOS_FUNCTION void find_forces(const Symmetric3<Lanes>& stress, TetCorners<Lanes>& f) const {
    f = find_tet_forces(g, stress);
  }
};

/// Calls take(row) for the slots of a record in their order.
template <class Rows, class Take>
PERCUSS_FORCE_INLINE void visit_slots(const TetNodes& nodes, const Rows& rows, int record, const Take& take) {
  const int last = static_cast<int>(nodes.slots.extent(0)) - 1, size = static_cast<int>(rows.extent(1));
  for (int i = nodes.first(record); i < nodes.first(record + 1); ++i) {
    const double* const ahead = &rows(nodes.slots(i + rows_ahead < last ? i + rows_ahead : last), 0);
    fetch_ahead(ahead);
    fetch_ahead(ahead + size - 1);
    take(&rows(nodes.slots(i), 0));
  }
}

}  // namespace

TetPasses make_tet_passes(const TetNodes& nodes, const ElementChunks& chunks, int slot_count) {
  const auto slots = static_cast<std::size_t>(slot_count), records = static_cast<std::size_t>(nodes.count);
  const auto packs = chunks.corner_slots.extent(0) / (8 * pack_size<Real>);
  return {
      Array<double>("percuss::tet_slot_nodes", nodes.slots_to_records.extent(0) * std::size_t{SolidScratch::node_size}),
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

void sum_rates(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
               const ChunkFields& fields) {
  sum_rates_of(space, chunks, blocks, step, fields);
}

void average_tet_rates(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetRateRows slots = launch.passes.slot_rates;
  const TetAverageRows means = launch.passes.rates;
  const Array<int> rates_rest = launch.passes.rates_rest;
  parallel_for(
      "percuss::average_tet_rates", RangeOf(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
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

void advance_stresses(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                      const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_stresses_of(space, chunks, block, step, fields); });
}

void average_tet_stresses(const ExecSpace& space, const TetLaunch& launch) {
  const TetNodes nodes = launch.nodes;
  const TetStressRows slots = launch.passes.slot_stresses;
  const TetAverageRows means = launch.passes.stresses;
  const Array<double> shares = launch.passes.shares;
  const Array<int> stresses_stay = launch.passes.stresses_stay;
  parallel_for(
      "percuss::average_tet_stresses", RangeOf(space, 0, nodes.count), KOKKOS_LAMBDA(const int r) {
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

void sum_forces(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks, const TetStep& step,
                const ChunkFields& fields) {
  sum_forces_of<TetForces>(space, chunks, blocks, step, fields);
}

void advance_plain(const ExecSpace& space, const ElementChunks& chunks, const TetBlocks& blocks,
                   const ElementMotion& motion, const ChunkFields& fields) {
  for_each_block(blocks, [&](const auto& block) { advance_plain_of(space, chunks, block, motion, fields); });
}

}  // namespace percuss
