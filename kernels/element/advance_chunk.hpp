#pragma once
// Advances the elements of one chunk, one after the other, and the chunks of a block in parallel.
//
// The body of an element is compiled for each compiled-in material and each kind of element (advance_*.cpp name the
// pairs); every other material shares one body and is called.

#include "kernels/core/prefetch.hpp"
#include "kernels/element/chunk_records.hpp"
#include "kernels/element/chunk_rest.hpp"
#include "kernels/element/chunk_sums.hpp"
#include "kernels/element/hex8/fold_resistance.hpp"
#include "kernels/element/hex8/hex_record.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/element/living_lanes.hpp"

namespace percuss {

template <class Material, HexKind Kind>
using LaneState = HexState<HexLanes, Material, Kind>;

/// Prefetches a third of the next pack's record during the work on this one: the hardware does not look ahead across
/// the pack's long body. In thirds, because a core that requests all at once has to wait until its requests are
/// accepted.
template <int Size>
PERCUSS_FORCE_INLINE void fetch_third(const Real* record, int third) {
  constexpr int line = static_cast<int>(cache_line / sizeof(Real)), lines = (Size + line - 1) / line;
  for (int i = lines * third / 3; i < lines * (third + 1) / 3; ++i) fetch_to_write(record + line * i);
}

/// How many rows ahead of its copy the row of a node is prefetched: numbers of a chunk's nodes jump where other chunks
/// own them. 48 takes 0.95 to 0.97 of the whole step's time without; 24 is as good, 12 and 96 less so.
inline constexpr int rows_ahead = 48;

/// A pack whose elements may resist folding: what its own body need not keep for that.
struct FoldingPack {
  const Real* nodes;
  const std::uint16_t* corners;
  Real dt, modulus, threshold;
  bool is_near;  // whether an element is known to be near folding
};

/// Adds the resistance of a pack to its forces, if an element is near folding. A call that gathers the motion anew: the
/// body of the element keeps its registers.
PERCUSS_NO_INLINE inline FoldResult<HexLanes> resist_folding_of_pack(const FoldingPack& pack, const HexLanes& mass,
                                                                     const HexLanes& stable_step, HexLanes (&f)[3][8]) {
  VectorModes<HexLanes> a, v;
  gather_modes(pack.nodes, pack.corners, a);
  const HexLanes threshold(pack.threshold);
  if (!pack.is_near && !is_near_folding(threshold, a, find_volume_gradient(a).volume))
    return {HexLanes(0), stable_step, false, false};
  gather_modes(pack.nodes + 4, pack.corners, v);
  return add_fold_resistance(FoldRule<HexLanes>{HexLanes(pack.modulus), threshold},
                             FoldMotion<HexLanes>{a, v, HexLanes(pack.dt)}, mass, stable_step, f);
}

/// Follows the bounds of a pack: growth of the square of the element's frequency since the estimate, relative to it or
/// to the square of the mesh's frequency, whichever is larger.
PERCUSS_FORCE_INLINE void watch_step(const StepWatch& watch, std::size_t lane, const HexLanes& bound,
                                     HexLanes& growth) {
  store_pack(&watch.bound(lane), bound);
  if (watch.step <= 0) return;
  const HexLanes reference = load_pack(&watch.reference(lane));
  const HexLanes ratio = reference / bound, share = HexLanes(static_cast<Real>(watch.step)) / reference;
  growth = larger(growth, (ratio * ratio - HexLanes(1)) * smaller(HexLanes(1), share * share));
}

/// Largest growth of the lanes; NaN if the first one's is.
PERCUSS_FORCE_INLINE double reduce_growth(const HexLanes& value) {
  constexpr int width = pack_size<Real>;
  alignas(64) Real row[width];
  store_pack(row, value);
  Real largest = row[0];
  for (int lane = 1; lane < width; ++lane) largest = larger(largest, row[lane]);
  return largest;
}

template <class Material, HexKind Kind>
struct AdvanceChunk {
  static constexpr int width = pack_size<Real>;
  ElementChunks chunks;
  HexBlock<Material, Kind> block;
  ElementMotion motion;
  Array<Real> state;
  Rows3<double> slot_force;
  ChunkResults results;

