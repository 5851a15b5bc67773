// Bars of joined parts: one of one material is a bar in one part, bit by bit; at a step of the impedance a wave
// divides.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::joined_bar_test {
namespace {

/// A bar of 32 x 4 x 4 cells of an eighth, which begins to move askew on its left half. Cuts at the middle fall on the
/// cuts of its chunks.
std::string describe_bar(const std::string& parts) {
  return R"(
title: a bar, whole or joined
time: {end: 4e-4}
parts:
)" + parts +
         R"(
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
initial: [{part: {name: all, inside: [[0, 0, 0], [1.99, 1, 1]]}, velocity: [100, 3, 0]}]
contact: {surfaces: all}
)";
}

}  // namespace

TEST(JoinedBar, OfOneMaterialIsABarInOnePart) {
  const Outcome whole =
      run_deck(describe_bar("  bar: {box: {size: [4, 0.5, 0.5], cells: [32, 4, 4]}, material: steel}\n"));
  const Outcome joined =
      run_deck(describe_bar("  left: {box: {size: [2, 0.5, 0.5], cells: [16, 4, 4]}, material: steel}\n"
                            "  right: {box: {size: [2, 0.5, 0.5], cells: [16, 4, 4]}, at: [2, 0, 0], material: steel}\n"
                            "join: true\n"));
  EXPECT_EQ(joined.summary.nodes, whole.summary.nodes);
  EXPECT_EQ(joined.summary.contact_faces, whole.summary.contact_faces);
  EXPECT_EQ(joined.summary.steps, whole.summary.steps);
  EXPECT_EQ(joined.summary.state_hash, whole.summary.state_hash);
}

// A step of velocity v runs from steel with the impedance Z1 = rho1 c1 into aluminium with Z2. The interface then moves
// at 2 Z1 / (Z1 + Z2) v; the stress behind the transmitted front is Z2 times that, and behind the reflected one the
// same (Achenbach, Wave Propagation in Elastic Solids, section 1.4). Poisson's ratio is 0: the bar is one-dimensional.
TEST(JoinedBar, DividesAWaveAtAStepOfTheImpedance) {
  const double v = 1, z1 = std::sqrt(200e9 * 7850), z2 = std::sqrt(70e9 * 2700);
  const double c1 = std::sqrt(200e9 / 7850), c2 = std::sqrt(70e9 / 2700);
  const HistoryTable h = run_deck(R"(
title: impedance step
time: {end: 3.6e-4}
parts:
  left: {box: {size: [1, 0.02, 0.02], cells: [200, 1, 1]}, material: steel}
  right: {box: {size: [1, 0.02, 0.02], cells: [200, 1, 1]}, at: [1, 0, 0], material: aluminium}
join: [{parts: [left, right], tolerance: 1e-6}]
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}
  aluminium: {model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}
conditions: [{nodes: left/x_min, velocity: {x: 1}}]
output: {history: {elements: [{name: a, near: [0.5, 0.01, 0.01]}, {name: b, near: [1.5, 0.01, 0.01]}], nodes: [{name: face, near: [1, 0, 0]}, {name: n, near: [1.5, 0, 0]}]}}
)")
                             .history;
  const double at_face = 2 * z1 / (z1 + z2) * v, transmitted = z2 * at_face;
  const double arrival_a = 0.5 / c1, return_a = 1.5 / c1, arrival_b = 1 / c1 + 0.5 / c2;
  // Over the middle of each plateau, where the ringing of the fronts is gone, as of a bar in one part: 0.2 %.
  const auto mean = [&](double from, double to, const char* column) {
    return h.mean(from + 0.3 * (to - from), to - 0.1 * (to - from), column);
  };
  fmt::print("transmitted {:.5g} of {:.5g}, reflected {:.5g}, face {:.5g} of {:.5g}\n",
             mean(arrival_b, 3.6e-4, "b_stress_xx"), -transmitted, mean(return_a, 3.6e-4, "a_stress_xx"),
             mean(1 / c1, 3.6e-4, "face_vx"), at_face);
  EXPECT_NEAR(mean(arrival_a, return_a, "a_stress_xx"), -z1 * v, 2e-3 * z1 * v);
  EXPECT_NEAR(mean(return_a, 3.6e-4, "a_stress_xx"), -transmitted, 2e-3 * z1 * v);
  EXPECT_NEAR(mean(arrival_b, 3.6e-4, "b_stress_xx"), -transmitted, 2e-3 * z1 * v);
  EXPECT_NEAR(mean(1 / c1, 3.6e-4, "face_vx"), at_face, 2e-3 * v);
  EXPECT_NEAR(mean(arrival_b, 3.6e-4, "n_vx"), at_face, 2e-3 * v);
}

}  // namespace percuss::test::joined_bar_test
