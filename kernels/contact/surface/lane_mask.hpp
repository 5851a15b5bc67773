#pragma once
// Sixteen boxes or points in float against one: which of them meet, as bits.

#include <cstdint>

#include "kernels/core/simd.hpp"
#include "kernels/core/views.hpp"

namespace percuss {

inline constexpr int block_size = 16;

/// Lowest x, y, z and highest x, y, z of sixteen boxes, one a lane. Empty lanes are boxes that meet nothing.
struct alignas(64) BoxBlock {
  float low[3][block_size], high[3][block_size];
};

/// A box in float.
struct FloatBox {
  float low[3], high[3];
};

/// Sixteen points.
struct alignas(64) PointLanes {
  float x[3][block_size];
};

/// Bit i: point i lies in `box`, its faces included or not.
template <bool WithFaces = true>
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_lanes_inside(const PointLanes& points, const FloatBox& box) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX__)  // AVX-512 has it, too
  constexpr int at_most = WithFaces ? _CMP_LE_OQ : _CMP_LT_OQ, at_least = WithFaces ? _CMP_GE_OQ : _CMP_GT_OQ;
#endif
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512F__)
  __mmask16 mask = 0xffff;
  for (int axis = 0; axis < 3; ++axis) {
    const __m512 x = _mm512_load_ps(points.x[axis]);
    mask = _mm512_mask_cmp_ps_mask(mask, x, _mm512_set1_ps(box.high[axis]), at_most);
    mask = _mm512_mask_cmp_ps_mask(mask, x, _mm512_set1_ps(box.low[axis]), at_least);
  }
  return mask;
#elif defined(PERCUSS_HAS_SIMD) && defined(__AVX__)
  std::uint32_t mask = 0;
  for (int half = 0; half < block_size; half += 8) {
    __m256 inside = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
    for (int axis = 0; axis < 3; ++axis) {
      const __m256 x = _mm256_load_ps(points.x[axis] + half);
      inside = _mm256_and_ps(inside, _mm256_cmp_ps(x, _mm256_set1_ps(box.high[axis]), at_most));
      inside = _mm256_and_ps(inside, _mm256_cmp_ps(x, _mm256_set1_ps(box.low[axis]), at_least));
    }
    mask |= static_cast<std::uint32_t>(_mm256_movemask_ps(inside)) << half;
  }
  return mask;
#else
  std::uint32_t mask = 0;
  for (int lane = 0; lane < block_size; ++lane) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) {
      const float x = points.x[axis][lane], low = box.low[axis], high = box.high[axis];
      inside = inside & (WithFaces ? (x >= low) & (x <= high) : (x > low) & (x < high));
    }
    mask |= static_cast<std::uint32_t>(inside) << lane;
  }
  return mask;
#endif
}

/// Bit i: box i of the block and `box` have a point in common.
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_meeting_lanes(const BoxBlock& block, const FloatBox& box) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512F__)
  __mmask16 mask = 0xffff;
  for (int axis = 0; axis < 3; ++axis) {
    mask = _mm512_mask_cmp_ps_mask(mask, _mm512_load_ps(block.low[axis]), _mm512_set1_ps(box.high[axis]), _CMP_LE_OQ);
    mask = _mm512_mask_cmp_ps_mask(mask, _mm512_load_ps(block.high[axis]), _mm512_set1_ps(box.low[axis]), _CMP_GE_OQ);
  }
  return mask;
#elif defined(PERCUSS_HAS_SIMD) && defined(__AVX__)
  std::uint32_t mask = 0;
  for (int half = 0; half < block_size; half += 8) {
    __m256 meets = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
    for (int axis = 0; axis < 3; ++axis) {
      const __m256 low = _mm256_load_ps(block.low[axis] + half), high = _mm256_load_ps(block.high[axis] + half);
      meets = _mm256_and_ps(meets, _mm256_cmp_ps(low, _mm256_set1_ps(box.high[axis]), _CMP_LE_OQ));
      meets = _mm256_and_ps(meets, _mm256_cmp_ps(high, _mm256_set1_ps(box.low[axis]), _CMP_GE_OQ));
    }
    mask |= static_cast<std::uint32_t>(_mm256_movemask_ps(meets)) << half;
  }
  return mask;
