// Beams that fail by the forces of their section or at a time: one that is led, and two bodies that one holds together.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/error.hpp"
#include "tests/verification/support/deaths.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::beam_failure_test {
namespace {

constexpr double young = 100, shear = 40, radius = 0.1, speed = 0.5, pi = std::numbers::pi;
constexpr double area = pi * radius * radius, inertia = area * radius * radius / 4;

/// A round beam of length 1 along x that is clamped at its start; its end moves and turns at the given rates.
HistoryTable lead(const std::string& failure, const std::string& rates) {
  return run_deck(fmt::format(R"(
time: {{end: 100, max_steps: 90, max_step: 0.0078125}}
parts: {{bar: {{line: {{from: [0, 0, 0], to: [1, 0, 0], cells: 1}}, section: {{round: {{radius: {}}}}}, toward: y, material: m}}}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: {}, poissons_ratio: 0.25, failure: {{{}}}}}}}
conditions: [{{nodes: bar/start, fixed: [x, y, z, rx, ry, rz]}}, {{nodes: bar/end, velocity: {{{}}}}}]
output: {{history: {{elements: [{{name: e, near: [0.5, 0, 0]}}]}}}}
audit: {{max_energy_error: 10, max_momentum_error: 1}}
)",
                              radius, young, failure, rates))
      .history;
}

std::string move_end(const std::string& one) {
  std::string all;
  for (const std::string axis : {"x", "y", "z", "rx", "ry", "rz"})
    all += fmt::format("{}{}: {}", all.empty() ? "" : ", ", axis, axis == one ? speed : 0);
  return all;
}

}  // namespace

TEST(BeamFailure, OfATensionAloneIsMetInItsStep) {
  const double limit = young * area * 0.1;
  const HistoryTable pulled = lead(fmt::format("resultants: {{axial: {}}}", limit), move_end("x"));
  expect_death(pulled, [&](std::size_t row) { return std::log1p(speed * pulled["time"][row]) >= 0.1; });
  std::string pressed = move_end("x");
  pressed.replace(pressed.find("0.5"), 3, "-0.5");
  EXPECT_EQ(lead(fmt::format("resultants: {{axial: {}}}", limit), pressed).last("eroded_elements"), 0);
}

// A turn of the end is a twist, or a curvature with half of it as shear.
TEST(BeamFailure, OfATorqueAndOfMomentsIsMetInItsStep) {
  const HistoryTable twisted =
      lead(fmt::format("resultants: {{torque: {}}}", shear * 2 * inertia * 0.1), move_end("rx"));
  expect_death(twisted, [&](std::size_t row) { return speed * twisted["time"][row] >= 0.1; });
  for (const char* axis : {"y", "z"}) {
    const HistoryTable bent = lead(fmt::format("resultants: {{moment_{}: {}}}", axis, young * inertia * 0.1),
                                   move_end(std::string("r") + axis));
    expect_death(bent, [&](std::size_t row) { return speed * bent["time"][row] >= 0.1; });
  }
}

TEST(BeamFailure, OfShearsIsMetInItsStep) {
  for (const char* axis : {"y", "z"}) {
    const HistoryTable sheared =
        lead(fmt::format("resultants: {{shear_{}: {}}}", axis, 0.9 * shear * area * 0.02), move_end(axis));
    // the angle of the line of the nodes, to the square of it
    expect_death(sheared, [&](std::size_t row) { return std::atan(speed * sheared["time"][row]) >= 0.02; });
  }
}

TEST(BeamFailure, SquaresOfTheForcesAddUp) {
  std::string both = move_end("rx");
  both.replace(both.find("x: 0"), 4, "x: 0.5");
  const HistoryTable led =
      lead(fmt::format("resultants: {{axial: {}, torque: {}}}", young * area * 0.2, shear * 2 * inertia * 0.15), both);
  // the same turn is a smaller twist of a longer beam
  expect_death(led, [&](std::size_t row) {
    const double strain = std::log1p(speed * led["time"][row]);
    return std::pow(strain / 0.2, 2) + std::pow(strain / 0.15, 2) >= 1;
  });
}

TEST(BeamFailure, AtATimeIsMetInItsStep) {
  const HistoryTable led = lead("time: 0.3", move_end("x"));
  expect_death(led, [&](std::size_t row) { return led["time"][row] >= 0.3; });
}

