#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/kernels/contact/enforcement/enforced_scene.hpp"

namespace percuss::test::enforcement_test {
namespace {

using Small = EnforcedScene<SmallSpace>;

/// A held floor and a brick of four unit masses at its foot that comes down with (vx, 0, vz).
BrickScene make_block_on_floor(double vx, double vz) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 1});
  for (Point3& w : scene.inverse_mass) w = {0, 0, 0};
  scene.add_brick({1.25, 1.5, 1}, {1, 1, 1}, {vx, 0, vz});
  return scene;
}

TEST(Enforcement, NodesOfTwoMassesEndWithTheirCommonVelocity) {
  // Coincident nodes, each on the other's corner: all rows of a pair together exchange m1 m2 / (m1 + m2) (v1 - v2).
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, 2}, 3);
  bricks.add_brick({0, 0, 1}, {1, 1, 1}, {0, 0, -1}, 1);
  const Small scene(bricks, 0.01, 0);
  const double common = (3 * 2 - 1 * 1) / 4.0, impulse = 3 * 1 / 4.0 * 3;
  EXPECT_TRUE(scene.solved.converged);
  for (int i = 0; i < 4; ++i) {
    // The iteration ends within 1e-3 of the predicted penetration, 3 dt.
    EXPECT_NEAR(scene.v(4 + i).z, common, 3e-3);
    EXPECT_NEAR(scene.v(8 + i).z, common, 9e-3);
    EXPECT_NEAR(scene.p(8 + i).z, impulse, 9e-3);
    EXPECT_NEAR(scene.p(8 + i).z + scene.p(4 + i).z, 0, 1e-14);
  }
  EXPECT_EQ(scene.v(0).z, 2);  // not in contact
  EXPECT_LT(scene.sums.residual, 3e-3 * 0.03);
}

TEST(Enforcement, BodiesThatPartAreNotHeld) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, -1});
  bricks.add_brick({0, 0, 1}, {1, 1, 1}, {0, 0, 1});
  const Small scene(bricks, 0.01, 0.5);
  for (int n = 0; n < 16; ++n) EXPECT_EQ(scene.v(n).z, n < 8 ? -1 : 1);
  EXPECT_EQ(scene.sums.pushes, 0);
  EXPECT_EQ(scene.sums.normal_work.round(), 0);
}

TEST(Enforcement, FrictionStopsASlowBlockAndDragsAFastOneByMuTimesThePush) {
  // One row a node, axes along its directions: the exact impulses follow at once.
  const Small sticking(make_block_on_floor(0.4, -1), 0.01, 0.5);
  const Small sliding(make_block_on_floor(2.0, -1), 0.01, 0.5);
  for (int n = 8; n < 12; ++n) {
    EXPECT_NEAR(sticking.v(n).x, 0, 1e-14);
    EXPECT_NEAR(sticking.v(n).z, 0, 1e-14);
    EXPECT_NEAR(sliding.v(n).x, 1.5, 1e-14);
    EXPECT_NEAR(sliding.p(n).x, -0.5, 1e-14);
    EXPECT_NEAR(sliding.p(n).z, 1, 1e-14);
  }
  // Work of P is P . (v before + v after) / 2: 4 nodes lose (0.4^2 + 1) / 2, or 1 / 2 and (2^2 - 1.5^2) / 2.
  EXPECT_NEAR(sticking.sums.friction_work.round(), -4 * 0.08, 1e-13);
  EXPECT_NEAR(sticking.sums.normal_work.round(), -4 * 0.5, 1e-13);
  EXPECT_NEAR(sliding.sums.friction_work.round(), -4 * 0.875, 1e-13);
}

// A floor that leans by `slope` rises under a block that may only move along x and y.
BrickScene make_guided_block(double slope) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 1}, {0, 0, 1});
  for (int n = 0; n < 8; ++n) {
    scene.inverse_mass[static_cast<std::size_t>(n)] = {0, 0, 0};
    scene.x[static_cast<std::size_t>(n)].z += slope * (scene.x[static_cast<std::size_t>(n)].x - 1.25);
  }
  scene.add_brick({1.25, 1.5, 1}, {1, 1, 1});
  for (int n = 8; n < 16; ++n) scene.inverse_mass[static_cast<std::size_t>(n)].z = 0;
  return scene;
}

