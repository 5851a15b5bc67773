// Failure and erosion against exact answers: each criterion on one element, the place of a spall, particles, books.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/deaths.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::erosion_test {
namespace {

constexpr double speed = 1;  // of the face that is pulled; the cube has an edge of 1

/// A cube that is pulled in uniaxial strain, steps of 1/128 all along.
HistoryTable pull_cube(const std::string& model, const std::string& failure, const std::string& more = "") {
  return run_deck(fmt::format(R"(
title: a cube is pulled
time: {{end: 100, max_steps: 100, max_step: 0.0078125}}
parts: {{cube: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, material: m}}}}
materials: {{m: {{density: 1, youngs_modulus: 100, poissons_ratio: 0.25, {}{}}}}}
conditions:
  - {{nodes: cube, fixed: [y, z]}}
  - {{nodes: cube/x_min, fixed: [x]}}
  - {{nodes: cube/x_max, velocity: {{x: {}}}}}
output: {{history: {{elements: [{{name: e, near: [0.5, 0.5, 0.5]}}], nodes: [{{name: n, near: [1, 0, 0]}}]}}}}
audit: {{max_energy_error: 10}}
{}
)",
                              model, failure.empty() ? "" : ", failure: {" + failure + "}", speed, more))
      .history;
}

const std::string elastic = "model: elastic";
const std::string plastic = "model: j2_plasticity, yield_stress: 5, hardening_modulus: 2";

// A rod punches a hole into a plate: contact of faces and edges, friction, gravity, pressure, fading.
const std::string punch = R"(
title: a rod punches a plate
time: {end: 1}
parts:
  rod: {box: {size: [0.008, 0.008, 0.03], cells: [2, 2, 8]}, at: [-0.004, -0.0035, 0.0065], material: steel}
  plate: {box: {size: [0.04, 0.04, 0.006], cells: [10, 10, 2]}, at: [-0.02, -0.02, 0], material: soft}
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 2e9}
  soft: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e8, failure: {plastic_strain: 0.3, yield_time: 2e-5, inverted: true, fade_steps: 3}}
initial: [{part: rod, velocity: [30, 0, -600]}]
loads: {gravity: [0, 0, -1e6], pressure: [{faces: plate/z_min, value: 1e7}]}
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 0}, checkpoint: {every: 1}}
audit: {max_energy_error: 10}
)";

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

Summary run(const std::string& deck, const std::string& folder, int steps, const std::string& restart = "") {
  RunOptions options;
  options.out_dir = folder;
  options.restart = restart;
  options.goes_on_in_place = !restart.empty();
  return run_scene(parse_deck(deck, "deck.yaml", {"time.max_steps=" + std::to_string(steps)}), options).summary;
}

}  // namespace

TEST(Failure, StrainsAreScaledByTheSizeOfTheElement) {
  // Boxes of edge 1 and 2 and shells of edge 3 that are pulled at the same strain rate: ln(1 + t / 10) is the principal
  // strain; the factors are 1, 0.75 (half way) and 0.5.
  const HistoryTable h = run_deck(R"(
title: elements of three sizes
time: {end: 4, max_step: 0.0078125}
parts:
  a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}
  b: {box: {size: [2, 2, 2], cells: [1, 1, 1]}, at: [0, 5, 0], material: m}
  c: {shell_plate: {size: [3, 3], cells: [1, 1]}, thickness: 0.1, at: [0, 10, 0], material: m}
materials: {m: {model: elastic, density: 1e-4, youngs_modulus: 100, poissons_ratio: 0, failure: {principal_strain: 0.2, size: [[1, 1], [3, 0.5]]}}}
conditions:
  - {nodes: all, fixed: [y, z]}
  - {nodes: {inside: [[0, 0, 0], [0, 20, 2]]}, fixed: [x]}
  - {nodes: a/x_max, velocity: {x: 0.1}}
  - {nodes: b/x_max, velocity: {x: 0.2}}
  - {nodes: c/x_max, velocity: {x: 0.3}}
output: {history: {every: 0.0078125, parts: all}}
audit: {max_energy_error: 10}
)")
                             .history;
  double count = 0;
  for (const double factor : {0.5, 0.75, 1.0}) {  // the largest fails first
    EXPECT_NEAR(h.time_of_rise("eroded_elements", count + 0.5), 10 * (std::exp(0.2 * factor) - 1), 0.03) << factor;
    ++count;
  }
}

