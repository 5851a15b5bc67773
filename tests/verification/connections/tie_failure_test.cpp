// Ties that let go: in which step, by which stress, and what the surfaces do then.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "tests/verification/connections/pulled_block.hpp"

namespace percuss::test::tie_failure_test {
namespace {

std::string pull_block(const std::string& failure, const std::string& load) {
  return make_pulled_block(
      fmt::format("contact: {{surfaces: none, ties: [{{a: high/z_min, b: low/z_max{}}}]}}", failure), load);
}

constexpr double node_area = 0.25e-4;

}  // namespace

// (tension / 2e8)^2 + (shear / 8e7)^1.5 reaches 1; pressure adds nothing. Row n has the force at n - 1.
TEST(TieFailure, ComesInTheStepInWhichItsCriterionReachesOne) {
  const struct {
    const char* load;
    double pull, shear;  // force of a node per time
  } cases[] = {{"{z: {expression: 1e8 * t}}", 1e8, 0},
               {"{x: {expression: 6e7 * t}}", 0, 6e7},
               {"{x: {expression: -3e7 * t}, y: {expression: 4e7 * t}, z: {expression: 6e7 * t}}", 6e7, 5e7},
               {"{x: {expression: 6e7 * t}, z: {expression: -9e7 * t}}", -9e7, 6e7}};
  for (const auto& pulled : cases) {
    const Outcome run = run_deck(pull_block(", failure: {normal: 2e8, shear: 8e7, shear_exponent: 1.5}", pulled.load));
    const HistoryTable& history = run.history;
    const std::size_t failed = find_failure(history, "failed_ties");
    ASSERT_LT(failed, history.rows());
    for (std::size_t row = 1; row <= failed; ++row) {
      const double t = history["time"][row - 1], n = pulled.pull * t, s = pulled.shear * t;
      EXPECT_NEAR(history["fz:held"][row], -4 * n, 1e-9 * 5e3);
      const double reached = std::pow(std::max(n, 0.0) / node_area / 2e8, 2) + std::pow(s / node_area / 8e7, 1.5);
      EXPECT_EQ(reached >= 1, row == failed) << row;
    }
    EXPECT_EQ(history["failed_ties"][failed], 4);
    EXPECT_EQ(history.last("contacts"), 0);
    EXPECT_EQ(history.last("fz:held"), 0);
    const auto& warnings = run.summary.warnings;
    const auto told = std::find_if(warnings.begin(), warnings.end(),
                                   [](const Warning& warning) { return warning.rule == "tie_failure"; });
    ASSERT_NE(told, warnings.end());
    EXPECT_EQ(told->place.substr(told->place.find(':')), ":8:34");
  }
}

TEST(TieFailure, DoesNotComeOfPressureOrOfAStrengthThatIsNotGiven) {
  for (const char* load : {"{z: {expression: -1e9 * t}}", "{x: {expression: 1e9 * t}}"}) {
    const Outcome run = run_deck(pull_block(", failure: {normal: 2e8}", load));
    EXPECT_EQ(run.history.last("failed_ties"), 0);
    EXPECT_EQ(run.history.last("contacts"), 4);
  }
}

// A glued block is torn off and comes back: it bounces on the surface that it was tied to.
TEST(TieFailure, LeavesSurfacesInContact) {
  const Outcome run = run_deck(R"yaml(
time: {end: 4e-4, max_step: 3e-6}
parts:
  low: {box: {size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}, material: m}
  high: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [0, 0, 0.02], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
contact: {surfaces: all, ties: [{a: high/z_min, b: low/z_max, failure: {normal: 2e6}}]}
conditions:
  - {nodes: low/z_min, velocity: {z: 0}}
  - {nodes: high/z_max, velocity: {z: {table: [[0, 0], [1e-4, 2], [1.5e-4, 2], [2.5e-4, -3]]}}}
output: {history: {every: 0, forces: [{name: glue, contact: [high, low]}]}}
)yaml");
  const HistoryTable& history = run.history;
  EXPECT_EQ(history.last("failed_ties"), 16);
  double farthest_pull = 0, largest_push = 0;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    farthest_pull = std::min(farthest_pull, history["fz:glue"][row]);
    largest_push = std::max(largest_push, history["fz:glue"][row]);
  }
  EXPECT_LT(farthest_pull, -0.8 * 2e6 * 4e-4);  // of a uniform stress, which the corners' is above
  EXPECT_GT(farthest_pull, -1.2 * 2e6 * 4e-4);
  EXPECT_GT(largest_push, 1e6 * 4e-4);
  EXPECT_LT(history.largest("residual"), 1e-4);  // of a face edge: it does not go through
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// Meshes that do not match, turned, flush or overlapping by 0.02 of a face: the side of a node is that of its body,
// whatever round-off makes of the gap.
TEST(TieFailure, TellsTensionFromPressureWhereNodesLieInTheFaceOrBehindIt) {
  const auto press = [](double overlap, double speed) {
    const double z = 0.02 - overlap;
    return run_deck(fmt::format(R"yaml(
time: {{end: 2e-5}}
parts:
  low: {{box: {{size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}}, material: m, rotate: [{{axis: y, angle: 33}}]}}
  high: {{box: {{size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}}, material: m, rotate: [{{axis: y, angle: 33}}], at: [{}, 0, {}]}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}}}
contact: {{surfaces: all, ties: [{{a: high/z_min, b: low/z_max, failure: {{normal: 1e5}}}}]}}
initial: [{{part: high, velocity: [{}, 0, {}]}}]
output: {{history: {{every: 0}}}}
)yaml",
                                z * std::sin(33 * M_PI / 180), z * std::cos(33 * M_PI / 180),
                                speed * std::sin(33 * M_PI / 180), speed * std::cos(33 * M_PI / 180)));
  };
  for (const double overlap : {0.0, 1e-4}) {
    EXPECT_EQ(press(overlap, -2).history.last("failed_ties"), 0) << overlap;
    EXPECT_EQ(press(overlap, 2).history.last("failed_ties"), 16) << overlap;
  }
}

