#pragma once
// What the launchers of tetrahedra share: groups of numbers that packs of elements give to nodes and take from them.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include <cstring>
#include <type_traits>

#include "kernels/core/number_rows.hpp"
#include "kernels/element/solid_packs.hpp"
#include "kernels/tet/tet_chunks.hpp"

namespace percuss {

/// Scratch of a pass: averages at a chunk's nodes, and what its elements give to them, GivenRow numbers each.
/// Elements first leave what they give side by side; a node then adds up what its elements have left. An element that
/// added to its nodes itself would wait for the one before it, with which it shares some.
/// The nodes themselves lie in passes.nodes, for all passes of a step.
template <int GivenRow>
struct MixedScratch : SolidScratch {
  static constexpr int given_row = GivenRow;
  double* means;  // [slots][TetSums::average_row]
  double* given;  // [lanes of the chunk + 1][GivenRow], of which the last row is 0

  KOKKOS_FUNCTION MixedScratch(const ChunkMember& member, const SolidChunk& chunk, const TetPasses& passes)
      : SolidScratch(member, 0),
        means(take<double>(member, chunk.slot_count * TetSums::average_row)),
        given(take<double>(member, (count_lanes(chunk) + 1) * GivenRow)) {
    nodes = &passes.nodes(static_cast<std::size_t>(node_record) * static_cast<std::size_t>(chunk.first_slot));
    double* const end = given + count_lanes(chunk) * GivenRow;
    for (int k = 0; k < GivenRow; ++k) end[k] = 0;
  }

  static KOKKOS_FUNCTION int count_lanes(const SolidChunk& chunk) {
    return (chunk.end_element - chunk.first_element + solid_width - 1) / solid_width * solid_width;
  }

  /// What a pack gives, its first element first.
  PERCUSS_FORCE_INLINE double* find_given(int pack) const {
    return given + static_cast<std::size_t>(pack) * solid_width * GivenRow;
  }

  /// Elements that died give nothing.
  KOKKOS_FUNCTION void clear_given(const SolidChunk& chunk) const {
    for (int i = 0; i < count_lanes(chunk) * GivenRow; ++i) given[i] = 0;
  }

  static std::size_t count_bytes(const ElementChunks& chunks, const TetNodes& nodes) {
    return sizeof(double) * (static_cast<std::size_t>(chunks.largest_slot_count) * TetSums::average_row +
                             static_cast<std::size_t>(nodes.largest_lane_count + 1) * GivenRow + 16);
  }
};

/// Sums over the corners of elements at each slot of a chunk, in ascending order: add(sum, element, corner), then
/// leave(slot, sum).
template <class Sum, class Add, class Leave>
PERCUSS_FORCE_INLINE void sum_slots(const TetNodes& nodes, int c, const Add& add, const Leave& leave) {
  constexpr int size = TetNodes::group_size;
  for (int g = nodes.first_group(c); g < nodes.first_group(c + 1); ++g) {
    Sum sums[size] = {};
    const std::uint16_t* const end = nodes.corners.data() + size * nodes.first_corner(g + 1);
    for (const std::uint16_t* at = nodes.corners.data() + size * nodes.first_corner(g); at < end; at += size)
      for (int k = 0; k < size; ++k) add(sums[k], at[k] >> 3, at[k] & 7);
    for (int k = 0; k < size; ++k) {
      const int slot = nodes.group_slots(size * g + k);
      if (slot != TetNodes::no_slot) leave(slot, sums[k]);
    }
  }
}

/// Launches a pass over chunks, a team each.
template <class Kernel>
void launch_pass(const char* label, const ExecSpace& space, const ElementChunks& chunks, const Array<int>& list,
                 const Kernel& kernel) {
  launch_solids(label, space, chunks, list, kernel, Kernel::Scratch::count_bytes(chunks, kernel.launch.nodes));
}

/// Averages at the nodes of a chunk, [slots][TetSums::average_row].
struct TetGather {
  const double* rows;

