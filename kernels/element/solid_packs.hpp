#pragma once
// What the launchers of solids other than hexahedra share: a chunk's nodes in scratch, packs of elements from them, and
// what packs leave. These elements are in double.
//
// Sources that include this are compiled with the same options (kernels/tet/CMakeLists.txt).

#include "kernels/core/prefetch.hpp"
#include "kernels/element/chunk_records.hpp"
#include "kernels/element/chunk_rest.hpp"
#include "kernels/element/chunk_sums.hpp"
#include "kernels/element/internal_force.hpp"
#include "kernels/element/living_lanes.hpp"

namespace percuss {

inline constexpr int solid_width = pack_size<double>;

/// How many rows ahead of its use a row of a node is prefetched, as for hexahedra (advance_chunk.hpp).
inline constexpr int node_rows_ahead = 48;
using SolidScratch = ChunkScratch<node_record, force_record>;
using SolidSums = ChunkSums<double>;

/// The first numbers of one corner of a pack's elements, from rows of `row_size` numbers, at least four.
template <int Columns>
PERCUSS_FORCE_INLINE void gather_corner(const double* rows, int row_size, const std::uint16_t* corner,
                                        Lanes (&packs)[Columns]) {
  const double* records[solid_width];
  for (int lane = 0; lane < solid_width; ++lane)
    records[lane] = rows + static_cast<std::size_t>(row_size) * corner[lane];
  transpose_to_packs(records, packs);
}

/// A vector of the pack's N corners. Field: indexed by corner.
template <int N, class Field>
PERCUSS_FORCE_INLINE void gather_corners(const double* rows, int row_size, const std::uint16_t* corners, Field& u) {
  for (int i = 0; i < N; ++i) {
    Lanes packs[3];
    gather_corner(rows, row_size, corners + i * solid_width, packs);
    u[i] = {packs[0], packs[1], packs[2]};
  }
}

/// Subtracts the forces of the first `lanes` elements from the chunk's records, element by element.
template <int N, class Field>
PERCUSS_FORCE_INLINE void scatter_corners(const Field& f, const std::uint16_t* corners, int lanes, double* forces) {
  alignas(64) double records[N][solid_width][4];
  for (int i = 0; i < N; ++i) {
    const Lanes packs[3] = {f[i].x, f[i].y, f[i].z};
    transpose_to_records(packs, records[i]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < N; ++i)
      subtract_record(records[i][lane],
                      forces + force_record * static_cast<std::size_t>(corners[i * solid_width + lane]));
  }
}

/// The same of N corners, with the number behind the vector.
template <int N, class Field>
PERCUSS_FORCE_INLINE void gather_corners(const double* rows, int row_size, const std::uint16_t* corners, Field& u,
                                         Lanes (&behind)[N]) {
  for (int i = 0; i < N; ++i) {
    Lanes packs[4];
    gather_corner(rows, row_size, corners + i * solid_width, packs);
    u[i] = {packs[0], packs[1], packs[2]};
    behind[i] = packs[3];
  }
}

/// The chunk of a team.
struct SolidChunk {
  const ElementChunks& chunks;
  int c, first_slot, slot_count, first_element, end_element;

  KOKKOS_FUNCTION SolidChunk(const ElementChunks& of, int chunk)
      : chunks(of),
        c(chunk),
        first_slot(of.first_slot(chunk)),
        slot_count(of.first_slot(chunk + 1) - first_slot),
        first_element(of.first_element(chunk)),
        end_element(of.first_element(chunk + 1)) {}

  /// Places and velocities of its nodes into node records.
  KOKKOS_FUNCTION void fill_nodes(const ElementMotion& motion, double* nodes) const {
    fill_rows(motion.x.data(), nodes);
    fill_rows(motion.v.data(), nodes + 4);
  }

  /// Their places alone.
  KOKKOS_FUNCTION void fill_places(const ElementMotion& motion, double* nodes) const {
    fill_rows(motion.x.data(), nodes);
  }

  KOKKOS_FUNCTION void fill_rows(const double* rows, double* nodes) const {
    const int* const slots_to_nodes = &chunks.slots_to_nodes(first_slot);
    for (int s = 0; s < slot_count; ++s) {
      fetch_ahead(rows + 3 * static_cast<std::size_t>(
                                 slots_to_nodes[s + node_rows_ahead < slot_count ? s + node_rows_ahead : s]));
      fill_row(rows + 3 * static_cast<std::size_t>(slots_to_nodes[s]), rows, nodes + node_record * s);
    }
  }

  KOKKOS_FUNCTION const std::uint16_t* find_corners() const {
    return &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * solid_width);
  }

  KOKKOS_FUNCTION void leave_step(SolidSums& sums, const ChunkResults& results) const {
    sums.leave_step(c, first_element, end_element - first_element, results);
  }

  /// Calls visit(i, lanes, corners) for each pack i with so many elements.
  template <class Visit>
  KOKKOS_FUNCTION void for_each_pack(const Visit& visit) const {
    const std::uint16_t* corners = find_corners();
    for (int e = first_element, i = 0; e < end_element; e += solid_width, ++i, corners += 8 * solid_width)
      visit(i, end_element - e < solid_width ? end_element - e : solid_width, corners);
  }
};

/// Active lanes of a chunk of solids in double, pass by pass (LivingLanes). A template, so that it is not instantiated
/// in single precision, in which only hexahedra exist.
template <class>
class LivingSolids : public LivingLanes {
 public:
  KOKKOS_FUNCTION LivingSolids(const FailingChunks& failing, const ElementLives& lives, int chunk)
      : LivingLanes(failing, lives, chunk),
        shares_(&lives.force_share),
        first_((failing.find_pack(chunk) - 1) * width) {}

