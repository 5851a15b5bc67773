#pragma once
// Shells as packs of a launcher: records of their nodes and forces in scratch, shapes, and what lanes leave.
//
// Sources that include this are compiled with the same options (kernels/shell/CMakeLists.txt).

#include <type_traits>

#include "kernels/element/chunk_records.hpp"
#include "kernels/shell/shell4.hpp"

namespace percuss {

inline constexpr int shell_width = pack_size<double>;

using ShellScratch = ChunkScratch<3, 2>;

/// The motion of a pack's corners.
struct GatheredShells {
  Vector3<Lanes> x[4], v[4], w[4];

  PERCUSS_FORCE_INLINE GatheredShells(const ShellScratch& scratch, const std::uint16_t* corners) {
    scratch.gather(0, corners, x);
    scratch.gather(1, corners, v);
    scratch.gather(2, corners, w);
  }
};

/// Marks the lanes of a pack that are triangles: their last corner is the third again.
PERCUSS_FORCE_INLINE auto find_shapes(const std::uint16_t* corners) {
  alignas(64) double repeated[shell_width];
  for (int lane = 0; lane < shell_width; ++lane) {
    repeated[lane] = corners[2 * shell_width + lane] == corners[3 * shell_width + lane] ? 1 : 0;
  }
  const auto is_triangle = load_pack(repeated) > Lanes(0.5);
  return MixedShapes<std::remove_const_t<decltype(is_triangle)>>{is_triangle};
}

}  // namespace percuss
