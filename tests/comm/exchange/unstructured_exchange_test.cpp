// Plans of random patterns by both methods, against the pattern itself, which every rank can compute.

#include "comm/exchange/unstructured_exchange.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

/// Items that every rank sends to every rank; 0 for most pairs.
using Pattern = std::vector<std::vector<std::int64_t>>;

Pattern make_pattern(int rank_count, std::uint64_t seed, int share_of_pairs) {
  Random random(seed);
  const auto size = static_cast<std::size_t>(rank_count);
  Pattern counts(size, std::vector<std::int64_t>(size, 0));
  for (auto& row : counts) {
    for (auto& count : row) {
      if (random.below(share_of_pairs) == 0) count = 1 + random.below(1000);
    }
  }
  return counts;
}

std::vector<PeerRun> lay_out(const std::vector<std::int64_t>& counts) {
  std::vector<PeerRun> runs;
  std::int64_t next = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    if (counts[rank] > 0) runs.push_back({static_cast<int>(rank), next, counts[rank]});
    next += counts[rank];
  }
  return runs;
}

std::vector<PeerRun> lay_out_received(const Pattern& pattern, int me) {
  std::vector<std::int64_t> counts;
  for (const auto& row : pattern) counts.push_back(row[static_cast<std::size_t>(me)]);
  return lay_out(counts);
}

class PlanByMethod : public testing::TestWithParam<PlanMethod> {
 protected:
  const Communicator world_ = Communicator::world();
  const std::size_t me_ = static_cast<std::size_t>(world_.rank());
};

}  // namespace

TEST_P(PlanByMethod, ReceivesWhatTheOthersSend) {
  UnstructuredExchange exchange(world_);
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Pattern pattern = make_pattern(world_.size(), seed, 1 + static_cast<int>(seed % 4));
    const ExchangePlan plan = exchange.plan(lay_out(pattern[me_]), GetParam());
    EXPECT_EQ(plan.to, lay_out(pattern[me_]));
    EXPECT_EQ(plan.from, lay_out_received(pattern, world_.rank()));
  }
}

TEST_P(PlanByMethod, OfNothingIsEmptyEverywhere) {
  UnstructuredExchange exchange(world_);
  const ExchangePlan plan = exchange.plan({}, GetParam());
  EXPECT_TRUE(plan.to.empty());
  EXPECT_TRUE(plan.from.empty());
}

TEST_P(PlanByMethod, EmptyRunsLeaveNoTrace) {
  UnstructuredExchange exchange(world_);
  std::vector<PeerRun> to;
  for (int rank = 0; rank < world_.size(); ++rank) to.push_back({rank, 0, 0});
  const ExchangePlan plan = exchange.plan(to, GetParam());
  EXPECT_TRUE(plan.to.empty());
  EXPECT_TRUE(plan.from.empty());
}

TEST_P(PlanByMethod, OfMessagesToOneselfHasNoOtherRank) {
  UnstructuredExchange exchange(world_);
  const std::vector<PeerRun> to_self{{world_.rank(), 0, 17}};
  EXPECT_EQ(exchange.plan(to_self, GetParam()).from, to_self);
}

TEST_P(PlanByMethod, OfOneRankThatSendsToAllReachesAll) {
  UnstructuredExchange exchange(world_);
  Pattern pattern(static_cast<std::size_t>(world_.size()),
                  std::vector<std::int64_t>(static_cast<std::size_t>(world_.size()), 0));
  for (auto& count : pattern.back()) count = 3;
  const ExchangePlan plan = exchange.plan(lay_out(pattern[me_]), GetParam());
  EXPECT_EQ(plan.from, (std::vector<PeerRun>{{world_.size() - 1, 0, 3}}));
}

TEST_P(PlanByMethod, CountsBeyondTwoToThe31AreToldAsTheyAre) {
  UnstructuredExchange exchange(world_);
  const std::int64_t many = (std::int64_t{1} << 31) + 5;
  const int next = (world_.rank() + 1) % world_.size();
  const int previous = (world_.rank() + world_.size() - 1) % world_.size();
  EXPECT_EQ(exchange.plan({{next, 0, many}}, GetParam()).from, (std::vector<PeerRun>{{previous, 0, many}}));
}

// Ranks that hurry ahead must not be heard by those still in the exchange before.
TEST_P(PlanByMethod, ManyInARowDoNotMix) {
  UnstructuredExchange exchange(world_);
  for (int round = 0; round < 400; ++round) {
    const int next = (world_.rank() + 1 + round) % world_.size();
    const int previous = ((world_.rank() - 1 - round) % world_.size() + world_.size()) % world_.size();
    const ExchangePlan plan = exchange.plan({{next, 0, 1 + round}}, GetParam());
    ASSERT_EQ(plan.from, (std::vector<PeerRun>{{previous, 0, 1 + round}}));
  }
}

INSTANTIATE_TEST_SUITE_P(Figure2, PlanByMethod,
                         testing::Values(PlanMethod::automatic, PlanMethod::reduce_scatter, PlanMethod::consensus),
                         [](const auto& instance) {
                           switch (instance.param) {
                             case PlanMethod::automatic:
                               return "automatic";
                             case PlanMethod::reduce_scatter:
                               return "reduce_scatter";
                             case PlanMethod::consensus:
                               return "consensus";
                           }
                           return "unknown";
                         });

}  // namespace percuss::test