#else
  std::uint32_t mask = 0;
  for (int lane = 0; lane < block_size; ++lane) {
    bool meets = true;
    for (int axis = 0; axis < 3; ++axis)
      meets = meets & (block.low[axis][lane] <= box.high[axis]) & (block.high[axis][lane] >= box.low[axis]);
    mask |= static_cast<std::uint32_t>(meets) << lane;
  }
  return mask;
#endif
}

/// Sixteen numbers, one a lane.
struct alignas(64) LaneNumbers {
  int lane[block_size];
};

/// Bit i: number i is one of the four values.
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_equal_lanes(const LaneNumbers& numbers, const int* values) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512F__)
  const __m512i all = _mm512_load_si512(numbers.lane);
  __mmask16 mask = 0;
  for (int i = 0; i < 4; ++i) mask |= _mm512_cmpeq_epi32_mask(all, _mm512_set1_epi32(values[i]));
  return mask;
#elif defined(PERCUSS_HAS_SIMD) && defined(__AVX2__)
  std::uint32_t mask = 0;
  for (int half = 0; half < block_size; half += 8) {
    const __m256i some = _mm256_load_si256(reinterpret_cast<const __m256i*>(numbers.lane + half));
    __m256i equal = _mm256_setzero_si256();
    for (int i = 0; i < 4; ++i) equal = _mm256_or_si256(equal, _mm256_cmpeq_epi32(some, _mm256_set1_epi32(values[i])));
    mask |= static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(equal))) << half;
  }
  return mask;
#else
  std::uint32_t mask = 0;
  for (int lane = 0; lane < block_size; ++lane) {
    bool equal = false;
    for (int i = 0; i < 4; ++i) equal = equal | (numbers.lane[lane] == values[i]);
    mask |= static_cast<std::uint32_t>(equal) << lane;
  }
  return mask;
#endif
}

/// Bit i: number i is below the value.
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_lanes_below(const LaneNumbers& numbers, int value) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512F__)
  return _mm512_cmplt_epi32_mask(_mm512_load_si512(numbers.lane), _mm512_set1_epi32(value));
#elif defined(PERCUSS_HAS_SIMD) && defined(__AVX2__)
  std::uint32_t mask = 0;
  for (int half = 0; half < block_size; half += 8) {
    const __m256i some = _mm256_load_si256(reinterpret_cast<const __m256i*>(numbers.lane + half));
    const __m256 below = _mm256_castsi256_ps(_mm256_cmpgt_epi32(_mm256_set1_epi32(value), some));
    mask |= static_cast<std::uint32_t>(_mm256_movemask_ps(below)) << half;
  }
  return mask;
#else
  std::uint32_t mask = 0;
  for (int lane = 0; lane < block_size; ++lane) mask |= static_cast<std::uint32_t>(numbers.lane[lane] < value) << lane;
  return mask;
#endif
}

/// Adds one to the numbers whose bits are set.
KOKKOS_FORCEINLINE_FUNCTION void count_lanes(std::uint32_t mask, LaneNumbers& numbers) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX2__) && !defined(__AVX512F__)
  const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  for (int half = 0; half < block_size; half += 8) {
    __m256i* const some = reinterpret_cast<__m256i*>(numbers.lane + half);
    const __m256i its = _mm256_and_si256(bits, _mm256_set1_epi32(static_cast<int>(mask >> half)));
    _mm256_store_si256(some, _mm256_sub_epi32(_mm256_load_si256(some), _mm256_cmpeq_epi32(its, bits)));
  }
#else
  for (int lane = 0; lane < block_size; ++lane) numbers.lane[lane] += static_cast<int>(mask >> lane & 1u);
#endif
}

/// How many bits are set.
KOKKOS_FORCEINLINE_FUNCTION int count_bits(std::uint32_t mask) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
  return __builtin_popcount(mask);
#else
  int count = 0;
  for (; mask != 0; mask &= mask - 1) ++count;
  return count;
#endif
}

/// Place of the lowest bit that is set.
KOKKOS_FORCEINLINE_FUNCTION int find_lowest_bit(std::uint32_t mask) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
  return __builtin_ctz(mask);
#else
  int place = 0;
  for (; (mask & 1u) == 0; mask >>= 1) ++place;
  return place;
#endif
}

}  // namespace percuss
