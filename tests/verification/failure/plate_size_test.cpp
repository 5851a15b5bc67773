// A plate of three meshes that a punch goes through: with failure strains over the size of elements the speed behind it
// is that of all three.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::plate_size_test {
namespace {

/// Speed [m/s] of the punch behind the plate, of cells with this edge [mm].
double find_residual(double cell, double speed, const std::string& failure) {
  const Outcome run = run_deck(fmt::format(R"(
title: a punch goes through a plate, a quarter of both
units: mm, t, s
time: {{end: 6e-5}}
parts:
  plate: {{box: {{size: [24, 24, 6], cells: [{0:.0f}, {0:.0f}, {1:.0f}]}}, material: plate}}
  punch: {{box: {{size: [6, 6, 24], cells: [6, 6, 24]}}, at: [0, 0, 6.01], material: punch}}
materials:
  plate: {{model: johnson_cook, density: 7.85e-9, youngs_modulus: 200e3, poissons_ratio: 0.33, a: 490, b: 383, n: 0.45, c: 0.0114, reference_rate: 5e-4, m: 0.94, specific_heat: 452e6, heating_share: 0.9, melt_temperature: 1800, room_temperature: 293, start_temperature: 293, failure: {{{2}, inverted: true}}}}
  punch: {{model: elastic, density: 7.85e-9, youngs_modulus: 200e3, poissons_ratio: 0.3}}
initial: [{{part: punch, velocity: [0, 0, {3}]}}]
conditions:
  - {{nodes: {{inside: [[0, -1, -1], [0, 99, 99]]}}, symmetry: x}}
  - {{nodes: {{inside: [[-1, 0, -1], [99, 0, 99]]}}, symmetry: y}}
  - {{nodes: plate/x_max, fixed: [x, y, z]}}
  - {{nodes: plate/y_max, fixed: [x, y, z]}}
contact: {{surfaces: all}}
erosion: {{free_nodes: remove}}
output: {{history: {{every: 1e-6, parts: [punch]}}}}
)",
                                           24 / cell, 6 / cell, failure, -1e3 * speed));
  return -1e-3 * run.history.last("momentum_z:punch") / run.history.last("mass:punch");
}

// The factors are fitted at 400 m/s, 500 m/s is left to them.
TEST(PlateOfThreeMeshes, LeavesOneSpeedWhereTheFailureStrainDependsOnTheSize) {
  const std::string sizes = "plastic_strain: 1, size: [[1, 1], [1.5, 0.86], [2, 0.7]]", one = "plastic_strain: 1";
  for (const double speed : {400.0, 500.0}) {
    std::vector<double> found;
    for (const double cell : {2.0, 1.5, 1.0}) found.push_back(find_residual(cell, speed, sizes));
    const double without = find_residual(2, speed, one);
    fmt::print(
        "{} m/s: {:.1f}, {:.1f} and {:.1f} m/s behind cells of 2, 1.5 and 1 mm; {:.1f} of 2 mm with one strain\n",
        speed, found[0], found[1], found[2], without);
    const auto [least, most] = std::minmax_element(found.begin(), found.end());
    EXPECT_LT(*most, 1.05 * *least) << speed;
    EXPECT_GT(*least, 0.4 * speed) << speed;
    EXPECT_LT(without, 0.9 * *least) << speed;
  }
}

}  // namespace
}  // namespace percuss::test::plate_size_test
