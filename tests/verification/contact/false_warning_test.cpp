// Runs in which contact gives energy for a good reason, and that do not warn of it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/step/run/run.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::false_warning_test {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> list_rules(const Outcome& outcome) {
  std::vector<std::string> rules;
  rules.reserve(outcome.summary.warnings.size());
  for (const Warning& warning : outcome.summary.warnings) rules.push_back(warning.rule);
  return rules;
}

const std::string steel =
    "materials: {s: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

TEST(FalseWarnings, AreNotGivenOfRoundOffBetweenBodiesThatMoveAlike) {
  // An overlap that is accepted: contact works at the round-off of places, for want of anything else to do.
  const std::string overlapping =
      "time: {end: 4.0e-4}\n"
      "parts:\n"
      "  a: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, material: s}\n"
      "  b: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0.013, 0.007, 0.09975], material: s}\n"
      "initial: [{velocity: [0.3, 0.2, 0.1]}]\n"
      "contact: {overlap: accept}\n"
      "silence: [unreached_body]\n" +
      steel;
  const Outcome outcome = run_deck(overlapping);
  EXPECT_NE(outcome.summary.energy.contact, 0);  // else the scene tests nothing
  EXPECT_LT(outcome.summary.energy.contact, 1e-20);
  EXPECT_THAT(outcome.summary.warnings, IsEmpty());
}

TEST(FalseWarnings, AreNotGivenOfANodeBesideTheRimOfAShell) {
  // Within half the thickness of the rim, outside the tube: edges hold the plate there.
  const std::string beside_the_rim =
      "time: {end: 1.0, max_steps: 20}\n"
      "parts:\n"
      "  tube: {shell_tube: {radius: 0.2, length: 0.4, arc: 180, cells: [40, 52]}, thickness: 0.006, material: s}\n"
      "  plate: {box: {size: [0.52, 0.26, 0.045], cells: [16, 16, 3]}, rotate: [{axis: y, angle: -10, center: [0.057, "
      "0, 0]}], at: [-0.26, 0, 0.4035], material: s}\n"
      "initial: [{part: plate, velocity: [0, 0, -120]}]\n"
      "conditions: [{nodes: tube/start, fixed: [x, y, z, rx, ry, rz]}]\n"
      "contact: {surfaces: all}\n" +
      steel;
  EXPECT_THAT(list_rules(run_deck(beside_the_rim)), Not(Contains("missed_contact")));
}

TEST(FalseWarnings, AreNotGivenOfATieThatIsLoadedAtOnce) {
  // A gas that is tied to a cold one: the tie halves the first half step of the pressure, whose work is in no store
  // yet.
  const std::string tied =
      "time: {end: 1.0e-6, max_step: 1.0e-6}\n"
      "parts:\n"
      "  hot: {box: {size: [0.0025, 0.0025, 0.0025], cells: [1, 1, 1]}, material: h}\n"
      "  cold: {box: {size: [0.1, 0.0025, 0.0025], cells: [40, 1, 1]}, at: [0.0025, 0, 0], material: c}\n"
      "materials:\n"
      "  h: {model: fluid, density: 1.0, equation_of_state: {kind: ideal_gas, gamma: 1.4, start_energy: 27.0}}\n"
      "  c: {model: fluid, density: 1.0, equation_of_state: {kind: ideal_gas, gamma: 1.4, start_energy: 1.0e-6}}\n"
      "elements: {hourglass: viscous}\n"
      "conditions:\n"
      "  - {nodes: hot, fixed: [y, z]}\n"
      "  - {nodes: cold, fixed: [y, z]}\n"
      "  - {nodes: hot/x_min, fixed: [x]}\n"
      "contact: {surfaces: none, ties: [{a: hot/x_max, b: cold/x_min}]}\n";
  const Outcome outcome = run_deck(tied);
  EXPECT_GT(outcome.summary.energy.contact, 0.3 * outcome.summary.energy.kinetic);
  EXPECT_THAT(list_rules(outcome), Not(Contains("contact_energy")));
}

// A sheet on a wall, with momenta of round-off: their balance is judged by its weight.
TEST(FalseWarnings, DoNotEndARunAtRestUnderItsWeight) {
  const std::string sheet =
      "time: {end: 0.1, max_steps: 800}\n"
      "parts:\n"
      "  sheet: {shell_plate: {size: [0.1, 0.1], cells: [4, 3]}, thickness: 0.003, at: [0, 0, 0.0015], material: s}\n"
      "loads: {gravity: [0, 0, -9.81]}\n"
      "walls: [{point: [0, 0, 0], normal: z, thickness: included}]\n"
      "contact: {surfaces: all}\n" +
      steel;
  const Outcome outcome = run_deck(sheet);
  EXPECT_EQ(outcome.summary.status, "completed");
  EXPECT_LT(outcome.summary.momentum.linear_error, 1e-6);
  EXPECT_LT(outcome.summary.momentum.angular_error, 1e-6);
}