TEST(Enforcement, WhatIsHeldAlongThePushIsNotThrownAcrossIt) {
  const Small sliding(make_guided_block(0.02), 0.01, 0);
  EXPECT_NEAR(sliding.v(8).x, -1 / 0.02, 1e-6 / 0.02);  // down the slope as fast as it rises
  const Small round_off(make_guided_block(1e-9), 0.01, 0);
  for (int n = 8; n < 16; ++n) EXPECT_EQ(round_off.v(n).x, 0);
  EXPECT_TRUE(round_off.solved.converged);
}

TEST(Enforcement, AWallPushesAndRubsLikeABodyWithoutMotion) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0.005}, {1, 1, 1}, {3, 0, -1});
  const WallPairs walls{to_array(std::vector<ContactWall>{{{0, 0, 0}, {0, 0, 1}, 0.5}}),
                        to_array(std::vector<int>{0, 0, 0, 0}), to_array(std::vector<int>{0, 1, 2, 3}),
                        to_array(std::vector<double>{1, 1, 1, 1})};
  const Small scene(bricks, 0.01, 0, walls);
  for (int n = 0; n < 4; ++n) {
    // Half of the step closes the gap: the node arrives with half its velocity and the push is the other half.
    EXPECT_NEAR(scene.v(n).z, -0.5, 1e-14);
    EXPECT_NEAR(scene.v(n).x, 3 - 0.25, 1e-14);
  }
  EXPECT_EQ(scene.v(4).z, -1);
}

TEST(Enforcement, NodesHeldInOneDirectionMoveInTheOthersOnly) {
  BrickScene bricks = make_block_on_floor(0.4, -1);
  bricks.inverse_mass[8] = {0, 1, 1};
  const Small scene(bricks, 0.01, 0.5);
  EXPECT_EQ(scene.v(8).x, 0.4);
  EXPECT_NEAR(scene.v(8).z, 0, 1e-14);
}

TEST(Enforcement, TwoHeldBodiesAreLeftAlone) {
  BrickScene bricks = make_block_on_floor(0, -1);
  for (Point3& w : bricks.inverse_mass) w = {0, 0, 0};
  const Small scene(bricks, 0.01, 0.5);
  EXPECT_TRUE(scene.solved.converged);
  for (int n = 8; n < 12; ++n) EXPECT_EQ(scene.v(n).z, -1);
}

TEST(Enforcement, StickingHistoryOwesTheSlipThatTheIterationLeft) {
  Small scene(make_block_on_floor(0.4, -1), 0.01, 0.5);
  const int record = 3 * 8;
  EXPECT_EQ(scene.history.face(record), 5);
  EXPECT_NEAR(norm(load_row(scene.history.slip, record)), 0, 1e-16);
  EXPECT_NEAR(load_row(scene.history.impulse, record).z, 1, 1e-14);
}

TEST(Enforcement, MomentumIsKeptWithFrictionAndBookedWorkIsTheChangeOfKineticEnergy) {
  const BrickScene bricks = make_pile();
  const Small scene(bricks, 0.01, 0.4);
  ASSERT_GT(scene.sums.pushes, 8);
  const Gain gain = find_gain(scene, bricks);
  // Round-off of sums of some 30 numbers of size 10.
  EXPECT_LT(norm(gain.linear), 1e-13);
  EXPECT_LT(norm(gain.angular), 1e-13);
  EXPECT_NEAR(scene.sums.normal_work.round() + scene.sums.friction_work.round(), gain.kinetic, 1e-13);
  EXPECT_LT(gain.kinetic, 0);
}

/// dv of the frictionless rows by projected Gauss-Seidel on the dense matrix, run far beyond convergence.
std::vector<Point3> solve_densely(const BrickScene& bricks, const RowSystem& system, double dt) {
  const auto n = static_cast<std::size_t>(system.num_rows);
  std::vector<std::vector<Point3>> c(n, std::vector<Point3>(bricks.x.size()));
  for (std::size_t r = 0; r < n; ++r) {
    const ContactRow& row = system.rows(r);
    for (int slot = 0; slot < row_nodes; ++slot)
      c[r][static_cast<std::size_t>(system.nodes(row.place[slot]))] =
          spread_impulse(row, slot, row.normal, find_couple(row, row.normal));
  }
  std::vector<double> p(n, 0);
  std::vector<Point3> dv(bricks.x.size());
  for (int sweep = 0; sweep < 20000; ++sweep)
    for (std::size_t r = 0; r < n; ++r) {
      double u = 0, diagonal = 0;
      for (std::size_t a = 0; a < dv.size(); ++a) {
        u += dot(c[r][a], dv[a]);
        diagonal += dot(c[r][a], c[r][a]) * bricks.inverse_mass[a].x;
      }
      const ContactRow& row = system.rows(r);
      const double fresh = std::max(0.0, p[r] - ((row.gap - row.target) / dt + u) / diagonal);
      for (std::size_t a = 0; a < dv.size(); ++a) dv[a] = dv[a] + (fresh - p[r]) * bricks.inverse_mass[a].x * c[r][a];
      p[r] = fresh;
    }
  return dv;
}

