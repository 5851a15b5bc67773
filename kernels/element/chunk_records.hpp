#pragma once
// What a team has of its chunk: records of the chunk's nodes and forces in scratch, and how packs of elements read the
// former and add to the latter.
//
// Sources that include this are compiled with the same options (kernels/element/CMakeLists.txt).

#include <cstdint>
#include <cstring>

#include "kernels/core/contract.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/prefetch.hpp"
#include "kernels/core/tensor.hpp"
#include "kernels/core/transpose.hpp"
#include "kernels/element/element_chunks.hpp"
#include "kernels/element/element_motion.hpp"

namespace percuss {

using Lanes = Pack<double>;  // one element a lane
using ChunkPolicy = Kokkos::TeamPolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
using ChunkMember = ChunkPolicy::member_type;

/// A pack of a chunk in work. Numbers of its record lie behind each other.
struct ChunkPack {
  int first, lanes;              // element of the first lane, counted from the chunk's first; elements
  const std::uint16_t* corners;  // [8][W] of elements that live
  Real* record;
  const Real* next;  // record of the next pack

  /// Prefetches a third of the next record, of so many numbers, during the work on this one: the hardware does not look
  /// ahead across the pack's long body. In thirds, because a core that requests all at once has to wait until its
  /// requests are accepted.
  PERCUSS_FORCE_INLINE void fetch_third(int size, int third) const {
    constexpr int line = static_cast<int>(cache_line / sizeof(Real));
    const int lines = (size + line - 1) / line;
    for (int i = lines * third / 3; i < lines * (third + 1) / 3; ++i) fetch_to_write(next + line * i);
  }
};

/// Lanes of elements of which none can fail (LivingLanes).
struct WholeLanes {
  KOKKOS_FUNCTION static bool can_fail() { return false; }
  KOKKOS_FUNCTION static bool take_pack(const std::uint16_t*&) { return true; }
};

/// The chunk of a team.
struct TeamChunk {
  static constexpr int width = pack_size<Real>;
  const ElementChunks& chunks;
  int c, first_slot, slot_count, first_element, count;  // count: elements

  KOKKOS_FUNCTION TeamChunk(const ElementChunks& of, int chunk)
      : chunks(of),
        c(chunk),
        first_slot(of.first_slot(chunk)),
        slot_count(of.first_slot(chunk + 1) - first_slot),
        first_element(of.first_element(chunk)),
        count(of.first_element(chunk + 1) - first_element) {}

  KOKKOS_FUNCTION const int* nodes() const { return &chunks.slots_to_nodes(first_slot); }
  KOKKOS_FUNCTION const std::uint16_t* corners() const {
    return &chunks.corner_slots(static_cast<std::size_t>(chunks.first_pack(c)) * 8 * width);
  }
  KOKKOS_FUNCTION int count_lanes() const { return (count + width - 1) / width * width; }

  /// Calls visit(pack) for each pack with elements that live (LivingLanes). records: of the chunk, a pack's `size`
  /// numbers apart; null: not used.
  template <class Lives, class Visit>
  PERCUSS_FORCE_INLINE void for_each_pack(Lives& lives, Real* records, int size, const Visit& visit) const {
    const std::uint16_t* all = corners();
    for (int e = 0; e < count; e += width, records += size, all += 8 * width) {
      ChunkPack pack{e, count - e < width ? count - e : width, all, records, records + size};
      if (lives.can_fail() && !lives.take_pack(pack.corners)) continue;
      visit(pack);
    }
  }
};

/// Three numbers: a row of a view, or a record without its padding.
PERCUSS_FORCE_INLINE void copy_row(const double* from, double* to) { std::memcpy(to, from, 3 * sizeof(double)); }

/// Makes the four numbers of a record 0.
PERCUSS_FORCE_INLINE void clear_record(double* record) {
#ifdef PERCUSS_HAS_SIMD
  *reinterpret_cast<detail::RawPack<4>::type*>(record) = detail::RawPack<4>::type{};
#else
  for (int k = 0; k < 4; ++k) record[k] = 0;
#endif
}

/// The rows of `count` force records: to[3 s + k] = records[4 s + k]. Each row but the last is stored with the number
/// behind it, which the next row overwrites.
PERCUSS_FORCE_INLINE void copy_force_rows(const double* records, int count, double* to) {
  for (int s = 0; s < count - 1; ++s) std::memcpy(to + 3 * s, records + 4 * s, 4 * sizeof(double));
  if (count > 0) copy_row(records + 4 * (count - 1), to + 3 * (count - 1));
}

/// A row of positions or velocities into a chunk's record of it, in single precision relative to `origin`, a row of a
/// node of the chunk: its digits then describe the shape and not the position.
PERCUSS_FORCE_INLINE void fill_row(const double* from, const double* /*origin*/, double* to) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX__)  // three of four lanes, without a look beyond the row
  _mm256_store_pd(to, _mm256_maskload_pd(from, _mm256_setr_epi64x(-1, -1, -1, 0)));
