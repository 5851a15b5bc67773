// A Taylor bar of Johnson-Cook steel: shape and temperature of two other codes.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "tests/verification/support/mapped_mesh.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::johnson_cook_test {

TEST(JohnsonCookTaylorBar, HasTheShapeAndTheTemperatureOfTwoCodes) {
  const int n = 2;
  const TemporaryFile file(
      testing_mesh::write_exodus(make_quarter_cylinder(3.2e-3, 32.4e-3, n, 20 * n), "johnson_cook.exo"));
  const Outcome run = run_deck(fmt::format(
      R"(
title: Taylor bar, Johnson-Cook steel
time: {{end: 80e-6}}
parts: {{bar: {{exodus: {{file: {}}}, material: steel}}}}
materials:
  steel: {{model: johnson_cook, density: 7830, youngs_modulus: 206.9e9, poissons_ratio: 0.3, a: 806e6, b: 614e6, n: 0.168, c: 0.0089, m: 1.1, specific_heat: 460, heating_share: 0.9, start_temperature: 20, room_temperature: 20, melt_temperature: 1540}}
initial: [{{part: bar, velocity: [0, 0, -287]}}]
conditions:
  - {{nodes: bar/x_plane, symmetry: x}}
  - {{nodes: bar/y_plane, symmetry: y}}
  - {{nodes: bar/foot, fixed: [z]}}
output:
  history:
    every: 1e-6
    nodes:
      - {{name: top, near: [0, 0, 32.4e-3]}}
      - {{name: foot, near: [3.2e-3, 0, 0]}}
      - {{name: diagonal, near: [2.263e-3, 2.263e-3, 0]}}
    elements: [{{name: middle, near: [0, 0, 0]}}]
)",
      file.path()));
  const HistoryTable& h = run.history;
  const double length = h.last("top_z"), axis = 2 * std::hypot(h.last("foot_x"), h.last("foot_y")),
               diagonal = 2 * std::hypot(h.last("diagonal_x"), h.last("diagonal_y")),
               hot = h.last("middle_temperature");
  fmt::print("length {:.3f} mm, foot {:.3f} and {:.3f} mm, {:.1f} C, plastic strain {:.3f}\n", 1e3 * length, 1e3 * axis,
             1e3 * diagonal, hot, h.last("middle_eps"));
  EXPECT_NEAR(length, 26.54e-3, 0.01 * 26.54e-3);
  EXPECT_NEAR(0.5 * (axis + diagonal), 11.185e-3, 0.03 * 11.185e-3);
  EXPECT_NEAR(hot, 589.5, 0.03 * 589.5);
}

}  // namespace percuss::test::johnson_cook_test
