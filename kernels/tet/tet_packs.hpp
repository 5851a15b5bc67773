#pragma once
// What the launchers of tetrahedra share: groups of numbers that packs of elements give to nodes and take from them.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include <type_traits>

#include "kernels/element/solid_packs.hpp"
#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

/// to[0..4) += from[0..4), both aligned to four doubles.
PERCUSS_FORCE_INLINE void add_record(const double* from, double* to) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = detail::RawPack<4>::type;
  *reinterpret_cast<Raw*>(to) += *reinterpret_cast<const Raw*>(from);
#else
  for (int k = 0; k < 4; ++k) to[k] += from[k];
#endif
}

/// Four numbers of each element of a pack: [lane][4].
struct LaneRows {
  alignas(64) double row[solid_width][4];

  PERCUSS_FORCE_INLINE void set(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    alignas(64) double packs[4][solid_width];
    const Lanes* const from[4] = {&a, &b, &c, &d};
    for (int k = 0; k < 4; ++k) store_pack(packs[k], *from[k]);
    int lanes[solid_width];
    for (int lane = 0; lane < solid_width; ++lane) lanes[lane] = lane;
    store_rows_of_four(packs, lanes, row[0]);
  }
  PERCUSS_FORCE_INLINE void load(Lanes (&to)[4]) const {
    alignas(64) double packs[4][solid_width];
    int lanes[solid_width];
    for (int lane = 0; lane < solid_width; ++lane) lanes[lane] = lane;
    load_rows_of_four(row[0], lanes, packs);
    for (int k = 0; k < 4; ++k) to[k] = load_pack(packs[k]);
  }
};

/// Sum over the corners of a lane of their rows of four, from 0 in their order. Scaled: the last number of each row is
/// one N-th.
template <int N, bool Scaled>
PERCUSS_FORCE_INLINE void sum_rows(const double* const (&rows)[N], double* sum) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = detail::RawPack<4>::type;
  constexpr Raw scale = {1, 1, 1, 1.0 / N};
  Raw total{};
  for (int i = 0; i < N; ++i) {
    const Raw row = *reinterpret_cast<const Raw*>(rows[i]);
    total += Scaled ? scale * row : row;
  }
  *reinterpret_cast<Raw*>(sum) = total;
#else
  for (int k = 0; k < 4; ++k) {
    sum[k] = 0;
    for (int i = 0; i < N; ++i) sum[k] += Scaled && k == 3 ? 1.0 / N * rows[i][k] : rows[i][k];
  }
#endif
}

/// Averages at the corners.
struct TetGather {
  const double* rows;
  int row_size;
  const int* slots_to_records;

  PERCUSS_FORCE_INLINE const double* find_row(int corner, int lane, const std::uint16_t* corners) const {
    const int record = slots_to_records[corners[corner * solid_width + lane]];
    return rows + static_cast<std::size_t>(row_size) * static_cast<std::size_t>(record);
  }

  /// Sums over N corners of the first two groups of four. The last of each is its mean instead: the sum of N-th parts.
  template <int N>
  PERCUSS_FORCE_INLINE void add_up(const std::uint16_t* corners, Lanes (&low)[4], Lanes (&high)[4]) const {
    constexpr bool is_power_of_two = (N & (N - 1)) == 0;  // of which the mean is exact in either order
    LaneRows sums[2];
    for (int lane = 0; lane < solid_width; ++lane) {
      const double *first[N], *second[N];
      for (int i = 0; i < N; ++i) {
        first[i] = find_row(i, lane, corners);
        second[i] = first[i] + 4;
      }
      sum_rows<N, !is_power_of_two>(first, sums[0].row[lane]);
      sum_rows<N, !is_power_of_two>(second, sums[1].row[lane]);
    }
    sums[0].load(low);
    sums[1].load(high);
    if constexpr (is_power_of_two) {
      low[3] = Lanes(1.0 / N) * low[3];
      high[3] = Lanes(1.0 / N) * high[3];
    }
  }