#else
  copy_row(from, to);
#endif
}
PERCUSS_FORCE_INLINE void fill_row(const double* from, const double* origin, float* to) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512VL__)  // as above
  const __m256d row = _mm256_maskz_loadu_pd(7, from), center = _mm256_maskz_loadu_pd(7, origin);
  _mm_store_ps(to, _mm256_cvtpd_ps(_mm256_sub_pd(row, center)));
#else
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(from[k] - origin[k]);
#endif
}

/// The first numbers of one corner of a pack's elements, from rows of `row_size` numbers, at least four.
template <int Columns>
PERCUSS_FORCE_INLINE void gather_corner(const double* rows, int row_size, const std::uint16_t* corner,
                                        Lanes (&packs)[Columns]) {
  constexpr int width = pack_size<double>;
  const double* records[width];
  for (int lane = 0; lane < width; ++lane) records[lane] = rows + static_cast<std::size_t>(row_size) * corner[lane];
  transpose_to_packs(records, packs);
}

/// How many rows ahead of its copy the row of a node is prefetched: numbers of a chunk's nodes jump where other chunks
/// own them. 48 takes 0.95 to 0.97 of the whole step's time without; 24 is as good, 12 and 96 less so.
inline constexpr int rows_ahead = 48;

/// Records of a chunk's slots in a team's scratch memory, each list on a cache line of its own: of a node place,
/// velocity and with three `Vectors` its spin, as Number; of `Loads` force and moment, in double whatever the elements
/// work in. A vector has three numbers and one behind.
template <int Vectors, int Loads, class Number = double>
struct ChunkScratch {
  static constexpr int node_size = 4 * Vectors, force_size = 4 * Loads;
  static constexpr bool has_spins = Vectors == 3;
  using Scalar = Number;
  Number* nodes;
  double* forces;

  KOKKOS_FUNCTION ChunkScratch(const ChunkMember& member, int slot_count)
      : nodes(take<Number>(member, slot_count * node_size)), forces(take<double>(member, slot_count * force_size)) {}

  template <class T>
  static KOKKOS_FUNCTION T* take(const ChunkMember& member, int scalars) {
    return static_cast<T*>(member.team_scratch(0).get_shmem_aligned(static_cast<std::size_t>(scalars) * sizeof(T), 64));
  }

  KOKKOS_FUNCTION void fill(const TeamChunk& chunk, const ElementMotion& motion) const {
    if constexpr (has_spins) {
      fill_rows(chunk, motion.x.data(), motion.v.data(), motion.spins().data());
    } else {
      fill_rows(chunk, motion.x.data(), motion.v.data());
    }
  }

  /// Fills the node records with rows by node, vector by vector.
  template <class... Rows>
  KOKKOS_FUNCTION void fill_rows(const TeamChunk& chunk, const Rows*... rows) const {
    const int* const to_nodes = chunk.nodes();
    const std::size_t middle = 3 * static_cast<std::size_t>(to_nodes[chunk.slot_count / 2]);
    for (int s = 0; s < chunk.slot_count; ++s) {
      const int ahead = to_nodes[s + rows_ahead < chunk.slot_count ? s + rows_ahead : chunk.slot_count - 1];
      (fetch_ahead(rows + 3 * static_cast<std::size_t>(ahead)), ...);
      const std::size_t n = 3 * static_cast<std::size_t>(to_nodes[s]);
      Number* to = nodes + node_size * s;
      ((fill_row(rows + n, rows + middle, to), to += 4), ...);
    }
  }

  KOKKOS_FUNCTION void clear(const TeamChunk& chunk) const {
    for (int i = 0; i < chunk.slot_count * Loads; ++i) clear_record(forces + 4 * i);
  }