TEST(Failure, PrincipalStrainIsMetInItsStep) {
  const HistoryTable history = pull_cube(elastic, "principal_strain: 0.2");
  expect_death(history, [&](std::size_t row) { return std::log1p(speed * history["time"][row]) >= 0.2; });
}

TEST(Failure, PrincipalStressIsMetInItsStep) {
  const HistoryTable history = pull_cube(elastic, "principal_stress: 20");
  expect_death(history, [&](std::size_t row) { return history["e_stress_xx"][row] >= 20; });
}

TEST(Failure, TensilePressureIsMetInItsStep) {
  const HistoryTable history = pull_cube(elastic, "pressure: 15");
  expect_death(history, [&](std::size_t row) { return history["e_pressure"][row] <= -15; });
}

TEST(Failure, PlasticStrainIsMetInItsStep) {
  const HistoryTable history = pull_cube(plastic, "plastic_strain: 0.1");
  expect_death(history, [&](std::size_t row) { return history["e_eps"][row] >= 0.1; });
}

TEST(Failure, TimeAtYieldIsMetInItsStep) {
  const HistoryTable history = pull_cube(plastic, "yield_time: 0.25");
  double time = 0;
  expect_death(history, [&](std::size_t row) {
    if (row > 0 && history["e_eps"][row] > history["e_eps"][row - 1]) time += history["dt"][row];
    return time >= 0.25;
  });
}

/// Damage with this d4 is met in the step in which its sum over the rows reaches 1.
void expect_johnson_cook_death(double d4) {
  const HistoryTable history = pull_cube(
      plastic, fmt::format("johnson_cook: {{d1: 0.05, d2: 0.3, d3: -0.5, d4: {}, reference_rate: 0.01}}", d4));
  double damage = 0;
  expect_death(history, [&](std::size_t row) {
    if (row == 0) return false;
    const double growth = history["e_eps"][row] - history["e_eps"][row - 1];
    if (!(growth > 0)) return false;
    const double ratio = std::min(1.5, -history["e_pressure"][row] / history["e_von_mises"][row]);
    const double rate = std::max(1.0, growth / history["dt"][row] / 0.01);
    damage += growth / ((0.05 + 0.3 * std::exp(-0.5 * ratio)) * (1 + d4 * std::log(rate)));
    return damage >= 1;
  });
}

TEST(Failure, JohnsonCookDamageIsMetInItsStep) { expect_johnson_cook_death(0.1); }

TEST(Failure, JohnsonCookDamageOfANegativeRateConstantIsMetInItsStep) { expect_johnson_cook_death(-0.05); }

TEST(Failure, FadesInEqualParts) {
  const HistoryTable whole = pull_cube(elastic, ""),
                     history = pull_cube(elastic, "principal_stress: 20, fade_steps: 8");
  const std::size_t met = find_row(whole, [&](std::size_t row) { return whole["e_stress_xx"][row] >= 20; });
  expect_death(
      history, [&](std::size_t row) { return row == met; }, 8);
  for (std::size_t k = 0; k <= 8; ++k) {
    EXPECT_NEAR(history["e_stress_xx"][met + k], whole["e_stress_xx"][met + k] * (8.0 - static_cast<double>(k)) / 8,
                1e-12);
  }
}

