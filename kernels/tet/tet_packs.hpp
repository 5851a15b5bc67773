#pragma once
// What the launchers of tetrahedra share: groups of numbers that packs of elements give to nodes and take from them.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include <cstring>
#include <type_traits>

#include "kernels/core/number_rows.hpp"
#include "kernels/element/solid_body.hpp"
#include "kernels/tet/tet_force.hpp"

namespace percuss {

/// Inputs of a pass for a block in a step.
template <class Block>
struct PassStep : BlockStep<Block> {
  TetLaunch launch;
};

/// Chunks, of which a pass requests no material.
struct ChunkList {
  Array<int> chunks;
};

/// Scratch of a pass: averages at a chunk's nodes, and what its elements give to them, GivenRow numbers each.
/// Elements first leave what they give side by side; a node then adds up what its elements have left. An element that
/// added to its nodes itself would wait for the one before it, with which it shares some.
/// The nodes themselves lie in passes.nodes, for all passes of a step.
template <int GivenRow>
struct MixedScratch : SolidScratch {
  double* means;  // [slots][TetSums::average_row]
  double* given;  // [lanes of the chunk + 1][GivenRow], of which the last row is 0

  KOKKOS_FUNCTION MixedScratch(const ChunkMember& member, const TeamChunk& chunk, const TetPasses& passes)
      : SolidScratch(member, 0),
        means(take<double>(member, chunk.slot_count * TetSums::average_row)),
        given(take<double>(member, (chunk.count_lanes() + 1) * GivenRow)) {
    nodes = &passes.nodes(std::size_t{node_size} * static_cast<std::size_t>(chunk.first_slot));
    double* const end = given + chunk.count_lanes() * GivenRow;
    for (int k = 0; k < GivenRow; ++k) end[k] = 0;
  }

  /// Values that a pack gives to nodes, its first element first.
  PERCUSS_FORCE_INLINE double* find_given(const ChunkPack& pack) const { return given + pack.first * GivenRow; }

