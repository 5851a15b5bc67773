#pragma once
// Rows of numbers by node, each known to one rank, made known to all.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "comm/all_reduce.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/index.hpp"

namespace percuss {

/// own: [rows of this rank][count]; places: [rows of this rank] where they belong in `rows`, [all rows][count]. The
/// other ranks give zeros, and bits are added up, so that the numbers stay as they are. Collective.
template <class Rows, class Places>
void gather_rows(const Communicator& ranks, const Rows& own, const Places& places, std::size_t count,
                 std::vector<double>& rows) {
  const auto host = to_host(own);
  const auto where = to_host(places);
  std::vector<std::uint64_t> bits(rows.size(), 0);
  for (std::size_t i = 0; i < where.extent(0); ++i)
    for (std::size_t k = 0; k < count; ++k) bits[at(where(i)) * count + k] = std::bit_cast<std::uint64_t>(host(i, k));
  all_reduce(ranks, Reduce::sum, bits);
  for (std::size_t i = 0; i < bits.size(); ++i) rows[i] = std::bit_cast<double>(bits[i]);
}

}  // namespace percuss
