// The first sloshing mode of a tank for 20 periods: frequency and height, soft and as stiff as water.

#include <gtest/gtest.h>

#include "tests/verification/fluids/tank.hpp"

namespace percuss::test::sloshing_test {
namespace {

void expect_sloshing(double bulk_modulus, double periods) {
  Tank tank;
  tank.bulk_modulus = bulk_modulus;
  tank.push = 0.0343;  // a wave of 5 mm
  tank.periods = periods;
  const Outcome run = run_deck(make_tank(tank));
  const double first = find_largest(run.history, "kinetic", 1),
               last = find_largest(run.history, "kinetic", periods - 1);
  fmt::print("K {}: frequency {:.4f} of the exact one, height {:.4f} of the first after {} periods\n", bulk_modulus,
             find_frequency_ratio(run.history), std::sqrt(last / first), periods - 2);
  EXPECT_NEAR(find_frequency_ratio(run.history), 1, 0.01);
  EXPECT_NEAR(std::sqrt(last / first), 1, 0.05);
}

}  // namespace

TEST(Sloshing, OfSoftWaterKeepsItsFrequencyAndHeight) { expect_sloshing(4e6, 21); }

TEST(Sloshing, OfRealWaterKeepsItsFrequencyAndHeight) { expect_sloshing(2.2e9, 21); }

/// A column of water, twice as high as wide, that nothing holds any more: place of its front over its width, at times
/// over sqrt(width / 2 g). Martin and Moyce, Phil. Trans. R. Soc. London A 244, 312 (1952), width 2.25 in. Water
/// without friction runs ahead of the experiment, whose dam does not open at once: 13 to 23 % here. The mesh follows up
/// to five widths.
TEST(DamBreak, HasItsFrontWhereItWasSeen) {
  constexpr double width = 0.05715;
  const Outcome run = run_deck(R"(
title: a dam breaks
time: {end: 0.23, collapse_ratio: 0.001}
parts: {w: {box: {size: [0.05715, 0.0057, 0.1143], cells: [20, 1, 40]}, material: water}}
materials: {water: {model: fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 4.0e+5}}}
conditions:
  - {nodes: w/x_min, fixed: [x]}
  - {nodes: w/y_min, fixed: [y]}
  - {nodes: w/y_max, fixed: [y]}
  - {nodes: w/z_min, fixed: [z]}
loads: {gravity: [0, 0, -9.81]}
output: {history: {every: 0.001, nodes: [{name: front, near: [0.05715, 0, 0]}]}}
)");
  struct Seen {
    double time, place;
  };
  for (const auto& [time, place] :
       {Seen{0.832, 1.217}, {1.219, 1.474}, {1.997, 2.292}, {2.547, 2.995}, {3.345, 4.134}, {4.034, 4.944}}) {
    const double now = run.history.at(time * std::sqrt(width / (2 * gravity)), "front_x") / width;
    fmt::print("front at {:.3f} widths, seen {}\n", now, place);
    EXPECT_GT(now, place);
    EXPECT_LT(now, 1.25 * place);
  }
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
}

}  // namespace percuss::test::sloshing_test
