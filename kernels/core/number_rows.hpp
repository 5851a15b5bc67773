#pragma once
// Rows of four or eight numbers: their sums, and how packs become rows of eight and rows packs.

#include <cstring>

#include "kernels/core/transpose.hpp"

namespace percuss {

/// A sum of rows of N numbers, 4 or 8, from 0 in the order in which they come. Rows lie anywhere.
template <int N>
class RowSum {
 public:
#ifdef PERCUSS_HAS_SIMD
  static constexpr int width = N == 8 && pack_size<double> == 8 ? 8 : 4, parts = N / width;
  using Raw = typename detail::RawPack<width>::type;
  Raw part[parts] = {};

  PERCUSS_FORCE_INLINE void add(const double* row) {
    for (int k = 0; k < parts; ++k) part[k] += load(row, k);
  }
  PERCUSS_FORCE_INLINE void subtract(const double* row) {
    for (int k = 0; k < parts; ++k) part[k] -= load(row, k);
  }
  /// Adds a row times `scale`, a row as well.
  PERCUSS_FORCE_INLINE void add_scaled(const double* scale, const double* row) {
    for (int k = 0; k < parts; ++k) part[k] += load(scale, k) * load(row, k);
  }
  PERCUSS_FORCE_INLINE void scale(double by) {
    for (int k = 0; k < parts; ++k) part[k] = by * part[k];
  }
  PERCUSS_FORCE_INLINE void store(double* row) const {
    for (int k = 0; k < parts; ++k) std::memcpy(row + width * k, &part[k], sizeof(Raw));
  }
  PERCUSS_FORCE_INLINE void store_three(double* row) const { std::memcpy(row, &part[0], 3 * sizeof(double)); }

 private:
  static PERCUSS_FORCE_INLINE Raw load(const double* row, int k) {
    Raw raw;
    std::memcpy(&raw, row + width * k, sizeof raw);
    return raw;
  }
#else
  double value[N] = {};

  PERCUSS_FORCE_INLINE void add(const double* row) {
    for (int k = 0; k < N; ++k) value[k] += row[k];
  }
  PERCUSS_FORCE_INLINE void subtract(const double* row) {
    for (int k = 0; k < N; ++k) value[k] -= row[k];
  }
  PERCUSS_FORCE_INLINE void add_scaled(const double* scale, const double* row) {
    for (int k = 0; k < N; ++k) value[k] += scale[k] * row[k];
  }
  PERCUSS_FORCE_INLINE void scale(double by) {
    for (int k = 0; k < N; ++k) value[k] = by * value[k];
  }
  PERCUSS_FORCE_INLINE void store(double* row) const {
    for (int k = 0; k < N; ++k) row[k] = value[k];
  }
  PERCUSS_FORCE_INLINE void store_three(double* row) const {
    for (int k = 0; k < 3; ++k) row[k] = value[k];
  }
#endif
};

#ifdef PERCUSS_HAS_SIMD
namespace detail {

/// Transposes the block of 8 x 8 in eight vectors.
template <class Raw>
PERCUSS_FORCE_INLINE void transpose_eight(Raw (&rows)[8]) {
  constexpr auto lanes = std::make_integer_sequence<int, 8>();
  for (int i = 0; i < 4; ++i) swap_blocks<4, 8>(rows[i], rows[i + 4], lanes);
  for (int i = 0; i < 8; i += 4) {
    swap_blocks<2, 8>(rows[i], rows[i + 2], lanes);
    swap_blocks<2, 8>(rows[i + 1], rows[i + 3], lanes);
  }
  for (int i = 0; i < 8; i += 2) swap_blocks<1, 8>(rows[i], rows[i + 1], lanes);
}

}  // namespace detail
#endif

/// Sums of the W lanes as packs: packs[k][lane] is the k-th number of rows[lane].
template <int W>
PERCUSS_FORCE_INLINE void turn_to_packs(const RowSum<8> (&rows)[W], Pack<double> (&packs)[8]) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = RowSum<8>::Raw;
  if constexpr (W == 8) {
    Raw block[8];
    for (int i = 0; i < 8; ++i) block[i] = rows[i].part[0];
    detail::transpose_eight(block);
    for (int k = 0; k < 8; ++k) packs[k] = Pack<double>(block[k]);
    return;
  } else if constexpr (W == 4) {
    for (int half = 0; half < 2; ++half) {
      Raw block[4];
      for (int i = 0; i < 4; ++i) block[i] = rows[i].part[half];
      detail::transpose_blocks<4>(block);
      for (int k = 0; k < 4; ++k) packs[4 * half + k] = Pack<double>(block[k]);
    }
    return;
  }
#endif
  alignas(64) double row[W][8];
  for (int lane = 0; lane < W; ++lane) rows[lane].store(row[lane]);
  for (int k = 0; k < 8; ++k) {
    alignas(64) double column[W];
    for (int lane = 0; lane < W; ++lane) column[lane] = row[lane][k];
    packs[k] = load_pack(column);
  }
}

/// The way back: to[stride lane + k] = packs[k][lane]. Rows are aligned to eight doubles.
PERCUSS_FORCE_INLINE void turn_to_rows(const Pack<double> (&packs)[8], double* to, int stride) {
  constexpr int W = pack_size<double>;
#ifdef PERCUSS_HAS_SIMD
  using Raw = RowSum<8>::Raw;
  if constexpr (W == 8) {
    Raw block[8];
    for (int k = 0; k < 8; ++k) block[k] = static_cast<Raw>(packs[k]);
    detail::transpose_eight(block);
    for (int i = 0; i < 8; ++i) *reinterpret_cast<Raw*>(to + stride * i) = block[i];
    return;
  } else if constexpr (W == 4) {
    for (int half = 0; half < 2; ++half) {
      Raw block[4];
      for (int k = 0; k < 4; ++k) block[k] = static_cast<Raw>(packs[4 * half + k]);
      detail::transpose_blocks<4>(block);
      for (int i = 0; i < 4; ++i) *reinterpret_cast<Raw*>(to + stride * i + 4 * half) = block[i];
    }
    return;
  }
#endif
  for (int k = 0; k < 8; ++k) {
    alignas(64) double column[W];
    store_pack(column, packs[k]);
    for (int lane = 0; lane < W; ++lane) to[stride * lane + k] = column[lane];
  }
}

}  // namespace percuss
