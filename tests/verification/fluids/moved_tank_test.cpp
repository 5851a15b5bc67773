// Tanks of water that accelerate, fall onto a floor, or stand.

#include <gtest/gtest.h>

#include "tests/verification/fluids/tank.hpp"

namespace percuss::test::moved_tank_test {

/// Walls that accelerate along the tank: the surface comes to the slope a / g. The acceleration rises within a period
/// of the first sloshing mode, which then has no energy.
TEST(MovedTank, ThatAcceleratesHasTheSlopeOfItsApparentGravity) {
  constexpr double acceleration = 0.2;
  const std::string velocity =
      fmt::format("{{expression: \"{0:.17g} * ((t < {1:.17g}) ? t^2 / {2:.17g} : t - {3:.17g})\"}}", acceleration,
                  sloshing_period, 2 * sloshing_period, 0.5 * sloshing_period);
  const Outcome run = run_deck(fmt::format(R"(
title: a tank of water accelerates
time: {{end: {end:.17g}}}
parts: {{w: {{box: {{size: [1, 0.05, 0.5], cells: [20, 1, 10]}}, material: water}}}}
materials: {{water: {{model: fluid, density: 1000, equation_of_state: {{kind: linear, bulk_modulus: 4.0e+6}}}}}}
conditions:
  - {{nodes: w/x_min, velocity: {{x: {velocity}}}}}
  - {{nodes: w/x_max, velocity: {{x: {velocity}}}}}
  - {{nodes: w/y_min, fixed: [y]}}
  - {{nodes: w/y_max, fixed: [y]}}
  - {{nodes: w/z_min, fixed: [z]}}
loads: {{gravity: [0, 0, -9.81]}}
start: {{hydrostatic: [{{parts: [w], surface: [0, 0, 0.5]}}]}}
output:
  history:
    every: {every:.17g}
    nodes: [{{name: left, near: [0, 0, 0.5]}}, {{name: right, near: [1, 0, 0.5]}}]
    forces: [{{name: behind, support: w/x_min}}, {{name: ahead, support: w/x_max}}]
)",
                                           fmt::arg("end", 3 * sloshing_period), fmt::arg("velocity", velocity),
                                           fmt::arg("every", sloshing_period / 100)));
  const auto mean = [&](const char* column) {
    return run.history.mean(2 * sloshing_period, 3 * sloshing_period, column);
  };
  const double slope = mean("left_z") - mean("right_z"), force = mean("fx:behind") + mean("fx:ahead");
  const double steepness = acceleration / gravity, push = 25 * acceleration;  // 25 kg
  fmt::print("surface {:.5f} m higher behind, exact {:.5f}; the walls push with {:.4f} N, exact {:.4f}\n", slope,
             steepness * tank_length, force, push);
  EXPECT_NEAR(slope, steepness * tank_length, 0.005 * steepness);
  EXPECT_NEAR(force, push, 0.001 * push);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

/// A tray with water falls freely, and onto a floor: until then the water has no pressure, and then the floor's impulse
/// is the momentum of all.
TEST(MovedTank, ThatFallsGivesItsMomentumToTheFloor) {
  constexpr double fall = 0.012;
  const double arrival = std::sqrt(2 * fall / gravity);
  const Outcome run = run_deck(fmt::format(R"(
title: a tray with water falls
time: {{end: {end:.17g}}}
parts:
  water: {{box: {{size: [0.2, 0.2, 0.15], cells: [6, 6, 5]}}, material: water}}
  tray: {{shell_box_tube: {{size: [0.204, 0.204], length: 0.2, cells: [6, 6, 6], closed: start}}, thickness: 0.004, at: [0.1, 0.1, -0.002], material: plastic}}
materials:
  water: {{model: fluid, density: 1000, equation_of_state: {{kind: linear, bulk_modulus: 4.0e+6}}}}
  plastic: {{model: elastic, density: 1200, youngs_modulus: 2e9, poissons_ratio: 0.3}}
loads: {{gravity: [0, 0, -9.81]}}
walls: [{{name: floor, point: [0, 0, {floor:.17g}], normal: z}}]
contact: {{surfaces: all}}
output: {{history: {{every: {every:.17g}, parts: all, forces: [{{name: floor, wall: floor}}]}}}}
)",
                                           fmt::arg("end", 2 * arrival), fmt::arg("floor", -0.002 - fall),
                                           fmt::arg("every", arrival / 250)));
  const HistoryTable& h = run.history;
  const double mass = h["mass:water"][0] + h["mass:tray"][0];
  double impulse = 0;
  for (std::size_t row = 1; row < h.rows(); ++row) {
    impulse += h["fz:floor"][row] * (h["time"][row] - h["time"][row - 1]);
    if (h["time"][row] > 0.99 * arrival) continue;
    const double speed = gravity * (h["time"][row] - 0.5 * h["dt"][row]);
    ASSERT_NEAR(h["momentum_z"][row], -mass * speed, 1e-9 * mass * speed) << row;
    ASSERT_LT(std::abs(h["internal"][row]), 1e-20);
  }
  const double taken = mass * gravity * (h.last("time") - 0.5 * h.last("dt")) + h.last("momentum_z");
  fmt::print("the floor gives {:.6g} N s, all has lost {:.6g}; energy error {:.2g}\n", impulse, taken,
             run.summary.energy.error);
  EXPECT_NEAR(impulse, taken, 1e-9 * taken);
  EXPECT_GT(impulse, mass * gravity * arrival);
  EXPECT_LT(h.last("kinetic"), 0.2 * 0.5 * mass * std::pow(gravity * arrival, 2));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-9);
}

/// Eight elements of real water, for long: nothing grows out of round-off.
TEST(MovedTank, ThatStandsStaysAtRestForLong) {
  const Outcome run = run_deck(R"(
title: a tank at rest
time: {end: 1e+9, max_steps: 20000}
parts: {w: {box: {size: [0.2, 0.1, 0.4], cells: [2, 1, 4]}, material: water}}
materials: {water: {model: fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 2.2e+9}}}
conditions:
  - {nodes: w/x_min, fixed: [x]}
  - {nodes: w/x_max, fixed: [x]}
  - {nodes: w/y_min, fixed: [y]}
  - {nodes: w/y_max, fixed: [y]}
  - {nodes: w/z_min, fixed: [z]}
loads: {gravity: [0, 0, -9.81]}
start: {hydrostatic: [{parts: [w], surface: [0, 0, 0.4]}]}
output: {history: {every: 1e-3}}
)");
  const double potential = 1000 * gravity * 0.2 * 0.1 * 0.4 * 0.2;
  fmt::print("kinetic energy at most {:.2g} of the potential one\n", run.history.largest("kinetic") / potential);
  EXPECT_LT(run.history.largest("kinetic"), 1e-15 * potential);
}

}  // namespace percuss::test::moved_tank_test
