#pragma once
// Point clouds, ways to hold them at the start, and the comparison of a parallel bisection with the serial one.

#include <gtest/gtest.h>

#include "comm/rcb/rcb.hpp"
#include "tests/comm/random_numbers.hpp"
#include "tests/comm/rcb/serial_rcb.hpp"

namespace percuss::test {

using Points = std::vector<Point>;

inline Points make_random_points(int count, std::uint64_t seed) {
  Random random(seed);
  Points points(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {
        {random.between(0, 3), random.between(-1, 1), random.between(5, 5.5)}, static_cast<std::int64_t>(i * 7), 1};
  }
  return points;
}

/// Nodes of a lattice: whole planes of points have one coordinate.
inline Points make_lattice(int nx, int ny, int nz) {
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

inline Points take_share(const Points& points, const Communicator& world, Start start) {
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

inline RcbPoints to_rcb_points(const Points& points, bool with_weights) {
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

}  // namespace percuss::test
