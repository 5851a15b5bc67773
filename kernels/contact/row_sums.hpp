#pragma once
// Sums over rows in one fixed order: runs of rows, then the runs one after another. The same bits for any threads.

#include "kernels/contact/small_space.hpp"

namespace percuss {

/// Memory for the sums of the runs.
using SumScratch = Array<double>;

/// Calls body(row, sums) for rows 0 to n - 1 and returns the total. Sums: a struct of doubles and of nothing else, with
/// add(); its zero is Sums{}.
template <class Sums, class Space, class Body>
Sums sum_rows(const Space& space, int n, SumScratch& scratch, const Body& body) {
  constexpr int run = 64;
  constexpr int width = static_cast<int>(sizeof(Sums) / sizeof(double));
  static_assert(sizeof(Sums) == width * sizeof(double));
  const int runs = (n + run - 1) / run;
  reserve(scratch, runs * width);
  const SumScratch partial = scratch;
  Kokkos::parallel_for(
      "contact::sum_rows", RangeOf<Space>(space, 0, runs), KOKKOS_LAMBDA(int k) {
        Sums sums;
        const int last = (k + 1) * run < n ? (k + 1) * run : n;
        for (int r = k * run; r < last; ++r) body(r, sums);
        reinterpret_cast<Sums*>(partial.data())[k] = sums;
      });
  space.fence();
  const auto on_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  Sums total;
  for (int k = 0; k < runs; ++k) total.add(reinterpret_cast<const Sums*>(on_host.data())[k]);
  return total;
}

}  // namespace percuss
