#pragma once
// What the launchers of shells share: records of a chunk's nodes and forces in scratch, and how packs of elements read
// the former and add to the latter.
//
// Sources that include this are compiled with the same options (kernels/shell/CMakeLists.txt).

#include <type_traits>

#include "kernels/element/chunk_records.hpp"
#include "kernels/shell/shell4.hpp"

namespace percuss {

inline constexpr int shell_width = pack_size<double>;
inline constexpr int corners_of_shell_pack = 8 * shell_width;  // of the shared table; shells use the first half
inline constexpr int shell_node_record = 12;                   // x, -, v, -, w, -: three numbers each
inline constexpr int shell_force_record = 8;                   // force, -, moment, -

using ShellScratch = ChunkScratch<shell_node_record, shell_force_record>;

/// A vector of the pack's corners, from the chunk's node records.
PERCUSS_FORCE_INLINE void gather_corners(const double* nodes, const std::uint16_t* corners, Vector3<Lanes> (&u)[4]) {
  for (int i = 0; i < 4; ++i) {
    const double* records[shell_width];
    for (int lane = 0; lane < shell_width; ++lane) {
      records[lane] = nodes + shell_node_record * static_cast<std::size_t>(corners[i * shell_width + lane]);
    }
    Lanes packs[3];
    transpose_to_packs(records, packs);
    u[i] = {packs[0], packs[1], packs[2]};
  }
}

/// Subtracts a vector of the corners of the first `lanes` elements from the chunk's records, element by element.
PERCUSS_FORCE_INLINE void scatter_corners(const Vector3<Lanes> (&u)[4], const std::uint16_t* corners, int lanes,
                                          double* sums) {
  alignas(64) double records[4][shell_width][4];
  for (int i = 0; i < 4; ++i) {
    const Lanes packs[3] = {u[i].x, u[i].y, u[i].z};
    transpose_to_records(packs, records[i]);
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (int i = 0; i < 4; ++i) {
      subtract_record(records[i][lane],
                      sums + shell_force_record * static_cast<std::size_t>(corners[i * shell_width + lane]));
    }
  }
}

/// Which lanes of a pack are triangles: their last corner is the third again.
PERCUSS_FORCE_INLINE auto find_shapes(const std::uint16_t* corners) {
  alignas(64) double repeated[shell_width];
  for (int lane = 0; lane < shell_width; ++lane) {
    repeated[lane] = corners[2 * shell_width + lane] == corners[3 * shell_width + lane] ? 1 : 0;
  }
  const auto is_triangle = load_pack(repeated) > Lanes(0.5);
  return MixedShapes<std::remove_const_t<decltype(is_triangle)>>{is_triangle};
}

}  // namespace percuss
