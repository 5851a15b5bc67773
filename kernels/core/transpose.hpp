#pragma once
// Transposes between records in memory (array of structures) and packs (one element a lane), in registers.
//
// Eklundh's block swaps: log2(W) rounds of two-input shuffles for a W x W block, instead of W * W scalar moves.

#include <cstddef>
#include <utility>

#include "kernels/core/simd.hpp"

namespace percuss {

#ifdef PERCUSS_HAS_SIMD
namespace detail {

template <int W>
struct RawPack {
  typedef double type __attribute__((vector_size(W * sizeof(double)), may_alias));
};

template <int S, int W, class Raw, int... E>
PERCUSS_FORCE_INLINE void swap_blocks(Raw& a, Raw& b, std::integer_sequence<int, E...>) {
  const Raw low = __builtin_shufflevector(a, b, ((E & S) != 0 ? W + E - S : E)...);
  const Raw high = __builtin_shufflevector(a, b, ((E & S) != 0 ? W + E : E + S)...);
  a = low;
  b = high;
}

template <int S, int W, class Raw>
PERCUSS_FORCE_INLINE void transpose_round(Raw (&rows)[W]) {
  for (int i = 0; i < W; ++i) {
    if ((i & S) == 0) swap_blocks<S, W>(rows[i], rows[i | S], std::make_integer_sequence<int, W>());
  }
  if constexpr (S > 1) transpose_round<S / 2, W>(rows);
}

}  // namespace detail
#endif

/// Eight columns of W records into eight packs: packs[k][lane] = records[lane][k]. Records and packs are aligned to
/// eight doubles; W = pack_size<double> is 1, 2, 4 or 8.
PERCUSS_FORCE_INLINE void transpose_to_packs(const double* const (&records)[pack_size<double>],
                                             double (&packs)[8][pack_size<double>]) {
#ifdef PERCUSS_HAS_SIMD
  constexpr int W = pack_size<double>;
  using Raw = typename detail::RawPack<W>::type;
  for (int first = 0; first < 8; first += W) {
    Raw rows[W];
    for (int i = 0; i < W; ++i) rows[i] = *reinterpret_cast<const Raw*>(records[i] + first);
    if constexpr (W > 1) detail::transpose_round<W / 2, W>(rows);
    for (int k = 0; k < W; ++k) *reinterpret_cast<Raw*>(packs[first + k]) = rows[k];
  }
#else
  for (int k = 0; k < 8; ++k) packs[k][0] = records[0][k];
#endif
}

/// The way back: records[lane][k] = packs[k][lane].
PERCUSS_FORCE_INLINE void transpose_to_records(const double (&packs)[8][pack_size<double>],
                                               double (&records)[pack_size<double>][8]) {
#ifdef PERCUSS_HAS_SIMD
  constexpr int W = pack_size<double>;
  using Raw = typename detail::RawPack<W>::type;
  for (int first = 0; first < 8; first += W) {
    Raw rows[W];
    for (int k = 0; k < W; ++k) rows[k] = *reinterpret_cast<const Raw*>(packs[first + k]);
    if constexpr (W > 1) detail::transpose_round<W / 2, W>(rows);
    for (int i = 0; i < W; ++i) *reinterpret_cast<Raw*>(records[i] + first) = rows[i];
  }
#else
  for (int k = 0; k < 8; ++k) records[0][k] = packs[k][0];
#endif
}

#ifdef PERCUSS_HAS_SIMD
namespace detail {

/// Transposes the blocks of 4 x 4 in four vectors of W lanes.
template <int W, class Raw>
inline void transpose_blocks(Raw (&rows)[4]) {
  constexpr auto lanes = std::make_integer_sequence<int, W>();
  swap_blocks<2, W>(rows[0], rows[2], lanes);
  swap_blocks<2, W>(rows[1], rows[3], lanes);
  swap_blocks<1, W>(rows[0], rows[1], lanes);
  swap_blocks<1, W>(rows[2], rows[3], lanes);
}

using RowOfFour = RawPack<4>::type;

template <int W>
inline void load_blocks(const double* rows, const int* index, double (&packs)[4][W]) {
  using Raw = typename RawPack<W>::type;
  const auto row = [&](int lane) {
    return *reinterpret_cast<const RowOfFour*>(rows + 4 * std::ptrdiff_t{index[lane]});
  };
  Raw block[4];
  for (int i = 0; i < 4; ++i) {
    if constexpr (W == 8)
      block[i] = __builtin_shufflevector(row(i), row(i + 4), 0, 1, 2, 3, 4, 5, 6, 7);
    else
      block[i] = row(i);
  }
  transpose_blocks<W>(block);
  for (int k = 0; k < 4; ++k) *reinterpret_cast<Raw*>(packs[k]) = block[k];
}

template <int W>
inline void store_blocks(const double (&packs)[4][W], const int* index, double* rows) {
  using Raw = typename RawPack<W>::type;
  Raw block[4];
  for (int k = 0; k < 4; ++k) block[k] = *reinterpret_cast<const Raw*>(packs[k]);
  transpose_blocks<W>(block);
  const auto store = [&](int lane, const RowOfFour& row) {
    if (index[lane] >= 0) *reinterpret_cast<RowOfFour*>(rows + 4 * std::ptrdiff_t{index[lane]}) = row;
  };
  for (int i = 0; i < 4; ++i) {
    if constexpr (W == 8) {
      store(i, __builtin_shufflevector(block[i], block[i], 0, 1, 2, 3));
      store(i + 4, __builtin_shufflevector(block[i], block[i], 4, 5, 6, 7));
    } else {
      store(i, block[i]);
    }
  }
}

}  // namespace detail
#endif

/// Rows of four doubles, one a lane, into four packs: packs[k][lane] = rows[4 index[lane] + k]. Rows are aligned to
/// four doubles, packs to W = pack_size<double> is 1, 2, 4 or 8.
template <int W>
KOKKOS_FORCEINLINE_FUNCTION void load_rows_of_four(const double* rows, const int* index, double (&packs)[4][W]) {
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    detail::load_blocks<W>(rows, index, packs);
    return;
  }
#endif
  for (int lane = 0; lane < W; ++lane)
    for (int k = 0; k < 4; ++k) packs[k][lane] = rows[4 * std::ptrdiff_t{index[lane]} + k];
}

/// The way back, for lanes with index >= 0: rows[4 index[lane] + k] = packs[k][lane].
template <int W>
KOKKOS_FORCEINLINE_FUNCTION void store_rows_of_four(const double (&packs)[4][W], const int* index, double* rows) {
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    detail::store_blocks<W>(packs, index, rows);
    return;
  }
#endif
  for (int lane = 0; lane < W; ++lane) {
    if (index[lane] < 0) continue;
    for (int k = 0; k < 4; ++k) rows[4 * std::ptrdiff_t{index[lane]} + k] = packs[k][lane];
  }
}

/// to[0..4) -= from[0..4), both aligned to four doubles.
PERCUSS_FORCE_INLINE void subtract_record(const double* from, double* to) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = detail::RawPack<4>::type;
  *reinterpret_cast<Raw*>(to) -= *reinterpret_cast<const Raw*>(from);
#else
  for (int k = 0; k < 4; ++k) to[k] -= from[k];
#endif
}

}  // namespace percuss