  /// Elements that died give nothing.
  KOKKOS_FUNCTION void clear_given(const TeamChunk& chunk) const {
    for (int i = 0; i < chunk.count_lanes() * GivenRow; ++i) given[i] = 0;
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

/// Launches a pass over the chunks of a block, a team each.
template <class Pass, class Block>
void launch_pass(const char* label, const ExecSpace& space, const ElementChunks& chunks, const Block& block,
                 const TetStep& step, const ChunkFields& fields) {
  if (block.chunks.extent(0) == 0) return;
  launch_chunks(label, space, chunks, block.chunks, Pass{{{chunks, block, step.motion, fields}, step.launch}},
                Pass::Scratch::count_bytes(chunks, step.launch.nodes));
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

/// First pass of the elements of a shape: V D / N and V / N of each to its N nodes.
template <class Shape>
struct SumRates : PassStep<ChunkList> {
  using Scratch = MixedScratch<TetSums::rate_row>;
  static constexpr int corners_of = Shape::corners;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(chunks, block.chunks(member.league_rank()));
    if (ChunkRest(chunks, fields.results, chunk.c, motion.skips_rest, motion.v).is_settled()) return;
    const Scratch scratch(member, chunk, launch.passes);
    scratch.fill(chunk, motion);
    LivingSolids living(motion.failing, motion.lives, chunk.c);
    if (living.can_fail()) scratch.clear_given(chunk);
    chunk.for_each_pack(living, nullptr, 0, [&](const ChunkPack& pack) { leave_pack(scratch, pack, living); });
    using Sum = RowSum<TetSums::rate_row>;
    double* const sums = &launch.passes.slot_rates(chunk.first_slot, 0);
    sum_slots<Sum>(
        launch.nodes, chunk.c,
        [&](Sum& sum, int element, int) { sum.add(scratch.given + TetSums::rate_row * element); },
        [&](int s, const Sum& sum) { sum.store(sums + TetSums::rate_row * s); });
  }

  KOKKOS_FUNCTION void leave_pack(const Scratch& scratch, const ChunkPack& pack, const LivingSolids& living) const {
    const Lanes zero(0.0), part(1.0 / corners_of);
    typename ShapeField<Lanes, Shape>::type x, v;
    scratch.gather(0, pack.corners, x.at);
    scratch.gather(1, pack.corners, v.at);
    const auto middle = find_shape_geometry(find_middle(x, v, Lanes(motion.dt)));
    Lanes volume = middle.volume;
    if (living.can_fail()) volume = select(living.load_force_share() < zero, zero, volume);
    const auto counts = volume > zero;
    const Symmetric3<Lanes> d = part * symmetric_part(find_volume_times_gradient(v, middle));
    const auto keep = [&](const Lanes& value) { return select(counts, value, zero); };
    turn_to_rows({keep(d.xx), keep(d.yy), keep(d.zz), keep(part * volume), keep(d.xy), keep(d.yz), keep(d.zx), zero},
                 scratch.find_given(pack), TetSums::rate_row);
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

/// Stress of an element at n+1, from what the second pass leaves.
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

/// What the second pass leaves of a pack for the third [TetPasses::scalars][W].
KOKKOS_INLINE_FUNCTION double* find_scalars(const TetPasses& passes, const TeamChunk& chunk, const ChunkPack& pack) {
  const int lane = chunk.chunks.first_pack(chunk.c) * solid_width + pack.first;
  return &passes.elements(static_cast<std::size_t>(lane) * TetPasses::scalars);
}

/// Averages at the nodes of a chunk into its scratch. Their records jump where other chunks come first.
PERCUSS_FORCE_INLINE void fill_averages(const TetLaunch& launch, const TeamChunk& chunk, const TetAverageRows& rows,
                                        double* means) {
  constexpr int size = TetSums::average_row;
  const int* const records = &launch.nodes.slots_to_records(chunk.first_slot);
  const auto find_row = [from = rows.data()](int record) { return from + size * static_cast<std::size_t>(record); };
  for (int s = 0; s < chunk.slot_count; ++s) {
    fetch_ahead(find_row(records[s + rows_ahead < chunk.slot_count ? s + rows_ahead : s]));
    std::memcpy(means + size * s, find_row(records[s]), size * sizeof(double));
  }
}

/// Body of StressPass, as that of ElementKernel. The mass of the nodes of tetrahedra is shared by the squares of
/// corners, that of the others' is not.
template <class Block_>
struct StressBody : SolidMaterial<Block_> {
  using Block = Block_;
  using Parameters = const SolidParameters<typename Block::Material>;
  using Sums = SolidSums;
  using Lives = LivingSolids;
  using Scratch = MixedScratch<GivenStress::row>;
  static constexpr int corners = Block::Shape::corners;
  static constexpr int largest_record = sizeof(typename Block::State) / sizeof(Real);
  static constexpr bool shares_mass = std::is_same_v<typename Block::Shape, Tet4>;
  const PassStep<Block>& of;
  const TeamChunk& chunk;
  const Scratch& scratch;

  KOKKOS_FUNCTION int find_record_size() const { return chunk.chunks.record_size(chunk.c) * solid_width; }

  PERCUSS_FORCE_INLINE void advance(Parameters& parameters, const ChunkPack& pack, const Lives& lives,
                                    Sums& sums) const {
    const int size = find_record_size();
    typename Block::Field x, v;
    pack.fetch_third(size, 0);
    scratch.gather(0, pack.corners, x.at);
    pack.fetch_third(size, 1);
    scratch.gather(1, pack.corners, v.at);
    pack.fetch_third(size, 2);
    auto& state = *reinterpret_cast<typename Block::State*>(pack.record);
    const MeanRate<Lanes> mean{TetGather{scratch.means}.template find_mean<corners>(pack.corners),
                               Lanes(of.launch.nodes.deviator_share(chunk.c))};
    leave_place(parameters.material, x, state);
    auto point = advance_mixed(parameters, x, v, mean, Lanes(of.motion.dt), state);
    Lanes share(1.0);
    if (lives.can_fail()) {
      share = lives.take_force_share(Lanes(1e300), point.geometry.volume);
      lives.take_work(share, point.work);
    }
    sums.take_work(point.work, pack.lanes);
    leave_stress(point, state, pack, share,
                 find_guard_modulus(state.guard, parameters.lambda + 2.0 / 3.0 * parameters.mu));
  }

  /// For the third pass, and what the pack gives to its nodes. share: of its force that each lane leaves.
  template <class Point>
  PERCUSS_FORCE_INLINE void leave_stress(const Point& point, const typename Block::State& state, const ChunkPack& pack,
                                         const Lanes& share, const Lanes& guard_modulus) const {
    const Lanes zero(0.0);
    const TetStiffness<Lanes> own = find_stiffness(point);
    double* const scalars = find_scalars(of.launch.passes, chunk, pack);
    store_pack(scalars + TetPasses::shear * solid_width, own.shear);
    store_pack(scalars + TetPasses::tangent * solid_width, own.tangent);
    store_pack(scalars + TetPasses::guard_modulus * solid_width, guard_modulus);
    OwnStress(point.stress, state.guard, state.viscous_pressure).leave(scalars);
    Lanes mass = zero, square[4] = {zero, zero, zero, zero};
    if constexpr (shares_mass) {
      mass = Lanes(0.25) * state.mass;
      for (int i = 0; i < 4; ++i) square[i] = dot(point.geometry.b[i], point.geometry.b[i]) / point.geometry.volume;
    } else {
      store_pack(scalars + TetPasses::hourglass * solid_width, point.own.hourglass);
    }
    GivenStress::leave<corners>(
        {share * add_to_diagonal(point.stress, zero - state.guard), own.bulk + guard_modulus, own.shear},
        point.geometry.volume, !(share < zero), mass, square, scratch.find_given(pack));
  }
};

/// Second pass over the elements of a block: their stress and history, and what each pack gives to its nodes.
template <class Block>
struct StressPass : PassStep<Block> {
  using Of = PassStep<Block>;
  using Of::launch;
  using Body = StressBody<Block>;
  using Scratch = typename Body::Scratch;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(Of::chunks, Of::block.chunks(member.league_rank()));
    const ChunkResults& results = Of::fields.results;
    const ChunkRest rest(Of::chunks, results, chunk.c, Of::motion.skips_rest && Body::may_rest(*this, chunk.c),
                         Of::motion.v);
    if (leave_as_it_is(chunk, rest)) return;
    const Scratch scratch(member, chunk, launch.passes);
    fill_averages(launch, chunk, launch.passes.rates, scratch.means);
    if (Of::motion.failing.find_pack(chunk.c) >= 0) scratch.clear_given(chunk);
    Body body{{}, *this, chunk, scratch};
    SolidSums sums;
    rest.leave(advance_packs(*this, chunk, body, sums, rest.is_at_rest()));
    sums.leave_work(chunk.c, results);
    add_up(chunk, scratch.given);
  }

  /// Sums of the chunk's slots.
  KOKKOS_FUNCTION void add_up(const TeamChunk& chunk, const double* given) const {
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
          if constexpr (Body::shares_mass) sum.square += row[GivenStress::squares + corner];
        },
        [&](int s, const Sum& sum) {
          double* const row = sums + TetSums::stress_row * s;
          sum.low.store(row);
          sum.high.store(row + 8);
          if constexpr (Body::shares_mass) row[TetSums::square] = sum.square;
        });
  }

  /// Whether neither the motion of a chunk nor the averaged rates at its nodes request an evaluation.
  KOKKOS_FUNCTION bool leave_as_it_is(const TeamChunk& chunk, const ChunkRest& rest) const {
    const TetPasses& passes = launch.passes;
    const bool is_left =
        rest.is_settled() &&
        TetPasses::are_set(passes.rates_rest, &launch.nodes.slots_to_records(chunk.first_slot), chunk.slot_count);
    passes.is_left(chunk.c) = is_left ? 1 : 0;
    return is_left;
  }
};

/// Third pass: forces of the elements of a shape. Element: a pack of them, with volume(), find_step() with the moduli
/// that it feels, scale() of what it remembers of its forces, find_forces() of a stress.
template <class Shape, class Element>
struct ForcePass : PassStep<ChunkList> {
  using Scratch = MixedScratch<4 * Shape::corners>;
  using Field = typename ShapeField<Lanes, Shape>::type;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const TeamChunk chunk(chunks, block.chunks(member.league_rank()));
    const TetPasses& passes = launch.passes;
    if (passes.is_left(chunk.c) != 0 &&
        TetPasses::are_set(passes.stresses_stay, &launch.nodes.slots_to_records(chunk.first_slot), chunk.slot_count)) {
      ++fields.results.skipped(chunk.c);
    } else {
      const Scratch scratch(member, chunk, passes);
      fill_averages(launch, chunk, passes.stresses, scratch.means);
      if constexpr (std::is_same_v<Shape, Tet4>) fill_shares(chunk, scratch.nodes);
      SolidSums sums;
      LivingSolids living(motion.failing, motion.lives, chunk.c);
      if (living.can_fail()) scratch.clear_given(chunk);
      chunk.for_each_pack(living, &fields.state(chunks.first_state(chunk.c)), chunks.record_size(chunk.c) * solid_width,
                          [&](const ChunkPack& pack) { leave_pack(chunk, pack, living, sums, scratch); });
      sums.leave_step(chunk.c, chunk.first_element, chunk.count, fields.results);
      subtract_forces(chunk, scratch.given);
    }
    leave_growth(motion.watch, chunk.c);
  }

