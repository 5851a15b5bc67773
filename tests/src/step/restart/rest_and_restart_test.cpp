// What rests in a relaxation and wakes in the run, what a run that continues still warns of, and what its summary keeps
// of the runs before it.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string replace(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Summary run(const std::string& deck, const std::string& folder, bool goes_on = false) {
  RunOptions options;
  options.out_dir = folder;
  if (goes_on) options.restart = folder + "/checkpoint.h5";
  options.goes_on_in_place = options.may_remove_results = goes_on;
  return run_scene(parse_deck(deck, "deck.yaml"), options).summary;
}

/// A run of so many steps, and one that continues from there.
Summary run_in_two(const std::string& deck, int steps, const std::string& folder) {
  run(replace(deck, "time: {", fmt::format("time: {{max_steps: {}, ", steps)), folder);
  return run(deck, folder, true);
}

using testing::HasSubstr;
constexpr const char* computes_all = "elements: {skip_resting: false}\n";

// A plate that nothing loads rests in the relaxation, until a ball strikes it. Chunks of the plate are neighbours.
const std::string struck_plate = R"yaml(
time: {end: 3.0e-5}
start: {relaxation: {}}
parts:
  plate: {box: {size: [0.1, 0.1, 0.02], cells: [5, 5, 1]}, elements: KIND, material: alloy}
  ball: {sphere: {radius: 0.01, cells: 4}, at: [0.08, 0.05, 0.0305], material: alloy}
materials: {alloy: {model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33}}
initial: [{part: ball, velocity: [0, 0, -100]}]
contact: {surfaces: all}
output: {history: {every: 0}, checkpoint: {every: 1}}
)yaml";

// An edge goes through a sheet, and two blocks begin inside one another: edges are not checked.
const std::string pierced_sheet = R"yaml(
time: {end: 1.8e-3, max_step: 5.0e-5}
parts:
  low: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [5, 0, 0], material: steel}
  top: {box: {size: [0.8, 0.8, 1], cells: [1, 1, 1]}, at: [5.1, 0.1, 0.99], material: steel}
  lying: {shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.01, material: steel}
  standing: {shell_plate: {size: [2, 1], cells: [1, 1]}, rotate: [{axis: x, angle: 90}], at: [-0.5, 0.5, 0.02], thickness: 0.01, material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{part: standing, velocity: [0, 0, -100]}]
contact: {surfaces: all, edges: false}
output: {history: {every: 0}, checkpoint: {every: 1}}
)yaml";

// Two bars of which nodes at the ends are rigid bodies, much lighter than the masses that a relaxation gives the
// others.
const std::string linked_bars = R"yaml(
time: {end: 1.0e-5}
start: {relaxation: {tolerance: 1.0e-4, ramp: 50}}
parts:
  a: {box: {size: [0.1, 0.02, 0.02], cells: [10, 2, 2]}, material: steel}
  b: {box: {size: [0.1, 0.02, 0.02], cells: [40, 2, 2]}, at: [0.1, 0, 0], material: steel}
  mass: {box: {size: [0.1, 0.1, 0.1], cells: [2, 1, 1]}, at: [0, 0.1, 0], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
rigid_sets: {end_a: {nodes: a/x_max}, end_b: {nodes: b/x_min}}
joints: {pin: {kind: spherical, bodies: [end_a, end_b], at: [0.1, 0.01, 0.01]}}
conditions: [{nodes: a/x_min, fixed: [x, y, z]}, {nodes: b/x_max, fixed: [x, y, z]}, {nodes: mass/x_min, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -9.81]}
output: {history: {every: 0, forces: [{name: left, support: a/x_min}, {name: right, support: b/x_max}]}}
)yaml";

}  // namespace

/// Expects that the run skips elements, if it may, and ends as one that computes all, and as one that is stopped after
/// two steps.
void expect_same_bits(const std::string& deck, bool skips = true) {
  const TemporaryFolder skipping, computing, parts;
  const Summary some = run(deck, skipping.path()), all = run(computes_all + deck, computing.path());
  EXPECT_EQ(some.state_hash, all.state_hash) << deck;
  EXPECT_EQ(read_file(skipping.path() + "/history.csv"), read_file(computing.path() + "/history.csv")) << deck;
  EXPECT_EQ(run_in_two(deck, 2, parts.path()).state_hash, all.state_hash) << deck;
  if (skips) EXPECT_GT(some.skipped.chunk_updates, all.skipped.chunk_updates) << deck;
}

TEST(Rest, OfARelaxationEndsWhereTheRunWakesItWithTheSameBits) {
  for (const char* kind : {"hexahedra", "tetrahedra", "wedges", "pyramids"})
    expect_same_bits(replace(struck_plate, "KIND", kind));
}

