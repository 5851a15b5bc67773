// A Taylor bar of Johnson-Cook steel: shape and temperature of two other codes. Heat of plastic work against its closed
// form where the volume changes.

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

namespace {

/// A cube of perfectly plastic metal that is pulled or pushed along x to a volume of `volume`, held across. kind: how
/// its elements are given. Returns how much warmer it is.
double find_rise(const std::string& kind, double volume) {
  const Outcome run = run_deck(fmt::format(R"(
title: cube of uniaxial strain
time: {{end: 1e-3}}
parts: {{cube: {{box: {{size: [1e-3, 1e-3, 1e-3], cells: [1, 1, 1]}}, material: metal{}}}}}
materials:
  metal: {{model: johnson_cook, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3, a: 100e6, b: 0, n: 1, melt_temperature: 1e9, room_temperature: 293, start_temperature: 293, specific_heat: 400, heating_share: 1}}
conditions:
  - {{nodes: cube, velocity: {{y: 0, z: 0}}}}
  - {{nodes: cube/x_min, fixed: [x]}}
  - {{nodes: cube/x_max, velocity: {{x: {:g}}}}}
output: {{history: {{every: 1e-5, elements: [{{name: e, near: [5e-4, 5e-4, 5e-4]}}]}}}}
)",
                                           kind, volume - 1));
  return run.history.last("e_temperature") - 293;
}

}  // namespace

// A unit of mass takes J s dp / rho0, with dp = (2/3) dJ / J from the yield on: its work is linear in J.
TEST(HeatOfPlasticWork, IsThatOfAUnitOfMassWhereTheVolumeChanges) {
  constexpr double yield = 100e6, heat = 8000 * 400, shear = 200e9 / 2.6;
  for (const char* kind : {"", ", integration: full", ", integration: thick_shell", ", elements: tetrahedra",
                           ", elements: wedges", ", elements: pyramids"}) {
    for (const double volume : {2.0, 0.6}) {
      const double at_yield = std::exp((volume > 1 ? 0.5 : -0.5) * yield / shear);
      const double right = 2.0 / 3.0 * yield * std::abs(volume - at_yield) / heat;
      EXPECT_NEAR(find_rise(kind, volume), right, 3e-3 * right) << kind << " " << volume;
    }
  }
}

}  // namespace percuss::test::johnson_cook_test
