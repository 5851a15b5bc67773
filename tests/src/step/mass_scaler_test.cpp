// Mass scaling during the run against its exact answers.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/step/audit/audit.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// A body that is pressed together at a steady rate, all of its nodes driven, and a block beside it.
std::string write_press(const std::string& shape, const std::string& scaling) {
  return fmt::format(R"yaml(
time: {{end: 1}}
parts:
  body: {{{}, material: steel{}}}
  beside: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, at: [9, 0, 0], material: steel}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
conditions: [{{nodes: body/x_min, fixed: [x, y, z]}}, {{nodes: body/x_max, velocity: {{x: -10, y: 0, z: 0}}}}]
)yaml",
                     shape, scaling) +
         steel_text;
}

const std::string solid = "box: {size: [0.1, 0.2, 0.2], cells: [1, 1, 1]}",
                  sheet = "shell_plate: {size: [0.1, 0.2], cells: [1, 1]}, thickness: 0.01";

double find_press_bound(const std::string& shape) {
  Scene scene(write_press(shape, ""));
  scene.stepper.start(scene.state);
  return scene.state.bound.step;
}

/// The mass that the least bound lacks is added after the forces: the bound of the next forces tells.
void expect_bound_held(const std::string& shape) {
  const double wanted = 0.98 * find_press_bound(shape);
  Scene scene(write_press(shape, fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 9, every: 1}}", wanted)));
  scene.run(0);
  const double before = scene.state.total_mass;
  double moved = 0;
  while (moved < 0.03) {
    scene.stepper.advance(scene.state);
    const double shrunk = 10 * scene.state.dt;
    moved += shrunk;
    // A step shortens the body by this share, and the bound by no more than twice that.
    EXPECT_GT(scene.state.bound.step, wanted * (1 - 2 * shrunk / (0.1 - moved)));
  }
  EXPECT_GT(scene.state.total_mass, before);
  EXPECT_NEAR(scene.state.total_mass - before, scene.state.books.added_mass, 1e-12 * before);
  EXPECT_LT(scene.state.bound.step, wanted * 1.0001);
}

}  // namespace

TEST(MassScaler, HoldsTheStepOfASolidThatIsPressed) { expect_bound_held(solid); }

TEST(MassScaler, HoldsTheStepOfAShellThatIsPressed) { expect_bound_held(sheet); }

TEST(MassScaler, NodesHaveTheMassOfTheirElements) {
  const double wanted = 0.99 * find_press_bound(sheet);
  Scene scene(write_press(sheet, fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 9, every: 7}}", wanted)));
  scene.run(60);
  double elements = 0, nodes = 0;
  for (std::size_t e = 0; e < 2; ++e) elements += scene.state.element_mass(e);
  for (std::size_t n = 0; n < 12; ++n) {
    nodes += scene.state.mass(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const double inverse = scene.state.inverse_mass(n, k);
      if (inverse == 0) continue;
      EXPECT_DOUBLE_EQ(inverse * scene.state.mass(n), 1);
    }
    // t^2 / 12 + A / 8 of the first shape, times the mass of the sheet's nodes
    if (scene.state.inertia(n) == 0) continue;
    EXPECT_NEAR(scene.state.inertia(n) / scene.state.mass(n), 0.01 * 0.01 / 12 + 0.02 / 8, 1e-15);
  }
  EXPECT_GT(elements, 7850 * (1 + 0.0002) * (1 + 1e-6));
  EXPECT_NEAR(nodes / elements, 1, 1e-14);
  EXPECT_NEAR(scene.state.total_mass / elements, 1, 1e-14);
}

TEST(MassScaler, OnlyEveryNStepsAddsMass) {
  const double wanted = 0.99 * find_press_bound(solid);
  Scene scene(write_press(solid, fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 9, every: 5}}", wanted)));
  scene.run(0);
  int additions = 0;
  double last = 0;
  for (int i = 1; i <= 60; ++i) {
    scene.stepper.advance(scene.state);
    if (scene.state.books.added_mass == last) continue;
    EXPECT_EQ(i % 5, 0);
    ++additions;
    last = scene.state.books.added_mass;
  }
  EXPECT_GT(additions, 5);
}