  /// Mean of the tensor.
  template <int N>
  PERCUSS_FORCE_INLINE static Symmetric3<Lanes> find_tensor(const Lanes (&low)[4], const Lanes (&high)[4]) {
    return Lanes(1.0 / N) * Symmetric3<Lanes>{low[0], low[1], low[2], high[0], high[1], high[2]};
  }

  /// Mean over N corners of a tensor.
  template <int N>
  PERCUSS_FORCE_INLINE Symmetric3<Lanes> find_mean(const std::uint16_t* corners) const {
    Lanes low[4], high[4];
    add_up<N>(corners, low, high);
    return find_tensor<N>(low, high);
  }

  /// Mean over N corners of the stress and of the moduli; of tetrahedra also the shares of mass.
  template <int N>
  PERCUSS_FORCE_INLINE TetMeans<Lanes> find_means(const std::uint16_t* corners) const {
    Lanes low[4], high[4];
    add_up<N>(corners, low, high);
    TetMeans<Lanes> means;
    means.stress = find_tensor<N>(low, high);
    means.bulk = low[3];
    means.shear = high[3];
    for (int i = 0; i < 4; ++i) {
      alignas(64) double share[solid_width];
      for (int lane = 0; lane < solid_width; ++lane) share[lane] = find_row(i, lane, corners)[TetAverages::share];
      means.share[i] = load_pack(share);
    }
    return means;
  }
};

/// First pass of the elements of a shape: V D / N and V / N of each to its N nodes. L: Lanes.
template <class L, class Shape>
struct SumRates {
  using Living = LivingSolids<L>;
  static constexpr int corners_of = Shape::corners;
  ElementChunks chunks;
  Array<int> list;
  ElementMotion motion;
  TetRateRows rows;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const SolidChunk chunk(chunks, list(member.league_rank()));
    if (ChunkRest(chunks, results, chunk.c, motion.skips_rest, motion.v).is_settled()) return;
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_nodes(motion, scratch.nodes);
    double* const sums = &rows(chunk.first_slot, 0);
    for (int k = 0; k < chunk.slot_count * TetSums::rate_row; ++k) sums[k] = 0;
    Living living(motion.failing, motion.lives, chunk.c);
    chunk.for_each_pack([&](int, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      if (living.can_fail() && !living.take_pack(corners)) return;
      add_pack(scratch.nodes, corners, lanes, living, sums);
    });
  }

  KOKKOS_FUNCTION void add_pack(const double* nodes, const std::uint16_t* corners, int lanes, const Living& living,
                                double* sums) const {
    const Lanes zero(0.0), part(1.0 / corners_of);
    typename ShapeField<Lanes, Shape>::type x, v;
    gather_corners<corners_of>(nodes, node_record, corners, x);
    gather_corners<corners_of>(nodes + 4, node_record, corners, v);
    const auto middle = find_shape_geometry(find_middle(x, v, Lanes(motion.dt)));
    Lanes volume = middle.volume;
    if (living.can_fail()) volume = select(living.load_force_share() < zero, zero, volume);
    const auto counts = volume > zero;
    const Symmetric3<Lanes> d = part * symmetric_part(find_volume_times_gradient(v, middle));
    const auto keep = [&](const Lanes& value) { return select(counts, value, zero); };
    LaneRows low, high;
    low.set(keep(d.xx), keep(d.yy), keep(d.zz), keep(part * volume));
    high.set(keep(d.xy), keep(d.yz), keep(d.zx), zero);
    for (int lane = 0; lane < lanes; ++lane) {
      for (int i = 0; i < corners_of; ++i) {
        double* const row = sums + TetSums::rate_row * static_cast<std::size_t>(corners[i * solid_width + lane]);
        add_record(low.row[lane], row);
        add_record(high.row[lane], row + 4);
      }
    }
  }
};

/// What elements give to each of their N nodes after the second pass: their volume, and what it weighs.
template <class Mask>
struct GivenStress {
  Mask counts;  // lanes that give
  Lanes weight;

