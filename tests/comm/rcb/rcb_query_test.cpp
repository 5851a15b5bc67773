// Questions to the cuts of a bisection: who owns a point, whom a box reaches.

#include <gtest/gtest.h>

#include <map>

#include "tests/comm/rcb/rcb_fixture.hpp"

namespace percuss::test {

using RcbQuery = RcbTest;

TEST_F(RcbQuery, FindsRankZeroBeforeTheFirstBisection) {
  const double x[3] = {1, 2, 3};
  EXPECT_EQ(find_owner(rcb_.tree(), x, 7), 0);
  visit_reached_ranks(rcb_.tree(), x, x, [](int rank) { EXPECT_EQ(rank, 0); });
}

TEST_F(RcbQuery, FindsOwnersOnTheDevice) {
  const Points points = make_random_points(3'000, 17);
  decompose(points);
  const SerialRcb expected = bisect_serially(points, world_.size());
  const RcbPoints all = to_rcb_points(points, false);
  const Array<int> owners("owners", points.size());
  find_owners(ExecSpace(), rcb_.tree(), all.positions, all.ids, owners);
  Kokkos::fence();
  std::map<std::int64_t, int> expected_owners;
  for (std::size_t rank = 0; rank < expected.owned.size(); ++rank) {
    for (const Point& point : expected.owned[rank]) expected_owners[point.id] = static_cast<int>(rank);
  }
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(owners(i), expected_owners[points[i].id]);
}

TEST_F(RcbQuery, BoxesReachTheOwnersOfAllPointsInThem) {
  const Points points = make_random_points(2'000, 18);
  decompose(points);
  Random random(19);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const Point& middle = points[static_cast<std::size_t>(random.below(2'000))];
    double low[3], high[3];
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = middle.x[k] - random.between(0, 0.3);
      high[k] = middle.x[k] + random.between(0, 0.3);
    }
    std::vector<char> reached(static_cast<std::size_t>(world_.size()), 0);
    visit_reached_ranks(rcb_.tree(), low, high, [&](int rank) { reached[static_cast<std::size_t>(rank)] = 1; });
    for (const Point& point : points) {
      bool is_inside = true;
      for (std::size_t k = 0; k < 3; ++k) is_inside = is_inside && point.x[k] >= low[k] && point.x[k] <= high[k];
      const bool is_reached = reached[static_cast<std::size_t>(find_owner(rcb_.tree(), point.x, point.id))] != 0;
      EXPECT_TRUE(is_reached || !is_inside);
    }
  }
}

TEST_F(RcbQuery, RefittedBoxesReachOwnersWhosePointsHaveMovedAcrossTheCuts) {
  Points points = make_random_points(2'000, 20);
  decompose(points);
  std::vector<int> owners;
  Points own;
  Random random(21);
  for (Point& point : points) {
    owners.push_back(find_owner(rcb_.tree(), point.x, point.id));
    for (double& x : point.x) x += random.between(-0.5, 0.5);
    if (owners.back() == world_.rank()) own.push_back(point);
  }
  rcb_.refit(ExecSpace(), to_rcb_points(own, false).positions);
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool is_reached = false;
    visit_reached_ranks(rcb_.tree(), points[i].x, points[i].x,
                        [&](int rank) { is_reached = is_reached || rank == owners[i]; });
    EXPECT_TRUE(is_reached) << i;
  }
}

}  // namespace percuss::test
