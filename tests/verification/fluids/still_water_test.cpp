// Water at rest stays at rest: lumped masses at the corners of hexahedra alone make it grow out of round-off at rates
// up to 0.74 sqrt(g / h), whatever the step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "tests/verification/fluids/tank.hpp"
#include "tests/verification/support/mapped_mesh.hpp"

namespace percuss::test::still_water_test {
namespace {

constexpr double push = 9.81e-4;  // makes a wave of 0.14 mm

/// The energy of the wave is what it was in its first free period, but for what its damping takes.
void expect_kept(const Tank& tank, double share) {
  const Outcome run = run_deck(make_tank(tank));
  const int last = static_cast<int>(tank.periods) - 1;
  const double first = find_largest(run.history, "kinetic", 1), now = find_largest(run.history, "kinetic", last);
  fmt::print("kinetic energy {:.3g} J in the second period, {:.3g} J in the last, frequency {:.4f} of the exact one\n",
             first, now, find_frequency_ratio(run.history));
  EXPECT_LT(now, 1.02 * first);
  EXPECT_GT(now, share * first);
  EXPECT_NEAR(find_frequency_ratio(run.history), 1, 0.02);  // of 10 layers: 0.4 % too low
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-6);
}

}  // namespace

TEST(StillWater, DoesNotGrowWithTheControlOfFluids) {
  Tank tank;
  tank.push = push;
  tank.periods = 6;
  expect_kept(tank, 0.95);
}

TEST(StillWater, DoesNotGrowWithMuchDampingOfHourglassModesNorWithout) {
  for (const char* more :
       {"elements: {hourglass: {kind: viscous, coefficient: 0.1}}", "elements: {integration: full}"}) {
    Tank tank;
    tank.push = push;
    tank.periods = 6;
    tank.more = more;
    expect_kept(tank, 0.8);
  }
}

TEST(StillWater, OfTwoElementsDoesNotGrow) {
  Tank tank;
  tank.shape = "box: {size: [1, 0.05, 0.5], cells: [2, 1, 1]}";
  tank.push = push;
  tank.periods = 6;
  const Outcome run = run_deck(make_tank(tank));
  EXPECT_LT(find_largest(run.history, "kinetic", 5), 1.02 * find_largest(run.history, "kinetic", 1));
}

TEST(StillWater, OfWedgesDoesNotGrow) {
  Tank tank;
  tank.shape = "box: {size: [1, 0.05, 0.5], cells: [20, 1, 10]}, elements: wedges";
  tank.push = push;
  tank.periods = 6;
  expect_kept(tank, 0.8);
}

TEST(StillWater, OfPyramidsDoesNotGrow) {
  Tank tank;
  tank.shape = "box: {size: [1, 0.05, 0.5], cells: [10, 1, 5]}, elements: pyramids";
  tank.push = push;
  tank.periods = 6;
  expect_kept(tank, 0.9);
}

/// A mesh whose inner nodes are off their lattice by up to a fifth of an element: its relaxation settles.
TEST(StillWater, OfAnIrregularMeshSettles) {
  std::uint64_t seed = 7;
  const auto next = [&] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 33) / 4294967296.0 - 0.25;
  };
  const auto mesh = make_mapped_box({20, 1, 10}, [&](const Vec3& u) {
    const double dx = 0.02 * next(), dz = 0.02 * next();
    const bool is_inside = u[0] > 0.01 && u[0] < 0.99 && u[2] > 0.01 && u[2] < 0.99;
    return Vec3{u[0] + (is_inside ? dx : 0), 0.05 * u[1], 0.5 * u[2] + (is_inside ? dz : 0)};
  });
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "irregular_tank.exo"));
  Tank tank;
  tank.shape = fmt::format("exodus: {{file: {}}}", file.path());
  tank.start = "relaxation: {}";  // one that does not settle is refused
  tank.periods = 6;
  const Outcome run = run_deck(make_tank(tank));
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  fmt::print("settled after {} steps, kinetic energy {:.3g} J\n", run.summary.relaxation.steps,
             run.history.largest("kinetic"));
  EXPECT_LT(run.history.largest("kinetic"), 1e-5);
}

/// Acceleration acts as gravity does.
TEST(StillWater, InATankThatIsPushedUpwardsStaysLevel) {
  const Outcome run = run_deck(R"(
title: a tank that is pushed upwards with 9.81 m/s2, without gravity
time: {end: 6}
parts: {w: {box: {size: [1, 0.05, 0.5], cells: [20, 1, 10]}, material: water}}
materials: {water: {model: fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 4.0e+6}}}
conditions:
  - {nodes: w/x_min, fixed: [x]}
  - {nodes: w/x_max, fixed: [x]}
  - {nodes: w/y_min, fixed: [y]}
  - {nodes: w/y_max, fixed: [y]}
  - {nodes: w/z_min, velocity: {z: {table: [[0, 0], [0.1, 0.4905], [10, 97.6095]]}}}
output: {history: {every: 0.05, nodes: [{name: low, near: [0, 0, 0]}, {name: left, near: [0, 0, 0.5]}, {name: middle, near: [0.5, 0, 0.5]}], elements: [{name: bottom, near: [0.5, 0, 0]}]}}
)");
  double lowest = 1, highest = 0, slope = 0;
  for (std::size_t row = run.history.rows() / 2; row < run.history.rows(); ++row) {
    const double height = run.history["left_z"][row] - run.history["low_z"][row];
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    slope = std::max(slope, std::abs(run.history["left_z"][row] - run.history["middle_z"][row]));
  }
  const double pressure = run.history.mean(3, 6, "bottom_pressure"), exact = 1000 * gravity * 0.475;  // rho a depth
  fmt::print(
      "surface {:.3g} m off level, {:.4g} to {:.4g} m above the bottom; pressure there {:.2f} Pa, exact {:.2f}\n",
      slope, lowest, highest, pressure, exact);
  EXPECT_NEAR(pressure, exact, 1e-3 * exact);
  EXPECT_LT(slope, 1e-6);
  EXPECT_NEAR(lowest, 0.5, 1e-3);  // sound rings in the column, which is 0.3 mm shorter
  EXPECT_NEAR(highest, 0.5, 1e-3);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

}  // namespace percuss::test::still_water_test
