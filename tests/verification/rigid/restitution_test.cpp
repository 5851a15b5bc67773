// Rigid bodies that meet part with the restitution of the deck, at every impact and under every enforcement.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::restitution_test {
namespace {

constexpr double gravity = 9.81, drop = 0.05;

/// A cube, corner, edge or face ahead, that falls by `drop` on a rigid block at z = 0 and bounces. contact: its keys.
std::string describe_bounces(const std::string& part, double end, const std::string& contact) {
  return fmt::format(R"(
time: {{end: {}, max_step: 5.0e-5}}
parts:
  body: {{{}, material: steel, rigid: true}}
  floor: {{box: {{size: [0.4, 0.4, 0.1], cells: [3, 3, 1]}}, at: [-0.2, -0.2, -0.1], material: steel, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
materials:
  steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {{gravity: [0, 0, -{}]}}
contact: {{surfaces: all{}}}
output: {{history: {{every: 0}}}}
)",
                     end, part, gravity, contact);
}

const std::string flat_cube = "box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [-0.03, -0.02, 0.05]";
const std::string ball = "sphere: {radius: 0.05, cells: 6}, at: [0.013, 0.007, 0.1]";

/// The tops of the bounces above the place of rest.
std::vector<double> find_tops(const HistoryTable& history, double rest) {
  std::vector<double> tops;
  const std::vector<double>& z = history["body_z:body"];
  for (std::size_t i = 1; i + 1 < z.size(); ++i)
    if (z[i] > z[i - 1] && z[i] >= z[i + 1]) tops.push_back(z[i] - rest);
  return tops;
}

struct BounceCase {
  const char* enforcement;
  double restitution;
};

class Restitution : public testing::TestWithParam<BounceCase> {};

}  // namespace

// Each top is e^2 of the one before. A step meets the floor up to v dt early: 5e-5 m.
TEST_P(Restitution, OfAFlatCubeGivesEachHeight) {
  const auto& [enforcement, e] = GetParam();
  const Outcome run =
      run_deck(describe_bounces(flat_cube, 0.7, fmt::format(", enforcement: {}, restitution: {}", enforcement, e)));
  const std::vector<double> tops = find_tops(run.history, 0.05);
  ASSERT_GE(tops.size(), 2U);
  double expected = drop;
  for (std::size_t i = 0; i < 2; ++i) {
    expected *= e * e;
    EXPECT_NEAR(tops[i], expected, 2e-3 * drop) << i;
  }
  EXPECT_LT(run.history.largest("kinetic"), 1.001 * 8 * gravity * drop);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(AllEnforcements, Restitution,
                         testing::Values(BounceCase{"kinematic", 1}, BounceCase{"kinematic", 0.6},
                                         BounceCase{"penalty", 1}, BounceCase{"penalty", 0.6},
                                         BounceCase{"lagrange", 0.6}),
                         [](const auto& param) {
                           return fmt::format("{}_{}", param.param.enforcement,
                                              static_cast<int>(100 * param.param.restitution));
                         });

// A ball hits the floor below its centre, or beside it by the facets of its mesh: the energy cannot grow, and the first
// impact is no other than the next ones.
TEST(RestitutionOfABall, IsThatOfTheDeckAtTheFirstImpactAndLater) {
  const Outcome run = run_deck(describe_bounces(ball, 0.5, ", restitution: 0.7"));
  const std::vector<double>&z = run.history["body_vz:body"], &contact = run.history["contact"];
  EXPECT_LE(*std::max_element(contact.begin(), contact.end()), 1e-9);
  int impacts = 0;
  for (std::size_t i = 1; i < z.size(); ++i) {
    if (!(z[i - 1] < -0.1 && z[i] > 0)) continue;
    EXPECT_NEAR(z[i] / -z[i - 1], 0.7, 0.01) << run.history["time"][i];
    ++impacts;
  }
  EXPECT_GE(impacts, 2);
}

// Without the key: none of the velocity with kinematic, all of it with the springs of penalty.
TEST(RestitutionByDefault, IsThatOfTheEnforcement) {
  const Outcome dead = run_deck(describe_bounces(flat_cube, 0.3, ""));
  EXPECT_NEAR(dead.history.last("body_z:body"), 0.05, 1e-5);
  const Outcome live = run_deck(describe_bounces(flat_cube, 0.3, ", enforcement: penalty"));
  EXPECT_NEAR(find_tops(live.history, 0.05).at(0), drop, 2e-3 * drop);
}

// A block at rest stays at rest, whatever the restitution.
TEST(RestitutionAtRest, LeavesABlockWhereItIs) {
  for (const char* enforcement : {"kinematic", "penalty"}) {
    const std::string block = "box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [-0.03, -0.02, 0]";
    const Outcome run =
        run_deck(describe_bounces(block, 0.05, fmt::format(", restitution: 1, enforcement: {}", enforcement)) +
                 "audit: {max_momentum_error: 1}\n");  // of nothing: it never moves
    EXPECT_NEAR(run.history.last("body_z:body"), 0.05, 1e-7) << enforcement;
    EXPECT_LT(run.history.largest("kinetic"), 1e-9) << enforcement;
  }
}

}  // namespace percuss::test::restitution_test
