// Settings of elements by part and friction by pair: each acts where it is given and nowhere else.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "tests/src/step/two_scenes.hpp"

namespace percuss::test {
namespace {

constexpr double spacing = 0.125;

/// A bar that is held at one end and moves on: it bends, twists and carries waves. Apart from bars of other numbers.
std::string write_bar(int number, const std::string& more) {
  return fmt::format(
      "  bar{}: {{box: {{size: [0.06, 0.02, 0.02], cells: [6, 2, 2]}}, at: [0, {}, 0], material: steel{}}}\n", number,
      spacing * number, more);
}

/// max_step: shorter than any bound of an element, so that all scenes take the same steps.
std::string write_scene(const std::string& parts, const std::string& elements) {
  return "time: {end: 1, max_step: 2e-7}\nparts:\n" + parts +
         "initial: [{velocity: [3, -20, 30], angular_velocity: [200, 0, 0], center: [0, 0, 0]}]\n"
         "conditions: [{nodes: {inside: [[-1, -100, -1], [1e-6, 100, 1]]}, fixed: [x, y, z]}]\n"
         "materials:\n  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}\n" +
         elements;
}

using Places = std::map<std::array<double, 3>, std::array<double, 3>>;

/// Where the nodes of the bar of this number are at the end, by where they began.
Places find_places(const Scene& scene, int number) {
  Places places;
  const auto x = to_host(scene.state.x);
  for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
    const Vec3& at = scene.chunked.mesh.nodes[n];
    if (std::abs(at[1] - spacing * number - 0.01) < 0.02) places[{at[0], at[1], at[2]}] = {x(n, 0), x(n, 1), x(n, 2)};
  }
  return places;
}

Places run_alone(int number, const std::string& of_part, const std::string& elements) {
  Scene scene(write_scene(write_bar(number, of_part), elements), Communicator(MPI_COMM_SELF));
  scene.run(60);
  return find_places(scene, number);
}

const std::array<std::string, 4> settings{"integration: full", "hourglass: {kind: stiffness, coefficient: 0.1}",
                                          "hourglass: viscous", "bulk_viscosity: {linear: 0.4, quadratic: 3}"};

}  // namespace

TEST(PartSettings, ActOnTheirPartAloneToTheLastBit) {
  std::string parts = write_bar(0, "");
  for (std::size_t s = 0; s < settings.size(); ++s) parts += write_bar(static_cast<int>(s) + 1, ", " + settings[s]);
  Scene together(write_scene(parts, ""), Communicator(MPI_COMM_SELF));
  together.run(60);
  EXPECT_EQ(find_places(together, 0), run_alone(0, "", ""));
  for (std::size_t s = 0; s < settings.size(); ++s) {
    const int number = static_cast<int>(s) + 1;
    const Places of_part = find_places(together, number);
    EXPECT_EQ(of_part.size(), 63u);
    EXPECT_EQ(of_part, run_alone(number, "", "elements: {" + settings[s] + "}\n")) << settings[s];
    EXPECT_NE(of_part, run_alone(number, "", "")) << settings[s];
  }
}

TEST(PartSettings, WhatAPartLeavesOutIsThatOfTheScene) {
  const std::string scene = "elements: {hourglass: {kind: viscous, coefficient: 0.1}, bulk_viscosity: {linear: 0.2}}\n";
  EXPECT_EQ(
      run_alone(0, ", hourglass: {coefficient: 0.02}", scene),
      run_alone(0, "", "elements: {hourglass: {kind: viscous, coefficient: 0.02}, bulk_viscosity: {linear: 0.2}}\n"));
  EXPECT_EQ(run_alone(0, ", integration: full, bulk_viscosity: {quadratic: 0}", scene),
            run_alone(0, "", "elements: {integration: full, bulk_viscosity: {linear: 0.2, quadratic: 0}}\n"));
}

