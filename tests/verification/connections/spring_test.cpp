// Springs and dampers between rigid bodies: central differences have closed forms, which the runs must follow to
// round-off.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::spring_test {
namespace {

constexpr double mass = 2, stiffness = 800, dt = 1e-3;  // omega = 20: omega dt = 0.02
const double omega = std::sqrt(stiffness / mass);

/// Two blocks of mass 2, each with a node at its centre, 1 apart along x; the first is held.
std::string describe_blocks(const std::string& spring, const std::string& rest, const std::string& first = "") {
  return fmt::format(R"yaml(
parts:
  a: {{box: {{size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}}, at: [-0.1, -0.1, -0.1], material: m, rigid: {{mass: 2{}}}}}
  b: {{box: {{size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}}, at: [0.9, -0.1, -0.1], material: m, rigid: {{mass: 2}}}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}}}
springs:
  s: {{between: [{{near: [0, 0, 0], part: a}}, {{near: [1, 0, 0], part: b}}], {}}}
{})yaml",
                     first, spring, rest);
}
const std::string held = ", fixed: [x, y, z, rx, ry, rz]";

std::string end_at(double end) {
  return fmt::format("time: {{end: {}, max_step: {}}}\noutput: {{history: {{every: 0}}}}\n", end, dt);
}

/// The row at which as many steps have been made.
double step_of(const HistoryTable& history, std::size_t row) { return history["step"][row]; }

}  // namespace

// x(n) = A sin(n W dt) with sin(W dt / 2) = omega dt / 2 and x(1) = v0 dt.
TEST(Spring, SwingsAMassAsCentralDifferencesDo) {
  const Outcome run = run_deck(describe_blocks(fmt::format("stiffness: {}", stiffness),
                                               end_at(1) + "initial: [{part: b, velocity: [3, 0, 0]}]\n", held));
  const double phase = 2 * std::asin(0.5 * omega * dt), amplitude = 3 * dt / std::sin(phase);
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double x = amplitude * std::sin(step_of(run.history, row) * phase);
    ASSERT_NEAR(run.history["spring_elongation:s"][row], x, 1e-11 * amplitude);
    ASSERT_NEAR(run.history["spring_force:s"][row], stiffness * x, 1e-11 * stiffness * amplitude);
    ASSERT_NEAR(run.history["internal"][row], 0.5 * stiffness * x * x, 1e-10);
  }
  EXPECT_NEAR(amplitude, 3 / omega, 1e-4 * amplitude);  // (omega dt)^2 / 8 from the exact one
  EXPECT_EQ(run.history.rows(), 1001);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// The damper sees the velocity half a step before: x(n) = B r^n sin(n q), r^2 = 1 - c dt / m.
TEST(Spring, DampedDecaysAsItsDifferenceEquation) {
  const double damping = 8, b = damping * dt / mass, a = omega * omega * dt * dt;  // 10 % of the critical damping
  const Outcome run = run_deck(describe_blocks(fmt::format("stiffness: {}, damping: {}", stiffness, damping),
                                               end_at(1) + "initial: [{part: b, velocity: [3, 0, 0]}]\n", held));
  const double r = std::sqrt(1 - b), q = std::acos((2 - a - b) / (2 * r));
  const double first = dt * 3 * (1 - 0.5 * b), scale = first / (r * std::sin(q));
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double n = step_of(run.history, row);
    ASSERT_NEAR(run.history["spring_elongation:s"][row], scale * std::pow(r, n) * std::sin(n * q), 1e-11 * scale);
  }
  EXPECT_NEAR(std::pow(r, 1000), std::exp(-0.5 * damping / mass), 2e-3);  // after one second, b / 4 in the exponent
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_NEAR(run.history.last("damper_work") + run.history.last("internal") + run.history.last("kinetic"), 9, 1e-2);
  EXPECT_EQ(run.history.last("viscous"), run.history.last("damper_work"));
}

// Two free masses that swing and turn about each other: what a force along the line between them leaves as it is.
TEST(Spring, KeepsMomentumOfTwoFreeMasses) {
  const Outcome run = run_deck(
      describe_blocks(fmt::format("stiffness: {}, damping: 1", stiffness),
                      end_at(1) + "initial: [{part: b, velocity: [3, 5, -2]}, {part: a, velocity: [1, 0, 4]}]\n"));
  EXPECT_LT(run.summary.momentum.linear_error, 1e-14);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);  // square of the angle of a step
  EXPECT_GT(run.history.largest("spring_elongation:s"), 0.1);
}

