// Free elastic bodies that vibrate for thousands of periods with nothing to damp them: their energy stays what it was.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::vibration_test {
namespace {

using testing::Contains;
using testing::Field;
using testing::Not;

/// perf/stability/undamped_ball.yaml, whose 0.45 J became 22 kJ when elements had no energy of their own.
const std::string ball = R"(
time: {end: 12}
parts: {ball: {sphere: {radius: 0.1, cells: 4}, material: soft}}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 4e6, poissons_ratio: 0.3}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial:
  - {part: ball, angular_velocity: [3, 2, 1]}
  - {nodes: {name: ball, inside: [[-1, -1, 0.05], [1, 1, 1]]}, velocity: [0.7, 0.4, -0.9]}
output: {history: {every: 0.02}}
)";

/// From the first tenth of a second on, when the vibration has spread over all modes, half of its energy is kinetic.
void expect_bounded(const Outcome& outcome, double energy_error) {
  const HistoryTable& history = outcome.history;
  const double initial = outcome.summary.energy.initial, end = outcome.summary.time;
  EXPECT_EQ(outcome.summary.status, "completed");
  EXPECT_LT(history.largest("kinetic"), 1.001 * initial);
  EXPECT_GT(history.smallest("internal"), -1e-3 * initial);
  EXPECT_GT(history.smallest("hourglass"), -1e-3 * initial);
  EXPECT_LT(std::abs(outcome.summary.energy.error), energy_error);
  EXPECT_LT(history.mean(0.75 * end, end, "kinetic"), 1.03 * history.mean(0.1, 0.25 * end, "kinetic"));
  EXPECT_THAT(outcome.summary.warnings, Not(Contains(Field(&Warning::rule, "element_energy"))));
}

}  // namespace

TEST(Vibration, OfABallIsBoundedWithAssumedStrain) { expect_bounded(run_deck(ball), 0.01); }

TEST(Vibration, OfABallIsBoundedWithHourglassStiffness) {
  expect_bounded(run_deck(ball, {"elements.hourglass=stiffness"}), 0.04);
}

TEST(Vibration, OfABallIsBoundedWithHourglassViscosity) {
  expect_bounded(run_deck(ball, {"elements.hourglass=viscous"}), 0.1);
}

TEST(Vibration, OfABallIsBoundedWithFullIntegration) {
  expect_bounded(run_deck(ball, {"elements.integration=full"}), 0.01);
}

TEST(Vibration, OfAnElasticRubberBallIsBounded) {
  expect_bounded(run_deck(ball, {"materials.soft.model=neo_hookean"}), 0.01);
}

TEST(Vibration, OfAnElasticRubberBallIsBoundedWithFullIntegration) {
  expect_bounded(run_deck(ball, {"materials.soft.model=neo_hookean", "elements.integration=full"}), 0.01);
}

}  // namespace percuss::test::vibration_test