TEST(BeamFailure, FadesInEqualParts) {
  const HistoryTable led = lead("time: 0.3, fade_steps: 8", move_end("x"));
  const std::size_t met = find_row(led, [&](std::size_t row) { return led["time"][row] >= 0.3; });
  expect_death(
      led, [&](std::size_t row) { return row == met; }, 8);
  for (std::size_t k = 0; k <= 8; ++k) {
    const double whole = young * area * std::log1p(speed * led["time"][met + k]);
    EXPECT_NEAR(led["e_axial_force"][met + k], whole * (8.0 - static_cast<double>(k)) / 8, 1e-4 * whole);
  }
  const std::size_t death = find_death(led);
  EXPECT_NEAR(led["eroded_mass"][death], area, 1e-12);
  EXPECT_GT(led["eroded_energy"][death], 0);
  EXPECT_EQ(led["internal"][death], 0);
}

// Two cubes fly apart, held by a weld: its force and the energy that it takes up to its failure slow them down.
TEST(BeamFailure, AWeldHoldsTwoBodiesUntilItFails) {
  constexpr double length = 0.2, limit = 0.02, stiff = 100 * pi * 0.01 * 0.01;
  const Outcome run = run_deck(R"(
time: {end: 1}
parts:
  left: {box: {size: [0.5, 0.5, 0.5], cells: [2, 2, 2]}, at: [-0.5, -0.25, -0.25], material: m}
  right: {box: {size: [0.5, 0.5, 0.5], cells: [2, 2, 2]}, at: [0.2, -0.25, -0.25], material: m}
  weld: {line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 1}, section: {truss: {area: 3.14159265358979e-4}}, material: w}
join: [{parts: [left, right, weld]}]
materials:
  m: {model: elastic, density: 8, youngs_modulus: 1e6, poissons_ratio: 0.25}
  w: {model: elastic, density: 1e-3, youngs_modulus: 100, poissons_ratio: 0.25, failure: {resultants: {axial: 6.28318530717959e-4}}}
initial: [{part: left, velocity: [-0.1, 0, 0]}, {part: right, velocity: [0.1, 0, 0]}]
output: {history: {every: 0, parts: all}}
)");
  // The weld is stretched to the logarithm 0.02 and takes E A L e^2 / 2 of it.
  EXPECT_EQ(run.history.last("eroded_elements"), 1);
  const double taken = stiff * length * limit * limit / 2;
  EXPECT_NEAR(run.history.last("eroded_energy"), taken, 0.05 * taken);
  EXPECT_NEAR(run.history["time"][find_death(run.history)], length * std::expm1(limit) / 0.2,
              2 * run.summary.dt.max);  // sampled by steps, and death comes one after the criterion
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(BeamFailure, IsRefusedForOtherElementsAndOtherCriteria) {
  const auto refuse = [](const std::string& shape, const std::string& failure) -> std::string {
    try {
      run_deck(
          fmt::format("time: {{end: 1e-3, max_steps: 1}}\nparts: {{bar: {{{}, material: m}}}}\nmaterials: {{m: "
                      "{{model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, failure: "
                      "{{{}}}}}}}\n",
                      shape, failure));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  };
  const std::string box = "box: {size: [1, 1, 1], cells: [1, 1, 1]}",
                    sheet = "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1",
                    line = "line: {from: [0, 0, 0], to: [1, 0, 0], cells: 1}, section: {round: {radius: 0.1}}";
  for (const std::string& shape : {box, sheet})
    EXPECT_NE(refuse(shape, "resultants: {axial: 1}").find("resultants (of beams)"), std::string::npos);
  for (const std::string& shape : {box, line})
    EXPECT_EQ(refuse(shape, "mean_thinning: 1").find("no refusal"), std::string::npos);
  EXPECT_NE(refuse(box, "thinning: 1").find("thinning (of shells)"), std::string::npos);
  EXPECT_NE(refuse(line, "pressure: 1").find("criterion of other elements"), std::string::npos);
  EXPECT_NE(refuse(line, "resultants: {}").find("names no limit"), std::string::npos);
  EXPECT_EQ(refuse(line, "resultants: {axial: 1}"), "no refusal");
}

}  // namespace percuss::test::beam_failure_test