TEST(Failure, WhatAnElementHasTakenLeavesTheBooks) {
  const HistoryTable history = pull_cube(elastic, "principal_stress: 20, fade_steps: 4");
  const std::size_t death = find_death(history);
  // The work of the pulling hand until the force is gone; nothing more is done then.
  EXPECT_EQ(history["internal"][death], 0);
  EXPECT_GT(history["eroded_energy"][death], 0);
  EXPECT_EQ(history["eroded_mass"][death], 1);
  EXPECT_NEAR(history.last("external"), history["external"][death], 1e-12);
  EXPECT_LT(history.largest("energy_error"), 1e-3);
  EXPECT_GT(history.smallest("energy_error"), -1e-3);
}

TEST(Failure, AnInvertedElementEndsTheRunOrItself) {
  const std::string deck = R"(
title: a cube is turned inside out
time: {end: 1, max_steps: 5}
parts: {cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
conditions: [{nodes: cube/x_min, fixed: [x, y, z]}, {nodes: cube/x_max, velocity: {x: -1000}}]
output: {history: {}}
audit: {max_energy_error: 10}
)";
  EXPECT_ERROR(run_deck(deck), RunError, "has inverted");
  const Outcome run = run_deck(deck, {"materials.m.failure={inverted: true}"});
  EXPECT_EQ(run.summary.status, "completed");
  EXPECT_EQ(run.summary.eroded.elements, 1);
  EXPECT_EQ(find_death(run.history), 1U);
}

TEST(Failure, AnElementThatAllowsTooSmallAStepIsTakenOut) {
  const Outcome run = run_deck(R"(
title: a cube is flattened
time: {end: 100, max_steps: 60}
parts: {cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, failure: {step: 0.04}}}
conditions:
  - {nodes: cube, fixed: [y, z]}
  - {nodes: cube/x_min, fixed: [x]}
  - {nodes: cube/x_max, velocity: {x: -0.5}}
output: {history: {}}
audit: {max_energy_error: 10}
)");
  EXPECT_EQ(run.summary.eroded.elements, 1);
  EXPECT_GE(run.summary.dt.min, 0.04);
  EXPECT_LT(run.summary.dt.min, 0.042);  // and not long before
}

TEST(Erosion, ABarSpallsWhereTheReleasesMeet) {
  // A plate of length L hits one of 2 L, in uniaxial strain: the compressive pulse comes back from the far end as
  // tension and meets the release from the plate's own far end at L from the far end, at 3 L / c.
  const double young = 200e9, poisson = 0.3, density = 7850, velocity = 100, length = 0.05, edge = 0.001;
  const double c = std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
  const double tension = 0.5 * density * c * velocity, strength = 0.5 * tension;
  std::string points;
  for (int i = -8; i < 8; ++i) {
    points += fmt::format("{}{{name: e{}, near: [{}, 0.0005, 0.0005]}}", i == -8 ? "" : ", ", i + 8,
                          2 * length + (i + 0.5) * edge);
  }
  const Outcome run = run_deck(fmt::format(R"(
title: a plate spalls
time: {{end: 3.6e-5}}
parts:
  flyer:  {{box: {{size: [0.05, 0.001, 0.001], cells: [50, 1, 1]}}, material: steel}}
  target: {{box: {{size: [0.1, 0.001, 0.001], cells: [100, 1, 1]}}, at: [0.05, 0, 0], material: steel}}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, failure: {{principal_stress: {}}}}}
initial: [{{part: flyer, velocity: [{}, 0, 0]}}]
conditions: [{{nodes: all, fixed: [y, z]}}]
contact: {{surfaces: [{{a: flyer, b: target}}]}}
output: {{history: {{every: 1e-7, elements: [{}], nodes: [{{name: far, near: [0.15, 0, 0]}}]}}}}
)",
                                           strength, velocity, points));
  double sum = 0;
  int dead = 0;
  for (int i = 0; i < 16; ++i) {
    if (run.history.last(fmt::format("e{}_von_mises", i)) != 0) continue;
    ++dead;
    sum += i - 7.5;
  }
  ASSERT_GT(dead, 0);
  EXPECT_EQ(run.summary.eroded.elements, dead);  // nowhere else
  const double time = run.history.time_of_rise("eroded_elements", 0.5);
  fmt::print("{} elements dead, {:.2f} elements from the plane of the releases, at {:.3f} of 3 L / c\n", dead,
             sum / dead, time * c / (3 * length));
  // Viscosity spreads the rise of the tension over some elements, which reach the strength before the release of the
  // crack reaches them; the crack is in their middle.
  EXPECT_LE(dead, 10);
  EXPECT_NEAR(sum / dead, 0, 0.51);  // elements
  EXPECT_NEAR(time, 3 * length / c, 0.02 * 3 * length / c);
  EXPECT_NEAR(run.summary.energy.error, 0, 0.01);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(Erosion, FreeNodesFlyByNewton) {
  const std::string deck = R"(
title: a cube falls apart
time: {end: 1, max_steps: 200, max_step: 0.0078125}
parts:
  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}
  stone: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [5, 0, 0], material: stone}