  /// Copies forces, and with two `Loads` moments, to the slots of the chunk. One that is empty is not wanted.
  KOKKOS_FUNCTION void leave(const TeamChunk& chunk, const Rows3<double>& force, const Rows3<double>& moment) const {
    if constexpr (Loads == 1) return copy_force_rows(forces, chunk.slot_count, &force(chunk.first_slot, 0));
    for (int s = 0; s < chunk.slot_count; ++s) {
      copy_row(forces + force_size * s, &force(chunk.first_slot + s, 0));
      if (moment.extent(0) > 0) copy_row(forces + force_size * s + 4, &moment(chunk.first_slot + s, 0));
    }
  }

  /// A vector of the pack's N corners. k: which one.
  template <int N>
  PERCUSS_FORCE_INLINE void gather(int k, const std::uint16_t* corners, Vector3<Lanes> (&u)[N]) const {
    for (int i = 0; i < N; ++i) {
      Lanes packs[3];
      gather_corner(nodes + 4 * k, node_size, corners + i * pack_size<double>, packs);
      u[i] = {packs[0], packs[1], packs[2]};
    }
  }

  /// Subtracts a load of the corners of a pack's elements, one element after the other. k: which one.
  template <int N>
  PERCUSS_FORCE_INLINE void scatter(int k, const Vector3<Lanes> (&f)[N], const ChunkPack& pack) const {
    constexpr int width = pack_size<double>;
    alignas(64) double records[N][width][4];
    for (int i = 0; i < N; ++i) {
      const Lanes packs[3] = {f[i].x, f[i].y, f[i].z};
      transpose_to_records(packs, records[i]);
    }
    for (int lane = 0; lane < pack.lanes; ++lane) {
      for (int i = 0; i < N; ++i) {
        const auto slot = static_cast<std::size_t>(pack.corners[i * width + lane]);
        subtract_record(records[i][lane], forces + 4 * k + force_size * slot);
      }
    }
  }

  /// One team a chunk, `count` of them, the largest of which has so many slots. more_bytes: beside those of the slots.
  static ChunkPolicy make_policy(const ExecSpace& space, int count, int largest_slot_count, std::size_t more_bytes) {
    const std::size_t bytes =
        static_cast<std::size_t>(largest_slot_count) * (node_size * sizeof(Number) + force_size * sizeof(double)) +
        more_bytes + 8 * sizeof(double) + 128;
    ChunkPolicy policy(space, count, 1);
    policy.set_scratch_size(0, Kokkos::PerTeam(static_cast<int>(bytes))).set_chunk_size(find_share(space, count));
    return policy;
  }

  /// How many teams a thread takes at a time, a power of two: after each it waits until its stores have left. One
  /// thread alone takes all; several take fewer, so that their work stays balanced.
  static int find_share(const ExecSpace& space, int count) {
    constexpr int shares_of_thread = 64;
    const int threads = space.concurrency(), most = threads == 1 ? count : count / (shares_of_thread * threads);
    int share = 1;
    while (2 * share <= most) share *= 2;
    return share;
  }
};

/// Calls run(kernel, team) for each team of a policy.
void run_teams(const char* label, const ChunkPolicy& policy, void (*run)(const void*, const ChunkMember&),
               const void* kernel);

/// Launches a kernel over chunks, a team each, which has so many bytes of scratch beside that of its slots. In single
/// precision only hexahedra exist, and no kernel is compiled that works in double.
template <class Kernel>
void launch_chunks(const char* label, const ExecSpace& space, const ElementChunks& chunks, const Array<int>& list,
                   const Kernel& kernel, std::size_t more_bytes = 0) {
  const int count = static_cast<int>(list.extent(0));
  if (count == 0) return;
  PERCUSS_EXPECT(is_ascending(to_host(list), 0, count));
  using Scratch = typename Kernel::Scratch;
  if constexpr (std::is_same_v<typename Scratch::Scalar, Real>) {
    const ChunkPolicy policy = Scratch::make_policy(space, count, chunks.largest_slot_count, more_bytes);
#ifdef PERCUSS_ON_DEVICE
    Kokkos::parallel_for(label, policy, kernel);
#else
    const auto run = [](const void* of, const ChunkMember& team) { (*static_cast<const Kernel*>(of))(team); };
    run_teams(label, policy, run, &kernel);
#endif
  }
}

}  // namespace percuss
