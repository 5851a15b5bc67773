// Parallel bisection against the serial one: the same cuts to the last key, whoever holds the points at the start.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/comm/rcb/rcb_fixture.hpp"
#include "tests/expect_error.hpp"

namespace percuss::test {

TEST_F(RcbTest, CutsRandomPointsLikeTheSerialOne) {
  const RcbReport report = expect_like_serial(make_random_points(20'000, 1));
  EXPECT_EQ(report.points, 20'000);
  EXPECT_EQ(report.weight, 20'000);
  EXPECT_GE(report.imbalance, 1);
  // At each cut the upper side may get a point more than its share, which it divides among its ranks: 1 + 1/2 + 1/4 ...
  EXPECT_LE(report.imbalance, 1 + 2 * world_.size() / 20'000.0);
}

TEST_F(RcbTest, CutsDoNotDependOnWhoHoldsThePoints) {
  for (const Start start : {Start::all_on_first, Start::all_on_last, Start::blocks, Start::dealt}) {
    rcb_.restore({});
    axes_.clear();
    expect_like_serial(make_random_points(5'000, 2), start);
  }
}

TEST_F(RcbTest, CutsALatticeThroughItsPlanes) { expect_like_serial(make_lattice(30, 20, 11)); }

TEST_F(RcbTest, CutsPointsOnOnePlane) {
  Points points = make_random_points(3'000, 3);
  for (Point& point : points) point.x[0] = 1.25;
  expect_like_serial(points);
}

TEST_F(RcbTest, CutsCoincidentPointsById) {
  Points points = make_random_points(4'000, 4);
  for (Point& point : points) point.x = {1, -0.0, 2};
  expect_like_serial(points);
  expect_like_serial(points);  // from previous cuts without any spacing
}

TEST_F(RcbTest, CutsCrowdsOnWidelyDifferentScales) {
  Points points = make_random_points(6'000, 5);
  Random random(6);
  for (Point& point : points) point.x[0] = std::pow(10.0, random.between(-300, 300)) * (random.below(2) == 0 ? 1 : -1);
  expect_like_serial(points);
  for (std::size_t i = 0; i < points.size(); i += 2) points[i].x[0] = 1e-200;  // half of them tied on top
  expect_like_serial(points);
}

TEST_F(RcbTest, CutsFewerPointsThanRanks) {
  for (const int count : {0, 1, 2, 3, 5}) {
    rcb_.restore({});
    axes_.clear();
    const RcbReport report = expect_like_serial(make_random_points(count, 7), Start::all_on_first);
    EXPECT_EQ(report.points, count);
  }
}

TEST_F(RcbTest, SharesWeightsAndNotCounts) {
  Points points = make_random_points(8'000, 8);
  Random random(9);
  for (Point& point : points) point.weight = 1 + random.below(point.x[0] < 1 ? 100 : 10);
  const RcbReport report = expect_like_serial(points, Start::dealt, true);
  EXPECT_LE(report.imbalance, 1.02);
  expect_like_serial(points, Start::all_on_last, true);  // where the other ranks have no weights to show
}

TEST_F(RcbTest, AllRanksRefuseAPointWithoutAFinitePosition) {
  for (const double bad : {std::nan(""), -std::nan(""), std::numeric_limits<double>::infinity()}) {
    Points points = make_random_points(100, 22);
    points[37].x[1] = bad;
    EXPECT_ERROR(decompose(points), RcbError, "no finite");
  }
  EXPECT_EQ(decompose(make_random_points(100, 22)).points, 100);  // and can continue
}

TEST_F(RcbTest, AllRanksRefuseAWeightThatIsNotPositive) {
  Points points = make_random_points(100, 23);
  points[11].weight = 0;
  EXPECT_ERROR(decompose(points, Start::dealt, true), RcbError, "has the weight 0");
}

TEST_F(RcbTest, PointsThatShareAnIdAndAPlaceStayTogether) {
  Points points = make_random_points(3'000, 25);
  for (Point& point : points) point = {{1, 1, 1}, 5, 1};
  decompose(points);  // must end
  EXPECT_EQ(find_owner(rcb_.tree(), points[0].x, 5), world_.size() - 1);
}

}  // namespace percuss::test
