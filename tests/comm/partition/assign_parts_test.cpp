// Parts of a decomposition to the ranks that have most of their points.

#include "comm/partition/assign_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace percuss::test {
namespace {

TEST(AssignParts, GivesEachPartToTheRankThatHasMostOfIt) {
  // Rank 0 has all of part 2, rank 1 that of part 0, rank 2 a bit of everything.
  const std::vector<Overlap> overlaps{{0, 2, 100}, {1, 0, 90}, {2, 0, 20}, {2, 1, 30}, {2, 2, 40}};
  EXPECT_EQ(assign_parts(overlaps, 3), (std::vector<int>{1, 2, 0}));
}

TEST(AssignParts, LetsTheLargestOverlapChooseFirst) {
  // Both ranks have most of part 0; the one with more gets it, wherever it stands in the list.
  EXPECT_EQ(assign_parts({{0, 0, 10}, {0, 1, 1}, {1, 0, 11}, {1, 1, 5}}, 2), (std::vector<int>{1, 0}));
  EXPECT_EQ(assign_parts({{1, 1, 5}, {1, 0, 11}, {0, 1, 1}, {0, 0, 10}}, 2), (std::vector<int>{1, 0}));
}

TEST(AssignParts, GivesWhatNobodyHasToThoseThatAreLeft) {
  const std::vector<int> ranks = assign_parts({{3, 1, 7}}, 5);
  EXPECT_EQ(ranks[1], 3);
  std::vector<int> sorted = ranks, all(5);
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  EXPECT_EQ(assign_parts({}, 3), (std::vector<int>{0, 1, 2}));
}

TEST(AssignParts, CountsTheLargestOverlapsOfARank) {
  const std::vector<Overlap> found = find_overlaps(4, {7, 7, 2, 7, 2, 9});
  ASSERT_EQ(found.size(), 3u);
  const int parts[3] = {7, 2, 9};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found[i].rank, 4);
    EXPECT_EQ(found[i].part, parts[i]);
    EXPECT_EQ(found[i].points, 3 - static_cast<std::int64_t>(i));
  }
  std::vector<int> many;
  for (int part = 0; part < 20; ++part) many.insert(many.end(), static_cast<std::size_t>(part) + 1, part);
  const std::vector<Overlap> few = find_overlaps(0, many);
  ASSERT_EQ(few.size(), most_overlaps);
  EXPECT_EQ(few.front().part, 19);
  EXPECT_EQ(few.back().part, 20 - static_cast<int>(most_overlaps));
}

}  // namespace
}  // namespace percuss::test
