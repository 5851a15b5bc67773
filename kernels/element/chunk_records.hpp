#pragma once
// What launchers over chunks share: records of a chunk's nodes and forces in scratch, and how packs of elements read
// the former and add to the latter.
//
// Sources that include this are compiled with the same options (kernels/element/CMakeLists.txt).

#include <cstdint>
#include <cstring>
#include <utility>

#include "kernels/core/transpose.hpp"
#include "kernels/core/views.hpp"
#include "kernels/element/modes.hpp"

namespace percuss {

using Lanes = Pack<double>;             // one element a lane
inline constexpr int node_record = 8;   // x, y, z, -, vx, vy, vz, -: one cache line
inline constexpr int force_record = 4;  // fx, fy, fz, -

/// Modes of a vector field of the pack's elements, from the chunk's node records. A call, as its results go to memory
/// anyhow: there are more of them than registers.
PERCUSS_NO_INLINE inline void gather_modes(const double* nodes, const std::uint16_t* corners,
                                           VectorModes<Lanes>& modes) {
  constexpr int width = pack_size<double>;
  Lanes u[3][8];
  // one after the other and not in a loop, so that u stays in registers
  const auto gather_corner = [&](auto i) {
    const double* records[width];
    for (int lane = 0; lane < width; ++lane) {
      records[lane] = nodes + node_record * static_cast<std::size_t>(corners[i * width + lane]);
    }
    Lanes packs[3];
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

using ChunkPolicy = Kokkos::TeamPolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
using ChunkMember = ChunkPolicy::member_type;

/// Records of a chunk's slots in a team's scratch memory: NodeSize and ForceSize scalars a slot, each list on a cache
/// line of its own.
template <int NodeSize, int ForceSize>
struct ChunkScratch {
  double* nodes;
  double* forces;

  KOKKOS_FUNCTION ChunkScratch(const ChunkMember& member, int slot_count)
      : nodes(take(member, slot_count * NodeSize)), forces(take(member, slot_count * ForceSize)) {}

  static KOKKOS_FUNCTION double* take(const ChunkMember& member, int scalars) {
    return static_cast<double*>(
        member.team_scratch(0).get_shmem_aligned(static_cast<std::size_t>(scalars) * sizeof(double), 64));
  }

  /// One team a chunk, `count` of them, the largest of which has so many slots.
  static ChunkPolicy make_policy(const ExecSpace& space, int count, int largest_slot_count) {
    const std::size_t bytes =
        (static_cast<std::size_t>(largest_slot_count) * (NodeSize + ForceSize) + 8) * sizeof(double) + 128;
    ChunkPolicy policy(space, count, 1);
    policy.set_scratch_size(0, Kokkos::PerTeam(static_cast<int>(bytes))).set_chunk_size(1);
    return policy;
  }
};
using HexScratch = ChunkScratch<node_record, force_record>;

/// Three numbers: a row of a view, or a record without its padding.
PERCUSS_FORCE_INLINE void copy_row(const double* from, double* to) { std::memcpy(to, from, 3 * sizeof(double)); }

/// Whether the bits of three numbers are those of +0. (The sign of a zero could reach the bits of the state.)
PERCUSS_FORCE_INLINE bool is_plain_zero(const double* row) {
  std::uint64_t bits[3];
  std::memcpy(bits, row, sizeof bits);
  return (bits[0] | bits[1] | bits[2]) == 0;
}

}  // namespace percuss