  /// Sums over N corners. The last of each group of four is its mean instead: the sum of N-th parts.
  template <int N>
  PERCUSS_FORCE_INLINE void add_up(const std::uint16_t* corners, Lanes (&sums)[TetSums::average_row]) const {
    constexpr bool is_power_of_two = (N & (N - 1)) == 0;  // of which the mean is exact in either order
    constexpr double part = 1.0 / N;
    static constexpr double scale[8] = {1, 1, 1, part, 1, 1, 1, part};
    RowSum<8> of[solid_width];
    for (int lane = 0; lane < solid_width; ++lane) {
      for (int i = 0; i < N; ++i) {
        const double* const row =
            rows + TetSums::average_row * static_cast<std::size_t>(corners[i * solid_width + lane]);
        if constexpr (is_power_of_two)
          of[lane].add(row);
        else
          of[lane].add_scaled(scale, row);
      }
    }
    turn_to_packs(of, sums);
    if constexpr (is_power_of_two) {
      sums[3] = Lanes(part) * sums[3];
      sums[7] = Lanes(part) * sums[7];
    }
  }

  template <int N>
  PERCUSS_FORCE_INLINE static Symmetric3<Lanes> find_tensor(const Lanes (&sums)[TetSums::average_row]) {
    return Lanes(1.0 / N) * Symmetric3<Lanes>{sums[0], sums[1], sums[2], sums[4], sums[5], sums[6]};
  }

  /// Mean over N corners of a tensor.
  template <int N>
  PERCUSS_FORCE_INLINE Symmetric3<Lanes> find_mean(const std::uint16_t* corners) const {
    Lanes sums[TetSums::average_row];
    add_up<N>(corners, sums);
    return find_tensor<N>(sums);
  }

  /// Mean over N corners of the stress and of the moduli.
  template <int N>
  PERCUSS_FORCE_INLINE TetMeans<Lanes> find_means(const std::uint16_t* corners) const {
    Lanes sums[TetSums::average_row];
    add_up<N>(corners, sums);
    TetMeans<Lanes> means;
    means.stress = find_tensor<N>(sums);
    means.bulk = sums[3];
    means.shear = sums[7];
    return means;
  }
};

/// First pass of the elements of a shape: V D / N and V / N of each to its N nodes. L: Lanes.
template <class L, class Shape>
struct SumRates {
  using Living = LivingSolids<L>;
  using Scratch = MixedScratch<TetSums::rate_row>;
  static constexpr int corners_of = Shape::corners;
  ElementChunks chunks;
  Array<int> list;
  ElementMotion motion;
  TetLaunch launch;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const SolidChunk chunk(chunks, list(member.league_rank()));
    if (ChunkRest(chunks, results, chunk.c, motion.skips_rest, motion.v).is_settled()) return;
    const Scratch scratch(member, chunk, launch.passes);
    chunk.fill_nodes(motion, scratch.nodes);
    Living living(motion.failing, motion.lives, chunk.c);
    if (living.can_fail()) scratch.clear_given(chunk);
    chunk.for_each_pack([&](int pack, int, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      if (living.can_fail() && !living.take_pack(corners)) return;
      leave_pack(scratch.nodes, corners, living, scratch.find_given(pack));
    });
    using Sum = RowSum<TetSums::rate_row>;
    double* const sums = &launch.passes.slot_rates(chunk.first_slot, 0);
    sum_slots<Sum>(
        launch.nodes, chunk.c,
        [&](Sum& sum, int element, int) { sum.add(scratch.given + TetSums::rate_row * element); },
        [&](int s, const Sum& sum) { sum.store(sums + TetSums::rate_row * s); });
  }

  KOKKOS_FUNCTION void leave_pack(const double* nodes, const std::uint16_t* corners, const Living& living,
                                  double* given) const {
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
    turn_to_rows({keep(d.xx), keep(d.yy), keep(d.zz), keep(part * volume), keep(d.xy), keep(d.yz), keep(d.zx), zero},
                 given, TetSums::rate_row);
  }
};