// A shell has the area of one side, also where its part is named.
TEST(TieFailure, CountsAShellOnce) {
  const auto pull = [](const char* side) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 4e-4, max_step: 1e-6}}
parts:
  low: {{box: {{size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}}, material: m}}
  plate: {{shell_plate: {{size: [0.02, 0.02], cells: [3, 3]}}, thickness: 0.002, at: [0, 0, 0.021], material: m}}
  flyer: {{box: {{size: [0.02, 0.02, 0.02], cells: [1, 1, 1]}}, at: [0, 1, 0], material: m}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}}}
contact: {{surfaces: all, ties: [{{a: {}, b: low/z_max, distance: 1e-4, failure: {{normal: 1e6}}}}]}}
conditions: [{{nodes: low, fixed: [x, y, z]}}]
initial: [{{part: flyer, velocity: [0, 0, 10]}}]
loads: {{pressure: [{{faces: plate/top, value: {{expression: "-4e9 * t"}}}}]}}
output: {{history: {{every: 0}}}}
)yaml",
                                             side));
    return run.history["time"][find_failure(run.history, "failed_ties")];
  };
  EXPECT_EQ(pull("plate"), pull("plate/bottom"));
  EXPECT_NEAR(pull("plate"), 2.5e-4, 1e-5);
}

// A block that overlaps another by 0.045 of a face slides off its tie and moves on into it: contact takes it up.
TEST(TieFailure, LeavesOverlapToContact) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-4, max_step: 1e-6}
parts:
  low: {box: {size: [0.04, 0.02, 0.02], cells: [4, 2, 2]}, material: m}
  high: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [0.003, 0, 0.0197], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
contact:
  surfaces: all
  ties: [{a: high/z_min, b: low/z_max, distance: 6e-4, failure: {shear: 1e5}}]
initial: [{part: high, velocity: [5, 0, -10]}]
output: {history: {every: 0, forces: [{name: push, contact: [high, low]}], nodes: [{name: foot, near: [0.013, 0.01, 0.0197], part: high}]}}
conditions: [{nodes: low/z_min, fixed: [x, y, z]}]
)yaml");
  EXPECT_EQ(run.history.last("failed_ties"), 16);
  EXPECT_GT(run.history.largest("fz:push"), 0.1 * 10 * 1e6 * 4e-4);  // of the force of two bars that meet at 10 m/s
  EXPECT_GT(run.history.last("foot_vz"), 0);                         // it comes back
}

// Two ties: only that which fails is named.
TEST(TieFailure, IsToldOfTheTieThatFails) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-4}
parts:
  low: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, material: m}
  high: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [0, 0, 0.02], material: m}
  low2: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, at: [1, 0, 0], material: m}
  high2: {box: {size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}, at: [1, 0, 0.02], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
contact:
  surfaces: all
  ties:
    - {a: high/z_min, b: low/z_max, failure: {normal: 1e9}}
    - {a: high2/z_min, b: low2/z_max, failure: {normal: 1e5}}
initial: [{part: high2, velocity: [0, 0, 2]}]
output: {history: {every: 0}}
)yaml");
  EXPECT_EQ(run.history.last("failed_ties"), 16);
  for (const Warning& warning : run.summary.warnings) {
    if (warning.rule != "tie_failure") continue;
    EXPECT_NE(warning.text.find("'high2/z_min' and 'low2/z_max'"), std::string::npos) << warning.text;
    EXPECT_EQ(warning.count, 16);
  }
}

TEST(TieFailure, NeedsFacesThatAreTiedWhole) {
  const std::string deck = R"yaml(
time: {end: 1e-4}
parts:
  block: {box: {size: [1, 4, 4], cells: [1, 2, 2]}, at: [-1, 0, -2], material: m}
  sheet: {shell_plate: {size: [2, 4], cells: [2, 3]}, thickness: 0.1, material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
contact: {ties: [{a: sheet, b: block/x_max, failure: {normal: 2e6}}]}
)yaml";
  try {
    run_deck(deck);
    ADD_FAILURE() << "an edge has an area";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("on no face of side a that is tied with all its corners"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace percuss::test::tie_failure_test
