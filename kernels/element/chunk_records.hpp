#pragma once
// What launchers over chunks share: records of a chunk's nodes and forces in scratch, and how packs of elements read
// the former and add to the latter.
//
// Sources that include this are compiled with the same options (kernels/element/CMakeLists.txt).

#include <cstdint>
#include <cstring>
#include <utility>

#include "kernels/core/precision.hpp"
#include "kernels/core/same_bits.hpp"
#include "kernels/core/short_transpose.hpp"
#include "kernels/core/views.hpp"
#include "kernels/core/widen.hpp"
#include "kernels/element/hex8/modes.hpp"

namespace percuss {

using Lanes = Pack<double>;             // one element a lane
using HexLanes = Pack<Real>;            // the same in the precision of the hexahedra
inline constexpr int node_record = 8;   // x, y, z, -, vx, vy, vz, -: one cache line of doubles
inline constexpr int force_record = 4;  // fx, fy, fz, -, in double whatever the elements work in

/// Modes of a vector field of the pack's elements, from the chunk's node records. A call, as its results go to memory
/// anyhow: there are more of them than registers.
template <class Scalar>
PERCUSS_NO_INLINE void gather_modes(const Scalar* nodes, const std::uint16_t* corners,
                                    VectorModes<Pack<Scalar>>& modes) {
  constexpr int width = pack_size<Scalar>;
  Pack<Scalar> u[3][8];
  // one after the other and not in a loop, so that u stays in registers
  const auto gather_corner = [&](auto i) {
    const Scalar* records[width];
    for (int lane = 0; lane < width; ++lane) {
      records[lane] = nodes + node_record * static_cast<std::size_t>(corners[i * width + lane]);
    }
    Pack<Scalar> packs[3];
    transpose_to_packs(records, packs);
    for (int k = 0; k < 3; ++k) u[k][i] = packs[k];
  };
  [&]<int... I>(std::integer_sequence<int, I...>) { (gather_corner(std::integral_constant<int, I>()), ...); }
  (std::make_integer_sequence<int, 8>());
  for (int k = 0; k < 3; ++k) to_modes(u[k]);
  for (int m = 1; m < 8; ++m) modes[m] = {u[0][m], u[1][m], u[2][m]};
}

/// Subtracts the corner forces of the first `lanes` elements from the chunk's force records, element by element.
PERCUSS_NO_INLINE inline void scatter_forces(const Lanes (&f)[3][8], const std::uint16_t* corners, int lanes,
                                             double* forces) {
  constexpr int width = pack_size<double>;
  alignas(64) double records[8][width][4];
  for (int i = 0; i < 8; ++i) {
    const Lanes packs[3] = {f[0][i], f[1][i], f[2][i]};
    transpose_to_records(packs, records[i]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < 8; ++i) {
      subtract_record(records[i][lane], forces + force_record * static_cast<std::size_t>(corners[i * width + lane]));
    }
  }
}

/// The same of forces by mode, as elements in float leave them: turned to corners and added in double, so that those of
/// an element add up to nothing.
PERCUSS_NO_INLINE inline void scatter_forces(const Pack<float> (&f)[3][8], const std::uint16_t* corners, int lanes,
                                             double* forces) {
  constexpr int width = pack_size<double>, all = pack_size<float>;
  visit_parts<Pack<float>>([&](auto part) {
    alignas(64) double records[8][width][4];
    Lanes u[3][8];
    for (int k = 0; k < 3; ++k) {
      for (int m = 0; m < 8; ++m) u[k][m] = load_wide<part>(f[k][m]);
      to_corners(u[k]);
    }
    for (int i = 0; i < 8; ++i) {
      const Lanes packs[3] = {u[0][i], u[1][i], u[2][i]};
      transpose_to_records(packs, records[i]);
    }
    constexpr int first = part * width;
    for (int lane = 0; lane < width && first + lane < lanes; ++lane) {
      for (int i = 0; i < 8; ++i) {
        subtract_record(records[i][lane],
                        forces + force_record * static_cast<std::size_t>(corners[i * all + first + lane]));
      }
    }
  });
}

using ChunkPolicy = Kokkos::TeamPolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
using ChunkMember = ChunkPolicy::member_type;

/// Records of a chunk's slots in a team's scratch memory: NodeSize Scalars and ForceSize doubles a slot, each list on a
/// cache line of its own.
template <int NodeSize, int ForceSize, class Scalar = double>
struct ChunkScratch {
  Scalar* nodes;
  double* forces;

  KOKKOS_FUNCTION ChunkScratch(const ChunkMember& member, int slot_count)
      : nodes(take<Scalar>(member, slot_count * NodeSize)), forces(take<double>(member, slot_count * ForceSize)) {}

  template <class T>
  static KOKKOS_FUNCTION T* take(const ChunkMember& member, int scalars) {
    return static_cast<T*>(member.team_scratch(0).get_shmem_aligned(static_cast<std::size_t>(scalars) * sizeof(T), 64));
  }

  /// One team a chunk, `count` of them, the largest of which has so many slots. more_bytes: beside those of the slots.
  static ChunkPolicy make_policy(const ExecSpace& space, int count, int largest_slot_count,
                                 std::size_t more_bytes = 0) {
    const std::size_t bytes =
        static_cast<std::size_t>(largest_slot_count) * (NodeSize * sizeof(Scalar) + ForceSize * sizeof(double)) +
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
using HexScratch = ChunkScratch<node_record, force_record, Real>;

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

/// The rows of `count` force records: to[3 s + k] = records[force_record s + k]. Each row but the last is stored with
/// the number behind it, which the next row overwrites.
PERCUSS_FORCE_INLINE void copy_force_rows(const double* records, int count, double* to) {
  static_assert(force_record == 4);
  for (int s = 0; s < count - 1; ++s) std::memcpy(to + 3 * s, records + force_record * s, 4 * sizeof(double));
  if (count > 0) copy_row(records + force_record * (count - 1), to + 3 * (count - 1));
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

}  // namespace percuss
