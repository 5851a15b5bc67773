// Turn springs between rigid bodies: periods, decay, friction and stops against closed forms, and what is conserved.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::turn_spring_test {
namespace {

constexpr double inertia = 0.3;  // about every axis, of the body that turns

/// A fixed block and one that turns freely against it about its centre with a spin, for a time.
Outcome run_turn(const std::string& spring, const std::string& spin, double end, double step = 2e-4) {
  return run_deck(fmt::format(
      "time: {{end: {}, max_step: {}}}\n"
      "parts:\n"
      "  base: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, at: [0, 0, -3], material: steel, rigid: true}}\n"
      "  wheel: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, material: steel, rigid: {{mass: 2, inertia: [0.3, 0.3, "
      "0.3, 0, 0, 0]}}}}\n"
      "materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}\n"
      "conditions: [{{body: base, fixed: [x, y, z, rx, ry, rz]}}]\n"
      "initial: [{{part: wheel, angular_velocity: {}}}]\n"
      "turn_springs: {{s: {}}}\n"
      "output: {{history: {{every: 0}}}}\n",
      end, step, spin, spring));
}

/// Times at which a column falls through a value.
std::vector<double> find_falls(const HistoryTable& history, const std::string& name, double through) {
  const auto &y = history[name], &t = history["time"];
  std::vector<double> times;
  for (std::size_t row = 1; row < y.size(); ++row)
    if (y[row - 1] > through && y[row] <= through)
      times.push_back(t[row] - (t[row] - t[row - 1]) * (through - y[row]) / (y[row - 1] - y[row]));
  return times;
}

double find_largest_error(const Outcome& run) {
  return std::max(run.history.largest("energy_error"), -run.history.smallest("energy_error"));
}

}  // namespace

// q'' = -k / I q about each axis: T = 2 pi sqrt(I / k).
TEST(TorsionPendulum, SwingsWithTheExactPeriodAboutEachAxis) {
  const double stiffness = 50, omega = std::sqrt(stiffness / inertia), period = 2 * std::numbers::pi / omega;
  const std::vector<std::string> axes{"x", "y", "z"}, spins{"[2, 0, 0]", "[0, 2, 0]", "[0, 0, 2]"};
  for (std::size_t k = 0; k < 3; ++k) {
    const Outcome run = run_turn(fmt::format("{{bodies: [base, wheel], {}: {{stiffness: {}}}}}", axes[k], stiffness),
                                 spins[k], 10.6 * period);
    const std::vector<double> falls = find_falls(run.history, "turn_angle_" + axes[k] + ":s", 0);
    ASSERT_GE(falls.size(), 10U);
    EXPECT_NEAR((falls.back() - falls.front()) / static_cast<double>(falls.size() - 1), period, 1e-5 * period);
    EXPECT_NEAR(run.history.largest("turn_angle_" + axes[k] + ":s"), 2 / omega, 1e-4 * 2 / omega);
    EXPECT_LT(find_largest_error(run), 1e-4);
  }
}

// Two free bodies: the reduced inertia I_a I_b / (I_a + I_b), and their angular momentum stays.
TEST(TorsionPendulum, TurnsTwoFreeBodiesAgainstEachOther) {
  const double stiffness = 50, reduced = 0.3 * 0.1 / 0.4,
               period = 2 * std::numbers::pi * std::sqrt(reduced / stiffness);
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 1.0e-4}}\n"
      "parts:\n"
      "  base: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, at: [0, 0, -3], material: steel, rigid: {{mass: 1, "
      "inertia: [0.1, 0.1, 0.1, 0, 0, 0]}}}}\n"
      "  wheel: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, material: steel, rigid: {{mass: 2, inertia: [0.3, 0.3, "
      "0.3, 0, 0, 0]}}}}\n"
      "materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}\n"
      "initial: [{{part: wheel, angular_velocity: [1, 2, -1]}}]\n"
      "turn_springs: {{s: {{bodies: [base, wheel], axes: [[1, 2, -1], [1, 0, 0]], x: {{stiffness: {}}}}}}}\n"
      "output: {{history: {{every: 0}}}}\n",
      8.6 * period, stiffness));
  const std::vector<double> falls = find_falls(run.history, "turn_angle_x:s", 0);
  ASSERT_GE(falls.size(), 8U);
  EXPECT_NEAR((falls.back() - falls.front()) / static_cast<double>(falls.size() - 1), period, 1e-4 * period);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(find_largest_error(run), 1e-4);
}

// q'' + c / I q' + k / I q = 0: the logarithmic decrement is c T / (2 I).
TEST(TorsionPendulum, DecaysWithItsDamper) {
  const double stiffness = 50, damping = 0.4, rate = damping / (2 * inertia);
  const double omega = std::sqrt(stiffness / inertia - rate * rate), period = 2 * std::numbers::pi / omega;
  for (const std::string damper : {"damping: 0.4", "damping_table: [[-1, -0.4], [1, 0.4]]"}) {
    const Outcome run =
        run_turn("{bodies: [base, wheel], z: {stiffness: 50, " + damper + "}}", "[0, 0, 2]", 4.3 * period, 1e-4);
    std::vector<double> peaks;
    const auto& q = run.history["turn_angle_z:s"];
    for (std::size_t row = 1; row + 1 < q.size(); ++row)
      if (q[row] > q[row - 1] && q[row] >= q[row + 1]) peaks.push_back(q[row]);
    ASSERT_GE(peaks.size(), 4U);
    EXPECT_NEAR(std::log(peaks[0] / peaks[3]), 3 * rate * period, 1e-3 * 3 * rate * period);
    EXPECT_LT(find_largest_error(run), 1e-3);
    EXPECT_NEAR(run.history["turn_loss"].back(),
                0.5 * inertia * 4 - run.history["turn_work"].back() - run.history["body_kinetic:wheel"].back(), 1e-3);
  }
}

