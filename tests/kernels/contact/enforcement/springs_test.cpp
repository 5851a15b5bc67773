// Penalty rows: Hooke's law with both sides in series, Coulomb's limit, momentum, the bound of their frequency.

#include "kernels/contact/enforcement/springs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kernels/contact/enforcement/enforced_scene.hpp"

namespace percuss::test::springs_test {
namespace {

using Scene = EnforcedScene<SmallSpace>;

constexpr double dt = 0.01;

/// Stiffness 1 at every node, scale 2: two sides in series are a spring of stiffness 1.
Scene push(const BrickScene& bricks, double friction) {
  return Scene(bricks, dt, friction, Scene::no_walls(), Solver::springs);
}

/// A brick on a held floor, `depth` inside it.
BrickScene make_sunk_block(double depth, const Point3& velocity) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 1});
  for (Point3& w : scene.inverse_mass) w = {0, 0, 0};
  scene.add_brick({1.25, 1.5, 1 - depth}, {1, 1, 1}, velocity);
  return scene;
}

TEST(Springs, PushByStiffnessTimesPenetration) {
  const Scene scene = push(make_sunk_block(0.01, {}), 0);
  for (int n = 8; n < 12; ++n) {
    EXPECT_NEAR(scene.p(n).z, 0.01 * dt, 1e-15);
    EXPECT_NEAR(scene.v(n).z, 0.01 * dt, 1e-15);
  }
  // k d(n) d(n+1) / 2 of four springs.
  EXPECT_NEAR(scene.sums.stored.round(), 4 * 0.5 * 0.01 * (0.01 - 0.01 * dt * dt), 1e-15);
}

TEST(Springs, StopWhatWouldGoDeeperThanTheirCushion) {
  // Unit masses on a held floor: D = 1, h = 1. At -20 they would end 0.2 deep; 0.05 is left, at -5.
  const Scene fast = push(make_sunk_block(0, {0, 0, -20}), 0);
  for (int n = 8; n < 12; ++n) {
    EXPECT_NEAR(fast.v(n).z, -contact_limits::spring_cushion / dt, 1e-12);
    EXPECT_NEAR(fast.p(n).z, (0.2 - contact_limits::spring_cushion) / dt, 1e-12);
  }
  const Scene slow = push(make_sunk_block(0, {0, 0, -4}), 0);
  for (int n = 8; n < 12; ++n) EXPECT_EQ(slow.v(n).z, -4);
}

/// A brick whose lower nodes are `depth` in a wall.
Scene press_on_wall(double depth, double velocity, const SceneStep& step = dt) {
  BrickScene bricks;
  bricks.add_brick({0, 0, -depth}, {1, 1, 1}, {0, 0, velocity});
  return Scene(bricks, step, 0,
               {to_array(std::vector<ContactWall>{{{0, 0, 0}, {0, 0, 1}}}), to_array(std::vector<int>{0, 0, 0, 0}),
                to_array(std::vector<int>{0, 1, 2, 3}), to_array(std::vector<double>{1, 1, 1, 1})},
               Solver::springs);
}

// As where the element behind a face has been crushed: 1e-3 of the size a step, if the springs do not give more.
TEST(Springs, BringWhatIsDeeperThanTheirCushionBackSlowly) {
  const Scene resting = press_on_wall(0.06, 0), sinking = press_on_wall(0.06, -3);
  for (int n = 0; n < 4; ++n) {
    EXPECT_NEAR(resting.v(n).z, 1e-3 / dt, 1e-12);
    EXPECT_NEAR(sinking.v(n).z, 1e-3 / dt, 1e-12);
  }
  const Scene within = press_on_wall(0.0195, 0), leaving = press_on_wall(0.06, 1);
  for (int n = 0; n < 4; ++n) {
    EXPECT_NEAR(within.v(n).z, 2 * 0.0195 * dt, 1e-12);
    EXPECT_NEAR(leaving.v(n).z, 1 + 2 * 0.06 * dt, 1e-12);
  }
}

