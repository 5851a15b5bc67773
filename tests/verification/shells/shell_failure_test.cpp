// Failure and erosion of shells: criteria and layers against exact answers, a plate that is perforated, its books.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include "kernels/shell/thickness_points.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/deaths.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::shell_failure_test {
namespace {

constexpr double young = 100, poisson = 0.25, speed = 1;

/// One shell of edge 1, driven by the conditions in steps of 1/128.
HistoryTable drive_shell(const std::string& model, const std::string& failure, const std::string& conditions,
                         const std::string& more = "") {
  return run_deck(fmt::format(R"(
title: one shell
time: {{end: 100, max_steps: 100, max_step: 0.0078125}}
parts: {{shell: {{shell_plate: {{size: [1, 1], cells: [1, 1]}}, thickness: 0.1, points: 5, material: m}}}}
materials: {{m: {{density: 1, youngs_modulus: {}, poissons_ratio: {}, {}{}}}}}
conditions: {}
output: {{history: {{elements: [{{name: e, near: [0.5, 0.5, 0]}}], nodes: [{{name: n, near: [1, 0, 0]}}]}}}}
audit: {{max_energy_error: 10}}
{}
)",
                              young, poisson, model, failure.empty() ? "" : ", failure: {" + failure + "}", conditions,
                              more))
      .history;
}

/// Pulled along x, held along y.
HistoryTable pull_shell(const std::string& model, const std::string& failure) {
  return drive_shell(model, failure,
                     fmt::format("[{{nodes: shell, fixed: [y, z, rx, ry, rz]}}, {{nodes: shell/x_min, fixed: x}}, "
                                 "{{nodes: shell/x_max, velocity: {{x: {}}}}}]",
                                 speed));
}

/// Bent into a cylinder: the curvature grows by 2 in a unit of time.
HistoryTable bend_shell(const std::string& model, const std::string& failure) {
  return drive_shell(model, failure,
                     "[{nodes: shell, fixed: [x, y, z, rx, rz]}, {nodes: shell/x_min, velocity: {ry: -1}}, {nodes: "
                     "shell/x_max, velocity: {ry: 1}}]");
}

const std::string elastic = "model: elastic";
const std::string plastic = "model: j2_plasticity, yield_stress: 5, hardening_modulus: 2";

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

/// A ball goes through a plate whose layers fail one by one.
const std::string perforation = R"(
title: a ball perforates a plate of shells
time: {end: 2.5e-4}
parts:
  ball: {sphere: {radius: 0.008, cells: 6}, at: [0.001, 0.0005, 0.0095], material: steel}
  plate: {shell_plate: {size: [0.08, 0.08], cells: [24, 24]}, thickness: 0.0015, at: [-0.04, -0.04, 0], material: soft}
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  soft: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.3, yield_stress: 2e8, hardening_modulus: 2e8, failure: {plastic_strain: 0.3, inverted: true, fade_steps: 3}}
initial: [{part: ball, velocity: [20, 0, -200]}]
loads: {gravity: [0, 0, -1e5], pressure: [{faces: plate/bottom, value: 1e6}]}
conditions: [{nodes: plate/x_min, fixed: [x, y, z, rx, ry, rz]}, {nodes: plate/x_max, velocity: {ry: 20}}]
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 0, nodes: [{name: ball, near: [0.001, 0.0005, 0.0095]}]}, checkpoint: {every: 1}}
)";

}  // namespace

TEST(ShellFailure, PrincipalStrainIsMetInItsStep) {
  const HistoryTable history = pull_shell(elastic, "principal_strain: 0.2");
  // Log strain sums up from the rates of the middle of each step: (dt / L)^2 / 12 apart.
  expect_death(history, [&](std::size_t row) { return std::log1p(speed * history["time"][row]) >= 0.2; });
}

