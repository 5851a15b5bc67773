#pragma once
// What the elements of a chunk add up to, taken lane by lane in their order: the smallest step, the lowest element that
// failed, and work by kind.

#include "kernels/core/simd.hpp"
#include "kernels/core/work_kinds.hpp"
#include "kernels/element/element_chunks.hpp"

namespace percuss {

/// Sum over the first `lanes` lanes of a pack in their order.
template <class Scalar>
PERCUSS_FORCE_INLINE double sum_lanes(const Pack<Scalar>& value, int lanes) {
  alignas(64) Scalar row[pack_size<Scalar>];
  store_pack(row, value);
  double sum = 0;
  for (int lane = 0; lane < lanes; ++lane) sum += row[lane];
  return sum;
}

struct ChunkSums {
  double step = 1e300;
  int controlling = -1, failed = -1;  // elements
  double work[work_kinds] = {};

  /// k: place among the kinds of work.
  PERCUSS_FORCE_INLINE void take_work(int k, const Pack<double>& of, int lanes) {
    work[k] += sum_lanes<double>(of, lanes);
  }

  /// size: volume, area or length, which is positive.
  PERCUSS_FORCE_INLINE void take_step(const Pack<double>& stable_step, const Pack<double>& size, int first_element,
                                      int lanes) {
    constexpr int width = pack_size<double>;
    alignas(64) double steps[width], sizes[width];
    store_pack(steps, stable_step);
    store_pack(sizes, size);
    for (int lane = 0; lane < lanes; ++lane) take_element_step(steps[lane], sizes[lane], first_element + lane);
  }
  PERCUSS_FORCE_INLINE void take_element_step(double stable_step, double size, int element) {
    if (stable_step < step) {
      step = stable_step;
      controlling = element;
    }
    if (failed < 0 && !(size > 0 && stable_step > 0)) failed = element;  // also for NaN
  }

  KOKKOS_FUNCTION void leave_work(int c, const ChunkResults& results) const {
    for (int k = 0; k < work_kinds; ++k) results.work(c, k) += work[k];
  }

  KOKKOS_FUNCTION void leave_step(int c, int first_element, const ChunkResults& results) const {
    results.stable_step(c) = step;
    results.controlling_element(c) = controlling < 0 ? first_element : controlling;
    results.failed_element(c) = failed;
  }
};

}  // namespace percuss