materials:
  m: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25, failure: {principal_strain: 0.05}}
  stone: {model: elastic, density: 3, youngs_modulus: 100, poissons_ratio: 0.25}
initial: [{nodes: cube/x_max, velocity: [3, 0.5, 0.25]}, {nodes: stone, velocity: [0, 1, 0]}]
loads: {gravity: [0.5, 0, -1]}
output: {history: {nodes: [{name: n, near: [1, 1, 1]}]}}
)";
  const Outcome run = run_deck(deck);
  const HistoryTable& h = run.history;
  const std::size_t death = find_death(h);
  ASSERT_LT(death + 20, h.rows());
  const double v0 = h["n_vx"][death + 1], x0 = h["n_x"][death + 1], t0 = h["time"][death + 1];
  EXPECT_GT(std::abs(h["n_vx"][death] - h["n_vx"][death - 1]), 1e-3);  // until then the cube held it
  for (std::size_t row = death + 1; row < h.rows(); ++row) {
    const double t = h["time"][row] - t0;
    EXPECT_NEAR(h["n_vx"][row], v0 + 0.5 * t, 1e-12);
    EXPECT_NEAR(h["n_x"][row], x0 + v0 * t + 0.25 * t * (t + h["dt"][row]), 1e-12);
  }
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
  EXPECT_EQ(run.summary.eroded.mass, 2);
}

TEST(Erosion, WhatVanishesIsBooked) {
  const std::string deck = R"(
title: a cube vanishes
time: {end: 1, max_steps: 200, max_step: 0.0078125}
parts:
  cube: {box: {size: [2, 1, 1], cells: [2, 1, 1]}, material: m}
  stone: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [5, 0, 0], material: stone}
materials:
  m: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25, failure: {principal_strain: 0.05}}
  stone: {model: elastic, density: 3, youngs_modulus: 100, poissons_ratio: 0.25}
initial: [{nodes: cube/x_max, velocity: [3, 0.5, 0.25]}, {nodes: stone, velocity: [0, 1, 0]}]
loads: {gravity: [0.5, 0, -1]}
erosion: {free_nodes: remove}
output: {history: {}}
)";
  const Outcome run = run_deck(deck);
  ASSERT_GT(run.summary.eroded.elements, 0);
  EXPECT_EQ(run.summary.eroded.mass, 2.0 * static_cast<double>(run.summary.eroded.elements));
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
  EXPECT_NEAR(run.summary.energy.error, 0, 2e-3);
  const Outcome kept = run_deck(deck, {"erosion.free_nodes=keep"});
  EXPECT_GT(kept.summary.energy.kinetic, run.summary.energy.kinetic);
  EXPECT_GT(run.summary.eroded.energy, kept.summary.eroded.energy);
}

