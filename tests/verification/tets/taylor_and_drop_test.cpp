// Tetrahedra in whole runs: the Taylor bar, spins, drops onto a wall and onto each other, failure.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/verification/support/taylor_bar.hpp"

namespace percuss::test::taylor_and_drop_test {
namespace {

TaylorShape run_tets(int n, const std::string& elements) {
  return run_taylor_bar(n, TaylorFoot::held, elements, TaylorCells::tetrahedra);
}

TEST(Tetrahedra, OfTheMixedFormMakeTheTaylorBarOfTheReference) {
  const TaylorShape coarse = run_tets(1, "{}"), fine = run_tets(2, "{}");
  EXPECT_LT(std::abs(fine.length - taylor_length), std::abs(coarse.length - taylor_length));
  EXPECT_NEAR(fine.length, taylor_length, 0.005 * taylor_length);
  EXPECT_NEAR(fine.mean_foot(), taylor_radius, 0.01 * taylor_radius);
  EXPECT_LT(fine.energy_error, 2e-3);
}

// 720 elements of ten nodes are 5760 of four, as the finer bar above has.
TEST(Tetrahedra, OfTenNodesMakeTheTaylorBarOfTheReference) {
  const TaylorShape bar = run_taylor_bar(1, TaylorFoot::held, "{}", TaylorCells::tetrahedra_of_ten_nodes);
  EXPECT_NEAR(bar.length, taylor_length, 0.007 * taylor_length);
  EXPECT_NEAR(bar.mean_foot(), taylor_radius, 0.02 * taylor_radius);
  EXPECT_LT(bar.energy_error, 2e-3);
}

TEST(Tetrahedra, OfThePlainFormLock) {
  const TaylorShape plain = run_tets(1, "{tetrahedra: plain}"), mixed = run_tets(1, "{}");
  EXPECT_LT(plain.mean_foot(), 0.9 * taylor_radius);
  EXPECT_GT(mixed.mean_foot(), 0.95 * taylor_radius);
}

TEST(Tetrahedra, ThatSpinFreelyKeepTheirMomentumAndEnergy) {
  for (const char* form : {"mixed", "plain"}) {
    const Outcome run = run_deck(fmt::format(R"(
title: spinning block of tetrahedra
time: {{end: 2e-3}}
parts: {{block: {{box: {{size: [0.1, 0.06, 0.04], cells: [5, 3, 2]}}, elements: tetrahedra, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
elements: {{tetrahedra: {}}}
initial: [{{part: block, velocity: [1, 2, 3], angular_velocity: [300, 2000, 500]}}]
output: {{history: {{every: 1e-4}}}}
)",
                                             form));
    EXPECT_LT(run.summary.momentum.linear_error, 1e-13) << form;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-13) << form;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-5) << form;
  }
}

/// A ball of tetrahedra falls on a plate of `elements`, which stands on a wall.
Outcome drop_ball(const std::string& elements) {
  return run_deck(fmt::format(R"(
title: ball of tetrahedra on a plate
time: {{end: 6e-5}}
parts:
  ball: {{sphere: {{radius: 0.01, cells: 6}}, elements: tetrahedra, at: [0, 0, 0.0161], material: copper}}
  plate: {{box: {{size: [0.04, 0.04, 0.006], cells: [10, 10, 2]}}, elements: {}, at: [-0.02, -0.02, 0], material: copper}}
materials:
  copper: {{model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 200e6, hardening_modulus: 300e6}}
initial: [{{part: ball, velocity: [0, 0, -150]}}]
walls: [{{normal: z}}]
contact: {{surfaces: all, friction: 0.2}}
output: {{history: {{every: 1e-6, nodes: [{{name: top, near: [0, 0, 0.0261]}}]}}}}
)",
                              elements));
}

TEST(Tetrahedra, FallOnTetrahedraAndOnHexahedraAlike) {
  const Outcome on_hexahedra = drop_ball("hexahedra"), on_tetrahedra = drop_ball("tetrahedra");
  for (const Outcome* run : {&on_hexahedra, &on_tetrahedra}) {
    EXPECT_LT(run->summary.momentum.linear_error, 1e-12);
    EXPECT_LT(run->summary.momentum.angular_error, 1e-12);
    EXPECT_LT(std::abs(run->summary.energy.error), 5e-3);
    EXPECT_LT(run->history.last("top_z"), 0.0255);  // it has sunk in
  }
  EXPECT_NEAR(on_tetrahedra.history.last("top_z"), on_hexahedra.history.last("top_z"), 3e-4);
}

TEST(Tetrahedra, ThatFailLeaveTheAveragesAndTheBalanceAsTheyWere) {
  const Outcome run = run_deck(R"(
title: eroding rod of tetrahedra
time: {end: 3e-5}
parts:
  rod: {cylinder: {radius: 3e-3, length: 15e-3, cells: [6, 12]}, elements: tetrahedra, at: [0, 0, 1e-5], material: copper}
materials:
  copper:
    model: j2_plasticity
    density: 8930
    youngs_modulus: 117e9
    poissons_ratio: 0.35
    yield_stress: 400e6
    hardening_modulus: 100e6
    failure: {plastic_strain: 0.5, fade_steps: 5}
initial: [{part: rod, velocity: [0, 0, -300]}]
walls: [{normal: z}]
contact: {surfaces: all}
output: {history: {every: 1e-6}}
)");
  EXPECT_GT(run.summary.eroded.elements, 20);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-2);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

}  // namespace
}  // namespace percuss::test::taylor_and_drop_test
