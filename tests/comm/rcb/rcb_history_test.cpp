// What previous cuts change and what they do not: the axes and the number of rounds, never the cuts along an axis.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comm/rcb/rcb_fixture.hpp"

namespace percuss::test {

using RcbHistory = RcbTest;

TEST_F(RcbHistory, FollowsPointsThatMove) {
  Points points = make_random_points(10'000, 10);
  Random random(11);
  for (int step = 0; step < 12; ++step) {
    expect_like_serial(points, step % 2 == 0 ? Start::dealt : Start::blocks);
    const double travel = std::pow(10.0, random.between(-6, -1));
    for (Point& point : points) {
      for (double& x : point.x) x += random.between(-travel, travel) + (random.below(50) == 0 ? travel : 0);
    }
  }
}

TEST_F(RcbHistory, FollowsALatticeThatMovesAsAWhole) {
  Points points = make_lattice(24, 24, 12);
  for (int step = 0; step < 6; ++step) {
    expect_like_serial(points);
    for (Point& point : points) point.x = {point.x[0] + 1e-3, point.x[1] - 3e-4, point.x[2]};
  }
}

TEST_F(RcbHistory, GivesTheSameOwnersFromAnyPreviousCutsWithTheSameAxes) {
  const Points points = make_random_points(5'000, 12);
  decompose(points);
  const std::vector<Cut> cuts = rcb_.cuts();
  Random random(13);
  for (int repeat = 0; repeat < 5; ++repeat) {
    std::vector<Cut> misleading = cuts;
    for (Cut& cut : misleading) {
      cut.key = {order_coordinate(random.between(-10, 10)), random.below(1000)};
      cut.spacing = std::pow(10.0, random.between(-12, 3));
    }
    rcb_.restore(misleading);
    decompose(points, Start::blocks);
    for (std::size_t m = 1; m < cuts.size(); ++m) EXPECT_TRUE(rcb_.cuts()[m].key == cuts[m].key);
  }
}

TEST_F(RcbHistory, KeepsAnAxisUntilAnotherIsClearlyLonger) {
  if (world_.size() == 1) return;
  const auto first_cut = static_cast<std::size_t>(world_.size() / 2);
  Points points = make_random_points(2'000, 14);  // 3 by 2 by 0.5
  decompose(points);
  EXPECT_EQ(rcb_.cuts()[first_cut].axis, 0);
  for (Point& point : points) point.x[1] *= 1.65;  // 3 by 3.3 by 0.5
  decompose(points);
  EXPECT_EQ(rcb_.cuts()[first_cut].axis, 0);
  for (Point& point : points) point.x[1] *= 1.1;  // 3 by 3.63 by 0.5
  decompose(points);
  EXPECT_EQ(rcb_.cuts()[first_cut].axis, 1);
}

TEST_F(RcbHistory, OnlyFewRoundsAreNeededFromNearbyCuts) {
  Points points = make_random_points(40'000, 15);
  decompose(points);
  Random random(16);
  for (Point& point : points) {
    for (double& x : point.x) x += random.between(-1e-3, 1e-3);
  }
  const RcbReport report = decompose(points);
  EXPECT_LE(report.rounds_per_cut, 2.5);
  const RcbReport unmoved = decompose(points);
  EXPECT_LE(unmoved.rounds_per_cut, 1.0);  // every old cut is found at its place at once
}

TEST_F(RcbHistory, StartsColdFromCutsOfAnotherNumberOfRanks) {
  rcb_.restore(std::vector<Cut>(static_cast<std::size_t>(world_.size() + 1)));
  expect_like_serial(make_random_points(1'000, 24));
}

}  // namespace percuss::test
