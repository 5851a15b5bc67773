// Rigid walls and the thickness of shells.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// A plate that flies onto a wall at z = 0.
std::string write_plate(double height, const std::string& wall) {
  return fmt::format(R"yaml(
time: {{end: 1}}
parts: {{plate: {{shell_plate: {{size: [0.1, 0.1], cells: [4, 4]}}, thickness: 0.004, at: [0, 0, {:.17g}], material: steel}}}}
initial: [{{velocity: [0, 0, -10]}}]
walls: [{{normal: z{}}}]
)yaml",
                     height, wall) +
         steel_text;
}

double find_lowest(const std::string& deck, int steps) {
  Scene scene(deck);
  EXPECT_EQ(scene.contact.prepare(scene.state.x, scene.state.v), "");
  scene.stepper.start(scene.state);
  double lowest = INFINITY;
  for (int i = 0; i < steps; ++i) {
    scene.stepper.advance(scene.state);
    for (std::size_t n = 0; n < 25; ++n) lowest = std::min(lowest, scene.state.x(n, 2));
  }
  EXPECT_GT(scene.state.v(0, 2), -1);  // it was stopped
  return lowest;
}

}  // namespace

TEST(WallThickness, SeenKeepsNodesHalfAThicknessAway) {
  EXPECT_NEAR(find_lowest(write_plate(0.00205, ", thickness: included"), 40), 0.002, 1e-8);
}

TEST(WallThickness, IgnoredLetsThemComeToTheMesh) {
  EXPECT_NEAR(find_lowest(write_plate(0.00005, ""), 40), 0, 1e-8);
  EXPECT_NEAR(find_lowest(write_plate(0.00005, ", thickness: ignored"), 40), 0, 1e-8);
}

TEST(WallThickness, ActsFromTheSideOfTheBodies) {
  // The wall above: its normal points down.
  const std::string deck = fmt::format(R"yaml(
time: {{end: 1}}
parts: {{plate: {{shell_plate: {{size: [0.1, 0.1], cells: [4, 4]}}, thickness: 0.004, at: [0, 0, -0.00205], material: steel}}}}
initial: [{{velocity: [0, 0, 10]}}]
walls: [{{normal: -z, thickness: included}}]
)yaml") + steel_text;
  Scene scene(deck);
  scene.run(40);
  for (std::size_t n = 0; n < 25; ++n) EXPECT_LT(scene.state.x(n, 2), -0.002 + 1e-8);
}

TEST(WallThickness, SolidsBesideShellsHaveNone) {
  const std::string deck = R"yaml(
time: {end: 1}
parts:
  plate: {shell_plate: {size: [0.1, 0.1], cells: [4, 4]}, thickness: 0.004, at: [0, 0, 0.00205], material: steel}
  block: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0, 0.2, 0.00005], material: steel}
initial: [{velocity: [0, 0, -10]}]
walls: [{normal: z, thickness: included}]
)yaml" + steel_text;
  Scene scene(deck);
  scene.run(0);
  double plate = INFINITY, block = INFINITY;
  for (int i = 0; i < 40; ++i) {
    scene.stepper.advance(scene.state);
    for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
      double& lowest = scene.chunked.mesh.nodes[n][1] < 0.15 ? plate : block;
      lowest = std::min(lowest, scene.state.x(n, 2));
    }
  }
  EXPECT_GT(plate, 0.002 - 1e-8);
  EXPECT_NEAR(block, 0, 1e-8);  // solids have no offset
}

TEST(WallThickness, OverlapAtTheStartIsTold) {
  Scene scene(write_plate(0.0005, ", thickness: included"));
  EXPECT_THAT(scene.contact.prepare(scene.state.x, scene.state.v),
              testing::AllOf(testing::HasSubstr("25 contact nodes overlap a wall at the start, deepest 0.0015"),
                             testing::HasSubstr("accepted as the reference")));
}

}  // namespace percuss::test
