// The three enforcements of contact on the same scenes: exact answers of bars, a sliding block, a resting pile.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::enforcement_test {
namespace {

struct Expected {
  const char* name;
  double velocity, force;  // errors that the impact of bars may have, relative
};

class Enforcement : public testing::TestWithParam<Expected> {};

/// One bar of 100 elements runs into another that rests: rho c v / 2 for 2 L / c, then the second one flies at v.
Outcome collide_bars(const std::string& enforcement) {
  return run_deck(fmt::format(R"(
title: two bars, {0}
time: {{end: 1.26e-3}}
parts:
  a: {{box: {{size: [1, 0.01, 0.01], cells: [100, 1, 1]}}, at: [-1.0001, 0, 0], material: steel}}
  b: {{box: {{size: [1, 0.01, 0.01], cells: [100, 1, 1]}}, material: steel}}
materials: {{steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}}}
initial: [{{part: a, velocity: [10, 0, 0]}}]
contact: {{surfaces: all, enforcement: {0}}}
output: {{history: {{every: 1e-6, nodes: [{{name: a, near: [-0.5, 0, 0]}}, {{name: b, near: [0.5, 0, 0]}}], elements: [{{name: m, near: [0.255, 0.005, 0.005]}}]}}}}
)",
                              enforcement));
}

}  // namespace

TEST_P(Enforcement, BarsExchangeTheirVelocities) {
  const Outcome run = collide_bars(GetParam().name);
  const HistoryTable& h = run.history;
  const double c = 5000, v = 10, touch = 1e-4 / v;
  // Behind the front and before its return; two periods 2 L / c after the bars have parted.
  const double force = h.mean(touch + 0.3 / c, touch + 1.5 / c, "m_stress_xx") / (-8000 * c * v / 2);
  const double first = h.mean(4.5e-4, 1.25e-3, "a_vx") / v, second = h.mean(4.5e-4, 1.25e-3, "b_vx") / v;
  fmt::print(
      "{}: stress {:.5f}, velocities {:.5f} and {:.5f} of what they should be (1, 0, 1), contact work {:.4f} %\n",
      GetParam().name, force, first, second, 100 * run.summary.energy.contact / run.summary.energy.initial);
  EXPECT_NEAR(force, 1, GetParam().force);
  EXPECT_NEAR(first, 0, GetParam().velocity);
  EXPECT_NEAR(second, 1, GetParam().velocity);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// Its bending is damped: an undamped block flutters as it slides (docs/theory_contact.md, "Friction"), which makes its
// way up to 1 % longer, by any enforcement and more by stiffer springs.
TEST_P(Enforcement, ABlockSlidesToAStop) {
  const Outcome run = run_deck(fmt::format(R"(
title: sliding block, {}
time: {{end: 0.4}}
parts:
  floor: {{box: {{size: [2, 0.6, 0.1], cells: [4, 2, 1]}}, at: [-0.3, -0.1, -0.1], material: soft}}
  block: {{box: {{size: [0.4, 0.4, 0.1], cells: [2, 2, 1]}}, material: soft}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
conditions: [{{nodes: floor, fixed: [x, y, z]}}]
elements: {{hourglass: viscous}}
initial: [{{part: block, velocity: [1, 0, 0]}}]
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: all, friction: 0.4, enforcement: {}}}
output: {{history: {{every: 1e-3, nodes: [{{name: n, near: [0.2, 0.2, 0.05], part: block}}]}}}}
)",
                                           GetParam().name, GetParam().name));
  const double exact = 1 / (2 * 0.4 * 9.81), way = run.history.last("n_x") - 0.2;
  fmt::print("{}: {:.5f} m of {:.5f}\n", GetParam().name, way, exact);
  EXPECT_NEAR(way, exact, 5e-3 * exact);
  EXPECT_LT(std::abs(run.history.last("n_vx")), 2e-3);
}

TEST_P(Enforcement, APileOfBricksRests) {
  const Outcome run = run_deck(fmt::format(R"(
title: six bricks in three courses rest, {0}
time: {{end: 1000, max_steps: {1}}}
parts:
  low:    {{box: {{size: [0.2, 0.1, 0.06], cells: [2, 1, 1]}}, array: {{count: [3, 1, 1], pitch: [0.2, 0.1, 0.06]}}, material: brick}}
  middle: {{box: {{size: [0.2, 0.1, 0.06], cells: [2, 1, 1]}}, at: [0.1, 0, 0.06], array: {{count: [2, 1, 1], pitch: [0.2, 0.1, 0.06]}}, material: brick}}
  top:    {{box: {{size: [0.2, 0.1, 0.06], cells: [2, 1, 1]}}, at: [0.2, 0, 0.12], material: brick}}
materials: {{brick: {{model: elastic, density: 2000, youngs_modulus: 2e9, poissons_ratio: 0.2}}}}
loads: {{gravity: [0, 0, -9.81]}}
contact: {{surfaces: all, friction: 0.5, enforcement: {0}}}
walls: [{{normal: z, friction: 0.5}}]
output: {{history: {{every: 2e-3, nodes: [{{name: top, near: [0.2, 0, 0.18], part: top}}]}}}}
)",
                                           GetParam().name, std::string(GetParam().name) == "lagrange" ? 200 : 10000));
  const HistoryTable& h = run.history;
  const double weight = 6 * 2000 * 0.2 * 0.1 * 0.06 * 9.81, height = 0.18;
  const std::size_t last = h.rows() - 1;
  fmt::print("{}: kinetic {:.2e} m g H, drift {:.2e} {:.2e} {:.2e} of H\n", GetParam().name,
             h["kinetic"][last] / (weight * height), (h["top_x"][last] - 0.2) / height, h["top_y"][last] / height,
             (h["top_z"][last] - 0.18) / height);
  EXPECT_LT(h["kinetic"][last], 1e-7 * weight * height);
  EXPECT_LT(std::abs(h["top_x"][last] - 0.2), 1e-5 * height);
  EXPECT_LT(std::abs(h["top_y"][last]), 1e-5 * height);
  EXPECT_LT(std::abs(h["top_z"][last] - 0.18), 1e-5 * height);
}

