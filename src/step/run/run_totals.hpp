#pragma once
// What a summary says of all ranks together.

#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/exchange/data_exchange.hpp"
#include "src/mesh/numbering.hpp"
#include "src/output/ranks_file.hpp"
#include "src/output/summary.hpp"

namespace percuss {

/// Largest memory that this process has had [byte].
std::int64_t find_peak_bytes();

/// Elements of the rank that has most, over the mean of all ranks.
double find_element_balance(const Numbering& numbering, int rank_count);

/// Ranks that have no chunk.
int count_idle_ranks(const Numbering& numbering, int rank_count);

/// Puts the largest of all ranks in the place of seconds and peak memory. Collective. Throws MpiError.
void take_largest(const Communicator& ranks, Summary& summary);

/// Adds up what the ranks have sent. Collective. Throws MpiError.
Traffic sum_traffic(const Communicator& ranks, const Traffic& own);

/// Adds up a count of all ranks. Collective. Throws MpiError.
std::int64_t sum_counts(const Communicator& ranks, std::int64_t own);

/// [ranks] the rows of all ranks on rank 0, in their order; empty on the others. Collective. Throws MpiError.
std::vector<RankRow> gather_rows(const Communicator& ranks, const RankRow& own);

}  // namespace percuss