// Unit masses on springs of stiffness 2, so that the square of frequency times step is 1 / 2 and more.
// What Hooke's law leaves of k d(n) d(n+1) / 2 where the step changes is known: the next step takes it.
TEST(Springs, TakeFromTheSidesWhatTheyHoldWhereTheStepChanges) {
  constexpr double depth = 0.02, now = 0.5;
  for (const double before : {0.4, 0.5, 0.6}) {
    for (const double inward : {0.03, 0.01, -0.002, -0.01}) {
      const Scene scene = press_on_wall(depth, -inward, {before, now});
      const double out = scene.v(0).z, last = depth - before * inward, after = depth - now * out;
      const double held = 0.5 * 2 * depth * last, holds = 0.5 * 2 * depth * after;
      const double given = 0.5 * (out * out - inward * inward), stored = scene.sums.stored.round() / 4;
      ASSERT_GT(after, 0);
      EXPECT_NEAR(held, given + stored, 1e-17) << before << " " << inward;
      EXPECT_NEAR(stored - holds, 0.25 * 2 * depth * (now - before) * (out + inward), 1e-17) << before << " " << inward;
    }
  }
}

TEST(Springs, GiveBackAllThatTheyHoldAsTheyEnd) {
  for (const double before : {0.3, 0.5, 0.7}) {
    const double outward = 0.09, held = 0.5 * 2 * 0.02 * (0.02 + before * outward);
    const Scene scene = press_on_wall(0.02, outward, {before, 0.5});
    EXPECT_NEAR(0.5 * (std::pow(scene.v(0).z, 2) - outward * outward), held, 1e-17);
    EXPECT_EQ(scene.sums.stored.round(), 0);
  }
}

TEST(Springs, DoNotPullNorPushAcrossAGap) {
  const Scene apart = push(make_sunk_block(-0.005, {0, 0, -0.1}), 0.3);
  for (int n = 8; n < 12; ++n) EXPECT_EQ(apart.v(n).z, -0.1);
  EXPECT_EQ(apart.sums.pushes, 0);
}

TEST(Springs, VoteForAStepThatDoesNotDependOnGapOrVelocity) {
  const Scene deep = push(make_sunk_block(0.01, {0, 0, -0.3}), 0), touching = push(make_sunk_block(0, {}), 0);
  EXPECT_TRUE(std::isfinite(deep.sums.rate));
  EXPECT_GT(touching.sums.rate, 0);
  EXPECT_NEAR(touching.sums.rate, deep.sums.rate, 1e-12);
  // One spring of stiffness 1 on a unit mass, its other end held: the square of the frequency is 1.
  EXPECT_NEAR(deep.sums.rate, 1, 1e-12);
}

TEST(Springs, OfALinearPairAreBoundedByTheirVote) {
  // Two unit masses with rows from both sides: k = 2, reduced mass 1 / 2, w^2 = 4; the vote may be larger, not less.
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1});
  bricks.add_brick({0, 0, 0.99}, {1, 1, 1});
  const Scene scene = push(bricks, 0);
  EXPECT_GE(scene.sums.rate, 4 - 1e-12);
  EXPECT_LE(scene.sums.rate, 8);
}

TEST(Springs, RubWithinCoulombsLimit) {
  // One step of slip from nothing gives no friction yet: it is the displacement at n that stretches the spring.
  const Scene first = push(make_sunk_block(0.01, {1, 0, 0}), 0.5);
  for (int n = 8; n < 12; ++n) {
    EXPECT_EQ(first.v(n).x, 1);
    EXPECT_NEAR(load_row(first.history.slip, 3 * n).x, dt, 1e-15);
  }
}