INSTANTIATE_TEST_SUITE_P(Of, Enforcement,
                         // The fronts are some elements wide: 1.4 % of the momentum is left behind where they meet.
                         testing::Values(Expected{"kinematic", 1.5e-2, 1e-3}, Expected{"lagrange", 1.5e-2, 1e-3},
                                         Expected{"penalty", 1.5e-2, 1e-3}),
                         [](const auto& one) { return std::string(one.param.name); });

/// Momentum of a ball that has met a plate of its own material at 0.14 of the wave speed, over that before.
double find_momentum_left(const std::string& enforcement) {
  const Outcome run = run_deck(R"(
title: a fast ball meets a plate
time: {end: 3e-4}
parts:
  plate: {box: {size: [0.1, 0.5, 0.5], cells: [2, 10, 10]}, at: [-0.05, -0.25, -0.25], material: m}
  ball: {sphere: {radius: 0.2, cells: 8}, at: [-0.26, 0, 0], material: m}
materials: {m: {model: neo_hookean, density: 7800, youngs_modulus: 2.06e11, poissons_ratio: 0.286}}
initial: [{part: ball, velocity: [800, 0, 0]}]
output: {history: {parts: all}}
contact: {surfaces: all, enforcement: )" +
                               enforcement + "}\n");
  const HistoryTable& h = run.history;
  // Contacts that let go turn what they held into a loss.
  EXPECT_GT(h.last("contact"), -0.05 * h["kinetic"][0]) << enforcement;
  return h.last("momentum_x:ball") / h["momentum_x:ball"][0];
}

TEST(FastImpact, SpringsHoldABallAsIteratedForcesDo) {
  // Springs that let it through leave it 10 % more. They give back what 0.05 of an element holds, iterated forces
  // nothing.
  const double wanted = find_momentum_left("kinematic");
  EXPECT_NEAR(find_momentum_left("penalty"), wanted, 0.05 * wanted);
}

TEST(TipsOfBalls, GetNoEnergyFromSprings) {
  // Four elastic balls in a row that touch with the nodes at their poles, where round-off turns them aside. A push that
  // is turned along their slide gave 0.06 to 0.8 % of the energy.
  for (const double speed : {4.9, 4.95, 5.0, 5.05, 5.1}) {
    const HistoryTable h = run_deck(fmt::format(R"(
title: a row of balls
time: {{end: 7e-4}}
parts:
  first: {{sphere: {{radius: 0.05, cells: 6}}, material: m}}
  row: {{sphere: {{radius: 0.05, cells: 6}}, array: {{count: [3, 1, 1], pitch: [0.1001, 0, 0]}}, at: [0.1001, 0, 0], material: m}}
materials: {{m: {{model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}}}}
initial: [{{part: first, velocity: [{}, 0, 0]}}]
contact: {{surfaces: all, enforcement: penalty}}
output: {{history: {{every: 1e-5}}}}
)",
                                                speed))
                               .history;
    EXPECT_LT(h.largest("contact"), 1e-4 * h["kinetic"][0]) << speed;
  }
}

TEST(PairWork, OfTwoCubesIsTheEnergyThatTheirNodesLose) {
  // Cubes of one element and 8 kg that touch, one at 2 m/s. In the first step the four nodes of 1 kg on each side share
  // their momentum: the impulse of each is 1 N s, the velocity between them 2 m/s before and 0 after, the work
  // -4 (1 N s) (2 m/s + 0) / 2 = -4 J, which is what is left of 4 (1 kg) (2 m/s)^2 / 2 less the 4 J of the common
  // motion. The third cube is out of reach.
  const HistoryTable h = run_deck(R"(
title: two cubes hit
time: {end: 1, max_steps: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [1, 0, 0], material: m}
  c: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [9, 0, 0], material: m}
materials: {m: {model: elastic, density: 8, youngs_modulus: 1e6, poissons_ratio: 0}}
initial: [{part: a, velocity: [2, 0, 0]}]
contact: {surfaces: [[c, b], [a, b]], tolerance: 1e-12}
output: {history: {}}
)")
                             .history;
  EXPECT_NEAR(h.last("contact:a:b"), -4, 1e-10);
  EXPECT_EQ(h.last("contact:c:b"), 0);
  EXPECT_NEAR(h.last("contact"), h.last("contact:a:b"), 1e-15);
  EXPECT_EQ(h.last("friction:a:b"), 0);
}

}  // namespace percuss::test::enforcement_test
