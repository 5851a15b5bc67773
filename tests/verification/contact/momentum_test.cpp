// Closed scenes with contact: nothing from outside, so momentum stays to round-off and energy to what contact books.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::momentum_test {
namespace {

const std::string materials = R"(
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
  brick: {model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}
)";

const std::string small_wall = R"(
title: small brick wall
time: {end: 8e-4}
parts:
  rod: {cylinder: {radius: 0.03, length: 0.2, cells: [3, 12]}, at: [-0.203, 0.31, 0.14], axis: [1, 0.05, 0.02], material: steel}
  bricks: {box: {size: [0.1, 0.2, 0.06], cells: [2, 4, 2]}, array: {count: [1, 3, 5], pitch: [0.1, 0.2, 0.06], stagger: 0.5}, material: brick}
initial: [{part: rod, velocity: [200, 10, 4]}]
contact: {surfaces: all, friction: 0.3}
output: {history: {every: 1e-5}}
)" + materials;

void expect_closed(const Outcome& run, double energy) {
  // Round-off of some 1e4 pushes, and the sums of some 1e3 nodes in every one of some 1e3 steps.
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), energy);
  EXPECT_GT(run.history.largest("contacts"), 0);
  for (const double error : run.history["energy_error"]) EXPECT_LT(std::abs(error), energy);
  // contact may take energy, never give it
  EXPECT_LT(run.history.largest("contact"), energy * run.history["kinetic"][0]);
  EXPECT_LE(run.history.largest("friction"), 0);
}

/// Largest depth of a node behind a face, in edges of an element, over a breaking wall.
double find_deepest(const std::string& wall) {
  Scene scene(wall);
  EXPECT_EQ(scene.contact.prepare(scene.state.x, scene.state.v), "");
  scene.stepper.start(scene.state);
  int touching = 0;
  double deepest = 0;
  while (scene.state.time < scene.deck.time.end) {
    scene.stepper.advance(scene.state);
    if (scene.state.bound.failed_element >= 0) {
      ADD_FAILURE() << "an element inverted at " << scene.state.time;
      break;
    }
    touching = std::max(touching, scene.stepper.contact_report().interactions);
    if (scene.state.step % 20 == 0) deepest = std::max(deepest, scene.contact.measure_penetration(scene.state.x));
  }
  EXPECT_GT(touching, 100);
  return deepest;
}

}  // namespace

TEST(Momentum, StaysInAWallOfLooseBricksThatARodBreaks) { expect_closed(run_deck(small_wall), 1e-2); }

TEST(Penetration, NoNodeStaysBehindAFaceWhileARodBreaksAWall) {
  // The enforcement aims at a thousandth of an edge.
  std::string wall = small_wall;
  wall.replace(wall.find("friction: 0.3"), 0, "edges: false, ");
  EXPECT_LT(find_deepest(wall), 0.01);
  // With edges, two of bricks that break apart are for a moment up to 2 % of an edge inside each other.
  EXPECT_LT(find_deepest(small_wall), 0.03);
}

TEST(Momentum, StaysInAPileOfBlocksThatFlyIntoEachOther) {
  // Edge first, corner first, face first, spinning, without friction; elastic, so energy must close to 0.1 %.
  const Outcome run = run_deck(R"(
title: blocks that meet
time: {end: 4e-3}
parts:
  a: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, material: brick}
  b: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, rotate: [{axis: [1, 0, 0], angle: 45}], at: [0.02, 0.05, 0.11], material: brick}
  c: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, rotate: [{axis: [0, 0, 1], angle: 45}, {axis: [1, 0, 0], angle: 54.7}], at: [0.05, 0.05, -0.2], material: brick}
  d: {sphere: {radius: 0.05, cells: 6}, at: [0.16, 0.05, 0.05], material: brick}
initial:
  - {part: b, velocity: [0, 0, -20]}
  - {part: c, velocity: [0, 0, 25], angular_velocity: [0, 0, 50]}
  - {part: d, velocity: [-15, 0, 3]}
contact: {surfaces: all}
output: {history: {every: 2e-5}}
)" + materials);
  expect_closed(run, 1e-3);
}

TEST(Momentum, PassesDownARowOfBallsWhereverTheRowIs) {
  // Far from the origin the same: depths and normals come from differences of coordinates.
  for (const double x : {0.0, 1000.0}) {
    const Outcome run = run_deck(fmt::format(R"(
title: row of balls at x = {}
time: {{end: 1.6e-3}}
parts:
  first: {{sphere: {{radius: 0.05, cells: 6}}, at: [{}, 0, 0], material: brick}}
  row: {{sphere: {{radius: 0.05, cells: 6}}, array: {{count: [3, 1, 1], pitch: [0.1001, 0, 0]}}, at: [{}, 0, 0], material: brick}}
initial: [{{part: first, velocity: [5, 0, 0]}}]
contact: {{surfaces: all}}
output: {{history: {{every: 1e-5, nodes: [{{name: first, near: [{}, 0, 0]}}, {{name: last, near: [{}, 0, 0]}}]}}}}
)",
                                             x, x, x + 0.1001, x, x + 0.3003) +
                                 materials);
    expect_closed(run, 1e-3);
    EXPECT_GT(run.history.mean(1.4e-3, 1.6e-3, "last_vx"), 4);
    EXPECT_LT(std::abs(run.history.mean(1.4e-3, 1.6e-3, "first_vx")), 1);
  }
}

}  // namespace percuss::test::momentum_test
