// Parallel bisection against the serial one: the same cuts to the last key, whoever holds the points at the start.

#include "comm/rcb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "tests/comm/random_numbers.hpp"
#include "tests/comm/serial_rcb.hpp"

namespace percuss::test {

namespace {

using Points = std::vector<Point>;

Points make_random_points(int count, std::uint64_t seed) {
  Random random(seed);
  Points points(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {
        {random.between(0, 3), random.between(-1, 1), random.between(5, 5.5)}, static_cast<std::int64_t>(i * 7), 1};
  }
  return points;
}

/// Nodes of a lattice: whole planes of points have one coordinate.
Points make_lattice(int nx, int ny, int nz) {
  Points points;
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      for (int z = 0; z < nz; ++z)
        points.push_back({{0.1 * x, 0.1 * y, 0.1 * z}, static_cast<std::int64_t>(points.size()), 1});
    }
  }
  return points;
}

/// Where the points are before the bisection.
enum class Start { dealt, all_on_first, all_on_last, blocks };

Points take_share(const Points& points, const Communicator& world, Start start) {
  Points share;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t holder = 0;
    if (start == Start::dealt) holder = i % static_cast<std::size_t>(world.size());
    if (start == Start::all_on_last) holder = static_cast<std::size_t>(world.size() - 1);
    if (start == Start::blocks) holder = i * static_cast<std::size_t>(world.size()) / points.size();
    if (static_cast<int>(holder) == world.rank()) share.push_back(points[i]);
  }
  return share;
}

RcbPoints to_rcb_points(const Points& points, bool with_weights) {
  const Rows3<double> positions("positions", points.size());
  const Array<std::int64_t> ids("ids", points.size());
  const Array<int> weights("weights", with_weights ? points.size() : 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) positions(i, k) = points[i].x[k];
    ids(i) = points[i].id;
    if (with_weights) weights(i) = points[i].weight;
  }
  return {positions, ids, weights};
}

class RcbTest : public testing::Test {
 protected:
  RcbReport decompose(const Points& points, Start start = Start::dealt, bool with_weights = false) {
    return rcb_.decompose(ExecSpace(), to_rcb_points(take_share(points, world_, start), with_weights));
  }

  void expect_cuts(const SerialRcb& expected) const {
    for (std::size_t m = 1; m < expected.keys.size(); ++m) {
      EXPECT_EQ(rcb_.cuts()[m].axis, expected.axes[m]) << "cut " << m;
      EXPECT_TRUE(rcb_.cuts()[m].key == expected.keys[m])
          << "cut " << m << " is at " << restore_coordinate(rcb_.cuts()[m].key.coordinate) << ", id "
          << rcb_.cuts()[m].key.id << " instead of " << restore_coordinate(expected.keys[m].coordinate) << ", id "
          << expected.keys[m].id;
    }
  }

  void expect_owners(const SerialRcb& expected) const {
    for (std::size_t rank = 0; rank < expected.owned.size(); ++rank) {
      for (const Point& point : expected.owned[rank]) {
        EXPECT_EQ(find_owner(rcb_.tree(), point.x, point.id), static_cast<int>(rank)) << "point " << point.id;
      }
    }
  }

  RcbReport expect_like_serial(const Points& points, Start start = Start::dealt, bool with_weights = false) {
    const RcbReport report = decompose(points, start, with_weights);
    const SerialRcb expected = bisect_serially(points, world_.size(), axes_);
    expect_cuts(expected);
    expect_owners(expected);
    axes_ = expected.axes;
    return report;
  }

  const Communicator world_ = Communicator::world();
  Rcb rcb_{world_};
  std::vector<int> axes_;  // of the previous bisection
};

}  // namespace

TEST_F(RcbTest, CutsRandomPointsLikeTheSerialOne) {
  const RcbReport report = expect_like_serial(make_random_points(20'000, 1));
  EXPECT_EQ(report.points, 20'000);
  EXPECT_EQ(report.weight, 20'000);
  EXPECT_LE(report.imbalance, 1.001);
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

TEST_F(RcbTest, FollowsPointsThatMove) {
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

TEST_F(RcbTest, FollowsALatticeThatMovesAsAWhole) {
  Points points = make_lattice(24, 24, 12);
  for (int step = 0; step < 6; ++step) {
    expect_like_serial(points);
    for (Point& point : points) point.x = {point.x[0] + 1e-3, point.x[1] - 3e-4, point.x[2]};
  }
}

TEST_F(RcbTest, GivesTheSameOwnersFromAnyPreviousCutsWithTheSameAxes) {
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

TEST_F(RcbTest, KeepsAnAxisUntilAnotherIsClearlyLonger) {
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

TEST_F(RcbTest, OnlyFewRoundsAreNeededFromNearbyCuts) {
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

TEST_F(RcbTest, FindsOwnersOnTheDevice) {
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

TEST_F(RcbTest, BoxesReachTheOwnersOfAllPointsInThem) {
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

TEST_F(RcbTest, RefittedBoxesReachOwnersWhosePointsHaveMovedAcrossTheCuts) {
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

TEST_F(RcbTest, AllRanksRefuseAPointWithoutAFinitePosition) {
  for (const double bad : {std::nan(""), -std::nan(""), std::numeric_limits<double>::infinity()}) {
    Points points = make_random_points(100, 22);
    points[37].x[1] = bad;
    EXPECT_THROW(decompose(points), RcbError);
  }
  EXPECT_EQ(decompose(make_random_points(100, 22)).points, 100);  // and can go on
}

TEST_F(RcbTest, AllRanksRefuseAWeightThatIsNotPositive) {
  Points points = make_random_points(100, 23);
  points[11].weight = 0;
  EXPECT_THROW(decompose(points, Start::dealt, true), RcbError);
}

TEST_F(RcbTest, StartsColdFromCutsOfAnotherNumberOfRanks) {
  rcb_.restore(std::vector<Cut>(static_cast<std::size_t>(world_.size() + 1)));
  expect_like_serial(make_random_points(1'000, 24));
}

TEST_F(RcbTest, PointsThatShareAnIdAndAPlaceStayTogether) {
  Points points = make_random_points(3'000, 25);
  for (Point& point : points) point = {{1, 1, 1}, 5, 1};
  decompose(points);  // must end
  EXPECT_EQ(find_owner(rcb_.tree(), points[0].x, 5), world_.size() - 1);
}

}  // namespace percuss::test
