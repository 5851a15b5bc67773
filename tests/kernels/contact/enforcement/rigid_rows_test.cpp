// Rows between rigid bodies: impulses of mechanics, islands that others touch, and the same bits in any order.

#include "kernels/contact/enforcement/rigid_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace percuss::test::rigid_rows_test {
namespace {

constexpr double dt = 1e-3, g = 9.81;

/// A row that pushes body a along n and body b against it, both at their centres; b -1: a wall.
RigidRow make_row(std::int64_t key, int a, int b, const Point3& n, const Point3& t1, double friction) {
  RigidRow row;
  row.key = key;
  row.body[0] = a;
  row.body[1] = b;
  const Point3 t2 = cross(n, t1), directions[3] = {n, t1, t2};
  for (int d = 0; d < 3; ++d) {
    row.push[d][0].impulse = directions[d];
    if (b >= 0) row.push[d][1].impulse = -directions[d];
  }
  for (int k = 0; k < 2; ++k) row.gap[k] = row.push[0][k];
  row.size = 1;
  row.friction = friction;
  return row;
}

BodyResponse make_body(double mass) {
  BodyResponse body;
  body.inverse_mass = {1 / mass, 1 / mass, 1 / mass};
  return body;
}

/// Bodies of unit mass in a column on a floor, under gravity for a step.
struct Column {
  explicit Column(int count) : responses(static_cast<std::size_t>(count), make_body(1)) {
    for (int i = 0; i < count; ++i) {
      rows.push_back(make_row(10 * i, i, i - 1, {0, 0, 1}, {1, 0, 0}, 0.3));
      rows.back().missing = i == 0 ? -g * dt * dt : 0;  // all fall alike
    }
    others.assign(static_cast<std::size_t>(count) + 2, 0);
    others.back() = count;
  }
  RigidReport solve(double tolerance, double accepted = 0) {
    return solve_rigid_rows(rows, others, responses, {dt, tolerance, std::max(tolerance, accepted), 1e-14}, impulses);
  }
  double push(std::size_t i) const { return impulses[i].impulse.normal; }

  std::vector<RigidRow> rows;
  std::vector<BodyResponse> responses;
  std::vector<int> others;
  std::vector<RigidImpulse> impulses;
};

}  // namespace

// Each row carries the weight of all above, and the sweeps grow with the height, not with its square: conjugate
// directions. Plain sweeps of 40 bodies take some 5000.
TEST(RigidRows, OfAColumnCarryTheWeightAbove) {
  for (const int count : {1, 5, 40}) {
    Column column(count);
    const RigidReport report = column.solve(1e-8);
    EXPECT_EQ(report.converged, 1);
    EXPECT_EQ(report.is_all, 1);
    EXPECT_EQ(report.rows, count);
    EXPECT_LE(report.sweeps, 20 + 8 * count);
    for (int i = 0; i < count; ++i) {
      const double weight = (count - i) * g * dt;
      EXPECT_NEAR(column.push(static_cast<std::size_t>(i)), weight, 1e-4 * weight) << i << " of " << count;
    }
  }
}

// What is accepted after many sweeps ends a solution that takes more of them; a short one is as good as before.
TEST(RigidRows, OfAHighColumnAreAcceptedAfterManySweeps) {
  Column column(600), strict(600), low(5);
  const RigidReport report = column.solve(1e-12, 1e-3);
  EXPECT_EQ(report.converged, 1);
  EXPECT_GE(report.sweeps, 300);
  EXPECT_LT(report.sweeps, strict.solve(1e-12).sweeps);
  for (std::size_t i = 0; i < 600; ++i) EXPECT_NEAR(column.push(i), strict.push(i), 0.02 * strict.push(0)) << i;
  EXPECT_LT(low.solve(1e-8, 1e-3).sweeps, 60);
  EXPECT_NEAR(low.push(0), 5 * g * dt, 1e-6 * g * dt);
}

// A sliding body takes mu times the push, a slower one stops.
TEST(RigidRows, FrictionStopsOrTakesItsLimit) {
  for (const double speed : {0.5 * 0.3 * g * dt, 2 * 0.3 * g * dt}) {
    Column block(1);
    block.rows[0].slide[0] = speed * dt;
    ASSERT_EQ(block.solve(1e-8).converged, 1);
    const double limit = 0.3 * g * dt;
    EXPECT_NEAR(block.impulses[0].impulse.tangential[0], -std::min(speed, limit), 1e-9 * limit);
    EXPECT_NEAR(block.impulses[0].impulse.tangential[1], 0, 1e-12 * limit);
  }
}

// Four feet where three would do: a table of mass 1 whose weight no one can share out uniquely.
TEST(RigidRows, MoreThanTheMotionNeedsStillCarryTheWeight) {
  Column table(1);
  table.responses[0].inverse_inertia = {6, 6, 6, 0, 0, 0};
  table.rows.clear();
  for (int k = 0; k < 4; ++k) {
    RigidRow row = make_row(k, 0, -1, {0, 0, 1}, {1, 0, 0}, 0.3);
    const Point3 arm{k % 2 == 0 ? 0.5 : -0.5, k < 2 ? 0.5 : -0.5, -0.2};
    for (auto& push : row.push) push[0].moment = cross(arm, push[0].impulse);
    row.gap[0] = row.push[0][0];
    row.missing = -g * dt * dt;
    table.rows.push_back(row);
  }
  EXPECT_EQ(table.solve(1e-9).converged, 1);
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += table.push(k);
  EXPECT_NEAR(sum, g * dt, 1e-8 * g * dt);
}

// A body that a node also touches leaves its whole island to the iteration; the other island is solved.
TEST(RigidRows, OfIslandsThatOthersTouchAreLeft) {
  Column two(4);
  two.rows[2] = make_row(20, 2, -1, {0, 0, 1}, {1, 0, 0}, 0.3);  // 2 and 3 stand beside 0 and 1
  two.rows[2].missing = -g * dt * dt;
  two.others[1] = 1;  // body 1
  two.others[4] = 1;  // rows that are to be iterated
  const RigidReport report = two.solve(1e-8);
  EXPECT_EQ(report.is_all, 0);
  EXPECT_EQ(two.impulses[0].is_solved + two.impulses[1].is_solved, 0);
  EXPECT_EQ(two.impulses[2].is_solved + two.impulses[3].is_solved, 2);
  EXPECT_NEAR(two.push(2), 2 * g * dt, 1e-6 * g * dt);
}

TEST(RigidRows, InAnyOrderHaveTheSameBits) {
  Column column(12), mixed(12);
  std::reverse(mixed.rows.begin(), mixed.rows.end());
  std::swap(mixed.rows[3], mixed.rows[8]);
  column.solve(1e-6);
  mixed.solve(1e-6);
  for (std::size_t i = 0; i < 12; ++i) {
    const auto same = std::find_if(column.rows.begin(), column.rows.end(),
                                   [&](const RigidRow& row) { return row.key == mixed.rows[i].key; });
    EXPECT_EQ(mixed.push(i), column.push(static_cast<std::size_t>(same - column.rows.begin())));
  }
}

}  // namespace percuss::test::rigid_rows_test