TEST(MassScaler, StopsAtTheLimitAndSaysSo) {
  const double wanted = 0.99 * find_press_bound(solid);
  Scene scene(write_press(solid, fmt::format(", mass_scaling: {{step: {:.17g}, max_added: 0.05, every: 1}}", wanted)));
  scene.run(0);
  std::vector<Warning> warnings;
  for (int i = 0; i < 200; ++i) {
    scene.stepper.advance(scene.state);
    for (const Warning& warning : scene.stepper.take_warnings()) warnings.push_back(warning);
  }
  const double mass = 7850 * 0.1 * 0.2 * 0.2;
  EXPECT_NEAR(scene.state.books.added_mass, 0.05 * mass, 1e-12 * mass);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].rule, "mass_scaling_limit");
  EXPECT_EQ(warnings[0].place, "part 'body'");
  EXPECT_THAT(warnings[0].text, testing::HasSubstr("max_added = 0.05"));
  EXPECT_LT(scene.state.bound.step, 0.98 * wanted);  // nothing holds it any more
}

// A sheet and a block, turning, fly into a wall under gravity; nodes are held and elements fail.
const std::string crash = R"yaml(
time: {{end: 4e-4}}
parts:
  sheet: {{shell_plate: {{size: [0.1, 0.1], cells: [7, 6]}}, thickness: 0.002, material: steel, axis: y, at: [0, 0, 0.15]{0}}}
  block: {{box: {{size: [0.05, 0.05, 0.05], cells: [5, 5, 5]}}, at: [0.2, 0, 0.001], material: steel{1}}}
materials: {{steel: {{model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9{2}}}}}
initial: [{{velocity: [3, -2, -250], angular_velocity: [20, 10, 5]}}]
conditions: [{{nodes: sheet/x_min, velocity: {{y: -2}}}}]
loads: {{gravity: [5, 0, -1e5]}}
walls: [{{normal: z, friction: 0.2}}]
output: {{history: {{every: 0}}}}
)yaml";

Summary run_crash(const std::string& of_sheet, const std::string& of_block, const std::string& failure,
                  const std::string& more = "") {
  return run_scene(parse_deck(fmt::format(fmt::runtime(crash), of_sheet, of_block, failure) + more, "deck.yaml"), {})
      .summary;
}

TEST(MassScaler, EnergyAndMomentumCloseAsWithout) {
  const Summary plain = run_crash("", "", "");
  const Summary scaled = run_crash(", mass_scaling: {step: 2.2e-6, max_added: 9, every: 1}",
                                   ", mass_scaling: {step: 1.1e-6, max_added: 9, every: 3}", "");
  EXPECT_GT(scaled.mass.in_run, 1e-3);
  EXPECT_GT(scaled.mass.energy, 0);
  EXPECT_GT(scaled.dt.min, 1.1 * plain.dt.min);
  EXPECT_LT(scaled.momentum.linear_error, 1e-13);   // round-off
  EXPECT_LT(scaled.momentum.angular_error, 1e-13);  // likewise
  // What is left is that of steps that change, as without scaling: the added energy itself is hundreds of times more.
  EXPECT_LT(std::abs(scaled.energy.error), std::max(2 * std::abs(plain.energy.error), 1e-5));
  EXPECT_GT(scaled.mass.energy / scaled.energy.initial, 1e-3);
}

TEST(MassScaler, AlsoWhereElementsFailAndNodesGo) {
  const Summary summary = run_crash(", mass_scaling: {step: 2.2e-6, max_added: 9, every: 1}",
                                    ", mass_scaling: {step: 1.1e-6, max_added: 9, every: 2}",
                                    ", failure: {plastic_strain: 0.3}", "erosion: {free_nodes: remove}\n");
  EXPECT_GT(summary.eroded.elements, 0);
  EXPECT_GT(summary.eroded.vanished_mass, 0);
  EXPECT_GT(summary.mass.in_run, 0);
  EXPECT_LT(summary.momentum.linear_error, 1e-13);
  EXPECT_LT(summary.momentum.angular_error, 1e-13);
  const Summary plain = run_crash("", "", ", failure: {plastic_strain: 0.3}", "erosion: {free_nodes: remove}\n");
  EXPECT_LT(std::abs(summary.energy.error), 2 * std::abs(plain.energy.error));
}

}  // namespace percuss::test
