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

/// Transposes the blocks of 4 x 4 in four vectors of W lanes.
template <int W, class Raw>
PERCUSS_FORCE_INLINE void transpose_blocks(Raw (&rows)[4]) {
  constexpr auto lanes = std::make_integer_sequence<int, W>();
  swap_blocks<2, W>(rows[0], rows[2], lanes);
  swap_blocks<2, W>(rows[1], rows[3], lanes);
  swap_blocks<1, W>(rows[0], rows[1], lanes);
  swap_blocks<1, W>(rows[2], rows[3], lanes);
}

using RowOfFour = RawPack<4>::type;

template <int W = 4>  // a template: where no register holds four doubles, none is made
PERCUSS_FORCE_INLINE typename RawPack<W>::type load_row(const double* from) {
  return *reinterpret_cast<const typename RawPack<W>::type*>(from);
}

/// Two rows side by side; W is 8.
template <int W>
PERCUSS_FORCE_INLINE typename RawPack<W>::type join_rows(const double* low, const double* high) {
#ifdef __AVX512F__  // of the general form GCC 12 makes a load and a shuffle
  return _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(load_row(low)), load_row(high), 1);
#else
  return __builtin_shufflevector(load_row(low), load_row(high), 0, 1, 2, 3, 4, 5, 6, 7);
#endif
}

template <class Raw>
PERCUSS_FORCE_INLINE void part_rows(const Raw& rows, double* low, double* high) {
  *reinterpret_cast<RowOfFour*>(low) = __builtin_shufflevector(rows, rows, 0, 1, 2, 3);
  *reinterpret_cast<RowOfFour*>(high) = __builtin_shufflevector(rows, rows, 4, 5, 6, 7);
}

}  // namespace detail
#endif

/// The first columns, three or four, of W records of four doubles, aligned to these, as packs:
/// packs[k][lane] = records[lane][k]. W = pack_size<double> is 1, 2, 4 or 8.
template <int W, int Columns>
PERCUSS_FORCE_INLINE void transpose_to_packs(const double* const (&records)[W], Pack<double> (&packs)[Columns]) {
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    typename detail::RawPack<W>::type block[4];
    for (int i = 0; i < 4; ++i) {
      if constexpr (W == 8) {
        block[i] = detail::join_rows<W>(records[i], records[i + 4]);
      } else {
        block[i] = detail::load_row(records[i]);
      }
    }
    detail::transpose_blocks<W>(block);
    for (int k = 0; k < Columns; ++k) packs[k] = Pack<double>(block[k]);
    return;
  }
#endif
  for (int k = 0; k < Columns; ++k) {
    alignas(64) double column[W];
    for (int lane = 0; lane < W; ++lane) column[lane] = records[lane][k];
    packs[k] = load_pack(column);
  }
}

/// The way back, rows of three numbers and 0: to[stride lane + k] = packs[k][lane]. Rows are aligned to four doubles.
PERCUSS_FORCE_INLINE void turn_to_rows(const Pack<double> (&packs)[3], double* to, int stride) {
  constexpr int W = pack_size<double>;
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    using Raw = typename detail::RawPack<W>::type;
    Raw block[4] = {static_cast<Raw>(packs[0]), static_cast<Raw>(packs[1]), static_cast<Raw>(packs[2]), Raw{}};
    detail::transpose_blocks<W>(block);
    for (int i = 0; i < 4; ++i) {
      if constexpr (W == 8)
        detail::part_rows(block[i], to + stride * i, to + stride * (i + 4));
      else
        *reinterpret_cast<Raw*>(to + stride * i) = block[i];
    }
    return;
  }
#endif
  for (int k = 0; k < 4; ++k) {
    alignas(64) double column[W];
    store_pack(column, k < 3 ? packs[k] : Pack<double>(0));
    for (int lane = 0; lane < W; ++lane) to[stride * lane + k] = column[lane];
  }
}

/// Transposes into records: records[lane] = {packs[0][lane], packs[1][lane], packs[2][lane], 0}.
template <int W>
PERCUSS_FORCE_INLINE void transpose_to_records(const Pack<double> (&packs)[3], double (&records)[W][4]) {
  turn_to_rows(packs, &records[0][0], 4);
}

#ifdef PERCUSS_HAS_SIMD
namespace detail {

template <int W>
PERCUSS_FORCE_INLINE void load_blocks(const double* rows, const int* index, double (&packs)[4][W]) {
  using Raw = typename RawPack<W>::type;
  const auto row = [&](int lane) { return rows + 4 * std::ptrdiff_t{index[lane]}; };
  Raw block[4];
  for (int i = 0; i < 4; ++i) {
    if constexpr (W == 8)
      block[i] = join_rows<W>(row(i), row(i + 4));
    else
      block[i] = load_row(row(i));
  }
  transpose_blocks<W>(block);
  for (int k = 0; k < 4; ++k) *reinterpret_cast<Raw*>(packs[k]) = block[k];
}

template <int W>
PERCUSS_FORCE_INLINE void load_narrow_blocks(const double* rows, const int* index, Pack<double> (&packs)[3]) {
  using Raw = typename RawPack<W>::type;
  const auto row = [&](int lane) { return rows + 3 * std::ptrdiff_t{index[lane]}; };
  Raw block[4];
  for (int i = 0; i < 4; ++i) {
    const double* low = row(i);
    if constexpr (W == 8) {
      const double* high = row(i + 4);
      block[i] = Raw{low[0], low[1], low[2], 0, high[0], high[1], high[2], 0};
    } else {
      block[i] = Raw{low[0], low[1], low[2], 0};
    }
  }
  transpose_blocks<W>(block);
  for (int k = 0; k < 3; ++k) packs[k] = Pack<double>(block[k]);
}

template <int W>
PERCUSS_FORCE_INLINE void store_blocks(const double (&packs)[4][W], const int* index, double* rows) {
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

/// Rows of three doubles, one a lane: packs[k][lane] = rows[3 index[lane] + k].
template <int W>
KOKKOS_FORCEINLINE_FUNCTION void load_rows_of_three(const double* rows, const int (&index)[W],
                                                    Pack<double> (&packs)[3]) {
  static_assert(W == pack_size<double>, "one row a lane");
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    detail::load_narrow_blocks<W>(rows, index, packs);
    return;
  }
#endif
  for (int k = 0; k < 3; ++k) {
    alignas(64) double column[W];
    for (int lane = 0; lane < W; ++lane) column[lane] = rows[3 * std::ptrdiff_t{index[lane]} + k];
    packs[k] = load_pack(column);
  }
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
