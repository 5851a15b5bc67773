#pragma once
// How packs of hexahedra read a chunk's node records and add to its force records, in double and in float.

#include "kernels/core/short_transpose.hpp"
#include "kernels/core/widen.hpp"
#include "kernels/element/chunk_records.hpp"
#include "kernels/element/hex8/modes.hpp"

namespace percuss {

using HexLanes = Pack<Real>;
using HexScratch = ChunkScratch<2, 1, Real>;

/// Modes of a vector field of the pack's elements, from the chunk's node records. A call, as its results go to memory
/// anyhow: there are more of them than registers.
template <class Scalar>
PERCUSS_NO_INLINE void gather_modes(const Scalar* nodes, const std::uint16_t* corners,
                                    VectorModes<Pack<Scalar>>& modes) {
  Pack<Scalar> u[3][8];
  // one after the other and not in a loop, so that u stays in registers
  const auto gather_corner = [&](auto i) {
    constexpr int width = pack_size<Scalar>;
    const Scalar* records[width];
    for (int lane = 0; lane < width; ++lane) {
      records[lane] = nodes + HexScratch::node_size * static_cast<std::size_t>(corners[i * width + lane]);
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

/// The mean of the corners of the pack's elements. A call, which code of users alone makes.
template <class Scalar>
PERCUSS_NO_INLINE Vector3<Pack<Scalar>> gather_center(const Scalar* nodes, const std::uint16_t* corners) {
  constexpr int width = pack_size<Scalar>;
  alignas(64) Scalar sums[3][width] = {};
  for (int i = 0; i < 8 * width; ++i)
    for (int k = 0; k < 3; ++k)
      sums[k][i % width] +=
          nodes[HexScratch::node_size * static_cast<std::size_t>(corners[i]) + static_cast<std::size_t>(k)];
  const Pack<Scalar> eighth(Scalar(0.125));
  return {eighth * load_pack(sums[0]), eighth * load_pack(sums[1]), eighth * load_pack(sums[2])};
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
      subtract_record(records[i][lane],
                      forces + HexScratch::force_size * static_cast<std::size_t>(corners[i * width + lane]));
    }
  }
}

/// Scatters forces by mode, as elements in float leave them: turned to corners and added in double, so that those of
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
                        forces + HexScratch::force_size * static_cast<std::size_t>(corners[i * all + first + lane]));
      }
    }
  });
}

}  // namespace percuss
