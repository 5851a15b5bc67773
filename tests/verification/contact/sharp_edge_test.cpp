// Sharp edges of long elements do not pass between the nodes of a fine smooth body.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::sharp_edge_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A ball of radius 0.03 that comes to rest between the edges of two rigid bodies at x = -0.02 and 0.02. left, right:
/// their shapes.
std::string describe_ball(const std::string& left, const std::string& right, double height, const std::string& keys) {
  return fmt::format(R"(
time: {{end: 0.45}}
parts:
  ball: {{sphere: {{radius: 0.03, cells: 8}}, at: [0.003, 0, {}], material: m}}
  left: {{{}, material: s, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  right: {{{}, material: s, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
materials:
  m: {{model: elastic, density: 7800, youngs_modulus: 1e7, poissons_ratio: 0.3}}
  s: {{model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {{gravity: [0, 0, -9.81]}}
damping: [{{nodes: ball, coefficient: 10}}]
contact: {{surfaces: all, friction: 0.2{}}}
output: {{history: {{every: 2e-3, nodes: [{{name: c, near: [0.003, 0, {}], part: ball}}]}}}}
)",
                     height, left, right, keys, height);
}

}  // namespace

// Round rims of thickness t: the centre rests (r + t/2) from each. Facets lie inside the ball by 0.7 % of its radius.
TEST(SharpEdges, OfSheetsHoldABallBetweenItsNodes) {
  const std::string left = "shell_plate: {size: [0.1, 0.2], cells: [2, 4]}, thickness: 0.002, at: [-0.12, -0.1, 0]";
  const std::string right = "shell_plate: {size: [0.1, 0.2], cells: [2, 3]}, thickness: 0.002, at: [0.02, -0.1, 0]";
  const Outcome run = run_deck(describe_ball(left, right, 0.0315, ""));
  EXPECT_NEAR(run.history.last("c_z"), std::sqrt(0.031 * 0.031 - 0.02 * 0.02), 1.5e-3);
  EXPECT_NEAR(run.history.last("c_x"), 0, 1.5e-3);
}

// Edges of blocks: the centre rests r from each.
TEST(SharpEdges, OfBlocksHoldABallBetweenItsNodes) {
  const std::string left = "box: {size: [0.1, 0.2, 0.1], cells: [1, 3, 1]}, at: [-0.12, -0.1, -0.1]";
  const std::string right = "box: {size: [0.1, 0.2, 0.1], cells: [1, 2, 1]}, at: [0.02, -0.1, -0.1]";
  const Outcome run = run_deck(describe_ball(left, right, 0.0305, ""));
  EXPECT_NEAR(run.history.last("c_z"), std::sqrt(0.03 * 0.03 - 0.02 * 0.02), 1.5e-3);
  EXPECT_NEAR(run.history.last("c_x"), 0, 1.5e-3);
}

// The edge of a prism goes down by 0.03 between two rows of nodes of a flat soft face, 0.1 apart. Its ends are beyond
// the rims, which alone would bend: in the middle the line between the nodes goes down with it.
TEST(SharpEdges, PressOnTheMiddleOfAFlatFace) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.05}
parts:
  low: {box: {size: [0.5, 0.8, 0.2], cells: [5, 8, 2]}, at: [-0.25, -0.4, -0.2], material: m}
  prism: {box: {size: [0.3, 1.2, 0.3], cells: [1, 1, 1]}, rotate: [{axis: y, angle: -45, center: [0, 0, 0]}], at: [0, -0.6, 0.001], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
conditions:
  - {nodes: low/z_min, fixed: [x, y, z]}
  - {nodes: prism, displacement: {x: 0, y: 0, z: {table: [[0, 0], [0.04, -0.031], [0.05, -0.031]]}}}
contact: {surfaces: all}
output:
  history: {every: 1e-3, nodes: [{name: a, near: [-0.05, 0, 0], part: low}, {name: b, near: [0.05, 0, 0], part: low}]}
)yaml");
  EXPECT_NEAR(0.5 * (run.history.last("a_z") + run.history.last("b_z")), -0.03, 2e-3);
}

// Two bars cross edge on edge, each edge 0.1 long: the upper one falls by 0.01 and rests on the lower one. Both sides
// of an edge are triangles, or one is.
TEST(SharpEdges, OfTrianglesRestOnEachOther) {
  for (const char* const elements : {"tetrahedra", "wedges"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 0.15}}
parts:
  low: {{box: {{size: [0.3, 0.1, 0.1], cells: [3, 1, 1]}}, elements: {0}, rotate: [{{axis: x, angle: 45}}], at: [-0.16, 0, -0.141421356], material: m, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  high: {{box: {{size: [0.3, 0.1, 0.1], cells: [3, 1, 1]}}, elements: {0}, rotate: [{{axis: x, angle: 45}}, {{axis: z, angle: 90}}], at: [0, -0.16, 0.01], material: m, rigid: {{fixed: [x, y, rx, ry, rz]}}}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: all, restitution: 0}}
output: {{history: {{every: 5e-3, nodes: [{{name: a, near: [0, 0, 0.01], part: high}}]}}}}
)yaml",
                                             elements));
    EXPECT_NEAR(run.history.last("a_z"), 0, 1e-6) << elements;
  }
}