TEST(Rest, OfARelaxationLeavesTheBoundsThatMassScalingReads) {
  const std::string deck =
      replace(struck_plate, "end: 3.0e-5", "end: 6.0e-5, mass_scaling: {step: 4.0e-6, max_added: 200, every: 1}");
  for (const char* kind : {"hexahedra", "tetrahedra"}) expect_same_bits(replace(deck, "KIND", kind), false);
}

TEST(Relaxation, OfLightRigidBodiesThatHoldElementsComesToRestUnderTheirWeight) {
  const TemporaryFolder folder;
  const Summary summary = run(linked_bars, folder.path());
  EXPECT_EQ(summary.relaxation.state, "settled");
  const Outcome outcome = run_deck(linked_bars);
  const double weight = 2 * 0.1 * 0.02 * 0.02 * 7850 * 9.81;
  const double held = outcome.history["fz:left"][1] + outcome.history["fz:right"][1];
  EXPECT_NEAR(held, weight, 0.02 * weight);  // which round-off of the rest still moves
}

TEST(Relaxation, OfAJointThatNothingSupportsNamesIt) {
  const std::string deck = replace(replace(replace(linked_bars, "{nodes: a/x_min, fixed: [x, y, z]}, ", ""),
                                           "{nodes: b/x_max, fixed: [x, y, z]}, ", ""),
                                   "9.81", "9.81e9");
  const std::string free =
      replace(deck, ", forces: [{name: left, support: a/x_min}, {name: right, support: b/x_max}]", "");
  try {
    run(free, "");
    ADD_FAILURE() << "no refusal";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("of joint 'pin' has moved"));
    EXPECT_THAT(error.what(), HasSubstr("start.relaxation.hold"));
  }
}

TEST(Restart, WarnsOfMissedContactAsTheRunThatNeverStopped) {
  const TemporaryFolder whole, parts;
  const Summary expected = run(pierced_sheet, whole.path());
  const auto has_missed = [](const Summary& summary) {
    return std::any_of(summary.warnings.begin(), summary.warnings.end(),
                       [](const Warning& warning) { return warning.rule == "missed_contact"; });
  };
  ASSERT_TRUE(has_missed(expected));
  const Summary found = run_in_two(pierced_sheet, 20, parts.path());
  ASSERT_EQ(found.warnings.size(), expected.warnings.size());
  for (std::size_t i = 0; i < found.warnings.size(); ++i) {
    EXPECT_EQ(found.warnings[i].text, expected.warnings[i].text);
    EXPECT_EQ(found.warnings[i].time, expected.warnings[i].time);
    EXPECT_EQ(found.warnings[i].count, expected.warnings[i].count);
  }
}

TEST(Restart, KeepsTheCostOfTheRunsBefore) {
  const std::string deck = replace(struck_plate, "KIND", "hexahedra");
  const TemporaryFolder folder;
  const auto until = [&](int steps) { return replace(deck, "time: {", fmt::format("time: {{max_steps: {}, ", steps)); };
  const Summary first = run(until(4), folder.path());
  const Summary second = run(until(6), folder.path(), true);
  const Summary third = run(deck, folder.path(), true);
  EXPECT_EQ(first.earlier.runs, 0);
  EXPECT_EQ(second.earlier.runs, 1);
  EXPECT_EQ(second.earlier.steps, 4);
  EXPECT_EQ(third.earlier.runs, 2);
  EXPECT_EQ(third.earlier.steps, 6);
  EXPECT_EQ(second.earlier.setup_s, first.setup_s);
  EXPECT_DOUBLE_EQ(third.earlier.setup_s, first.setup_s + second.setup_s);
  EXPECT_GT(second.earlier.loop_s, 0);
  EXPECT_GT(third.earlier.loop_s, second.earlier.loop_s);
  EXPECT_GT(third.earlier.phases_s.internal_force, second.earlier.phases_s.internal_force);
  EXPECT_EQ(read_summary(folder.path() + "/summary.json").earlier.runs, 2);
}

TEST(Restart, WithNothingLeftKeepsTheSummary) {
  const TemporaryFolder folder;
  const std::string deck = replace(struck_plate, "KIND", "hexahedra"), path = folder.path() + "/summary.json";
  run(deck, folder.path());
  const std::string summary = read_file(path), ranks = read_file(folder.path() + "/ranks.csv");
  ASSERT_THAT(summary, HasSubstr("completed"));
  run(deck, folder.path(), true);
  EXPECT_EQ(read_file(path), summary);
  EXPECT_EQ(read_file(folder.path() + "/ranks.csv"), ranks);
  std::ofstream(path) << "{}";  // not one of this state
  run(deck, folder.path(), true);
  EXPECT_THAT(read_file(path), HasSubstr("completed"));
}

}  // namespace percuss::test
