// The energy balance at every step, from the first on.

#include "src/step/audit/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// Largest energy error at any of the first steps.
double find_largest_error(const std::string& text, int steps) {
  Scene scene(text + steel_text);
  Audit audit(scene.model);
  if (scene.contact.is_active()) scene.contact.prepare(scene.state.x, scene.state.v);
  scene.stepper.start(scene.state);
  double largest = std::abs(audit(scene.state).energy.error);
  for (int i = 0; i < steps; ++i) {
    scene.stepper.advance(scene.state);
    largest = std::max(largest, std::abs(audit(scene.state).energy.error));
  }
  return largest;
}

}  // namespace

// From rest all energy is what the forces of the first half steps give: nothing hides an error of these.
TEST(Audit, ABlockFallsFromRestWithoutErrorAtTheFirstStep) {
  EXPECT_LT(find_largest_error(R"(
time: {end: 1}
parts: {a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}}
loads: {gravity: [0, 0, -10]}
)",
                               20),
            1e-6);  // rounding moves the step bound, and the energy with the step
}

TEST(Audit, APileComesToRestUnderGravityWithoutErrorFromTheFirstStepOn) {
  // Bricks on a rigid wall, friction and all; what is left is the error of the elements' trapezoid in small strains.
  EXPECT_LT(find_largest_error(R"(
time: {end: 1}
parts: {a: {box: {size: [0.2, 0.1, 0.06], cells: [2, 1, 1]}, array: {count: [1, 1, 3], pitch: [0.2, 0.1, 0.06]}, material: steel}}
loads: {gravity: [0, 0, -10]}
walls: [{normal: z, friction: 0.6}]
contact: {friction: 0.6}
)",
                               400),
            1e-6);
}

}  // namespace percuss::test
