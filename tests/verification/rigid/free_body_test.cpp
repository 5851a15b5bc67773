// Rigid bodies alone: spin, fall, loads, held directions.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::free_body_test {
namespace {

const std::string materials =
    "materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

std::string describe_block(const std::string& rest, const std::string& rigid = "true") {
  return fmt::format(
      "parts: {{block: {{box: {{size: [0.3, 0.2, 0.1], cells: [6, 4, 2]}}, at: [-0.15, -0.1, -0.05], material: steel, "
      "rigid: {}}}}}\n{}{}",
      rigid, materials, rest);
}

}  // namespace

// About its middle axis, 100 turns: it turns over again and again. The momentum is state, and the energy an integral
// of the scheme: both are left with round-off, which adds up over 100 000 steps.
TEST(RigidBlock, SpinsAboutItsMiddleAxisWithoutLoss) {
  const Outcome run = run_deck(describe_block(R"yaml(
time: {end: 100, max_step: 1.0e-3}
initial: [{part: block, angular_velocity: [0.001, 6.283185307179586, 0.001]}]
output: {history: {every: 0.05}}
)yaml"));
  double lowest = 1;  // y of its middle axis
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double q1 = run.history["body_q1:block"][row], q3 = run.history["body_q3:block"][row];
    lowest = std::min(lowest, 1 - 2 * (q1 * q1 + q3 * q3));
  }
  EXPECT_LT(lowest, -0.99);  // it has turned over
  EXPECT_LT(run.history.largest("energy_error"), 1e-12);
  EXPECT_GT(run.history.smallest("energy_error"), -1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-14);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-14);
}

// Central differences with equal steps fall as the ground gives: exactly.
TEST(RigidBlock, FallsUnderGravity) {
  const Outcome run = run_deck(describe_block(R"yaml(
time: {end: 1, max_step: 1.0e-3}
loads: {gravity: [0, 0, -9.81]}
initial: [{part: block, velocity: [3, 0, 5]}]
output: {history: {every: 0.1}}
)yaml"));
  EXPECT_NEAR(run.history.last("body_z:block"), 5 - 0.5 * 9.81, 1e-12);
  EXPECT_NEAR(run.history.last("body_x:block"), 3, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// A force on the nodes of one end of a block that can only turn about z: angular acceleration T / I.
TEST(RigidBlock, TurnsAboutAFixedAxisUnderALoad) {
  const Outcome run =
      run_deck(describe_block(R"yaml(
time: {end: 1.0e-2, max_step: 1.0e-5}
loads: {pressure: [{faces: block/x_max, value: 1.0e4, direction: y}]}
output: {history: {every: 1.0e-3}}
)yaml",
                              "{fixed: [x, y, z, rx, ry], mass: 48, inertia: [0.2, 0.4, 0.5, 0, 0, 0]}"));
  const double moment = 1e4 * 0.2 * 0.1 * 0.15, rate = moment / 0.5;
  EXPECT_NEAR(run.history.last("body_wz:block"), rate * (1e-2 - 0.5e-5), 1e-5 * rate * 1e-2);  // half a step before
  EXPECT_EQ(run.history.last("body_x:block"), run.history["body_x:block"].front());
  EXPECT_EQ(run.history.last("body_wx:block"), 0);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);  // square of the angle of a step
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

TEST(RigidBlock, FollowsAPrescribedMotion) {
  const Outcome run = run_deck(describe_block(R"yaml(
time: {end: 1.0e-2, max_step: 1.0e-5}
loads: {gravity: [1, 2, 3]}
conditions:
  - {nodes: block, displacement: {x: {expression: "0.01 * (1 - cos(314.1592653589793 * t))"}}}
  - {nodes: block, velocity: {rx: {expression: "100"}, y: 2}}
output: {history: {every: 1.0e-3}}
)yaml"));
  EXPECT_NEAR(run.history.last("body_x:block"), 0.02, 1e-12);
  EXPECT_NEAR(run.history.last("body_y:block"), 0.02, 1e-12);
  EXPECT_NEAR(run.history.last("body_q0:block"), std::cos(0.5), 1e-6);  // the turn of a step is that of tan(angle / 2)
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);                  // square of the angle of a step
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// Two parts of one name are one body.
TEST(RigidBlock, OfTwoPartsMovesAsOne) {
  const Outcome run = run_deck(materials + R"yaml(
time: {end: 1.0e-2}
parts:
  left: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel, rigid: {body: both}}
  right: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [3, 0, 0], material: steel, rigid: {body: both}}
initial: [{part: all, angular_velocity: [0, 0, 10], center: [0, 0, 0]}]
output: {history: {every: 1.0e-3, nodes: [{name: n, near: [4, 1, 1]}]}}
)yaml");
  const double angle = 0.1;
  EXPECT_NEAR(run.history["body_x:both"].front(), 2, 1e-14);
  EXPECT_NEAR(run.history.last("body_x:both"), 2 - 10 * 0.5 * 1e-2, 1e-12);
  const double x = 2 * std::cos(angle) - 0.5 * std::sin(angle);  // of the node about the centre
  EXPECT_NEAR(run.history.last("n_x") - run.history.last("body_x:both"), x, 1e-6);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
}

}  // namespace percuss::test::free_body_test
