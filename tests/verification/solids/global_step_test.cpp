// Whole runs by steps from the largest eigenvalue of the mesh: they stay bounded, and take fewer steps.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::global_step_test {
namespace {

struct Runs {
  Summary element, global;
};

/// The deck with the steps of its elements, and with those of the mesh.
Runs run_both(const std::string& deck) {
  return {run_deck(deck).summary, run_deck(deck, {"time.step_estimate=global"}).summary};
}

void expect_gain(const Runs& runs, double gain, double energy_error) {
  EXPECT_EQ(runs.global.status, "completed");
  EXPECT_GE(runs.global.dt.estimates, 1);
  EXPECT_GT(runs.global.dt.gain, gain);
  EXPECT_LT(static_cast<double>(runs.global.steps) * gain, 1.01 * static_cast<double>(runs.element.steps));
  EXPECT_LT(std::abs(runs.global.energy.error), energy_error);
}

const std::string steel =
    "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

}  // namespace

// Without damping, so that what grows does so unhindered; a thousand periods of the shortest waves. What central
// differences conserve depends on the square of the step, so that the energy of short waves moves when the last steps
// land on the end (theory.md, section 1): 1.5 % of the step are 0.7 % of the energy of the ball, most of it in them.
TEST(GlobalStep, AVibratingBarStaysBounded) {
  expect_gain(run_both(R"(
time: {end: 2.0e-3}
parts: {bar: {box: {size: [0.2, 0.02, 0.02], cells: [20, 2, 2]}, material: steel}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{velocity: [1, 0, 0]}]
conditions: [{nodes: bar/x_min, fixed: [x, y, z]}]
)" + steel),
              1.25, 5e-4);
}

TEST(GlobalStep, ABallOfDistortedElementsStaysBounded) {
  expect_gain(run_both(R"(
time: {end: 1.5e-3}
parts: {ball: {sphere: {radius: 0.05, cells: 6}, material: steel}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}, integration: full}
initial: [{nodes: ball/surface, velocity: [1, 0, 0]}, {nodes: {name: ball/surface, inside: [[-1, -1, 0], [1, 1, 1]]}, velocity: [0, 5, 0]}]
)" + steel),
              1.4, 1e-2);
}

TEST(GlobalStep, BlocksInContactStayBounded) {
  expect_gain(run_both(R"(
time: {end: 2.5e-3}
parts:
  lower: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: steel}
  upper: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0.01, 0.005, 0.1], material: steel}
conditions: [{nodes: lower/z_min, fixed: [x, y, z]}]
loads: {pressure: [{faces: upper/z_max, value: 50e6}]}
contact: {friction: 0.3}
)" + steel),
              1.25, 1e-3);
}

// 40 % of its length are lost and elements flattened: estimates are made anew, and the step follows in between.
TEST(GlobalStep, ATaylorBarStaysBounded) {
  const Runs runs = run_both(R"(
time: {end: 60.0e-6}
parts: {bar: {cylinder: {radius: 3.2e-3, length: 32.4e-3, cells: [4, 20]}, material: copper}}
materials: {copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 400e6, hardening_modulus: 100e6}}
initial: [{velocity: [0, 0, -227]}]
conditions: [{nodes: bar/start, fixed: [z]}]
)");
  expect_gain(runs, 1.4, 1e-3);
  EXPECT_NEAR(runs.global.energy.internal() / runs.element.energy.internal(), 1, 1e-3);
}

}  // namespace percuss::test::global_step_test