  template <class L>
  PERCUSS_FORCE_INLINE L weigh(const L& value) const {
    return select(counts, weight * value, L(0.0));
  }
  PERCUSS_FORCE_INLINE void set(const Symmetric3<Lanes>& stress, const Lanes& bulk, LaneRows& low,
                                LaneRows& high) const {
    low.set(weigh(stress.xx), weigh(stress.yy), weigh(stress.zz), weight);
    high.set(weigh(stress.xy), weigh(stress.yz), weigh(stress.zx), weigh(bulk));
  }
};
template <int N, class Mask>
PERCUSS_FORCE_INLINE auto give_stress(const Lanes& volume, const Mask& lives) {
  const auto counts = lives && volume > Lanes(0.0);
  return GivenStress<std::remove_const_t<decltype(counts)>>{counts,
                                                            select(counts, Lanes(1.0 / N) * volume, Lanes(0.0))};
}

/// Of an element at n+1, from what the second pass leaves.
struct OwnStress {
  Symmetric3<Lanes> stress;
  Lanes guard, viscous_pressure;

  PERCUSS_FORCE_INLINE explicit OwnStress(const double* scalars) {
    const auto load = [&](int k) { return load_pack(scalars + k * solid_width); };
    constexpr int s = TetPasses::stress;
    stress = {load(s), load(s + 1), load(s + 2), load(s + 3), load(s + 4), load(s + 5)};
    guard = load(TetPasses::guard);
    viscous_pressure = load(TetPasses::viscous_pressure);
  }
  PERCUSS_FORCE_INLINE OwnStress(const Symmetric3<Lanes>& of, const Lanes& of_guard, const Lanes& of_viscosity)
      : stress(of), guard(of_guard), viscous_pressure(of_viscosity) {}

  PERCUSS_FORCE_INLINE void leave(double* scalars) const {
    const auto store = [&](int k, const Lanes& value) { store_pack(scalars + k * solid_width, value); };
    const Lanes* const parts[6] = {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.yz, &stress.zx};
    for (int k = 0; k < 6; ++k) store(TetPasses::stress + k, *parts[k]);
    store(TetPasses::guard, guard);
    store(TetPasses::viscous_pressure, viscous_pressure);
  }

  PERCUSS_FORCE_INLINE void scale(const Lanes& share) {
    stress = share * stress;
    guard = share * guard;
    viscous_pressure = share * viscous_pressure;
  }
};

/// The record of a pack.
KOKKOS_INLINE_FUNCTION const double* find_pack_record(const ElementChunks& chunks, const Array<Real>& state, int c,
                                                      int pack) {
  return reinterpret_cast<const double*>(&state(chunks.first_state(c))) +
         static_cast<std::size_t>(pack) * static_cast<std::size_t>(chunks.record_size(c)) * solid_width;
}

/// What the second pass leaves for the third [TetPasses::scalars][W].
KOKKOS_INLINE_FUNCTION double* find_scalars(const ElementChunks& chunks, const TetPasses& passes, int c, int pack) {
  const int place = chunks.first_pack(c) + pack;
  return &passes.elements(static_cast<std::size_t>(place) * TetPasses::scalars * solid_width);
}

/// Prefetches the averages at the nodes of a chunk: their records jump where other chunks come first.
template <class Rows>
KOKKOS_INLINE_FUNCTION void fetch_averages(const TetLaunch& launch, const SolidChunk& chunk, const Rows& rows) {
  constexpr int line = static_cast<int>(cache_line / sizeof(double));
  const int* const records = &launch.nodes.slots_to_records(chunk.first_slot);
  for (int s = 0; s < chunk.slot_count; ++s) {
    if (records[s] < 0) continue;
    const double* const row = &rows(records[s], 0);
    for (int k = 0; k < static_cast<int>(rows.extent(1)); k += line) fetch_ahead(row + k);
  }
}

