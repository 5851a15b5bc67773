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

/// Groups of three numbers of a pack's elements, by lane: records[lane][group].
template <int Groups>
struct TetGroups {
  alignas(64) double record[Groups][solid_width][4];

  PERCUSS_FORCE_INLINE void set(int group, const Lanes& a, const Lanes& b, const Lanes& c) {
    const Lanes packs[3] = {a, b, c};
    transpose_to_records(packs, record[group]);
  }

  /// Adds them to the row of a corner.
  PERCUSS_FORCE_INLINE void add(int lane, double* row) const {
    for (int g = 0; g < Groups; ++g) add_record(record[g][lane], row + 4 * g);
  }
};

/// Averages at the corners, one group of three: rows[corner].
struct TetGather {
  const double* rows;
  int row_size;
  const int* slots_to_records;

  PERCUSS_FORCE_INLINE Vector3<Lanes> operator()(int corner, int group, const std::uint16_t* corners) const {
    const double* records[solid_width];
    for (int lane = 0; lane < solid_width; ++lane) {
      const int record = slots_to_records[corners[corner * solid_width + lane]];
      records[lane] = rows + static_cast<std::size_t>(row_size) * static_cast<std::size_t>(record) + 4 * group;
    }
    Lanes packs[3];
    transpose_to_packs(records, packs);
    return {packs[0], packs[1], packs[2]};
  }

  /// Mean over N corners of a tensor in groups 0 and 1.
  template <int N>
  PERCUSS_FORCE_INLINE Symmetric3<Lanes> find_mean(const std::uint16_t* corners) const {
    const Lanes zero(0.0), part(1.0 / N);
    Vector3<Lanes> low{zero, zero, zero}, high{zero, zero, zero};
    for (int i = 0; i < N; ++i) {
      low = low + (*this)(i, 0, corners);
      high = high + (*this)(i, 1, corners);
    }
    return part * Symmetric3<Lanes>{low.x, low.y, low.z, high.x, high.y, high.z};
  }

  /// Mean over N corners of the stress and of the moduli; of tetrahedra also the shares of mass.
  template <int N>
  PERCUSS_FORCE_INLINE TetMeans<Lanes> find_means(const std::uint16_t* corners) const {
    TetMeans<Lanes> means;
    means.stress = find_mean<N>(corners);
    means.bulk = means.shear = Lanes(0.0);
    for (int i = 0; i < N; ++i) {
      const Vector3<Lanes> at_corner = (*this)(i, 2, corners);
      means.bulk = means.bulk + Lanes(1.0 / N) * at_corner.x;
      means.shear = means.shear + Lanes(1.0 / N) * at_corner.y;
      if (i < 4) means.share[i] = at_corner.z;
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
    TetGroups<TetSums::rate_groups> groups;
    groups.set(0, keep(d.xx), keep(d.yy), keep(d.zz));
    groups.set(1, keep(d.xy), keep(d.yz), keep(d.zx));
    groups.set(2, keep(part * volume), zero, zero);
    for (int lane = 0; lane < lanes; ++lane) {
      for (int i = 0; i < corners_of; ++i)
        groups.add(lane, sums + TetSums::rate_row * static_cast<std::size_t>(corners[i * solid_width + lane]));
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
  PERCUSS_FORCE_INLINE void set(const Symmetric3<Lanes>& stress, const Lanes& bulk, const Lanes& shear,
                                TetGroups<TetSums::stress_groups>& groups) const {
    groups.set(0, weigh(stress.xx), weigh(stress.yy), weigh(stress.zz));
    groups.set(1, weigh(stress.xy), weigh(stress.yz), weigh(stress.zx));
    groups.set(2, weight, weigh(bulk), weigh(shear));
  }
};
template <int N, class Mask>
PERCUSS_FORCE_INLINE auto give_stress(const Lanes& volume, const Mask& lives) {
  const auto counts = lives && volume > Lanes(0.0);
  return GivenStress<std::remove_const_t<decltype(counts)>>{counts,
                                                            select(counts, Lanes(1.0 / N) * volume, Lanes(0.0))};
}

/// Of an element at n+1, from its record.
struct OwnStress {
  Symmetric3<Lanes> stress;
  Lanes guard, viscous_pressure;

  PERCUSS_FORCE_INLINE explicit OwnStress(const double* record) {
    const auto load = [&](int scalar) { return load_pack(record + scalar * solid_width); };
    constexpr int r = TetRecord::rotation, s = TetRecord::stress;
    const Matrix3<Lanes> rotation{{{load(r), load(r + 1), load(r + 2)},
                                   {load(r + 3), load(r + 4), load(r + 5)},
                                   {load(r + 6), load(r + 7), load(r + 8)}}};
    stress = push_forward(rotation, {load(s), load(s + 1), load(s + 2), load(s + 3), load(s + 4), load(s + 5)});
    guard = load(TetRecord::guard);
    viscous_pressure = load(TetRecord::viscous_pressure);
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

  /// Calls add_pack(parameters, pack, living, state, sums) for each pack of the team's chunk that has living elements.
  template <class State, class AddPack>
  KOKKOS_FUNCTION void advance_chunk(const ChunkMember& member, const AddPack& add_pack) const {
    const SolidChunk chunk(chunks, block.chunks(member.league_rank()));
    SolidParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    const ChunkRest rest(chunks, results, chunk.c, motion.skips_rest && !changes_at_rest(parameters.material),
                         motion.v);
    if (leave_as_it_is(chunk, rest)) return;
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_nodes(motion, scratch.nodes);
    double* const rows = find_rows(chunk);
    for (int k = 0; k < chunk.slot_count * TetSums::stress_row; ++k) rows[k] = 0;
    parameters.time = motion.time;
    ChunkSums sums;
    RecordWatch<record_limit<State>> watch(rest.is_at_rest());
    Living living(motion.failing, motion.lives, chunk.c);
    const int size = chunks.record_size(chunk.c) * solid_width;
    Real* const records = &state(chunks.first_state(chunk.c));
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      Real* const record = records + static_cast<std::size_t>(size) * static_cast<std::size_t>(pack);
      if (living.can_fail() && !living.take_pack(corners)) return;
      watch.keep(record, size);
      add_pack(parameters, SolidPack{chunk, pack, lanes, corners, scratch}, living, *reinterpret_cast<State*>(record),
               sums);
      watch.compare(record, size);
    });
    rest.leave(watch.has_changed());
    sums.leave_work(chunk.c, results);
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
    chunk.fill_nodes(motion, scratch.nodes);
    for (int s = 0; s < chunk.slot_count; ++s) clear_record(scratch.forces + force_record * s);
    ChunkSums sums;
    Living living(motion.failing, motion.lives, chunk.c);
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      if (living.can_fail() && !living.take_pack(corners)) return;
      add_pack(SolidPack{chunk, pack, lanes, corners, scratch}, living, sums);
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