TEST(Enforcement, ACoupledPileEndsAtTheExactSolutionOfItsComplementarityProblem) {
  const BrickScene bricks = make_pile();
  const double dt = 0.01;
  for (const double tolerance : {1e-3, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11}) {
    const Small scene(bricks, dt, 0, Small::no_walls(), Solver::iterated, tolerance);
    ASSERT_GE(scene.system.num_rows, 12);
    EXPECT_TRUE(scene.solved.converged);
    const std::vector<Point3> exact = solve_densely(bricks, scene.system, dt);
    double error = 0;
    for (int n = 0; n < bricks.num_nodes(); ++n)
      error = std::max(error, norm(scene.v(n) - load_row(scene.before, n) - exact[static_cast<std::size_t>(n)]));
    // Velocities of order one; the iteration ends when no row changes by more than the tolerance times the largest
    // closing velocity.
    EXPECT_LT(error, 5 * tolerance) << tolerance;
  }
}

TEST(Enforcement, BothSpacesGiveTheSameBits) {
  BrickScene bricks;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> speed(-1, 1);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 3; ++k)
        bricks.add_brick({1.0 * i, j + 0.5 * (k % 2), 1.0 * k}, {1, 1, 1},
                         {speed(random), speed(random), speed(random)});
  const Small a(bricks, 0.005, 0.3);
  const EnforcedScene<ExecSpace> b(bricks, 0.005, 0.3);
  ASSERT_GT(a.system.num_rows, 500);
  EXPECT_EQ(a.solved.iterations, b.solved.iterations);
  EXPECT_EQ(a.sums.normal_work.round(), b.sums.normal_work.round());
  EXPECT_EQ(a.sums.friction_work.round(), b.sums.friction_work.round());
  for (int n = 0; n < bricks.num_nodes(); ++n)
    for (int d = 0; d < 3; ++d) {
      ASSERT_EQ(a.scene.v(n, d), b.scene.v(n, d));
      ASSERT_EQ(a.impulse(n, d), b.impulse(n, d));
    }
}

// What a step wrote is forgotten in the next one, and what nobody knows of at once.
TEST(WriteHistory, EmptiesWhatTheStepBeforeWrote) {
  const SmallSpace space;
  const int nodes = 4, wall = 3 * nodes;  // the wall's record
  ContactHistory history = make_empty_history(nodes, 2);
  RowSystem system;
  system.rows = Array<ContactRow>("test::rows", 2);
  const auto write = [&](int record, std::int64_t face, int wall_record) {
    ContactRow &pushed = system.rows(0), &walled = system.rows(1);
    pushed = walled = ContactRow{};
    pushed.kind = RowKind::face;
    pushed.record = record;
    pushed.face = face;
    walled.record = wall_record;
    pushed.impulse.normal = walled.impulse.normal = 1;
    pushed.force = walled.force = {1, 2, 3};
    pushed.reference = walled.reference = 0.5;
    system.num_rows = 2;
    write_history(space, 1, system, history);
  };
  const auto expect_only = [&](int record, std::int64_t face, int wall_record) {
    for (int r = 0; r < 3 * nodes; ++r) EXPECT_EQ(history.face(r), r == record ? face : -1) << r;
    for (int r = wall; r < wall + 2; ++r) {
      EXPECT_EQ(history.reference(r), r == wall_record ? 0.5 : 0) << r;
      EXPECT_EQ(history.impulse(r, 2), r == wall_record ? 3 : 0) << r;
    }
  };
  history.face(11) = 8;  // as a seed of the start, which no step wrote
  write(4, 77, wall + 1);
  expect_only(4, 77, wall + 1);
  write(7, 78, wall);
  expect_only(7, 78, wall);
  history.face(1) = 9;
  history.reference(wall + 1) = 2;
  system.num_written = -1;
  write(7, 79, wall);
  expect_only(7, 79, wall);
}

}  // namespace
}  // namespace percuss::test::enforcement_test