/// Second pass over the elements of a block: their stress and history, and what each pack gives to its nodes.
template <class Material, class Block>
struct StressPass {
  using Living = LivingSolids<Material>;
  ElementChunks chunks;
  Block block;
  ElementMotion motion;
  TetLaunch launch;
  Array<Real> state;
  ChunkResults results;

  /// Calls add_pack as SolidRecords::advance for the team's chunk.
  template <class State, class AddPack>
  KOKKOS_FUNCTION void advance_chunk(const ChunkMember& member, const AddPack& add_pack) const {
    const SolidChunk chunk(chunks, block.chunks(member.league_rank()));
    const SolidParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    const ChunkRest rest(chunks, results, chunk.c, motion.skips_rest && !changes_at_rest(parameters.material),
                         motion.v);
    if (leave_as_it_is(chunk, rest)) return;
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_nodes(motion, scratch.nodes);
    fetch_averages(launch, chunk, launch.passes.rates);
    double* const rows = find_rows(chunk);
    for (int k = 0; k < chunk.slot_count * TetSums::stress_row; ++k) rows[k] = 0;
    SolidRecords{chunk, rest, motion, state, scratch}
        .template advance<State>(parameters, add_pack)
        .leave_work(chunk.c, results);
  }

  /// Whether neither the motion of a chunk nor the averaged rates at its nodes ask for an evaluation.
  KOKKOS_FUNCTION bool leave_as_it_is(const SolidChunk& chunk, const ChunkRest& rest) const {
    const TetPasses& passes = launch.passes;
    const bool is_left =
        rest.is_settled() &&
        TetPasses::are_set(passes.rates_rest, &launch.nodes.slots_to_records(chunk.first_slot), chunk.slot_count);
    passes.is_left(chunk.c) = is_left ? 1 : 0;
    return is_left;
  }

  /// Sums of a chunk [slots][TetSums::stress_row].
  KOKKOS_FUNCTION double* find_rows(const SolidChunk& chunk) const {
    return &launch.passes.slot_stresses(chunk.first_slot, 0);
  }
};

/// Third pass: forces. L: Lanes.
template <class L>
struct ForcePass {
  using Living = LivingSolids<L>;
  ElementChunks chunks;
  Array<int> list;
  ElementMotion motion;
  TetLaunch launch;
  ChunkFields fields;

  /// Calls add_pack(pack, living, sums) for each pack of the team's chunk that has living elements.
  template <class AddPack>
  KOKKOS_FUNCTION void sum_chunk(const ChunkMember& member, const AddPack& add_pack) const {
    const SolidChunk chunk(chunks, list(member.league_rank()));
    const TetPasses& passes = launch.passes;
    if (passes.is_left(chunk.c) != 0 &&
        TetPasses::are_set(passes.stresses_stay, &launch.nodes.slots_to_records(chunk.first_slot), chunk.slot_count)) {
      ++fields.results.skipped(chunk.c);
      return;
    }
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_places(motion, scratch.nodes);
    fetch_averages(launch, chunk, passes.stresses);
    for (int s = 0; s < chunk.slot_count; ++s) clear_record(scratch.forces + force_record * s);
    ChunkSums sums;
    Living living(motion.failing, motion.lives, chunk.c);
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      if (living.can_fail() && !living.take_pack(corners)) return;
      add_pack(SolidPack{chunk, pack, lanes, corners, scratch, nullptr, 0}, living, sums);
    });
    sums.leave_step(chunk.c, chunk.first_element, fields.results);
    copy_force_rows(scratch.forces, chunk.slot_count, &fields.slot_force(chunk.first_slot, 0));
  }

  /// Averages of the stresses at the nodes of a chunk.
  KOKKOS_FUNCTION TetGather gather_stresses(const SolidChunk& chunk) const {
    return {launch.passes.stresses.data(), TetSums::stress_row, &launch.nodes.slots_to_records(chunk.first_slot)};
  }
};

}  // namespace percuss
