// Thick shells, one through the thickness, against theories of plates and published values.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::thick_shell_test {
namespace {

/// Deflection of the tip over that of a plate in cylindrical bending under its weight. length: of an element over its
/// thickness, of which there are ten.
double bend_strip(double length, double poisson, const std::string& integration) {
  const double strip = 10 * length, gravity = 1e-3 / std::pow(strip, 3);
  const Outcome run = run_deck(fmt::format(R"(
title: cantilever of thick shells
time: {{end: 1e-9, max_steps: 1}}
parts: {{strip: {{box: {{size: [{0}, {1}, 1], cells: [10, 1, 1]}}, material: steel, {2}}}}}
materials: {{steel: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: {3}}}}}
loads: {{gravity: [0, 0, -{4:.17g}]}}
conditions:
  - {{nodes: strip/x_min, fixed: [x]}}
  - {{nodes: {{inside: [[0, -1, -0.1], [0, 1e9, 0.1]]}}, fixed: [z]}}
  - {{nodes: strip/y_min, symmetry: y}}
  - {{nodes: strip/y_max, symmetry: y}}
start: {{relaxation: {{tolerance: 1e-10, max_steps: 1000000}}}}
output: {{history: {{every: 1, nodes: [{{name: tip, near: [{0}, 0, 0]}}]}}}}
silence: [single_layer]
)",
                                           strip, length, integration, poisson, gravity));
  const double rigidity = 1 / (12 * (1 - poisson * poisson));
  return -run.history["tip_z"][0] / (gravity * std::pow(strip, 4) / (8 * rigidity));
}

}  // namespace

TEST(ThickShell, CantileverBendsAsAPlate) {
  // Thinner ones need more damped steps; thick_shell_statics_test.cpp has them without steps.
  constexpr double length = 10;
  const double ratio = bend_strip(length, 0.3, "integration: thick_shell");
  fmt::print("elements {} times as long as thick: {:.4f} of the plate's deflection\n", length, ratio);
  EXPECT_NEAR(ratio, 1, 0.01);
}

}  // namespace percuss::test::thick_shell_test
