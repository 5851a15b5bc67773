#include "comm/exchange/exchange_plan.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace percuss {

ExchangePlan reverse(const ExchangePlan& plan) { return {plan.from, plan.to}; }

namespace {

/// Finds the run of a rank; neighbouring items mostly go to the same one.
class RunFinder {
 public:
  std::size_t operator()(int rank, std::vector<PeerRun>& runs) {
    if (rank != last_rank_) {
      const auto [place, is_new] = runs_of_ranks_.try_emplace(rank, runs.size());
      if (is_new) runs.push_back({rank, 0, 0});
      last_rank_ = rank;
      last_run_ = place->second;
    }
    return last_run_;
  }

 private:
  std::unordered_map<int, std::size_t> runs_of_ranks_;
  int last_rank_ = -1;
  std::size_t last_run_ = 0;
};

/// Sorts runs by rank and lays them out one after the other. Returns where each of the unsorted runs begins.
std::vector<std::int64_t> lay_out(std::vector<PeerRun>& runs) {
  std::vector<std::size_t> ascending(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) ascending[r] = r;
  std::sort(ascending.begin(), ascending.end(), [&](auto a, auto b) { return runs[a].rank < runs[b].rank; });
  std::vector<PeerRun> sorted;
  std::vector<std::int64_t> first(runs.size());
  std::int64_t next = 0;
  for (const std::size_t r : ascending) {
    first[r] = next;
    sorted.push_back({runs[r].rank, next, runs[r].count});
    next += runs[r].count;
  }
  runs = sorted;
  return first;
}

}  // namespace

SendOrder order_by_destination(const std::vector<int>& destinations) {
  SendOrder order;
  RunFinder find_run;
  std::vector<std::size_t> run_of_item(destinations.size());
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    run_of_item[i] = find_run(destinations[i], order.to);
    ++order.to[run_of_item[i]].count;
  }
  std::vector<std::int64_t> next = lay_out(order.to);
  order.items.resize(destinations.size());
  for (std::size_t i = 0; i < destinations.size(); ++i) {
    order.items[static_cast<std::size_t>(next[run_of_item[i]]++)] = static_cast<int>(i);
  }
  return order;
}

}  // namespace percuss