  KOKKOS_FUNCTION void operator()(const ChunkMember& member) const {
    const int c = block.chunks(member.league_rank());
    const int first_slot = chunks.first_slot(c);
    const int slot_count = chunks.first_slot(c + 1) - first_slot;
    const HexScratch scratch(member, slot_count);
    Real* const nodes = scratch.nodes;
    double* const forces = scratch.forces;
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    const double* const x = motion.x.data();
    const double* const v = motion.v.data();
    const ChunkRest rest(chunks, results, c,
                         motion.skips_rest && !changes_at_rest(block.parameters(chunks.parameters(c)).material),
                         motion.v);
    if (rest.skips()) return;
    const std::size_t middle = 3 * static_cast<std::size_t>(slots_to_nodes[slot_count / 2]);
    for (int s = 0; s < slot_count; ++s) {
      const int ahead = slots_to_nodes[s + rows_ahead < slot_count ? s + rows_ahead : slot_count - 1];
      fetch_ahead(x + 3 * static_cast<std::size_t>(ahead));
      fetch_ahead(v + 3 * static_cast<std::size_t>(ahead));
      const std::size_t n = 3 * static_cast<std::size_t>(slots_to_nodes[s]);
      fill_row(x + n, x + middle, nodes + node_record * s);
      fill_row(v + n, v + middle, nodes + node_record * s + 4);
      clear_record(forces + force_record * s);
    }
    rest.leave(advance_packs(c, nodes, forces, rest.is_at_rest()));
    copy_force_rows(forces, slot_count, &slot_force(first_slot, 0));
  }

  /// The packs of a chunk that have an element which may resist folding: those that are oblique, and all while one of
  /// the chunk resists, whose work of the step needs the force at n.
  class FoldingPacks {
   public:
    KOKKOS_FUNCTION FoldingPacks(const AdvanceChunk& of, int c) : dt_(static_cast<Real>(of.motion.dt)) {
      if (of.chunks.fold_threshold.extent(0) == 0) return;
      threshold_ = of.chunks.fold_threshold(c);
      takes_all_ = of.results.resists(c) != 0;
    }
    PERCUSS_FORCE_INLINE void resist(const SolidParameters<Material>& parameters, const Real* nodes,
                                     const std::uint16_t* corners, const HexLanes& mass, HexLanes (&f)[3][8],
                                     HexResult<HexLanes>& result) {
      acted_ = threshold_ > 0 && (takes_all_ || any(result.obliqueness > HexLanes(Real(unfolded_obliqueness))));
      if (!acted_) return;
      const auto modulus = static_cast<Real>(fold_stiffness * (parameters.lambda + 2 * parameters.mu));
      const HexLanes step = result.stable_step;
      const FoldResult<HexLanes> fold =
          resist_folding_of_pack({nodes, corners, dt_, modulus, threshold_, takes_all_}, mass, step, f);
      acted_ = fold.acted;
      result.stable_step = fold.stable_step;
      result.work.folding = fold.work;
      resists_ = fold.resists || resists_;
    }
    KOKKOS_FUNCTION bool acted() const { return acted_; }
    KOKKOS_FUNCTION void leave(const ChunkResults& of_chunks, int c) const {
      if (threshold_ > 0) of_chunks.resists(c) = resists_ ? 1 : 0;
    }

   private:
    Real dt_, threshold_ = 0;
    bool takes_all_ = false, acted_ = false, resists_ = false;
  };

