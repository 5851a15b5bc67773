// Damping in proportion to mass: free flight, spins and a hanging bar have closed forms.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::mass_damping_test {
namespace {

constexpr double coefficient = 50, dt = 4e-5;
constexpr int steps = 1000;

/// A body that nothing holds, in steps of dt.
std::string describe_flight(const std::string& part, const std::string& damping, const std::string& velocity) {
  return fmt::format(R"yaml(
time: {{end: {}, max_step: {}}}
parts: {{a: {{{}, material: m}}}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
initial: [{{part: a, {}}}]
{}
output: {{history: {{every: 0}}}}
)yaml",
                     steps * dt, dt, part, velocity, damping);
}
const std::string block = "box: {size: [1, 2, 3], cells: [2, 2, 2]}";
const std::string damped = fmt::format("damping: [{{coefficient: {}}}]", coefficient);

/// What is left of a velocity after n steps: half a step, then whole ones.
double find_left(double n) {
  const double half = 0.25 * coefficient * dt, whole = 0.5 * coefficient * dt;
  return n == 0 ? 1 : (1 - half) / (1 + half) * std::pow((1 - whole) / (1 + whole), n - 1);
}

void expect_decay(const Outcome& run, double speed) {
  const double mass = 6000;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double v = speed * find_left(run.history["step"][row]);
    ASSERT_NEAR(run.history["momentum_x"][row], mass * v, 1e-10 * mass * speed);
    ASSERT_NEAR(run.history["damping"][row], 0.5 * mass * (v * v - speed * speed), 1e-10 * mass * speed * speed);
  }
  EXPECT_EQ(run.history.rows(), steps + 1);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

}  // namespace

TEST(MassDamping, SlowsFreeFlightAsItsDifferenceEquation) {
  expect_decay(run_deck(describe_flight(block, damped, "velocity: [3, 0, 0]")), 3);
  EXPECT_NEAR(find_left(steps), std::exp(-coefficient * steps * dt),
              1e-2);  // rows have velocities of half a step before
  EXPECT_NEAR(find_left(steps), std::exp(-coefficient * (steps - 0.5) * dt), 1e-6);
}

TEST(MassDamping, SlowsARigidBodyLikewise) {
  expect_decay(run_deck(describe_flight(block + ", rigid: true", damped, "velocity: [3, 0, 0]")), 3);
}

TEST(MassDamping, SlowsTheSpinOfBodiesAndShells) {
  for (const std::string& part :
       {block + ", rigid: true", block, std::string("shell_plate: {size: [2, 2], cells: [4, 4]}, thickness: 0.1")}) {
    const Outcome run = run_deck(describe_flight(part, damped, "angular_velocity: [0, 0, 0.5]"));
    const double start = run.history["angular_z"][0];
    EXPECT_NEAR(run.history.last("angular_z"), start * find_left(steps), 1e-5 * start) << part;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12) << part;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-5) << part;
  }
}

// Critical damping of the lowest mode: the end sinks by rho g L^2 / (2 E), which linear elements have at their nodes.
TEST(MassDamping, BringsAHangingBarToRest) {
  const double rho = 1000, g = 10, length = 2, modulus = 1e8;
  const double frequency = 0.5 * M_PI / length * std::sqrt(modulus / rho);
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 0.3}}
parts: {{bar: {{box: {{size: [0.1, 0.1, {}], cells: [1, 1, 20]}}, material: m}}}}
materials: {{m: {{model: elastic, density: {}, youngs_modulus: {}, poissons_ratio: 0}}}}
loads: {{gravity: [0, 0, -{}]}}
conditions: [{{nodes: bar/z_max, fixed: [x, y, z]}}]
damping: [{{nodes: bar, coefficient: {}}}]
output: {{history: {{every: 0.01, nodes: [{{name: tip, near: [0, 0, 0]}}]}}}}
)yaml",
                                           length, rho, modulus, g, 2 * frequency));
  const double sag = rho * g * length * length / (2 * modulus);
  EXPECT_NEAR(-run.history.last("tip_z"), sag, 2 * sag * rho * g * length / modulus);  // strains are finite
  EXPECT_LT(run.history.last("kinetic"), 1e-12 * run.history.last("internal"));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

TEST(MassDamping, ObeysTheLastEntryThatNamesANode) {
  expect_decay(run_deck(describe_flight(
                   block, fmt::format("damping: [{{coefficient: 1e6}}, {{nodes: a, coefficient: {}}}]", coefficient),
                   "velocity: [3, 0, 0]")),
               3);
}

TEST(MassDamping, RefusesToDampAPartOfABody) {
  try {
    run_deck(
        describe_flight(block + ", rigid: true", "damping: [{nodes: a/x_min, coefficient: 1}]", "velocity: [3, 0, 0]"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("names only some nodes of rigid body 'a'"));
  }
}

}  // namespace percuss::test::mass_damping_test
