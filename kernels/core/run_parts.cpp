#include <algorithm>

#include "kernels/core/small_space.hpp"

namespace percuss {

#ifndef PERCUSS_ON_DEVICE  // its kernels are given to Kokkos one by one
void run_parts(const char* label, const RangeOf& range, void (*run)(const void*, int, int, int), const void* kernel) {
  const int first = range.first, count = range.last - first;
  if (count <= 0) return;
#if defined(PERCUSS_SMALL_SPACE)
  if (range.space.is_small()) {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<SmallSpace, Kokkos::IndexType<int>>(SmallSpace(), 0, 1),
                         [=](int) { run(kernel, first, first + count, 0); });
    return;
  }
#endif
  const int parts = std::min(range.space.concurrency(), count);
  Kokkos::parallel_for(label, Range(range.space.all(), 0, parts), [=](int part) {
    const auto place = [=](int p) { return first + static_cast<int>(static_cast<std::int64_t>(count) * p / parts); };
    run(kernel, place(part), place(part + 1), part);
  });
}
#endif

}  // namespace percuss