/// A brick of unit masses that sticks to a wall, on springs of friction of stiffness 2 that are stretched along x.
Scene rub_on_wall(double stretch, double speed, const SceneStep& step) {
  BrickScene bricks;
  bricks.add_brick({0, 0, -0.02}, {1, 1, 1}, {speed, 0, 0});
  return Scene(bricks, step, 100,
               {to_array(std::vector<ContactWall>{{{0, 0, 0}, {0, 0, 1}, 100}}), to_array(std::vector<int>{0, 0, 0, 0}),
                to_array(std::vector<int>{0, 1, 2, 3}), to_array(std::vector<double>{1, 1, 1, 1})},
               Solver::springs, 1e-3, {stretch, 0, 0});
}

// The square of frequency times step is 1 / 2. They hold k s(n) s(n+1) / 2 or, where the stretch changes sign, nothing.
TEST(Springs, OfFrictionGiveBackNoMoreThanTheyHold) {
  constexpr double step = 0.5, stiffness = 2;
  for (const double stretch : {0.02, 0.001}) {
    for (const double speed : {0.05, 0.003, -0.001, -0.03, -0.05, -0.2}) {
      const Scene scene = rub_on_wall(stretch, speed, step);
      const double last = stretch - step * speed, out = scene.v(0).x, after = stretch + step * out;
      const double held = std::max(0.5 * stiffness * last * stretch, 0.0),
                   holds = std::max(0.5 * stiffness * stretch * after, 0.0);
      EXPECT_NEAR(0.5 * (out * out - speed * speed), held - holds, 1e-17) << stretch << " " << speed;
      EXPECT_NEAR(scene.sums.stored_slip.round() / 4, holds, 1e-17) << stretch << " " << speed;
      EXPECT_NEAR(load_row(scene.history.slip, static_cast<int>(scene.history.face.extent(0))).x, after, 1e-15);
    }
  }
}

// In its first step, after a change of step too, a spring takes what it then stores.
TEST(Springs, OfFrictionTakeWhatTheyStoreInTheirFirstStep) {
  for (const double before : {0.4, 0.5, 0.6}) {
    const double speed = 0.04, stretch = before * speed;
    const Scene scene = rub_on_wall(stretch, speed, {before, 0.5});
    const double out = scene.v(0).x;
    EXPECT_NEAR(0.5 * (speed * speed - out * out), 0.5 * 2 * stretch * (stretch + 0.5 * out), 1e-17) << before;
  }
}

// Rest is an equilibrium of Hooke's law: nothing else acts on what is hardly stretched, nor before the first step.
TEST(Springs, OfFrictionFollowHookesLawAtRest) {
  constexpr double stretch = 1e-8;
  for (const double speed : {1e-7, 1e-9, 0.0, -1e-9, -1e-7})
    EXPECT_NEAR(rub_on_wall(stretch, speed, 0.5).v(0).x, speed - 2 * stretch * 0.5, 1e-22) << speed;
  EXPECT_NEAR(rub_on_wall(0.02, 0, {0, 0.5}).v(0).x, -2 * 0.02 * 0.25, 1e-16);
}

TEST(Springs, KeepMomentum) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {3, 3, 1}, {0.1, 0, 0.2}, 5);
  bricks.add_brick({0.3, 0.2, 0.99}, {1.2, 1.1, 1}, {0, 0.1, -0.5}, 1);
  bricks.add_brick({1.6, 0.4, 0.995}, {1, 1.3, 1}, {-0.2, 0, -0.7}, 2);
  const Scene scene = push(bricks, 0.4);
  ASSERT_GE(scene.sums.pushes, 8);
  const Gain gain = find_gain(scene, bricks);
  EXPECT_LT(norm(gain.linear), 1e-15);
  EXPECT_LT(norm(gain.angular), 1e-15);
  EXPECT_NEAR(scene.sums.normal_work.round() + scene.sums.friction_work.round(), gain.kinetic, 1e-15);
}

}  // namespace
}  // namespace percuss::test::springs_test
