#pragma once
// What the elements of a chunk add up to, in their order: the smallest step, the lowest element that failed, and work
// by kind. One rule for the launchers of all families.

#include "kernels/core/short_scalar.hpp"
#include "kernels/core/simd.hpp"
#include "kernels/core/work_kinds.hpp"
#include "kernels/element/chunk_records.hpp"

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

/// Sums over elements one by one. Elements are counted from the chunk's first.
struct ChunkTotals {
  double step = beyond_all<double>;
  int controlling = 0, failed = -1;
  double work[work_kinds] = {};

  /// size: volume, area or length, which is positive.
  KOKKOS_FUNCTION void take_step(double stable_step, double size, int element) {
    if (stable_step < step) {
      step = stable_step;
      controlling = element;
    }
    if (failed < 0 && !(size > 0 && stable_step > 0)) failed = element;  // also for NaN
  }

  KOKKOS_FUNCTION void leave_work(int c, const ChunkResults& results) const {
    for (int k = 0; k < work_kinds; ++k) results.work(c, k) += work[k];
  }

  KOKKOS_FUNCTION void leave_step(int c, int first_element, int /*count*/, const ChunkResults& results) const {
    results.stable_step(c) = step;
    results.controlling_element(c) = first_element + controlling;
    results.failed_element(c) = failed < 0 ? -1 : first_element + failed;
  }
};

/// Sums over packs: smallest steps by lane, of which the smallest becomes that of the chunk.
template <class Scalar>
class ChunkSums {
 public:
  using Lanes = Pack<Scalar>;
  static constexpr int width = pack_size<Scalar>;

  /// result: of the elements of a pack, as ElementResult.
  template <class Result>
  PERCUSS_FORCE_INLINE void take(const Result& result, const ChunkPack& pack) {
    take_step(result.stable_step, result.size, pack.first, pack.lanes);
    take_work(result.work, pack.lanes);
  }

  /// of: work of the first `lanes` elements of a pack.
  template <class Work>
  PERCUSS_FORCE_INLINE void take_work(Work of, int lanes) {
    of.visit([&](int kind, const Lanes& work) { take_work(kind, work, lanes); });
  }
  PERCUSS_FORCE_INLINE void take_work(int kind, const Lanes& work, int lanes) {
    totals_.work[kind] += sum_lanes<Scalar>(work, lanes);
  }

  /// first: element of the first lane, counted from the chunk's first. Lanes beyond `lanes` repeat the last element.
  PERCUSS_FORCE_INLINE void take_step(const Lanes& stable_step, const Lanes& size, int first, int lanes) {
    const auto is_smaller = stable_step < step_;
    step_ = select(is_smaller, stable_step, step_);
    first_ = select(is_smaller, Lanes(static_cast<Scalar>(first)), first_);
    const auto is_good = (size > Lanes(0)) & (stable_step > Lanes(0));
    if (any(!is_good) && totals_.failed < 0) find_failed(stable_step, size, first, lanes);
  }

  KOKKOS_FUNCTION void leave_work(int c, const ChunkResults& results) const { totals_.leave_work(c, results); }

  /// count: elements of the chunk.
  KOKKOS_FUNCTION void leave_step(int c, int first_element, int count, const ChunkResults& results) {
    alignas(64) Scalar steps[width], first[width];
    store_pack(steps, step_);
    store_pack(first, first_);
    Scalar smallest = beyond_all<Scalar>;
    for (int lane = 0; lane < width; ++lane) {  // the lowest of those that have it
      int element = static_cast<int>(first[lane]) + lane;
      if (element >= count) element = count - 1;
      if (steps[lane] < smallest || (steps[lane] == smallest && element < totals_.controlling)) {
        smallest = steps[lane];
        totals_.controlling = element;
      }
    }
    totals_.step = smallest;
    totals_.leave_step(c, first_element, count, results);
  }

 private:
  KOKKOS_FUNCTION void find_failed(const Lanes& stable_step, const Lanes& size, int first, int lanes) {
    alignas(64) Scalar steps[width], sizes[width];
    store_pack(steps, stable_step);
    store_pack(sizes, size);
    for (int lane = lanes - 1; lane >= 0; --lane) {
      if (!(sizes[lane] > 0 && steps[lane] > 0)) totals_.failed = first + lane;  // also for NaN
    }
  }

  Lanes step_ = Lanes(beyond_all<Scalar>), first_ = Lanes(0);
  ChunkTotals totals_;
};

}  // namespace percuss
