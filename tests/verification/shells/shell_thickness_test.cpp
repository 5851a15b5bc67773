// Shells of one part that differ in thickness: mass, tension, bending, and where contact begins.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::shell_thickness_test {
namespace {

constexpr double thin = 0.04, thick = 0.08;

/// A strip of length 2 and width 0.25 along x, half of it thin, that hangs at x = 0 and comes to rest.
std::string describe_strip(double end, double damping, const std::string& load, const std::string& held) {
  return fmt::format(R"yaml(
time: {{end: {}}}
parts:
  strip: {{shell_plate: {{size: [2, 0.25], cells: [16, 2]}}, thickness: {{expression: "x < 1 ? 0.08 : 0.04"}}, material: m}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}}}
conditions: [{{nodes: strip/x_min, fixed: [{}]}}]
damping: [{{coefficient: {}}}]
loads: {{nodal: [{}]}}
output: {{history: {{every: {}, nodes: [{{name: middle, near: [1, 0.125, 0]}}, {{name: tip, near: [2, 0.125, 0]}}]}}}}
)yaml",
                     end, held, damping, load, end / 100);
}

}  // namespace

TEST(ThicknessOfElements, GivesTheirMass) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-3}
parts: {p: {shell_plate: {size: [2, 1], cells: [4, 2]}, thickness: {expression: "x < 1 ? 0.1 : 0.3"}, material: m}}
materials: {m: {model: elastic, density: 3, youngs_modulus: 1, poissons_ratio: 0.3}}
initial: [{part: p, velocity: [0, 0, 2]}]
output: {history: {every: 0}}
)yaml");
  EXPECT_NEAR(run.history.last("momentum_z"), 2 * 3 * (0.1 + 0.3), 1e-14);
  EXPECT_NEAR(run.history.last("kinetic"), 0.5 * 4 * 3 * (0.1 + 0.3), 1e-13);
}

// N = E b t e: with the same force the thin half stretches twice as much. The load of 1e-6 E is small: the strain of
// Hencky and the engineer's differ by it.
TEST(ThicknessOfElements, StretchesInProportion) {
  const double force = 1e-7;  // on each of three nodes, half of it on those of the edges
  const std::string load = fmt::format(
      "{{nodes: {{name: strip/x_max, inside: [[1.9, 0.1, -1], [2.1, 0.15, 1]]}}, force: {{x: {}}}}}, "
      "{{nodes: {{name: strip/x_max, inside: [[1.9, -0.1, -1], [2.1, 0.05, 1]]}}, force: {{x: {}}}}}, "
      "{{nodes: {{name: strip/x_max, inside: [[1.9, 0.2, -1], [2.1, 0.3, 1]]}}, force: {{x: {}}}}}",
      2 * force, force, force);
  const Outcome run = run_deck(describe_strip(60, 1.5, load, "x, y, z, rx, ry, rz"));
  const double all = 4 * force, near = all / (0.25 * thick), far = all / (0.25 * thin);
  EXPECT_NEAR(run.history.last("middle_x") - 1, near, 1e-4 * near);
  EXPECT_NEAR(run.history.last("tip_x") - run.history.last("middle_x") - 1, far, 1e-4 * far);
}

// A moment M at the end: curvature 12 M / (E b t^3), eight times as much in the thin half.
TEST(ThicknessOfElements, BendsByItsCube) {
  const double moment = 1e-9;
  const std::string load = fmt::format(
      "{{nodes: {{name: strip/x_max, inside: [[1.9, 0.1, -1], [2.1, 0.15, 1]]}}, moment: {{y: {}}}}}, "
      "{{nodes: {{name: strip/x_max, inside: [[1.9, -0.1, -1], [2.1, 0.05, 1]]}}, moment: {{y: {}}}}}, "
      "{{nodes: {{name: strip/x_max, inside: [[1.9, 0.2, -1], [2.1, 0.3, 1]]}}, moment: {{y: {}}}}}",
      -2 * moment, -moment, -moment);
  const Outcome run = run_deck(describe_strip(1500, 0.025, load, "x, y, z, rx, ry, rz"));
  const auto curvature = [&](double t) { return 12 * 4 * moment / (0.25 * t * t * t); };
  const double middle = 0.5 * curvature(thick), tip = middle + curvature(thick) + 0.5 * curvature(thin);
  EXPECT_NEAR(run.history.last("middle_z"), middle, 1e-3 * middle);
  EXPECT_NEAR(run.history.last("tip_z"), tip, 1e-3 * tip);
}

// Sheets of 0.01 that fall on a plate, thin on one side: each stops at half of both thicknesses.
TEST(ThicknessOfElements, KeepsOthersOffByHalfOfIt) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.06}
parts:
  plate: {shell_plate: {size: [2, 1], cells: [8, 4]}, thickness: {expression: "x < 1 ? 0.02 : 0.06"}, material: m}
  left: {shell_plate: {size: [0.4, 0.4], cells: [2, 2]}, thickness: 0.01, at: [0.3, 0.3, 0.05], material: m}
  right: {shell_plate: {size: [0.4, 0.4], cells: [2, 2]}, thickness: 0.01, at: [1.3, 0.3, 0.05], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0}}
initial: [{part: left, velocity: [0, 0, -1]}, {part: right, velocity: [0, 0, -1]}]
conditions: [{nodes: plate, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, enforcement: kinematic}
output: {history: {every: 0, nodes: [{name: a, near: [0.5, 0.5, 0.05]}, {name: b, near: [1.5, 0.5, 0.05]}]}}
)yaml");
  EXPECT_NEAR(run.history.smallest("a_z"), 0.5 * (0.01 + 0.02), 1e-4);
  EXPECT_NEAR(run.history.smallest("b_z"), 0.5 * (0.01 + 0.06), 1e-4);
}

}  // namespace percuss::test::shell_thickness_test