TEST(ShellFailure, ThinningIsMetInItsStep) {
  // Held along y, an elastic sheet becomes thinner by nu / (1 - nu) of its strain along x.
  const auto is_met = [](const HistoryTable& history, double limit) {
    return [&history, limit](std::size_t row) {
      return poisson / (1 - poisson) * std::log1p(speed * history["time"][row]) >= limit;
    };
  };
  for (const char* key : {"thinning", "mean_thinning"}) {
    const HistoryTable history = pull_shell(elastic, fmt::format("{}: 0.06", key));
    expect_death(history, is_met(history, 0.06));
  }
  const HistoryTable small = pull_shell(elastic, "thinning: 0.06, size: [[1, 0.5]]");
  expect_death(small, is_met(small, 0.03));
}

TEST(ShellFailure, BendingThinsTheLayersOfOneSideAlone) {
  const HistoryTable mean = bend_shell(elastic, "mean_thinning: 0.001");
  EXPECT_EQ(find_death(mean), mean.rows());
  const HistoryTable history = bend_shell(elastic, "thinning: 0.01, layers: 0.1");
  const ThicknessPoints rule = find_thickness_points(5);
  expect_death(history, [&](std::size_t row) {
    return poisson / (1 - poisson) * 0.05 * rule.place[4] * 2 * history["time"][row] >= 0.01;
  });
}

TEST(ShellFailure, PrincipalStressIsMetInItsStep) {
  const HistoryTable history = pull_shell(elastic, "principal_stress: 20");
  expect_death(history, [&](std::size_t row) { return history["e_stress_xx"][row] >= 20; });
}

TEST(ShellFailure, PlasticStrainIsMetInItsStep) {
  const HistoryTable history = pull_shell(plastic, "plastic_strain: 0.1");
  expect_death(history, [&](std::size_t row) { return history["e_eps"][row] >= 0.1; });
}

TEST(ShellFailure, TimeAtYieldIsMetInItsStep) {
  const HistoryTable history = pull_shell(plastic, "yield_time: 0.25");
  double time = 0;
  expect_death(history, [&](std::size_t row) {
    if (row > 0 && history["e_eps"][row] > history["e_eps"][row - 1]) time += history["dt"][row];
    return time >= 0.25;
  });
}

TEST(ShellFailure, FadesInEqualParts) {
  const HistoryTable whole = pull_shell(elastic, ""),
                     history = pull_shell(elastic, "principal_stress: 20, fade_steps: 8");
  const std::size_t met = find_row(whole, [&](std::size_t row) { return whole["e_stress_xx"][row] >= 20; });
  expect_death(
      history, [&](std::size_t row) { return row == met; }, 8);
  for (std::size_t k = 0; k <= 8; ++k) {
    EXPECT_NEAR(history["e_stress_xx"][met + k], whole["e_stress_xx"][met + k] * (8.0 - static_cast<double>(k)) / 8,
                1e-12);
  }
  const std::size_t death = find_death(history);
  EXPECT_EQ(history["internal"][death], 0);
  EXPECT_GT(history["eroded_energy"][death], 0);
  EXPECT_EQ(history["eroded_mass"][death], 0.1);
  EXPECT_LT(history.largest("energy_error"), 1e-3);
  EXPECT_GT(history.smallest("energy_error"), -1e-3);
}