/// What an element of N corners gives to its nodes after the second pass: a row as TetSums has it, in which |B_I|^2 / V
/// follows by corner, of tetrahedra alone.
struct GivenStress {
  static constexpr int row = 16, squares = 12;

  /// stress, bulk, shear: what weighs with the volume; share: mass that each corner has.
  template <int N, class Mask>
  static PERCUSS_FORCE_INLINE void leave(const TetMeans<Lanes>& of, const Lanes& volume, const Mask& lives,
                                         const Lanes& share, const Lanes (&square)[4], double* given) {
    const Lanes zero(0.0);
    const auto counts = lives && volume > zero;
    const Lanes weight = select(counts, Lanes(1.0 / N) * volume, zero);
    const auto keep = [&](const Lanes& value) { return select(counts, value, zero); };
    const auto weigh = [&](const Lanes& value) { return select(counts, weight * value, zero); };
    const Symmetric3<Lanes>& s = of.stress;
    turn_to_rows(
        {weigh(s.xx), weigh(s.yy), weigh(s.zz), weigh(of.bulk), weigh(s.xy), weigh(s.yz), weigh(s.zx), weigh(of.shear)},
        given, row);
    turn_to_rows({weight, keep(share), zero, zero, keep(square[0]), keep(square[1]), keep(square[2]), keep(square[3])},
                 given + TetSums::volume, row);
  }
};

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

/// Averages at the nodes of a chunk into its scratch. Their records jump where other chunks come first.
PERCUSS_FORCE_INLINE void fill_averages(const TetLaunch& launch, const SolidChunk& chunk, const TetAverageRows& rows,
                                        double* means) {
  constexpr int size = TetSums::average_row;
  const int* const records = &launch.nodes.slots_to_records(chunk.first_slot);
  const auto find_row = [from = rows.data()](int record) { return from + size * static_cast<std::size_t>(record); };
  for (int s = 0; s < chunk.slot_count; ++s) {
    fetch_ahead(find_row(records[s + node_rows_ahead < chunk.slot_count ? s + node_rows_ahead : s]));
    std::memcpy(means + size * s, find_row(records[s]), size * sizeof(double));
  }
}

/// Second pass over the elements of a block: their stress and history, and what each pack gives to its nodes.
template <class Material, class Block>
struct StressPass {
  using Living = LivingSolids<Material>;
  using Scratch = MixedScratch<GivenStress::row>;
  ElementChunks chunks;
  Block block;
  ElementMotion motion;
  TetLaunch launch;
  Array<Real> state;
  ChunkResults results;

  /// Calls leave_pack(parameters, pack, living, state, sums, scratch) as SolidRecords::advance for the team's chunk,
  /// then adds up what packs have left. SharesMass: the squares of corners, too.
  template <class State, bool SharesMass, class LeavePack>
  KOKKOS_FUNCTION void advance_chunk(const ChunkMember& member, const LeavePack& leave_pack) const {
    const SolidChunk chunk(chunks, block.chunks(member.league_rank()));
    const SolidParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    const ChunkRest rest(chunks, results, chunk.c, motion.skips_rest && !changes_at_rest(parameters.material),
                         motion.v);
    if (leave_as_it_is(chunk, rest)) return;
    const Scratch scratch(member, chunk, launch.passes);
    fill_averages(launch, chunk, launch.passes.rates, scratch.means);
    if (motion.failing.find_pack(chunk.c) >= 0) scratch.clear_given(chunk);
    SolidRecords{chunk, rest, motion, state, scratch}
        .template advance<State>(
            parameters, [&](const SolidParameters<Material>& of_step, const SolidPack& on, const Living& living,
                            State& of, SolidSums& sums) { leave_pack(of_step, on, living, of, sums, scratch); })
        .leave_work(chunk.c, results);
    add_up<SharesMass>(chunk, scratch.given);
  }

