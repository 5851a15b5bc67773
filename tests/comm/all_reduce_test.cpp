// Plain numbers over ranks, in place.

#include "comm/all_reduce.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

namespace percuss::test {

TEST(AllReduce, GivesEveryRankSumLeastAndLargest) {
  const auto world = Communicator::world();
  const int rank = world.rank(), size = world.size();
  int sum = rank + 1, least = 10 + rank, largest = 10 - rank;
  all_reduce(world, Reduce::sum, sum);
  all_reduce(world, Reduce::least, least);
  all_reduce(world, Reduce::largest, largest);
  EXPECT_EQ(sum, size * (size + 1) / 2);
  EXPECT_EQ(least, 10);
  EXPECT_EQ(largest, 10);
}

TEST(AllReduce, KeepsAllDigitsOfWideNumbers) {
  const auto world = Communicator::world();
  std::int64_t wide = (std::int64_t{1} << 53) + 1 + world.rank();
  all_reduce(world, Reduce::largest, wide);
  EXPECT_EQ(wide, (std::int64_t{1} << 53) + world.size());
  std::uint64_t unsigned_least = std::numeric_limits<std::uint64_t>::max() - static_cast<std::uint64_t>(world.rank());
  all_reduce(world, Reduce::least, unsigned_least);
  EXPECT_EQ(unsigned_least, std::numeric_limits<std::uint64_t>::max() - static_cast<std::uint64_t>(world.size() - 1));
  double small = 1e-300 * (1 + world.rank());
  all_reduce(world, Reduce::least, small);
  EXPECT_EQ(small, 1e-300);
}

TEST(AllReduce, TakesEachNumberOfAnArrayByItself) {
  const auto world = Communicator::world();
  const int size = world.size();
  double plain[2] = {1.0 * world.rank(), -1.0 * world.rank()};
  all_reduce(world, Reduce::largest, plain);
  EXPECT_EQ(plain[0], size - 1);
  EXPECT_EQ(plain[1], 0);
  std::vector<std::int64_t> marks(static_cast<std::size_t>(size), 0);
  marks[static_cast<std::size_t>(world.rank())] = 1 + world.rank();
  all_reduce(world, Reduce::sum, marks);
  for (int r = 0; r < size; ++r) EXPECT_EQ(marks[static_cast<std::size_t>(r)], 1 + r);
  std::vector<int> none;
  all_reduce(world, Reduce::sum, none);
  EXPECT_TRUE(none.empty());
}

}  // namespace percuss::test