TEST(ShellFailure, TensionBarFailsAtTheStrainOfTheUniaxialLaw) {
  // Slowly, so that it stays uniaxial: 30 traversals of the bar by waves until it yields.
  constexpr double yield = 0.5, hardening = 1, limit = 0.1, pull = 0.02;
  // At the plastic strain p the stress s is yield + H p, and the strain across the strip -(p / 2 + nu s / E).
  const double of_thinning = (limit - poisson * yield / young) / (0.5 + poisson * hardening / young);
  for (const auto& [key, plastic_strain] :
       {std::pair{"plastic_strain", limit}, {"thinning", of_thinning}, {"mean_thinning", of_thinning}}) {
    const Outcome run = run_deck(fmt::format(R"(
title: a strip is pulled until it fails
time: {{end: 16, max_step: 0.004}}
parts: {{strip: {{shell_plate: {{size: [1, 0.5], cells: [1, 1]}}, thickness: 0.1, material: m}}}}
materials: {{m: {{model: j2_plasticity, density: 1, youngs_modulus: 100, poissons_ratio: 0.25, yield_stress: {}, hardening_modulus: {}, failure: {{{}: {}}}}}}}
conditions:
  - {{nodes: strip, fixed: [z, rx, ry, rz]}}
  - {{nodes: strip/x_min, fixed: x}}
  - {{nodes: strip/y_min, fixed: y}}
  - {{nodes: strip/x_max, velocity: {{x: {{table: [[0, 0], [1, {}]]}}}}}}
output: {{history: {{}}}}
)",
                                             yield, hardening, key, limit, pull));
    // Cauchy stress over logarithmic strain: p = (E e - yield) / (E + H); the pull is pull (t - 1/2).
    const double strain = (plastic_strain * (young + hardening) + yield) / young;
    const double time = 0.5 + std::expm1(strain) / pull;
    const double died = run.history["time"][find_death(run.history)];
    fmt::print("by {} the strip fails at {:.5f} of the exact elongation\n", key, (died - 0.5) / (time - 0.5));
    EXPECT_NEAR((died - 0.5) / (time - 0.5), 1, 2e-3);  // a step is 8e-4 of it, and death comes one after the criterion
    EXPECT_LT(run.history.largest("energy_error"), 1e-3);
  }
}

TEST(ShellFailure, LayersFailOneByOneInBending) {
  // Stress of a layer at z: E z curvature / (1 - nu^2). Only those in tension reach the limit: the share that they are
  // of the thickness, 0.36 with the second and 0.12 with the first, decides when the element dies.
  const ThicknessPoints rule = find_thickness_points(5);
  constexpr double limit = 4, half = 0.05;
  for (const int layers : {1, 2}) {
    const HistoryTable history =
        bend_shell(elastic, fmt::format("principal_stress: {}, layers: {}", limit, layers == 1 ? 0.1 : 0.3));
    const double curvature = limit * (1 - poisson * poisson) / (young * half * rule.place[5 - layers]);
    expect_death(history, [&](std::size_t row) { return 2 * history["time"][row] >= curvature; });
  }
  // The middle does not stretch, so that not all can fail.
  EXPECT_EQ(bend_shell(elastic, "principal_stress: 4").last("eroded_elements"), 0);
}

TEST(ShellFailure, LayersThatHaveFailedCarryNoStress) {
  constexpr double limit = 4, half = 0.05;
  const ThicknessPoints rule = find_thickness_points(5);
  const HistoryTable whole = bend_shell(elastic, ""), history = bend_shell(elastic, "principal_stress: 4");
  // Mean stress over the thickness: that of the layers in compression which the others no longer balance.
  const std::size_t last = history.rows() - 1;
  const double curvature = 2 * history["time"][last];
  ASSERT_GT(young * half * rule.place[3] * curvature / (1 - poisson * poisson), limit);
  double mean = 0;
  for (int p = 0; p < 3; ++p) mean += rule.weight[p] * rule.place[p];
  mean *= young * half * curvature / (1 - poisson * poisson);
  EXPECT_NEAR(whole["e_stress_xx"][last], 0, 1e-9);
  EXPECT_NEAR(history["e_stress_xx"][last], mean, 1e-3 * std::abs(mean));
  // Work of the hands that bend it, layer by layer up to the stress at which each fails, is what the books hold.
  EXPECT_LT(history.largest("energy_error"), 2e-3);
  EXPECT_GT(history.smallest("energy_error"), -2e-3);
}

