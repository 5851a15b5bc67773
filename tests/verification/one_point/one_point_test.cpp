// Wedges and pyramids in whole runs: spins, a wave in a bar, the Taylor bar, drops onto each other, failure.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/support/taylor_bar.hpp"

namespace percuss::test::one_point_test {
namespace {

TEST(OnePointSolids, ThatSpinFreelyKeepTheirMomentumAndEnergy) {
  for (const char* elements : {"wedges", "pyramids"}) {
    const Outcome run = run_deck(fmt::format(R"(
title: spinning block
time: {{end: 2e-3}}
parts: {{block: {{box: {{size: [0.1, 0.06, 0.04], cells: [5, 3, 2]}}, elements: {}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
initial: [{{part: block, velocity: [1, 2, 3], angular_velocity: [300, 2000, 500]}}]
output: {{history: {{every: 1e-4}}}}
)",
                                             elements));
    EXPECT_LT(run.summary.momentum.linear_error, 1e-13) << elements;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-13) << elements;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-5) << elements;
  }
}

/// Speed of a wave in a bar of such elements whose sides do not move sideways.
double measure_speed(const std::string& elements) {
  HistoryTable history = run_deck(fmt::format(R"(
title: bar with rollers
time: {{end: 1.9e-4, max_step: 5e-7}}
parts: {{bar: {{box: {{size: [1, 0.02, 0.02], cells: [100, 2, 2]}}, elements: {}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
conditions:
  - {{nodes: bar/x_min, velocity: {{x: 1}}}}
  - {{nodes: bar, fixed: [y, z]}}
output: {{history: {{nodes: [{{name: a, near: [0.25, 0, 0]}}, {{name: b, near: [0.75, 0, 0]}}]}}}}
)",
                                              elements))
                             .history;
  return 0.5 / (history.time_of_rise("b_vx", 0.5) - history.time_of_rise("a_vx", 0.5));
}

TEST(OnePointSolids, CarryAWaveAtTheDilatationalSpeed) {
  const double c = std::sqrt(200e9 * 0.7 / (1.3 * 0.4 * 7850));
  for (const char* elements : {"wedges", "pyramids"}) {
    const double speed = measure_speed(elements);
    fmt::print("{}: speed {:.1f} of {:.1f} m/s\n", elements, speed, c);
    // The averages slow short waves, so that the front spreads: half of one of 50 elements.
    EXPECT_NEAR(speed, c, 1e-2 * c) << elements;
  }
}

TEST(OnePointSolids, AsWedgesMakeTheTaylorBarOfTheReference) {
  const auto run = [](int n) { return run_taylor_bar(n, TaylorFoot::held, "{}", TaylorCells::wedges); };
  const TaylorShape coarse = run(1), fine = run(2);
  EXPECT_LT(std::abs(fine.length - taylor_length), std::abs(coarse.length - taylor_length));
  EXPECT_NEAR(fine.length, taylor_length, 0.01 * taylor_length);
  EXPECT_NEAR(fine.mean_foot(), taylor_radius, 0.05 * taylor_radius);
  EXPECT_LT(fine.energy_error, 2e-3);
}

TEST(OnePointSolids, FallOnEachOtherAndOnHexahedra) {
  const Outcome run = run_deck(R"(
title: a ball of pyramids and a rod of wedges on a plate of wedges and hexahedra
time: {end: 6e-5}
parts:
  ball: {sphere: {radius: 0.01, cells: 6}, elements: pyramids, at: [0, 0, 0.0161], material: copper}
  rod: {cylinder: {radius: 0.004, length: 0.01, cells: [6, 6]}, elements: wedges, at: [0.0305, 0, 0.0062], axis: [0.1, 0, 1], material: copper}
  plate: {box: {size: [0.04, 0.04, 0.006], cells: [10, 10, 2]}, elements: wedges, at: [-0.02, -0.02, 0], material: copper}
  next: {box: {size: [0.02, 0.04, 0.006], cells: [5, 10, 2]}, at: [0.0201, -0.02, 0], material: copper}
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 200e6, hardening_modulus: 300e6}
initial: [{part: ball, velocity: [0, 0, -150]}, {part: rod, velocity: [0, 0, -150]}]
walls: [{normal: z}]
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 1e-6, nodes: [{name: top, near: [0, 0, 0.0261]}]}}
)");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 5e-3);
  EXPECT_LT(run.history.last("top_z"), 0.0255);  // it has sunk in
}

TEST(OnePointSolids, ThatFailLeaveTheBalanceAsItWas) {
  for (const char* elements : {"wedges", "pyramids"}) {
    const Outcome run = run_deck(fmt::format(R"(
title: eroding rod
time: {{end: 3e-5}}
parts:
  rod: {{cylinder: {{radius: 3e-3, length: 15e-3, cells: [6, 12]}}, elements: {}, at: [0, 0, 1e-5], material: copper}}
materials:
  copper:
    model: j2_plasticity
    density: 8930
    youngs_modulus: 117e9
    poissons_ratio: 0.35
    yield_stress: 400e6
    hardening_modulus: 100e6
    failure: {{plastic_strain: 0.5, fade_steps: 5}}
initial: [{{part: rod, velocity: [0, 0, -300]}}]
walls: [{{normal: z}}]
contact: {{surfaces: all}}
output: {{history: {{every: 1e-6}}}}
)",
                                             elements));
    EXPECT_GT(run.summary.eroded.elements, 5) << elements;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-2) << elements;
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12) << elements;
  }
}

// A strip of hexahedra whose ends are halves of pyramids and tetrahedra would need a mesher; a beam of joined parts
// shows what a change of elements along it does: pyramids share the faces of hexahedra.
TEST(OnePointSolids, AsPyramidsLeadFromHexahedraWithoutAReflection) {
  HistoryTable history = run_deck(R"(
title: bar of hexahedra with pyramids in its middle
time: {end: 1.9e-4, max_step: 5e-7}
parts:
  left: {box: {size: [0.4, 0.02, 0.02], cells: [40, 2, 2]}, material: steel}
  middle: {box: {size: [0.2, 0.02, 0.02], cells: [20, 2, 2]}, elements: pyramids, at: [0.4, 0, 0], material: steel}
  right: {box: {size: [0.4, 0.02, 0.02], cells: [40, 2, 2]}, at: [0.6, 0, 0], material: steel}
join: [{parts: [left, middle, right]}]
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: left/x_min, velocity: {x: 1}}
  - {nodes: left, fixed: [y, z]}
  - {nodes: middle, fixed: [y, z]}
  - {nodes: right, fixed: [y, z]}
output: {history: {nodes: [{name: a, near: [0.2, 0, 0]}, {name: b, near: [0.9, 0, 0]}]}}
)")
                             .history;
  const double c = std::sqrt(200e9 * 0.7 / (1.3 * 0.4 * 7850));
  EXPECT_NEAR(0.7 / (history.time_of_rise("b_vx", 0.5) - history.time_of_rise("a_vx", 0.5)), c, 5e-3 * c);
  // behind the front, before it comes back from the end; a reflection would change it in the middle of this time
  EXPECT_NEAR(history.mean(1.0e-4, 1.6e-4, "a_vx"), 1, 2e-3);
}

}  // namespace
}  // namespace percuss::test::one_point_test
