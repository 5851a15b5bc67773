// Bisection by one process against Rcb on real ranks from a cold start: the same cuts, the same owners.

#include "comm/partition/bisect_points.hpp"

#include "kernels/core/host_copy.hpp"
#include "tests/comm/rcb/rcb_fixture.hpp"

namespace percuss::test {
namespace {

std::vector<PlacedPoint> place(const Points& points) {
  std::vector<PlacedPoint> placed;
  for (const Point& point : points) placed.push_back({point.x, point.id});
  return placed;
}

class BisectPointsTest : public RcbTest {
 protected:
  void expect_like_ranks(const Points& points) {
    rcb_.restore({});
    decompose(points, Start::blocks);
    const std::vector<Cut> cuts = bisect_points(place(points), world_.size());
    ASSERT_EQ(cuts.size(), rcb_.cuts().size());
    for (std::size_t m = 1; m < cuts.size(); ++m) {
      const Cut& expected = rcb_.cuts()[m];
      EXPECT_TRUE(cuts[m].key == expected.key) << "cut " << m;
      if (!is_made(expected)) continue;
      EXPECT_EQ(cuts[m].axis, expected.axis) << "cut " << m;
      EXPECT_EQ(cuts[m].lower_end, expected.lower_end) << "cut " << m;
      EXPECT_EQ(cuts[m].upper_begin, expected.upper_begin) << "cut " << m;
    }
    const CutTree tree{world_.size(), to_view("test::cuts", cuts)};
    for (const Point& point : points) {
      EXPECT_EQ(find_owner(tree, point.x, point.id), find_owner(rcb_.tree(), point.x, point.id)) << point.id;
    }
  }
};

TEST_F(BisectPointsTest, GivesRandomPointsTheOwnersThatRanksGiveThem) {
  expect_like_ranks(make_random_points(10'000, 11));
}

TEST_F(BisectPointsTest, GivesALatticeTheOwnersThatRanksGiveIt) { expect_like_ranks(make_lattice(17, 20, 11)); }

TEST_F(BisectPointsTest, GivesCoincidentPointsTheOwnersThatRanksGiveThem) {
  Points points = make_random_points(500, 12);
  for (Point& point : points) point.x = {1, -0.0, 2};
  expect_like_ranks(points);
}

TEST_F(BisectPointsTest, GivesFewerPointsThanRanksTheOwnersThatRanksGiveThem) {
  for (const int count : {0, 1, 2, 3, 5}) expect_like_ranks(make_random_points(count, 13));
}

TEST_F(BisectPointsTest, DividesEvenlyAmongMoreRanksThanThereAre) {
  const Points points = make_random_points(9'973, 14);
  constexpr int ranks = 61;
  const CutTree tree{ranks, to_view("test::cuts", bisect_points(place(points), ranks))};
  std::vector<int> owned(ranks, 0);
  for (const Point& point : points) ++owned[static_cast<std::size_t>(find_owner(tree, point.x, point.id))];
  // At each cut the upper side may get a point more than its share, which it divides: 1 + 1/2 + 1/4 ... < 2.
  for (const int count : owned) EXPECT_NEAR(count, 9'973.0 / ranks, 2);
}

}  // namespace
}  // namespace percuss::test