TEST(ShellFailure, AShellThatFoldsGoesOnUnlessItsMaterialFails) {
  const std::string deck = R"(
title: a corner of a shell is pushed through it
time: {end: 1, max_steps: 5}
parts: {shell: {shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25}}
conditions: [{nodes: shell/x_min, fixed: [x, y, z]}, {nodes: {name: shell, inside: [[1, 1, 0], [1, 1, 0]]}, velocity: {x: -400, y: -400}}]
output: {history: {}}
audit: {max_energy_error: 10}
)";
  const Outcome whole = run_deck(deck);
  EXPECT_EQ(whole.summary.status, "completed");
  EXPECT_EQ(whole.summary.steps, 5);
  const Outcome run = run_deck(deck, {"materials.m.failure={inverted: true}"});
  EXPECT_EQ(run.summary.status, "completed");
  EXPECT_EQ(run.summary.eroded.elements, 1);
}

TEST(ShellFailure, ABallPerforatesAPlateAndTheBooksClose) {
  for (const char* choice : {"keep", "remove"}) {
    const Outcome run = run_deck(perforation, {std::string("erosion={free_nodes: ") + choice + "}"});
    fmt::print("{}: {} elements dead, ball at {:.1f} m/s, energy {:.1e}, angular momentum {:.1e}\n", choice,
               run.summary.eroded.elements, run.history.last("ball_vz"), run.summary.energy.error,
               run.summary.momentum.angular_error);
    EXPECT_GT(run.summary.eroded.elements, 10);
    EXPECT_LT(run.history.last("ball_z"), -0.02);  // through
    EXPECT_NEAR(run.summary.eroded.mass,
                static_cast<double>(run.summary.eroded.elements) * 2700 * 0.0015 * 0.08 * 0.08 / 576,
                1e-12 * run.summary.eroded.mass);
    EXPECT_LT(std::abs(run.history.largest("energy_error")), 1e-2);
    EXPECT_LT(std::abs(run.history.smallest("energy_error")), 1e-2);
    EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  }
}

TEST(ShellFailure, ARunThatIsStoppedGoesOnToTheSameBits) {
  // Stops before the first death, amid the erosion, and while layers fade.
  for (const std::string choice : {"keep", "remove"}) {
    const std::string deck = perforation + "erosion: {free_nodes: " + choice + "}\n";
    const TemporaryFolder whole, parts;
    const Summary expected = run(deck, whole.path(), 340);
    EXPECT_GT(expected.eroded.elements, 10);
    run(deck, parts.path(), 20);
    for (const int steps : {105, 106, 107, 108, 220, 340})
      run(deck, parts.path(), steps, parts.path() + "/checkpoint.h5");
    const Summary summary = read_summary(parts.path() + "/summary.json");
    EXPECT_EQ(summary.state_hash, expected.state_hash);
    EXPECT_EQ(summary.eroded.elements, expected.eroded.elements);
    EXPECT_EQ(summary.eroded.energy, expected.eroded.energy);
    EXPECT_EQ(summary.energy.error, expected.energy.error);
    EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
  }
}

TEST(ShellFailure, WithoutADeathNoBitChanges) {
  const std::string failure = ", failure: {plastic_strain: 0.3, inverted: true, fade_steps: 3}";
  std::string plain = perforation, failing = perforation;
  plain.replace(plain.find(failure), failure.size(), "");
  failing.replace(failing.find(failure), failure.size(), ", failure: {plastic_strain: 10, principal_strain: 10}");
  const Outcome a = run_deck(plain, {"time.max_steps=60"}), b = run_deck(failing, {"time.max_steps=60"});
  EXPECT_GT(a.summary.energy.internal(), 0);
  EXPECT_EQ(a.summary.state_hash, b.summary.state_hash);
  for (const char* column : {"kinetic", "internal", "hourglass", "energy_error"})
    EXPECT_EQ(a.history[column], b.history[column]) << column;
}

}  // namespace percuss::test::shell_failure_test