  /// Returns whether a bit of the records has changed, if watched.
  KOKKOS_FUNCTION bool advance_packs(int c, const Real* nodes, double* forces, bool watched) const {
    constexpr int largest_size = hex_record_size<Material, Kind> * width;
    static_assert(sizeof(LaneState<Material, Kind>) == largest_size * sizeof(Real));
    const auto record_size = find_record_size(c);
    SolidParameters<Material> parameters = block.parameters(chunks.parameters(c));
    parameters.time = motion.time;
    const int first = chunks.first_element(c);
    const int end = chunks.first_element(c + 1);
    Real* record = &state(chunks.first_state(c));
    const std::uint16_t* next_corners =
        &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * width);
    constexpr int fetched = is_called<Material> ? HexRecord::history<Kind, Material> * width : largest_size;
    ChunkSums<Real> sums;
    FoldingPacks folding(*this, c);
    RecordWatch<largest_size> watch(watched);
    const bool watches_step = motion.watch.bound.extent(0) > 0;
    HexLanes growth(0);
    LivingLanes living(motion.failing, motion.lives, c);
    for (int e = first; e < end; e += width, record += record_size, next_corners += 8 * width) {
      const int lanes = end - e < width ? end - e : width;
      const std::uint16_t* corners = next_corners;
      if (living.can_fail() && !living.take_pack(corners)) continue;
      const Real* const next = record + record_size;
      VectorModes<HexLanes> a, v;
      fetch_third<fetched>(next, 0);
      gather_modes(nodes, corners, a);
      fetch_third<fetched>(next, 1);
      gather_modes(nodes + 4, corners, v);
      auto& s = *reinterpret_cast<LaneState<Material, Kind>*>(record);  // its scalars lie like the record's
      watch.keep(record, record_size);
      HexLanes f[3][8];
      HexResult<HexLanes> result =
          advance_hex8(parameters, a, v, HexLanes(static_cast<Real>(motion.dt)), s, {f[0], f[1], f[2]});
      fetch_third<fetched>(next, 2);
      folding.resist(parameters, nodes, corners, s.mass, f, result);
      if (living.can_fail()) living.settle(result, f);
      scatter_forces(f, corners, lanes, forces);
      watch.compare(record, record_size);
      sums.take_step(result.stable_step, result.volume, e - first, lanes);
      if (watches_step) {
        const int pack = chunks.first_pack(c) + (e - first) / width;
        watch_step(motion.watch, static_cast<std::size_t>(pack) * width, result.stable_step, growth);
      }
      sums.take_work(result.work, lanes);
      if (folding.acted()) sums.take_work(WorkKind::folding, result.work.folding, lanes);
    }
    folding.leave(results, c);
    if (watches_step) motion.watch.growth(c) = reduce_growth(growth);
    sums.leave_work(c, results);
    sums.leave_step(c, first, end - first, results);
    return watch.has_changed();
  }

  /// Numbers of a pack's record: known to the compiler, except for called materials, each of which has its own number.
  KOKKOS_FUNCTION auto find_record_size(int c) const {
    if constexpr (is_called<Material>) {
      return chunks.record_size(c) * width;
    } else {
      return std::integral_constant<int, hex_record_size<Material, Kind> * width>();
    }
  }
};

template <class Material, HexKind Kind>
void advance_block(const ExecSpace& space, const ElementChunks& chunks, const HexBlock<Material, Kind>& block,
                   const ElementMotion& motion, const ChunkFields& fields) {
  const int count = static_cast<int>(block.chunks.extent(0));
  if (count == 0) return;
  using Kernel = AdvanceChunk<Material, Kind>;
  const ChunkPolicy policy = HexScratch::make_policy(space, count, chunks.largest_slot_count);
  Kokkos::parallel_for("percuss::advance_elements", policy,
                       Kernel{chunks, block, motion, fields.state, fields.slot_force, fields.results});
}

/// Compiles advance_block for a material and a kind of element.
#define PERCUSS_COMPILE_ADVANCE(MATERIAL, KIND)                                                        \
  template void advance_block(const ExecSpace&, const ElementChunks&, const HexBlock<MATERIAL, KIND>&, \
                              const ElementMotion&, const ChunkFields&);

}  // namespace percuss