// Three kinds of elements, two integrations, three hourglass controls, two frictions, all in contact.
TEST(PartSettings, OfEveryKindHaveTheBitsOfOneRank) {
  TwoScenes scenes(R"yaml(
time: {end: 1}
parts:
  floor: {box: {size: [0.1, 0.1, 0.01], cells: [8, 8, 2]}, material: copper, hourglass: stiffness}
  full: {box: {size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}, at: [0.01, 0.01, 0.01001], material: steel, integration: full}
  thick: {box: {size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}, at: [0.05, 0.01, 0.01001], material: steel, hourglass: {kind: viscous, coefficient: 0.1}}
  usual: {box: {size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}, at: [0.01, 0.05, 0.01001], material: steel, bulk_viscosity: {linear: 0.1}}
  tets: {sphere: {radius: 0.01, cells: 4}, elements: tetrahedra, at: [0.06, 0.06, 0.02001], material: steel, bulk_viscosity: {linear: 0.1, quadratic: 2}}
  sheet: {shell_plate: {size: [0.09, 0.09], cells: [9, 9]}, thickness: 0.001, at: [0.005, 0.005, 0.0306], material: steel}
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
initial: [{velocity: [30, 20, -100]}, {part: floor, velocity: [0, 0, 0]}, {part: sheet, velocity: [0, 0, -200]}]
contact: {surfaces: all, friction: {default: 0.2, pairs: [{a: full, b: floor, friction: 0.6}, {a: sheet, friction: 0}]}}
)yaml");
  scenes.run(60);
  expect_same_rows(scenes, scenes.together.state.x, scenes.alone.state.x, "position");
  EXPECT_EQ(hash_state(scenes.together.model, scenes.together.state),
            hash_state(scenes.alone.model, scenes.alone.state));
  EXPECT_GT(scenes.alone.stepper.contact_report().interactions, 0);
}

namespace {

/// Blocks that slide on a floor: the ratio of their friction and their pushes so far, which while all slides is the
/// coefficient.
std::vector<double> find_ratios(const std::string& contact) {
  std::string parts, initial, forces;
  const std::array<const char*, 3> names{"a", "b", "c"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    parts += fmt::format(
        "  {}: {{box: {{size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}}, at: [{}, 0.02, 0.01], material: steel}}\n",
        names[i], 0.04 * static_cast<double>(i) + 0.01);
    initial += fmt::format("{{part: {}, velocity: [0, 20, -2]}}, ", names[i]);
    forces += fmt::format("{{name: on_{0}, contact: [{0}, floor]}}, ", names[i]);
  }
  Scene scene("time: {end: 1}\nparts:\n  floor: {box: {size: [0.12, 0.1, 0.01], cells: [6, 5, 1]}, material: steel}\n" +
                  parts + "initial: [" + initial + "]\nconditions: [{nodes: floor, fixed: [x, y, z]}]\n" + contact +
                  "output: {history: {every: 0, forces: [" + forces + "]}}" + steel_text,
              Communicator(MPI_COMM_SELF));
  scene.run(12);
  std::vector<double> ratios;
  for (const ContactImpulse& force : scene.contact.take_forces(scene.state.x)) {
    EXPECT_GT(force.normal, 0);
    ratios.push_back(force.tangential / force.normal);
  }
  return ratios;
}

void expect_ratios(const std::vector<double>& found, const std::array<double, 3>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

}  // namespace

TEST(PairFriction, IsOfItsPairAlone) {
  expect_ratios(find_ratios("contact: {friction: 0.05}\n"), {0.05, 0.05, 0.05});
  expect_ratios(
      find_ratios("contact: {friction: {default: 0.05, pairs: [{a: floor, b: a, friction: 0.1}, {a: b, friction: 0.3}, "
                  "{a: a, b: b, friction: 7}]}}\n"),
      {0.1, 0.3, 0.05});
}

TEST(PairFriction, OfTheFirstRowThatFitsCounts) {
  expect_ratios(
      find_ratios("contact: {friction: {pairs: [{a: b, b: floor, friction: 0.1}, {a: floor, friction: 0.2}]}}\n"),
      {0.2, 0.1, 0.2});
}

TEST(PairFriction, OfAPairOfSurfacesIsItsOwn) {
  expect_ratios(
      find_ratios("contact: {surfaces: [[a, floor], {a: b, b: floor, friction: 0.4}, {a: c, b: floor}], "
                  "friction: {default: 0.05, pairs: [{a: a, b: floor, friction: 0.1}, {a: b, friction: 0.3}]}}\n"),
      {0.1, 0.4, 0.05});
}

}  // namespace percuss::test