  /// Forces by the shares of the lanes; others' stresses act in full on a lane that lives.
  KOKKOS_FUNCTION void leave_pack(const TeamChunk& chunk, const ChunkPack& pack, const LivingSolids& living,
                                  SolidSums& sums, const Scratch& scratch) const {
    Element element(scratch, pack);
    const TetMeans<Lanes> means = TetGather{scratch.means}.template find_means<Shape::corners>(pack.corners);
    const double* const scalars = find_scalars(launch.passes, chunk, pack);
    const auto load = [&](int k) { return load_pack(scalars + k * solid_width); };
    OwnStress own(scalars);
    const Lanes deviator_share(launch.nodes.deviator_share(chunk.c));
    Lanes step = element.find_step(mix_moduli({Lanes(0.0), load(TetPasses::shear), load(TetPasses::tangent)}, means,
                                              deviator_share, load(TetPasses::guard_modulus)),
                                   scalars);
    Lanes volume = element.volume(), share(1.0);
    if (living.can_fail()) {
      share = living.take_force_share(step, volume);
      own.scale(share);
      element.scale(share);
    }
    Field f;
    element.find_forces(find_mixed_stress(own.stress, means.stress, deviator_share, own.guard - own.viscous_pressure),
                        f);
    if (living.can_fail()) {
      settle_forces(select(share < Lanes(0.0), share, Lanes(1.0)), f.at);
      settle_step(share, step, volume);
    }
    double* const given = scratch.find_given(pack);
    for (int i = 0; i < Shape::corners; ++i) turn_to_rows({f[i].x, f[i].y, f[i].z}, given + 4 * i, 4 * Shape::corners);
    sums.take_step(step, volume, pack.first, pack.lanes);
    leave_bound(motion.watch, chunk, pack.first, step);
  }

