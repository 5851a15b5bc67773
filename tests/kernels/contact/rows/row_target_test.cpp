// What makes pushes work-free: the discrete gradient, gaps of nodes whose predicted motion continues that of the last
// step.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/contact/rows/row_geometry.hpp"

namespace percuss::test::row_target_test {
namespace {

TEST(DiscreteGradient, MakesTheWayThatWasSeenChangeTheGapByWhatWasSeen) {
  // It goes away along the push direction by 1e-4 while its gap stays.
  const Point3 way{0.01, 0, 1e-4}, gradient = find_discrete_gradient({0, 0, 1}, way, 0, least_slide);
  EXPECT_NEAR(dot(gradient, way), 0, 2e-4 * 1e-4);
  EXPECT_NEAR(norm(gradient), 1, 1e-15);
  EXPECT_EQ(gradient.y, 0);
  EXPECT_LT(gradient.x, 0);
}

TEST(DiscreteGradient, LeavesSidesAloneThatDoNotSlide) {
  const Point3 gradient = find_discrete_gradient({0, 0, 1}, {1e-9, 0, -0.01}, -0.011, least_slide);
  EXPECT_NEAR(gradient.z, 1, 1e-12);
}

TEST(DiscreteGradient, TurnsByATangentOfOneFifthAtMost) {
  const Point3 gradient = find_discrete_gradient({0, 0, 1}, {0.01, 0, 0}, 0.02, least_slide);
  EXPECT_NEAR(gradient.x / gradient.z, 0.2, 1e-12);
}

/// A row of one node.
struct OneNodeRow {
  OneNodeRow(const Point3& seen, const Point3& predicted) {
    row.count = 1;
    row.place[0] = 0;
    row.size = 1;
    row.normal = row.gap_gradient = {0, 0, 1};
    for (Rows3<double>* v : {&at.v, &at.v_checked, &at.v_before}) *v = Rows3<double>("test::v", 1);
    store_row(at.v_checked, 0, seen);
    store_row(at.v, 0, predicted);
  }
  ContactRow row;
  RowNodes at;
};

TEST(RowWays, AreThoseOfTheVelocitiesWithoutContactAndAsTheNodesWereSeen) {
  const OneNodeRow pushed({0, 0, 0}, {0, 0, -0.5});
  const RowWays ways = find_ways(pushed.at, 0.5, pushed.row);
  EXPECT_EQ(ways.predicted.z, -0.25);
  EXPECT_EQ(ways.checked.z, 0);
}

TEST(RowTarget, AsksForNoMoreThanTheRowsOwnGapAtTheStart) {
  // The geometry at n says that it touches; the row's plane had it 0.003 deep at n, which cost nothing.
  OneNodeRow row({0, 0, 0}, {0, 0, 0});
  row.row.gap = -0.003;
  row.row.target = 0;
  limit_recovery({}, row.row);
  EXPECT_EQ(row.row.target, -0.003 + contact_limits::recovery);
  row.row.gap_start = 0.01;  // it comes from afar and is stopped at the face
  row.row.target = 0;
  limit_recovery({}, row.row);
  EXPECT_EQ(row.row.target, 0);
}

}  // namespace
}  // namespace percuss::test::row_target_test