// A face warps until its corners are 0.025 above and below its middle, which stays at z = 0. Then the edge of a prism
// falls across the ridge, over the two low corners: it rests on the middle of the fan, where no node and no side of the
// face is, within the depth at which ridges touch (5e-3 of an element, 0.0005) and what gravity presses in.
TEST(SharpEdges, RestOnTheMiddleOfAWarpedFace) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.25}
parts:
  low: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, at: [0, 0, -0.1], material: m}
  prism: {box: {size: [0.3, 0.1, 0.1], cells: [1, 1, 1]}, rotate: [{axis: x, angle: 45, center: [0, 0, 0]}, {axis: z, angle: -45, center: [0, 0, 0]}], at: [-0.056066, 0.156066, 0.05], material: m, rigid: {fixed: [x, y, rx, ry, rz]}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -9.81]}
conditions:
  - {nodes: low/z_min, fixed: [x, y, z]}
  - {nodes: {name: low, inside: [[-0.01, -0.01, -0.01], [0.01, 0.01, 0.01]]}, displacement: {x: 0, y: 0, z: {table: [[0, 0], [0.02, 0.025]]}}}
  - {nodes: {name: low, inside: [[0.09, 0.09, -0.01], [0.11, 0.11, 0.01]]}, displacement: {x: 0, y: 0, z: {table: [[0, 0], [0.02, 0.025]]}}}
  - {nodes: {name: low, inside: [[0.09, -0.01, -0.01], [0.11, 0.01, 0.01]]}, displacement: {x: 0, y: 0, z: {table: [[0, 0], [0.02, -0.025]]}}}
  - {nodes: {name: low, inside: [[-0.01, 0.09, -0.01], [0.01, 0.11, 0.01]]}, displacement: {x: 0, y: 0, z: {table: [[0, 0], [0.02, -0.025]]}}}
contact: {surfaces: all}
output: {history: {every: 5e-3, nodes: [{name: a, near: [-0.056, 0.156, 0.05], part: prism}]}}
)yaml");
  EXPECT_NEAR(run.history.last("a_z"), 0, 5e-4);
}

// A corner is lowest, 1.4e-3 of an element outside the face of the block below: its nodes meet no face. Its edge, twice
// as long, crosses that of the block at 0.0007 of its length, and at 0.007 of that of the other: the body rests there,
// within the depth at which edges touch beside their ends (5e-3 of an element, 0.0005).
TEST(SharpEdges, RestOnEachOtherBesideTheEndsOfBoth) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.1}
parts:
  low: {box: {size: [0.2, 0.2, 0.1], cells: [1, 1, 1]}, at: [0, 0, -0.1], material: m, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  high: {box: {size: [0.2, 0.1, 0.1], cells: [1, 1, 1]}, rotate: [{axis: x, angle: 20, center: [0, 0, 0]}, {axis: y, angle: -1, center: [0, 0, 0]}], at: [-0.00014, 0.0014, 0.002], material: m, rigid: {fixed: [x, y, rx, ry, rz]}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: all, restitution: 0}
output: {history: {every: 5e-3, nodes: [{name: a, near: [-0.00014, 0.0014, 0.002], part: high}]}}
)yaml");
  EXPECT_NEAR(run.history.last("a_z"), 0, 1e-3);
}

namespace {

std::string find_missed(const Outcome& run) {
  const auto& warnings = run.summary.warnings;
  const auto told = std::find_if(warnings.begin(), warnings.end(),
                                 [](const Warning& warning) { return warning.rule == "missed_contact"; });
  return told == warnings.end() ? "nothing" : told->text;
}

/// What missed_contact says of a body that is moved by 0.05 into a block, over a gap of 0.01, in one step, and out of
/// it again at a time; neither gives way, so that no row acts.
std::string warn_of_missed(const std::string& high, double end, double out,
                           const std::string& low = "box: {size: [0.4, 0.4, 0.4], cells: [4, 4, 4]}") {
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}, max_step: 1.0e-6}}
parts:
  low: {{{}, material: m, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  high: {{{}, material: m}}
materials: {{m: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
conditions:
  - {{nodes: high, displacement: {{x: 0, y: 0, z: {{table: [[0, 0], [1.0e-5, 0], [1.0001e-5, -0.05], [{}, -0.05], [{}, 0]]}}}}}}
contact: {{surfaces: all}}
audit: {{max_energy_error: 10}}
)yaml",
                                           end, low, high, out, out + 1e-9));
  return find_missed(run);
}