  /// Shares of mass behind the places in node records.
  KOKKOS_FUNCTION void fill_shares(const TeamChunk& chunk, double* nodes) const {
    const int* const records = &launch.nodes.slots_to_records(chunk.first_slot);
    for (int s = 0; s < chunk.slot_count; ++s)
      nodes[SolidScratch::node_size * s + 3] = launch.passes.shares(records[s]);
  }

  /// Minus the sum of corner forces, into the chunk's slots.
  KOKKOS_FUNCTION void subtract_forces(const TeamChunk& chunk, const double* given) const {
    using Sum = RowSum<4>;
    double* const to = &fields.slot_force(chunk.first_slot, 0);
    sum_slots<Sum>(
        launch.nodes, chunk.c,
        [&](Sum& sum, int element, int corner) { sum.subtract(given + 4 * (Shape::corners * element + corner)); },
        [&](int s, const Sum& sum) { sum.store_three(to + 3 * s); });
  }
};

/// The first and the third pass over every block of a family.
template <class Blocks>
void sum_rates_of(const ExecSpace& space, const ElementChunks& chunks, const Blocks& blocks, const TetStep& step,
                  const ChunkFields& fields) {
  for_each_block(blocks, [&]<class Block>(const Block& block) {
    using Pass = SumRates<typename Block::Shape>;
    launch_pass<Pass>("percuss::sum_rates", space, chunks, ChunkList{block.chunks}, step, fields);
  });
}
template <template <class> class Element, class Blocks>
void sum_forces_of(const ExecSpace& space, const ElementChunks& chunks, const Blocks& blocks, const TetStep& step,
                   const ChunkFields& fields) {
  for_each_block(blocks, [&]<class Block>(const Block& block) {
    using Pass = ForcePass<typename Block::Shape, Element<typename Block::Shape>>;
    launch_pass<Pass>("percuss::sum_forces", space, chunks, ChunkList{block.chunks}, step, fields);
  });
}

}  // namespace percuss
