#pragma once
// Records of four floats to packs, as transpose.hpp has it for doubles: 4, 8 or 16 lanes.

#include "kernels/core/transpose.hpp"

namespace percuss {

#ifdef PERCUSS_HAS_SIMD
namespace detail {

template <int W>
struct RawFloats {
  typedef float type __attribute__((vector_size(W * sizeof(float)), may_alias));
};

PERCUSS_FORCE_INLINE RawFloats<4>::type load_float_row(const float* from) {
  return *reinterpret_cast<const RawFloats<4>::type*>(from);
}

/// Rows side by side: those of lanes i, i + 4 and so on.
template <int W>
PERCUSS_FORCE_INLINE typename RawFloats<W>::type join_float_rows(const float* const (&records)[W], int i) {
  if constexpr (W == 4) {
    return load_float_row(records[i]);
  } else if constexpr (W == 8) {
    return __builtin_shufflevector(load_float_row(records[i]), load_float_row(records[i + 4]), 0, 1, 2, 3, 4, 5, 6, 7);
  } else {
#ifdef __AVX512F__  // as join_rows()
    const __m256 low =
        _mm256_insertf128_ps(_mm256_castps128_ps256(load_float_row(records[i])), load_float_row(records[i + 4]), 1);
    const __m256 high = _mm256_insertf128_ps(_mm256_castps128_ps256(load_float_row(records[i + 8])),
                                             load_float_row(records[i + 12]), 1);
    return _mm512_castpd_ps(
        _mm512_maskz_insertf64x4(0xff, _mm512_castps_pd(_mm512_castps256_ps512(low)), _mm256_castps_pd(high), 1));
#else
    static_assert(W < 16, "no register holds 16 floats");
#endif
  }
}

}  // namespace detail
#endif

/// The first three columns of W records of four floats, aligned to these, as packs: packs[k][lane] = records[lane][k].
/// W = pack_size<float>.
template <int W>
PERCUSS_FORCE_INLINE void transpose_to_packs(const float* const (&records)[W], Pack<float> (&packs)[3]) {
#ifdef PERCUSS_HAS_SIMD
  if constexpr (W >= 4) {
    typename detail::RawFloats<W>::type block[4];
    for (int i = 0; i < 4; ++i) block[i] = detail::join_float_rows(records, i);
    detail::transpose_blocks<W>(block);
    for (int k = 0; k < 3; ++k) packs[k] = Pack<float>(block[k]);
    return;
  }
#endif
  for (int k = 0; k < 3; ++k) {
    alignas(64) float column[W];
    for (int lane = 0; lane < W; ++lane) column[lane] = records[lane][k];
    packs[k] = load_pack(column);
  }
}

}  // namespace percuss
