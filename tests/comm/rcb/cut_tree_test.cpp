// Walks over the tree of cuts, against a look at every rank's box.

#include "comm/rcb/cut_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "comm/exchange/exchange_buffers.hpp"
#include "tests/comm/random_numbers.hpp"

namespace percuss::test {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Box {
  double low[3] = {-unbounded, -unbounded, -unbounded};
  double high[3] = {unbounded, unbounded, unbounded};
};

/// Cuts at random places inside the box of each group, and the boxes of all ranks.
void cut_randomly(Random& random, int first, int last, const Box& box, std::vector<Cut>& cuts,
                  std::vector<Box>& boxes) {
  if (last - first == 1) {
    boxes[static_cast<std::size_t>(first)] = box;
    return;
  }
  const int middle = find_middle_rank(first, last);
  Cut& cut = cuts[static_cast<std::size_t>(middle)];
  cut.axis = random.below(3);
  const double low = std::max(box.low[cut.axis], 0.0), high = std::min(box.high[cut.axis], 1.0);
  const double place = random.between(low, high);
  cut.key = {order_coordinate(place), 50};
  cut.lower_end = cut.upper_begin = place;
  Box lower = box, upper = box;
  lower.high[cut.axis] = upper.low[cut.axis] = place;
  cut_randomly(random, first, middle, lower, cuts, boxes);
  cut_randomly(random, middle, last, upper, cuts, boxes);
}

struct RandomTree {
  explicit RandomTree(int rank_count) : cuts(static_cast<std::size_t>(rank_count)), boxes(cuts.size()) {
    Random random(static_cast<std::uint64_t>(rank_count));
    cut_randomly(random, 0, rank_count, {}, cuts, boxes);
    tree = {rank_count, copy_to_view("cuts", cuts)};
  }
  std::vector<Cut> cuts;
  std::vector<Box> boxes;
  CutTree tree;
};

std::vector<int> list_reached(const CutTree& tree, const double (&low)[3], const double (&high)[3]) {
  std::vector<int> ranks;
  visit_reached_ranks(tree, low, high, [&](int rank) { ranks.push_back(rank); });
  return ranks;
}

bool meet(const Box& box, const double (&low)[3], const double (&high)[3]) {
  for (int k = 0; k < 3; ++k) {
    if (low[k] > box.high[k] || high[k] < box.low[k]) return false;
  }
  return true;
}

}  // namespace

TEST(CutTree, BoxesReachExactlyTheRanksWhoseBoxesTheyMeet) {
  for (const int rank_count : {1, 2, 3, 5, 8, 13, 64, 100}) {
    const RandomTree random_tree(rank_count);
    Random random(7);
    for (int repeat = 0; repeat < 300; ++repeat) {
      double low[3], high[3];
      for (int k = 0; k < 3; ++k) {
        low[k] = random.between(-0.1, 1);
        high[k] = low[k] + random.between(0, repeat % 3 == 0 ? 1 : 0.1);
      }
      std::vector<int> expected;
      for (int rank = 0; rank < rank_count; ++rank) {
        if (meet(random_tree.boxes[static_cast<std::size_t>(rank)], low, high)) expected.push_back(rank);
      }
      EXPECT_EQ(list_reached(random_tree.tree, low, high), expected);
    }
  }
}

TEST(CutTree, ABoxAsLargeAsAllReachesEveryRankInOrder) {
  const RandomTree random_tree(11);
  const double low[3] = {-unbounded, -unbounded, -unbounded}, high[3] = {unbounded, unbounded, unbounded};
  std::vector<int> all(11);
  for (int rank = 0; rank < 11; ++rank) all[static_cast<std::size_t>(rank)] = rank;
  EXPECT_EQ(list_reached(random_tree.tree, low, high), all);
}

TEST(CutTree, OwnerOfAPointIsTheRankWhoseBoxHoldsIt) {
  const RandomTree random_tree(23);
  Random random(3);
  for (int repeat = 0; repeat < 500; ++repeat) {
    const double x[3] = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    const auto owner = static_cast<std::size_t>(find_owner(random_tree.tree, x, repeat));
    EXPECT_TRUE(meet(random_tree.boxes[owner], x, x));
  }
}

TEST(CutTree, PointsOnACutAreDividedById) {
  std::vector<Cut> cuts(2);
  cuts[1].axis = 1;
  cuts[1].key = {order_coordinate(0.5), 50};
  const CutTree tree{2, copy_to_view("cuts", cuts)};
  const double x[3] = {9, 0.5, 9};
  EXPECT_EQ(find_owner(tree, x, 49), 0);
  EXPECT_EQ(find_owner(tree, x, 50), 1);
}

TEST(CutTree, ABoxBetweenTwoSidesThatHaveMovedApartReachesNobody) {
  std::vector<Cut> cuts(2);
  cuts[1].axis = 0;
  cuts[1].lower_end = 0.4;
  cuts[1].upper_begin = 0.6;
  const CutTree tree{2, copy_to_view("cuts", cuts)};
  const double low[3] = {0.45, 0, 0}, high[3] = {0.55, 1, 1}, higher[3] = {0.6, 1, 1};
  EXPECT_THAT(list_reached(tree, low, high), testing::IsEmpty());
  EXPECT_THAT(list_reached(tree, low, higher), testing::ElementsAre(1));
}

}  // namespace percuss::test