  KOKKOS_FUNCTION bool take_pack(const std::uint16_t*& corners) {
    first_ += width;
    return LivingLanes::take_pack(corners);
  }

  /// Shares of its force that each lane leaves at this evaluation, as far as the last one says; negative: eroded.
  KOKKOS_FUNCTION Lanes load_force_share() const { return load_pack(&(*shares_)(static_cast<std::size_t>(first_))); }

 private:
  const Array<Real>* shares_;
  int first_;  // lane of the pack
};

/// A pack of a chunk in work.
struct SolidPack {
  const SolidChunk& chunk;
  int pack, lanes;
  const std::uint16_t* corners;
  const SolidScratch& scratch;
  const Real* next;  // record of the next pack, of `size` numbers, which is prefetched in parts during the work on this
  int size;

  /// Prefetches a third of the next record.
  PERCUSS_FORCE_INLINE void fetch_third(int third) const {
    constexpr int line = static_cast<int>(cache_line / sizeof(Real));
    const int lines = size / line;
    for (int i = lines * third / 3; i < lines * (third + 1) / 3; ++i) fetch_to_write(next + line * i);
  }

  /// Its step bounds and volumes.
  PERCUSS_FORCE_INLINE void take_step(const Lanes& step, const Lanes& volume, SolidSums& sums) const {
    sums.take_step(step, volume, pack * solid_width, lanes);
  }

  /// The step bounds of its elements, if they are watched.
  KOKKOS_FUNCTION void leave_bound(const StepWatch& watch, const Lanes& step) const {
    if (watch.bound.extent(0) == 0) return;
    alignas(64) double steps[solid_width];
    store_pack(steps, step);
    Real* const bound = &watch.bound(static_cast<std::size_t>(chunk.chunks.first_pack(chunk.c) + pack) * solid_width);
    for (int lane = 0; lane < solid_width; ++lane) bound[lane] = static_cast<Real>(steps[lane]);
  }
};

/// Numbers of a pack's record, of which a material that is called uses as many as it needs.
template <class State>
inline constexpr int record_limit = static_cast<int>(sizeof(State) / sizeof(Real));

/// What an evaluation of the packs of a chunk works with, in which their records change.
struct SolidRecords {
  const SolidChunk& chunk;
  const ChunkRest& rest;
  const ElementMotion& motion;
  const Array<Real>& state;
  const SolidScratch& scratch;

  /// Calls body(parameters, pack, living, state, sums) for each pack that has living elements, and leaves whether a bit
  /// of the records has changed.
  template <class State, class Material, class Body>
  KOKKOS_FUNCTION SolidSums advance(SolidParameters<Material> parameters, const Body& body) const {
    parameters.time = motion.time;
    SolidSums sums;
    RecordWatch<record_limit<State>> watch(rest.is_at_rest());
    LivingSolids<Material> living(motion.failing, motion.lives, chunk.c);
    const int size = chunk.chunks.record_size(chunk.c) * solid_width;
    Real* record = &state(chunk.chunks.first_state(chunk.c));
    chunk.for_each_pack([&](int pack, int lanes, const std::uint16_t* own_corners) {
      const std::uint16_t* corners = own_corners;
      Real* const own = record;
      record += size;
      if (living.can_fail() && !living.take_pack(corners)) return;
      watch.keep(own, size);
      body(parameters, SolidPack{chunk, pack, lanes, corners, scratch, record, size}, living,
           *reinterpret_cast<State*>(own), sums);
      watch.compare(own, size);
    });
    rest.leave(watch.has_changed());
    return sums;
  }
};

/// The elements of a block, whose packs read and write a state of their own and leave forces on their corners.
template <class Material, class Block>
struct SolidKernel {
  using Living = LivingSolids<Material>;
  ElementChunks chunks;
  Block block;
  ElementMotion motion;
  ChunkFields fields;

  /// Calls advance_pack as SolidRecords::advance for the team's chunk.
  template <class State, class AdvancePack>
  KOKKOS_FUNCTION void advance_chunk(const ChunkMember& member, const AdvancePack& advance_pack) const {
    const SolidChunk chunk(chunks, block.chunks(member.league_rank()));
    const SolidParameters<Material> parameters = block.parameters(chunks.parameters(chunk.c));
    const ChunkRest rest(chunks, fields.results, chunk.c, motion.skips_rest && !changes_at_rest(parameters.material),
                         motion.v);
    if (rest.skips()) return;
    const SolidScratch scratch(member, chunk.slot_count);
    chunk.fill_nodes(motion, scratch.nodes);
    for (int s = 0; s < chunk.slot_count; ++s) clear_record(scratch.forces + force_record * s);
    SolidSums sums =
        SolidRecords{chunk, rest, motion, fields.state, scratch}.template advance<State>(parameters, advance_pack);
    sums.leave_work(chunk.c, fields.results);
    chunk.leave_step(sums, fields.results);
    copy_force_rows(scratch.forces, chunk.slot_count, &fields.slot_force(chunk.first_slot, 0));
  }
};

/// Launches a kernel over chunks, a team each, which has so many bytes of scratch beside that of its slots.
template <class Kernel>
void launch_solids(const char* label, const ExecSpace& space, const ElementChunks& chunks, const Array<int>& list,
                   const Kernel& kernel, std::size_t more_bytes = 0) {
  const int count = static_cast<int>(list.extent(0));
  if (count == 0 || is_single_precision) return;
  Kokkos::parallel_for(label, SolidScratch::make_policy(space, count, chunks.largest_slot_count, more_bytes), kernel);
}

}  // namespace percuss