/// What missed_contact says of a tube of four walls, the middle of one of which goes `by` towards the one opposite, 0.2
/// away.
std::string tell_folded(double by) {
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 3.0e-5, max_step: 1.0e-6}}
parts:
  tube: {{shell_box_tube: {{size: [0.2, 0.2], length: 0.2, cells: [2, 2, 2], closed: none}}, thickness: 0.002, material: m}}
materials: {{m: {{model: elastic, density: 7850, youngs_modulus: 1e6, poissons_ratio: 0.3}}}}
conditions:
  - {{nodes: {{name: tube, inside: [[-0.2, -0.2, -0.1], [0.2, 0.05, 0.3]]}}, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {{name: tube, inside: [[-0.2, 0.05, -0.1], [-0.05, 0.2, 0.3]]}}, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {{name: tube, inside: [[0.05, 0.05, -0.1], [0.2, 0.2, 0.3]]}}, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {{name: tube, inside: [[-0.05, 0.05, -0.1], [0.05, 0.2, 0.05]]}}, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {{name: tube, inside: [[-0.05, 0.05, 0.15], [0.05, 0.2, 0.3]]}}, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: {{name: tube, inside: [[-0.05, 0.05, 0.05], [0.05, 0.2, 0.15]]}}, displacement: {{x: 0, z: 0, y: {{table: [[0, 0], [1.0e-5, 0], [1.0001e-5, {}], [1, {}]]}}}}}}
contact: {{surfaces: all}}
audit: {{max_energy_error: 10}}
)yaml",
                                           -by, -by));
  return find_missed(run);
}

const std::string block = "box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, at: [0.11, 0.09, 0.41]";

}  // namespace

TEST(MissedContact, IsToldWithItsDepthAndPlace) {
  EXPECT_THAT(warn_of_missed(block, 3.0e-5, 1),
              HasSubstr("of part 'high' lies 0.04 (0.4 of an element) inside part 'low' at (0.11, 0.09, 0.36)"));
}

// The sharp edges of the block are found inside during the run.
TEST(MissedContact, IsToldWhereItHasGoneBeforeTheEnd) {
  EXPECT_THAT(
      warn_of_missed(block, 1.2e-4, 9.0e-5),
      AllOf(HasSubstr("an edge of part 'high' at node"), HasSubstr("lies 0.04 (0.4 of an element) inside part 'low'")));
}

// A rim, which half of the thickness of 0.004 brings nearer.
TEST(MissedContact, IsToldOfShellsInSolids) {
  const std::string plate = "shell_plate: {size: [0.2, 0.2], cells: [2, 2]}, thickness: 0.004, at: [0.11, 0.09, 0.41]";
  EXPECT_THAT(warn_of_missed(plate, 3.0e-5, 1), HasSubstr("lies 0.042 (0.42 of an element) inside part 'low'"));
}

// Smooth or sharp, of solids and of shells.
TEST(MissedContact, IsToldOfWhatHasGoneThroughASheet) {
  const std::string sheet = "shell_plate: {size: [0.4, 0.4], cells: [4, 4]}, thickness: 0.004, at: [0, 0, 0.4]";
  EXPECT_THAT(warn_of_missed(block, 3.0e-5, 1, sheet),
              AllOf(HasSubstr("an edge of part 'high' at node"),
                    HasSubstr("has gone 0.04 (0.4 of an element) through part 'low'")));
  const std::string ball = "shell_sphere: {radius: 0.1, cells: 3}, thickness: 0.004, at: [0.21, 0.19, 0.503]";
  EXPECT_THAT(warn_of_missed(ball, 3.0e-5, 1, sheet), HasSubstr("has gone"));
  const std::string beside = "box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, at: [0.405, 0.09, 0.41]";
  EXPECT_EQ(warn_of_missed(beside, 3.0e-5, 1, sheet), "nothing");
}

TEST(MissedContact, IsToldOfABodyThatHasGoneThroughItself) {
  EXPECT_THAT(tell_folded(0.27), HasSubstr("has gone 0.07 (0.7 of an element) through its own part"));
  EXPECT_EQ(tell_folded(0.16), "nothing");
}

}  // namespace percuss::test::sharp_edge_test
