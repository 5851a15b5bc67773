#include "kernels/contact/rows/contact_row.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/contact/rows/row_geometry.hpp"

namespace percuss::test::contact_row_test {
namespace {

struct RandomRow {
  ContactRow row;
  Point3 x[row_nodes]{};
};

/// A row on a warped face with the node anywhere near it.
RandomRow make_row(std::mt19937& random, double friction) {
  std::uniform_real_distribution<double> place(-1, 1), fraction(0, 1);
  RandomRow r;
  const FacePoints square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  Rows3<double> x("test::x", row_nodes);
  r.x[0] = {place(random), place(random), place(random)};
  for (int i = 0; i < 4; ++i) r.x[i + 1] = square.corner[i] + 0.2 * Point3{place(random), place(random), place(random)};
  for (int i = 0; i < row_nodes; ++i) {
    r.row.place[i] = i;
    store_row(x, i, r.x[i]);
  }
  const double a = fraction(random), b = fraction(random) * (1 - a);
  double corner[4] = {0, 0, 0, 0};
  set_fan_weights(1, {1 - a - b, a, b}, corner);
  for (int i = 0; i < 4; ++i) r.row.weight[i + 1] = -corner[i];
  r.row.count = row_nodes;
  r.row.face = 0;
  r.row.friction = friction;
  r.row.normal = normalize(Point3{place(random), place(random), 2});
  r.row.gap_gradient = r.row.normal;
  set_tangents(r.row);
  set_arms(x, r.row);
  return r;
}

/// A row of two crossed edges, anywhere near one another.
RandomRow make_edge_row(std::mt19937& random, double friction) {
  std::uniform_real_distribution<double> shift(-0.2, 0.2), fraction(0, 1);
  RandomRow r;
  const Point3 ends[4] = {{-1, 0, 0.1}, {1, 0, 0.1}, {0, -1, 0}, {0, 1, 0}};
  Rows3<double> x("test::x", row_nodes);
  for (int i = 0; i < 4; ++i) {
    r.x[i] = ends[i] + Point3{shift(random), shift(random), shift(random)};
    r.row.place[i] = i;
    store_row(x, i, r.x[i]);
  }
  const double s = fraction(random), t = fraction(random), weights[4] = {1 - s, s, t - 1, -t};
  for (int i = 0; i < 4; ++i) r.row.weight[i] = weights[i];
  r.row.count = 4;
  r.row.friction = friction;
  r.row.normal = normalize(cross(r.x[1] - r.x[0], r.x[3] - r.x[2]));
  r.row.gap_gradient = r.row.normal;
  set_tangents(r.row);
  set_arms(x, r.row);
  return r;
}

void expect_no_momentum(const RandomRow& r) {
  for (int d = 0; d < 3; ++d) {
    const Point3 p = get_direction(r.row, d), q = find_couple(r.row, p);
    Point3 sum{}, moment{};
    for (int slot = 0; slot < r.row.count; ++slot) {
      const Point3 f = spread_impulse(r.row, slot, p, q);
      sum = sum + f;
      moment = moment + cross(r.x[slot], f);
    }
    EXPECT_LT(norm(sum), 1e-14);     // sums of five numbers of order one
    EXPECT_LT(norm(moment), 1e-13);  // the inverse of J costs a digit
  }
}

TEST(ContactRow, ImpulsesOfARowSumToZeroAndSoDoTheirMoments) {
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i) expect_no_momentum(make_row(random, 0.3));
}

TEST(ContactRow, ImpulsesOfTwoEdgesSumToZeroAndSoDoTheirMoments) {
  std::mt19937 random(15);
  for (int i = 0; i < 100; ++i) expect_no_momentum(make_edge_row(random, 0.3));
}

TEST(ContactRow, WorkVelocityIsTheTransposeOfSpreading) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const RandomRow r = i % 2 == 0 ? make_row(random, 0.3) : make_edge_row(random, 0.3);
    Point3 v[row_nodes];
    for (Point3& a : v) a = {value(random), value(random), value(random)};
    const Point3 p{value(random), value(random), value(random)}, q = find_couple(r.row, p);
    double power = 0;
    for (int slot = 0; slot < r.row.count; ++slot) power += dot(spread_impulse(r.row, slot, p, q), v[slot]);
    const Point3 u = find_work_velocity(r.row, [&](int slot) { return v[slot]; });
    EXPECT_NEAR(power, dot(p, u), 1e-13);
  }
}

TEST(ContactRow, RigidMotionHasNoWorkVelocity) {
  std::mt19937 random(13);
  const RandomRow r = make_row(random, 0.3);
  const Point3 translation{1, 2, 3}, spin{0.5, -1, 0.25};
  const Point3 u = find_work_velocity(r.row, [&](int slot) { return translation + cross(spin, r.x[slot]); });
  EXPECT_LT(norm(u), 1e-13);
}

TEST(ContactRow, TangentsAndNormalAreARightHandedFrame) {
  std::mt19937 random(14);
  std::uniform_real_distribution<double> value(-1, 1);
  for (int i = 0; i < 100; ++i) {
    ContactRow row;
    row.normal = normalize(Point3{value(random), value(random), value(random)});
    set_tangents(row);
    EXPECT_LT(norm(cross(row.tangent[0], row.tangent[1]) - row.normal), 1e-14);
    EXPECT_NEAR(norm(row.tangent[0]), 1, 1e-14);
  }
}

TEST(ContactRow, RubIsShortenedToTheCoulombLimitAndKeepsItsDirection) {
  ContactRow row;
  row.friction = 0.5;
  RowImpulse p{2, {3, 4}};
  limit_friction(row, p);
  EXPECT_NEAR(p.tangential[0], 0.6, 1e-15);
  EXPECT_NEAR(p.tangential[1], 0.8, 1e-15);
  RowImpulse inside{10, {3, 4}};
  limit_friction(row, inside);
  EXPECT_EQ(inside.tangential[0], 3);
  EXPECT_EQ(inside.tangential[1], 4);
}

TEST(ContactRow, ATargetNeverDemandsMoreThanTheSlowRecovery) {
  ContactRow row;
  row.size = 2;
  row.gap_start = 0.1;
  set_target(row);
  EXPECT_EQ(row.target, 0);
  row.gap_start = -0.5;
  set_target(row);
  EXPECT_NEAR(row.target, -0.5 + 2 * contact_limits::recovery, 1e-16);
  row.reference = 0.5;  // accepted at the start
  set_target(row);
  EXPECT_EQ(row.target, -0.5);
}

TEST(ContactRow, ClosesNoMoreThanItsNodesCanHaveMoved) {
  RowNodes at;
  at.v = Rows3<double>("test::v", 5);
  at.v(0, 2) = -3;
  at.v(3, 1) = 4;
  ContactRow row;
  row.kind = RowKind::face;
  row.count = 5;
  for (int slot = 0; slot < 5; ++slot) row.place[slot] = slot;
  row.normal = row.gap_gradient = {0, 0, 1};
  row.size = 2;
  const auto limit = [&](double gap, double target) {
    row.gap = gap;
    row.target = target;
    limit_closing(at, 0.01, row);
    return row.target;
  };
  EXPECT_EQ(limit(-0.03, 0), 0);  // the node and the corner that moves: 5 a time
  EXPECT_EQ(limit(-0.4, -0.36), -0.36);
  EXPECT_DOUBLE_EQ(limit(-0.4, 0), -0.4 + 0.05 + 2e-4);
}

}  // namespace
}  // namespace percuss::test::contact_row_test