// One that acts in tension alone lets its mass go as it comes back, with the energy that it had.
TEST(Spring, OfTensionAloneLetsGo) {
  const Outcome run = run_deck(describe_blocks(fmt::format("stiffness: {}, acts: tension", stiffness),
                                               end_at(0.4) + "initial: [{part: b, velocity: [3, 0, 0]}]\n", held));
  EXPECT_EQ(run.history.smallest("spring_force:s"), 0);
  EXPECT_LT(run.history.last("spring_elongation:s"), 0);
  EXPECT_EQ(run.history.last("spring_force:s"), 0);
  EXPECT_NEAR(run.history.last("body_vx:b"), -3, 3 * 0.5 * omega * dt * omega * dt);  // of the step that lets go
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

// A table with a kink; the energy is the area below it, straight on beyond its last row.
TEST(Spring, FollowsItsTable) {
  const Outcome run = run_deck(describe_blocks("table: [[-1, -1000], [0, 0], [0.05, 100], [0.1, 120]]",
                                               end_at(0.2) + "initial: [{part: b, velocity: [6, 0, 0]}]\n", held));
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double e = run.history["spring_elongation:s"][row];
    const double force = e < 0 ? 1000 * e : e < 0.05 ? 2000 * e : 100 + 400 * (e - 0.05);
    ASSERT_NEAR(run.history["spring_force:s"][row], force, 1e-10);
  }
  EXPECT_GT(run.history.largest("spring_elongation:s"), 0.15);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

// At 60 the spring breaks, in the step in which its force would pass that: what it held is gone, and booked.
TEST(Spring, BreaksAtAForce) {
  const Outcome run = run_deck(describe_blocks(fmt::format("stiffness: {}, failure: {{force: 60}}", stiffness),
                                               end_at(0.2) + "initial: [{part: b, velocity: [3, 0, 0]}]\n", held));
  const double largest = run.history.largest("spring_force:s");
  EXPECT_LE(largest, 60);
  EXPECT_GT(largest, 60 - stiffness * 3 * dt);
  EXPECT_EQ(run.history.last("spring_force:s"), 0);
  EXPECT_NEAR(run.history.last("spring_work"), 0.5 * 60 * 60 / stiffness, 60 * 3 * dt);
  EXPECT_NEAR(run.history.last("kinetic") + run.history.last("spring_work"), 9, 1e-10);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
}

// One that begins shorter than at rest holds energy from the start.
TEST(Spring, BeginsWithTheEnergyOfItsRestLength) {
  const Outcome run = run_deck(
      describe_blocks(fmt::format("stiffness: {}, rest_length: 1.1, acts: compression", stiffness), end_at(0.2)));
  EXPECT_NEAR(run.history["spring_work"].front(), 0.5 * stiffness * 0.01, 1e-12);
  EXPECT_NEAR(run.history.last("kinetic"), 4, 1e-2);  // all of it, less what the step of the release keeps
  EXPECT_EQ(run.history.last("spring_force:s"), 0);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-14);
}

// Elements break up, and their nodes go with the springs on them: in the midst of a step's work, which must not be
// booked in half. (With half of it the energy would be 1 % off.)
TEST(Spring, ThatLosesANodeKeepsTheBalance) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-4}
parts:
  low: {box: {size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}, material: steel}
  high: {box: {size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}, at: [0, 0, 0.08], material: weak}
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  weak: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9, failure: {plastic_strain: 0.01}}
springs: {pillars: {between: [low/z_max, high/z_min], stiffness: 2e8, damping: 2e3, acts: compression}}
erosion: {free_nodes: remove}
initial: [{part: high, velocity: [3, -2, -150]}]
conditions: [{nodes: low/z_min, fixed: [x, y, z]}]
output: {history: {every: 0}}
)yaml");
  EXPECT_GT(run.history.last("vanished_mass"), 0.1);
  EXPECT_LT(std::abs(run.summary.energy.error), 3e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
}

}  // namespace percuss::test::spring_test