// A table that stiffens: the largest angle where its energy is that of the start.
TEST(TurnSpring, FollowsItsTable) {
  const Outcome run = run_turn("{bodies: [base, wheel], y: {table: [[-0.1, -2], [0, 0], [0.1, 2], [0.2, 12]]}}",
                               "[0, 1, 0]", 0.6, 1e-4);
  // 0.1 + 2 a + 50 a^2 = 0.15 beyond 0.1
  const double beyond = (-2 + std::sqrt(4 + 4 * 50 * 0.05)) / 100;
  EXPECT_NEAR(run.history.largest("turn_angle_y:s"), 0.1 + beyond, 1e-4);
  EXPECT_NEAR(run.history.largest("turn_work"), 0.15, 1e-4);
}

// Friction of 1.5 takes the energy 0.5 I w^2 = 0.6 over an angle of 0.4, but for what it stores as it sticks.
TEST(TurnSpring, StopsByFriction) {
  for (const std::string friction : {"friction: 1.5", "friction_table: [[-1, 1.5], [1, 1.5]]"}) {
    const Outcome run =
        run_turn("{bodies: [base, wheel], x: {" + friction + ", hold_stiffness: 3000}}", "[2, 0, 0]", 0.6, 5e-5);
    EXPECT_NEAR(run.history.largest("turn_angle_x:s"), 0.6 / 1.5 + 0.5 * 1.5 / 3000, 2e-4);
    EXPECT_NEAR(run.history["turn_angle_x:s"].back(), 0.4, 2e-3);
    EXPECT_LT(find_largest_error(run), 1e-3);
  }
}

// Free to the stop, which is a spring of 4000: 0.5 k a^2 = 0.6, and back with the same speed to the other stop.
TEST(TurnSpring, TurnsBackAtItsStops) {
  const Outcome run =
      run_turn("{bodies: [base, wheel], x: {least: -0.2, most: 0.3, hold_stiffness: 4000}}", "[2, 0, 0]", 0.6, 5e-5);
  const double way = std::sqrt(2 * 0.6 / 4000);
  EXPECT_NEAR(run.history.largest("turn_angle_x:s"), 0.3 + way, 1e-4);
  EXPECT_NEAR(run.history.smallest("turn_angle_x:s"), -0.2 - way, 1e-4);
  const std::vector<double> hits = find_falls(run.history, "turn_angle_x:s", 0);
  ASSERT_GE(hits.size(), 1U);
  EXPECT_NEAR(hits[0], 0.6 / 2 + std::numbers::pi / std::sqrt(4000 / inertia), 2e-4);
  EXPECT_LT(find_largest_error(run), 1e-3);
}

// Without a law on the way the angle about one axis continues beyond whole turns, and about y beyond a right angle.
TEST(TurnSpring, FollowsWholeTurns) {
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string spin = axis == 'x' ? "[20, 0, 0]" : axis == 'y' ? "[0, 20, 0]" : "[0, 0, 20]";
    const Outcome run =
        run_turn(fmt::format("{{bodies: [base, wheel], {}: {{damping: 1.0e-9}}}}", axis), spin, 1, 1e-3);
    EXPECT_NEAR(run.history[fmt::format("turn_angle_{}:s", axis)].back(), 20, 1e-2);
  }
}

// Angles about all three axes at once: springs store what they take from the motion.
TEST(TurnSpring, KeepsTheEnergyOfLargeTurnsAboutAllAxes) {
  const Outcome run = run_turn(
      "{bodies: [base, wheel], x: {stiffness: 30}, y: {stiffness: 20}, z: {stiffness: 45, least: -0.3, most: 0.2, "
      "hold_stiffness: 500}}",
      "[4, 3, -5]", 2, 1e-4);
  EXPECT_GT(run.history.largest("turn_angle_y:s"), 0.3);
  EXPECT_LT(find_largest_error(run), 1e-4);
}

// The axes of the second body stand a quarter radian off: the spring is stretched from the start.
TEST(TurnSpring, BeginsWithTheAngleBetweenItsAxes) {
  const double angle = 0.25;
  const Outcome run = run_turn(fmt::format("{{bodies: [base, wheel], second_axes: [[{0}, {1}, 0], [{2}, {0}, 0]], z: "
                                           "{{stiffness: 50}}}}",
                                           std::cos(angle), std::sin(angle), -std::sin(angle)),
                               "[0, 0, 0]", 0.1);
  EXPECT_NEAR(run.history["turn_angle_z:s"].front(), angle, 1e-12);
  EXPECT_NEAR(run.history["turn_work"].front(), 0.5 * 50 * angle * angle, 1e-12);
  EXPECT_NEAR(run.history["turn_angle_z:s"].back(), angle * std::cos(0.1 * std::sqrt(50 / inertia)), 1e-4);
}

}  // namespace percuss::test::turn_spring_test