TEST(Erosion, ARunThatIsStoppedGoesOnToTheSameBits) {
  // Stops before the first death, amid the erosion, and while elements fade.
  for (const std::string choice : {"keep", "remove"}) {
    const std::string deck = punch + "erosion: {free_nodes: " + choice + "}\n";
    const TemporaryFolder whole, parts;
    const Summary expected = run(deck, whole.path(), 160);
    EXPECT_GT(expected.eroded.elements, 20);
    run(deck, parts.path(), 12);
    for (const int steps : {40, 41, 42, 90, 160}) run(deck, parts.path(), steps, parts.path() + "/checkpoint.h5");
    const Summary summary = read_summary(parts.path() + "/summary.json");
    EXPECT_EQ(summary.state_hash, expected.state_hash);
    EXPECT_EQ(summary.eroded.elements, expected.eroded.elements);
    EXPECT_EQ(summary.eroded.energy, expected.eroded.energy);
    EXPECT_EQ(summary.contact_faces, expected.contact_faces);
    EXPECT_EQ(summary.energy.error, expected.energy.error);
    EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
    EXPECT_LT(expected.momentum.linear_error, 1e-12);
    EXPECT_LT(expected.momentum.angular_error, 1e-12);
    EXPECT_LT(std::abs(expected.energy.error), 1e-2);
  }
}

TEST(Erosion, WithoutADeathNoBitChanges) {
  const std::string deck = R"(
title: a blow that kills nothing
time: {end: 1, max_steps: 60}
parts:
  lower: {box: {size: [1, 1, 0.4], cells: [7, 7, 3]}, material: steel}
  upper: {box: {size: [0.5, 0.5, 0.5], cells: [3, 3, 3]}, at: [0.21, 0.22, 0.401], material: steel}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
initial: [{part: upper, velocity: [20, 5, -100]}]
contact: {surfaces: all, friction: 0.3}
output: {history: {every: 0}}
)";
  const Outcome plain = run_deck(deck);
  const Outcome failing = run_deck(deck, {"materials.steel.failure={plastic_strain: 10, inverted: true}"});
  EXPECT_EQ(failing.summary.state_hash, plain.summary.state_hash);
  EXPECT_EQ(failing.summary.eroded.elements, 0);
  for (const char* column : {"kinetic", "internal", "hourglass", "energy_error"})
    EXPECT_EQ(failing.history[column], plain.history[column]) << column;
}

// Slivers in the foot, where the measured gap leaps: one such leap once gave 80 % of the rod's energy in one step,
// booked as work of contact, so that the balance of energy did not show it.
TEST(ErodingRod, ContactGivesNoEnergyInAnyStep) {
  const HistoryTable h = run_deck(R"(
time: {end: 3.4e-5}
parts: {rod: {cylinder: {radius: 0.0038, length: 0.0254, cells: [8, 26]}, material: steel}}
materials:
  steel: {model: johnson_cook, density: 7830, youngs_modulus: 205e9, poissons_ratio: 0.29, a: 792e6, b: 510e6, n: 0.26, c: 0.014, m: 1.03, melt_temperature: 1793, specific_heat: 477, failure: {johnson_cook: {d1: 0.05, d2: 1.0, d3: -2.12, d4: 0.002, d5: 0.61}}}
initial: [{velocity: [0, 0, -600]}]
walls: [{normal: z}]
contact: {surfaces: all}
output: {history: {every: 0}}
)")
                             .history;
  double given = 0;
  for (std::size_t i = 1; i < h.rows(); ++i) given = std::max(given, h["contact"][i] - h["contact"][i - 1]);
  // What is left is recovered penetration and the push along means of normals.
  EXPECT_LT(given, 0.01 * h["kinetic"][0]);
  EXPECT_LT(h["contact"][h.rows() - 1], 0);
}

}  // namespace percuss::test::erosion_test
