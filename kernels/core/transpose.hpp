#pragma once
// Transposes between records in memory (array of structures) and packs (one element a lane), in registers.
//
// Eklundh's block swaps: log2(W) rounds of two-input shuffles for a W x W block, instead of W * W scalar moves.

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
inline void swap_blocks(Raw& a, Raw& b, std::integer_sequence<int, E...>) {
  const Raw low = __builtin_shufflevector(a, b, ((E & S) != 0 ? W + E - S : E)...);
  const Raw high = __builtin_shufflevector(a, b, ((E & S) != 0 ? W + E : E + S)...);
  a = low;
  b = high;
}

template <int S, int W, class Raw>
inline void transpose_round(Raw (&rows)[W]) {
  for (int i = 0; i < W; ++i) {
    if ((i & S) == 0) swap_blocks<S, W>(rows[i], rows[i | S], std::make_integer_sequence<int, W>());
  }
  if constexpr (S > 1) transpose_round<S / 2, W>(rows);
}

}  // namespace detail
#endif

/// Eight columns of W records into eight packs: packs[k][lane] = records[lane][k]. Records and packs are aligned to
/// eight doubles; W = pack_size<double> is 1, 2, 4 or 8.
inline KOKKOS_FUNCTION void transpose_to_packs(const double* const (&records)[pack_size<double>],
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
inline KOKKOS_FUNCTION void transpose_to_records(const double (&packs)[8][pack_size<double>],
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

/// to[0..4) -= from[0..4), both aligned to four doubles.
inline KOKKOS_FUNCTION void subtract_record(const double* from, double* to) {
#ifdef PERCUSS_HAS_SIMD
  using Raw = detail::RawPack<4>::type;
  *reinterpret_cast<Raw*>(to) -= *reinterpret_cast<const Raw*>(from);
#else
  for (int k = 0; k < 4; ++k) to[k] -= from[k];
#endif
}

}  // namespace percuss
