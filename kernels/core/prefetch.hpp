#pragma once
// Prefetches memory whose addresses the hardware cannot predict. No effect on a device.

#include <cstddef>

#include "kernels/core/simd.hpp"

namespace percuss {

inline constexpr std::size_t cache_line = 64;  // bytes

/// The lines of the cache that an object lies in; of a row the line of its first number.
template <class T>
PERCUSS_FORCE_INLINE void fetch_ahead([[maybe_unused]] const T* place) {
#ifdef PERCUSS_HAS_SIMD
  const char* const first = reinterpret_cast<const char*>(place);
  for (std::size_t byte = 0; byte < sizeof(T); byte += cache_line) __builtin_prefetch(first + byte, 0, 3);
#endif
}

/// The line that holds an address, to be written as well.
PERCUSS_FORCE_INLINE void fetch_to_write([[maybe_unused]] const void* place) {
#ifdef PERCUSS_HAS_SIMD
  __builtin_prefetch(place, 1, 3);
#endif
}

}  // namespace percuss
