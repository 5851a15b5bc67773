#pragma once
// Exchanges between ranks that know each other from a plan, with other numbers of items than the plan has.

#include <cstdint>
#include <numeric>
#include <vector>

#include "comm/data_exchange.hpp"

namespace percuss {

/// The runs of a plan with another number of items in each; runs without items are left out.
inline std::vector<PeerRun> resize_runs(const std::vector<PeerRun>& runs, const std::vector<int>& counts) {
  std::vector<PeerRun> resized;
  std::int64_t first = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (counts[r] > 0) resized.push_back({runs[r].rank, first, counts[r]});
    first += counts[r];
  }
  return resized;
}

/// One item for each run of a plan.
inline std::vector<PeerRun> count_runs(const std::vector<PeerRun>& runs) {
  std::vector<PeerRun> single;
  for (std::size_t r = 0; r < runs.size(); ++r) single.push_back({runs[r].rank, static_cast<std::int64_t>(r), 1});
  return single;
}

/// Sends other numbers of items between ranks that know each other from a plan: sizes first, then data (the paper's
/// (2.4) to (2.6)). counts: [plan.to] items for each run; items: in the order of the runs. Returns the received items
/// by source rank, then as sent. Every rank of the plan calls it. Throws MpiError.
template <class Item>
std::vector<Item> exchange_sized(DataExchange& data, const ExchangePlan& plan, const std::vector<int>& counts,
                                 const std::vector<Item>& items) {
  const ExchangePlan sizes{count_runs(plan.to), count_runs(plan.from)};
  const std::vector<int> received = data.exchange(sizes, counts);
  return data.exchange(ExchangePlan{resize_runs(plan.to, counts), resize_runs(plan.from, received)}, items);
}

/// Sums of a list by the runs of a plan that its items were sent along.
inline std::vector<int> sum_by_run(const std::vector<PeerRun>& runs, const std::vector<int>& values) {
  std::vector<int> sums;
  for (const PeerRun& run : runs) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(run.first);
    sums.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(run.count), 0));
  }
  return sums;
}

}  // namespace percuss
