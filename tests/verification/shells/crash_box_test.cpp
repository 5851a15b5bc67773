// A tube that is crushed to two fifths of its length: elements warp, fold and turn concave, and nothing stalls.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::crash_box_test {

TEST(CrashBox, IsCrushedWithBoundedStepsAndClosedBooks) {
  // A steel tube of 60 x 60 x 1.5 mm under 300 kg at 10 m/s, elements of 10 mm (perf/verify has 5 mm).
  const Outcome run = run_deck(R"yaml(
title: a crash box, coarse
units: m, kg, s
time: {end: 0.02}
parts:
  tube: {shell_box_tube: {size: [0.06, 0.06], length: 0.25, cells: [6, 6, 25]}, thickness: 0.0015, material: steel}
  sled: {box: {size: [0.12, 0.12, 0.05], cells: [2, 2, 1]}, at: [-0.06, -0.06, 0.2508], material: heavy}
materials:
  steel: {model: power_law_plasticity, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, yield_stress: 250e6, hardening_coefficient: 400e6, hardening_exponent: 0.5}
  heavy: {model: elastic, density: 416666.67, youngs_modulus: 210e9, poissons_ratio: 0.3}
initial: [{part: sled, velocity: [0, 0, -10]}]
conditions: [{nodes: sled, velocity: {x: 0, y: 0}}]
walls: [{normal: z, friction: 0.2}]
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 1e-4, nodes: [{name: sled, part: sled, near: [0, 0, 0.2508]}]}}
)yaml");
  fmt::print("crash box: {:.3f} of its length, least step {:.3f} of the largest, energy error {:.1e}\n",
             run.history.last("sled_z") / 0.25, run.summary.dt.min / run.summary.dt.max, run.summary.energy.error);
  EXPECT_LT(run.history.last("sled_z"), 0.4 * 0.25);
  EXPECT_GT(run.summary.dt.min, 0.4 * run.summary.dt.max);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

}  // namespace percuss::test::crash_box_test