// A block that sticks on a slope: the springs of friction hold what friction has taken.
TEST(FalseWarnings, AreNotGivenOfSpringsOfFriction) {
  const std::string block =
      "time: {end: 0.02}\n"
      "parts:\n"
      "  b: {box: {size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}, material: m, stiffness_damping: 5.0e-5}\n"
      "materials: {m: {model: elastic, density: 1500, youngs_modulus: 1.0e7, poissons_ratio: 0.3}}\n"
      "loads: {gravity: [3.3552, 0, -9.2184]}\n"
      "walls: [{point: [0, 0, 0], normal: z, friction: 0.38}]\n"
      "contact: {surfaces: all, friction: 0.38, enforcement: penalty}\n";
  const Outcome outcome = run_deck(block);
  EXPECT_LT(outcome.summary.energy.friction, 0);
  EXPECT_THAT(list_rules(outcome), Not(Contains("contact_energy")));
}

/// A half circle of eight rigid blocks, which holds itself up by contact.
std::string make_arch() {
  constexpr int blocks = 8;
  std::string text = "time: {end: 0.1, max_step: 2.0e-5, max_steps: 20}\nparts:\n";
  for (int n = 0; n < blocks; ++n) {
    const double depth = n % 2 == 0 ? 0.24 : 0.3;
    text += fmt::format(
        "  b{0}: {{tube: {{inner_radius: 0.94, outer_radius: 1.06, length: {1}, cells: [1, 3, 1], arc: {2}}}, axis: y, "
        "rotate: [{{axis: y, angle: {3}}}], at: [0, {4}, 0], material: m, rigid: true}}\n",
        n, depth, 180.0 / blocks, -180.0 * (n + 1) / blocks, -depth / 2);
  }
  return text +
         "materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.2}}\n"
         "loads: {gravity: [0, 0, -9.81]}\n"
         "walls: [{normal: z, friction: 1}]\n"
         "contact: {surfaces: all, friction: 1}\n";
}

TEST(FalseWarnings, AreNotGivenOfRigidBlocksThatRestOnEachOther) {
  // The only energy is that of half a step of their weight: what contact gives of it and takes again is no gain.
  const Outcome outcome = run_deck(make_arch());
  EXPECT_GT(outcome.summary.energy.contact, 0);  // else the scene tests nothing
  EXPECT_THAT(list_rules(outcome), Not(Contains("contact_energy")));
}

/// Two blocks between walls that overlap by so much.
std::string make_press_fit(double overlap) {
  return "time: {end: 2.5e-3}\n"
         "parts:\n"
         "  a: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: s}\n"
         "  b: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [0, 0, " +
         std::to_string(0.1 - overlap) +
         "], material: s}\n"
         "conditions: [{nodes: a/z_min, fixed: z}, {nodes: b/z_max, fixed: z}]\n" +
         steel;
}

TEST(FalseWarnings, AreNotGivenOfOverlapThatIsPushedOutAsAsked) {
  for (const char* enforcement : {"kinematic", "lagrange", "penalty"}) {
    const std::vector<std::string> overrides = {std::string("contact={overlap: push_out, enforcement: ") + enforcement +
                                                "}"};
    const Outcome outcome = run_deck(make_press_fit(2e-4), overrides);
    EXPECT_GT(outcome.summary.energy.contact, 10) << enforcement;
    EXPECT_THAT(list_rules(outcome), Not(Contains("contact_energy"))) << enforcement;
  }
}

TEST(FalseWarnings, AreNotGivenOfEnergiesOfTheFirstStepsOfARamp) {
  // A belt on a drum, whose load rises from 0: contact is most of the first 1e-12 of what becomes 1e-2.
  const std::string belt =
      "time: {end: 1.0e-3}\n"
      "parts:\n"
      "  drum: {tube: {inner_radius: 0.09, outer_radius: 0.1, length: 0.01, cells: [1, 24, 1], arc: 90}, material: s}\n"
      "  belt: {shell_tube: {radius: 0.10025, length: 0.01, cells: [24, 1], arc: 90}, thickness: 0.0005, material: m}\n"
      "materials:\n"
      "  m: {model: elastic, density: 1000, youngs_modulus: 2e9, poissons_ratio: 0}\n"
      "  s: {model: elastic, density: 8000, youngs_modulus: 20e9, poissons_ratio: 0.3}\n"
      "conditions:\n"
      "  - {nodes: drum, fixed: [x, y, z]}\n"
      "  - {nodes: belt, fixed: [z]}\n"
      "  - {nodes: belt/last, velocity: {x: {table: [[0, 0], [2e-3, -0.4], [8e-3, -0.4]]}}}\n"
      "loads: {nodal: [{nodes: belt/first, force: {y: {table: [[0, 0], [1e-3, -10], [8e-3, -10]]}}}]}\n"
      "contact: {surfaces: [[drum, belt]], friction: 0.3}\n";
  const Outcome outcome = run_deck(belt);
  EXPECT_GT(outcome.summary.energy.internal(), 1e-6);
  EXPECT_THAT(list_rules(outcome), Not(Contains("contact_energy")));
}

}  // namespace
}  // namespace percuss::test::false_warning_test