  /// Sums of the chunk's slots.
  template <bool SharesMass>
  KOKKOS_FUNCTION void add_up(const SolidChunk& chunk, const double* given) const {
    struct Sum {
      RowSum<8> low;
      RowSum<4> high;
      double square = 0;
    };
    double* const sums = &launch.passes.slot_stresses(chunk.first_slot, 0);
    sum_slots<Sum>(
        launch.nodes, chunk.c,
        [&](Sum& sum, int element, int corner) {
          const double* const row = given + GivenStress::row * element;
          sum.low.add(row);
          sum.high.add(row + 8);
          if constexpr (SharesMass) sum.square += row[GivenStress::squares + corner];
        },
        [&](int s, const Sum& sum) {
          double* const row = sums + TetSums::stress_row * s;
          sum.low.store(row);
          sum.high.store(row + 8);
          if constexpr (SharesMass) row[TetSums::square] = sum.square;
        });
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
};

/// Third pass: forces of the elements of a shape. L: Lanes.
template <class L, class Shape>
struct ForcePass {
  using Living = LivingSolids<L>;
  using Scratch = MixedScratch<4 * Shape::corners>;
  ElementChunks chunks;
  Array<int> list;
  ElementMotion motion;
  TetLaunch launch;
  ChunkFields fields;

  /// Calls leave_pack(pack, living, sums, scratch) for each pack of the team's chunk that has living elements.
  template <class LeavePack>
  KOKKOS_FUNCTION void sum_chunk(const ChunkMember& member, const LeavePack& leave_pack) const {
    const SolidChunk chunk(chunks, list(member.league_rank()));
    const TetPasses& passes = launch.passes;
    if (passes.is_left(chunk.c) != 0 &&
        TetPasses::are_set(passes.stresses_stay, &launch.nodes.slots_to_records(chunk.first_slot), chunk.slot_count)) {
      ++fields.results.skipped(chunk.c);
      return;
    }
    const Scratch scratch(member, chunk, passes);
    fill_averages(launch, chunk, passes.stresses, scratch.means);
    if constexpr (std::is_same_v<Shape, Tet4>) fill_shares(chunk, scratch.nodes);
    SolidSums sums;
    Living living(motion.failing, motion.lives, chunk.c);
    if (living.can_fail()) scratch.clear_given(chunk);
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      if (living.can_fail() && !living.take_pack(corners)) return;
      leave_pack(SolidPack{chunk, pack, lanes, corners, scratch, nullptr, 0}, living, sums, scratch);
    });
    chunk.leave_step(sums, fields.results);
    subtract_forces(chunk, scratch.given);
  }

  /// Shares of mass behind the places in node records.
  KOKKOS_FUNCTION void fill_shares(const SolidChunk& chunk, double* nodes) const {
    const int* const records = &launch.nodes.slots_to_records(chunk.first_slot);
    for (int s = 0; s < chunk.slot_count; ++s) nodes[node_record * s + 3] = launch.passes.shares(records[s]);
  }

  /// A pack's corner forces [W][N][4].
  static PERCUSS_FORCE_INLINE void leave_forces(const typename ShapeField<Lanes, Shape>::type& f, double* given) {
    for (int i = 0; i < Shape::corners; ++i) turn_to_rows({f[i].x, f[i].y, f[i].z}, given + 4 * i, 4 * Shape::corners);
  }

  /// Minus the sum of corner forces, into the chunk's slots.
  KOKKOS_FUNCTION void subtract_forces(const SolidChunk& chunk, const double* given) const {
    using Sum = RowSum<4>;
    double* const to = &fields.slot_force(chunk.first_slot, 0);
    sum_slots<Sum>(
        launch.nodes, chunk.c,
        [&](Sum& sum, int element, int corner) { sum.subtract(given + 4 * (Shape::corners * element + corner)); },
        [&](int s, const Sum& sum) { sum.store_three(to + 3 * s); });
  }
};

}  // namespace percuss
