#pragma once
// Sums and extremes over rows in parallel. Sums are exact (kernels/core/exact_sum.hpp), so that rows may lie on any
// number of threads and ranks.

#include "kernels/core/exact_sum.hpp"
#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// Calls body(row, sums) for rows 0 to n - 1, in no order, and returns the merge of all sums. Sums: trivially copyable,
/// with a merge(other) that is associative, commutative and exact; its zero is Sums{}. partial: memory for blocks.
template <class Sums, class Body>
Sums sum_rows(const WorkSpace& space, int n, Array<Sums>& partial, const Body& body) {
  constexpr int shortest = 64;  // rows: merging a block costs as much as one
  const int most = 4 * space.concurrency(), wanted = (n + shortest - 1) / shortest;
  const int blocks = wanted < most ? wanted : most;
  Sums total;
  if (blocks == 0) return total;
  reserve(partial, blocks);
  const Array<Sums> sums = partial;
  parallel_for(
      "contact::sum_rows", RangeOf(space, 0, blocks), KOKKOS_LAMBDA(int b) {
        Sums sum{};
        const auto first = static_cast<int>(static_cast<std::int64_t>(n) * b / blocks);
        const auto last = static_cast<int>(static_cast<std::int64_t>(n) * (b + 1) / blocks);
        for (int r = first; r < last; ++r) body(r, sum);
        sums(b) = sum;
      });
  space.fence();
  const auto on_host = to_host(sums);
  for (int b = 0; b < blocks; ++b) total.merge(on_host(b));
  return total;
}

}  // namespace percuss
