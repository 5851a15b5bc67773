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

/// Bit i: box i of the block and `box` have a point in common.
KOKKOS_FORCEINLINE_FUNCTION std::uint32_t find_meeting_lanes(const BoxBlock& block, const FloatBox& box) {
#if defined(PERCUSS_HAS_SIMD) && defined(__AVX512F__)
  __mmask16 mask = 0xffff;
  for (int axis = 0; axis < 3; ++axis) {
    mask = _mm512_mask_cmp_ps_mask(mask, _mm512_load_ps(block.low[axis]), _mm512_set1_ps(box.high[axis]), _CMP_LE_OQ);
    mask = _mm512_mask_cmp_ps_mask(mask, _mm512_load_ps(block.high[axis]), _mm512_set1_ps(box.low[axis]), _CMP_GE_OQ);
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
