#pragma once
// Exact sums over ranks: integers are added, so that no order shows in the bits.

#include <span>

#include "comm/all_reduce.hpp"
#include "kernels/core/exact_sum.hpp"

namespace percuss {

/// Adds up the sums of all ranks: in, those of this rank; out, the totals, the same on every rank. One message for all
/// of them. Collective: as many sums on every rank. Throws MpiError.
inline void sum_over_ranks(const Communicator& ranks, std::span<ExactSum> sums) {
  constexpr std::size_t words = ExactSum::limb_count + 1;
  static_assert(sizeof(ExactSum) == words * sizeof(std::int64_t), "limbs and count travel as one row of integers");
  for (ExactSum& sum : sums) sum.normalize();
  all_reduce(ranks, Reduce::sum, std::span(reinterpret_cast<std::int64_t*>(sums.data()), words * sums.size()));
}

}  // namespace percuss
