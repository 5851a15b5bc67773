// Exact sums over ranks have the bits of one rank.

#include "comm/exact_reduction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

TEST(ExactReduction, GivesEveryRankTheBitsOfOneRank) {
  const auto world = Communicator::world();
  Random random(5);
  std::array<ExactSum, 2> own{}, all{};
  for (int i = 0; i < 3000; ++i) {
    const double value = random.between(-1, 1) * std::pow(10.0, random.below(60) - 30);
    const auto sum = static_cast<std::size_t>(i % 2);
    all[sum].add(value);
    if (random.below(world.size()) == world.rank()) own[sum].add(value);
  }
  // Each rank draws the same numbers, so each value is added on one of them.
  sum_over_ranks(world, own);
  for (std::size_t s = 0; s < 2; ++s) EXPECT_EQ(own[s].round(), all[s].round());
}

TEST(ExactReduction, TellsAllRanksOfANumberThatIsNotFinite) {
  const auto world = Communicator::world();
  std::array<ExactSum, 1> sum{};
  sum[0].add(world.rank() == world.size() - 1 ? std::nan("") : 1.0);
  sum_over_ranks(world, sum);
  EXPECT_TRUE(std::isnan(sum[0].round()));
}

}  // namespace percuss::test
