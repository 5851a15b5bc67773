// Joints between rigid bodies, and between one and the ground: exact motions, what is conserved, what is refused.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "src/error.hpp"
#include "src/warning.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::joint_test {
namespace {

const std::string materials =
    "materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

/// A rod along x from `from`, its nodes on its line too.
std::string describe_rod(const std::string& name, const std::string& from, double length,
                         const std::string& rigid = "true") {
  return fmt::format(
      "  {}: {{box: {{size: [{}, 0.02, 0.02], cells: [4, 2, 2]}}, at: {}, material: steel, rigid: {}}}\n", name, length,
      from, rigid);
}

double find_largest_error(const Outcome& run) {
  return std::max(run.history.largest("energy_error"), -run.history.smallest("energy_error"));
}

/// Farthest that two followed nodes come apart.
double find_farthest(const HistoryTable& history, const std::string& a, const std::string& b) {
  double farthest = 0;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    double square = 0;
    for (const char* axis : {"_x", "_y", "_z"}) square += std::pow(history[a + axis][row] - history[b + axis][row], 2);
    farthest = std::max(farthest, std::sqrt(square));
  }
  return farthest;
}

}  // namespace

// Let go at 60 degrees from its lowest place: T = 4 sqrt(I / (M g d)) K(sin 30 degrees), I about the axis, over twenty
// swings.
TEST(Pendulum, SwingsWithTheExactPeriod) {
  const double angle = std::numbers::pi / 3, g = 9.81, mass = 2, arm = 0.5, inertia = 0.3 + mass * arm * arm;
  const double period = 4 * std::sqrt(inertia / (mass * g * arm)) * std::comp_ellint_1(std::sin(angle / 2));
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 1.0e-3}}\nparts:\n{}{}joints: {{pin: {{kind: revolute, bodies: [rod], at: [0, 0, 0], "
      "axis: y}}}}\nloads: {{gravity: [{}, 0, {}]}}\noutput: {{history: {{every: 0}}}}\n",
      21.1 * period, describe_rod("rod", "[0, -0.01, -0.01]", 1, "{mass: 2, inertia: [0.1, 0.3, 0.3, 0, 0, 0]}"),
      materials, g * std::cos(angle), -g * std::sin(angle)));
  const auto &x = run.history["body_x:rod"], &z = run.history["body_z:rod"], &t = run.history["time"];
  std::vector<double> passes;  // of the lowest place, in one direction
  double before = -1;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double side = x[row] * std::sin(angle) + z[row] * std::cos(angle);
    if (before > 0 && side <= 0) passes.push_back(t[row] - (t[row] - t[row - 1]) * side / (side - before));
    before = side;
  }
  ASSERT_GE(passes.size(), 21U);
  EXPECT_NEAR((passes[20] - passes[0]) / 20, period, 1e-5 * period);
  EXPECT_LT(find_largest_error(run), 1e-5);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  // The books add up 40 s of weight, a thousand times the momentum that is left of it.
  EXPECT_LT(run.summary.momentum.angular_error, 1e-9);
}

// At rest it hangs on its joint with its weight.
TEST(Pendulum, AtRestPullsWithItsWeight) {
  const Outcome run = run_deck("time: {end: 0.1, max_step: 1.0e-3}\nparts:\n" +
                               describe_rod("rod", "[0, -0.01, -0.01]", 1, "{mass: 2}") + materials +
                               "joints: {pin: {kind: revolute, bodies: [rod], at: [0, 0, 0], axis: y}}\n"
                               "loads: {gravity: [10, 0, 0]}\noutput: {history: {every: 0.01}}\n");
  EXPECT_NEAR(run.history.last("joint_fx:pin"), -20, 1e-9);
  EXPECT_NEAR(run.history.last("joint_fz:pin"), 0, 1e-9);
  EXPECT_NEAR(run.history.last("body_x:rod"), 0.5, 1e-13);
}

// Nothing moves but round-off, by which no balance is measured.
TEST(Pendulum, StandsOnItsJointAtRest) {
  const Outcome run = run_deck("time: {end: 0.1, max_step: 1.0e-3}\nparts:\n" +
                               describe_rod("rod", "[0, -0.01, -0.01]", 1) + materials +
                               "joints:\n  a: {kind: spherical, bodies: [rod], at: [0, 0, 0]}\n"
                               "  b: {kind: spherical, bodies: [rod], at: [1, 0, 0]}\n"
                               "loads: {gravity: [1, 2, -10]}\noutput: {history: {every: 0.01}}\n");
  EXPECT_NEAR(run.history.last("joint_fz:a"), 16, 1e-6);  // half of 3.2 kg
  EXPECT_LT(find_largest_error(run), 1e-6);
}

// A pendulum of two links with large swings: nobody knows its motion, but its energy stays.
TEST(Pendulum, OfTwoLinksKeepsItsEnergy) {
  const Outcome run = run_deck(
      "time: {end: 20, max_step: 1.0e-3}\nparts:\n" + describe_rod("upper", "[0, -0.01, -0.01]", 0.6) +
      describe_rod("lower", "[0.6, -0.01, -0.01]", 0.4) + materials +
      "joints:\n  shoulder: {kind: revolute, bodies: [upper], at: [0, 0, 0], axis: y}\n"
      "  elbow: {kind: spherical, bodies: [upper, lower], at: [0.6, 0, 0]}\n"
      "loads: {gravity: [0, 0, -9.81]}\noutput: {history: {every: 0.01, nodes: [{name: a, near: [0.6, 0, 0], part: "
      "upper}, {name: b, near: [0.6, 0, 0], part: lower}]}}\n");
  EXPECT_LT(find_largest_error(run), 2e-4);  // (w dt)^2 at w of 15 rad/s
  EXPECT_LT(find_farthest(run.history, "a", "b"), 1e-14);
}

// Steady precession of a heavy symmetric top: M g d = W (I3 s - I1 W cos a), I1 about the point, s its spin about its
// axis, a the angle of the axis to the vertical, W the rate (Goldstein, Classical Mechanics, section 5.7).
TEST(Top, PrecessesAtTheExactRate) {
  const double rate = 2, tilt = std::numbers::pi / 3, mgd = 9.81 * 0.3, across = 0.05 + 0.09, along = 0.02;
  const double spin = (mgd / rate + across * rate * std::cos(tilt)) / along;
  const double up[3] = {std::cos(tilt), 0, std::sin(tilt)};  // the axis of the top is x at the start
  const double turn = std::numbers::pi / rate;
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 1.0e-4}}\nparts:\n{}{}joints: {{tip: {{kind: spherical, bodies: [top], at: [0, 0, "
      "0]}}}}\nloads: {{gravity: [{}, 0, {}]}}\ninitial: [{{part: top, angular_velocity: [{}, 0, {}], center: [0, 0, "
      "0]}}]\noutput: {{history: {{every: {}}}}}\n",
      turn,
      describe_rod("top", "[0, -0.01, -0.01]", 0.6,
                   "{mass: 1, center: [0.3, 0, 0], inertia: [0.02, 0.05, 0.05, 0, 0, 0]}"),
      materials, -9.81 * up[0], -9.81 * up[2], rate * (up[0] - std::cos(tilt)) + spin, rate * up[2], turn / 100));
  // Half a turn about the vertical.
  EXPECT_NEAR(run.history.last("body_x:top"), 0.3 * (2 * std::cos(tilt) * up[0] - 1), 1e-4 * 0.3);
  EXPECT_NEAR(run.history.last("body_z:top"), 0.3 * (2 * std::cos(tilt) * up[2]), 1e-4 * 0.3);
  EXPECT_NEAR(run.history.last("body_y:top"), 0, 1e-3 * 0.3 * std::numbers::pi);
  EXPECT_LT(find_largest_error(run), 1e-5);
}

// Two hinges on one line say the same twice: the door turns as on one, and both carry the same.
TEST(Door, TurnsUniformlyOnTwoHinges) {
  const Outcome run = run_deck(R"(
time: {end: 0.5, max_step: 1.0e-4}
parts: {door: {box: {size: [0.9, 0.04, 2], cells: [2, 2, 4]}, at: [0, -0.02, -1], material: steel, rigid: {mass: 40}}}
joints:
  upper: {kind: revolute, bodies: [door], at: [0, 0, 0.8], axis: z}
  lower: {kind: revolute, bodies: [door], at: [0, 0, -0.8], axis: z}
loads: {gravity: [0, 0, -10]}
initial: [{part: door, angular_velocity: [0, 0, 2], center: [0, 0, 0]}]
output: {history: {every: 0.01}}
)" + materials);
  EXPECT_NEAR(run.history.last("body_x:door"), 0.45 * std::cos(1), 1e-6);
  EXPECT_NEAR(run.history.last("body_y:door"), 0.45 * std::sin(1), 1e-6);
  EXPECT_NEAR(run.history.last("body_z:door"), 0, 1e-12);
  for (const char* hinge : {"joint_fz:upper", "joint_fz:lower"}) EXPECT_NEAR(run.history.last(hinge), 200, 1e-6);
  const double fx = run.history.last("joint_fx:upper") + run.history.last("joint_fx:lower");
  EXPECT_NEAR(fx, -40 * 4 * 0.45 * std::cos(1), 1e-3 * 72);
  EXPECT_LT(find_largest_error(run), 1e-7);
}

// Bodies with a loop of revolute joints, 20 rows for 17 that count, that turn without loss where nothing acts on them.
TEST(FourBar, TurnsOnWithRedundantRows) {
  const Outcome run = run_deck(R"(
time: {end: 4, max_step: 2.5e-4}
parts:
  crank: {box: {size: [0.2, 0.02, 0.02], cells: [4, 2, 2]}, at: [0.01, -0.01, 0], rotate: [{axis: y, angle: -90}], material: steel, rigid: true}
  coupler: {box: {size: [0.5, 0.02, 0.02], cells: [4, 2, 2]}, at: [0, -0.01, 0.19], material: steel, rigid: true}
  rocker: {box: {size: [0.4, 0.02, 0.02], cells: [4, 2, 2]}, at: [0.51, -0.01, -0.2], rotate: [{axis: y, angle: -90}], material: steel, rigid: true}
joints:
  a: {kind: revolute, bodies: [crank], at: [0, 0, 0], axis: y}
  b: {kind: revolute, bodies: [crank, coupler], at: [0, 0, 0.2], axis: y}
  c: {kind: revolute, bodies: [coupler, rocker], at: [0.5, 0, 0.2], axis: y}
  d: {kind: revolute, bodies: [rocker], at: [0.5, 0, -0.2], axis: y}
loads: {gravity: [3, 0, -9.81]}
output: {history: {every: 0.01, nodes: [{name: p, near: [0.5, 0, 0.2], part: coupler}, {name: q, near: [0.5, 0, 0.2], part: rocker}]}}
)" + materials);
  double moved = 0;
  for (const double z : run.history["body_z:coupler"]) moved = std::max(moved, std::abs(z - 0.2));
  EXPECT_GT(moved, 0.1);
  for (const char* body : {"crank", "coupler", "rocker"})
    EXPECT_LT(run.history.largest(fmt::format("body_y:{}", body)), 1e-12) << body;
  EXPECT_LT(find_farthest(run.history, "p", "q"), 1e-13);
  EXPECT_LT(find_largest_error(run), 1e-4);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);  // of books that add up 4 s of weight
}

// A free chain that turns and folds: equal and opposite impulses at common points.
TEST(FreeChain, ConservesItsMomenta) {
  const Outcome run = run_deck(
      "time: {end: 5, max_step: 1.0e-3}\nparts:\n" + describe_rod("a", "[0, -0.01, -0.01]", 0.3) +
      describe_rod("b", "[0.3, -0.01, -0.01]", 0.4) + describe_rod("c", "[0.7, -0.01, -0.01]", 0.2) + materials +
      "joints:\n  ab: {kind: revolute, bodies: [a, b], at: [0.3, 0, 0], axis: [0.3, 1, 0.2]}\n"
      "  bc: {kind: spherical, bodies: [b, c], at: [0.7, 0, 0]}\n"
      "initial:\n  - {part: all, velocity: [1, 2, 3]}\n  - {part: c, velocity: [1, 2, 3], angular_velocity: [3, 4, 5], "
      "center: [0.7, 0, 0]}\noutput: {history: {every: 0.05}}\n");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(find_largest_error(run), 1e-5);
  EXPECT_GT(std::abs(run.history.last("body_wz:a")), 0.1);  // it has been taken along
}

// A hammer on a hinge, the work of whose contact is that at what its hinge lets it do.
TEST(Hammer, ClosesTheEnergyInContact) {
  for (const char* enforcement : {"kinematic", "lagrange", "penalty"}) {
    const Outcome run = run_deck(fmt::format(R"(
time: {{end: 2.0e-3}}
parts:
  hammer: {{box: {{size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}}, at: [0.45, -0.05, 0.0001], material: steel, rigid: true}}
  plate: {{box: {{size: [0.3, 0.3, 0.1], cells: [6, 6, 2]}}, at: [0.35, -0.15, -0.1], material: soft}}
joints: {{pin: {{kind: revolute, bodies: [hammer], at: [0, 0, 0.05], axis: y}}}}
conditions: [{{nodes: plate/z_min, fixed: [x, y, z]}}]
initial: [{{part: hammer, angular_velocity: [0, 10, 0], center: [0, 0, 0.05]}}]
contact: {{surfaces: all, friction: 0.2, enforcement: {}}}
materials:
  steel: {{model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}
  soft: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
output: {{history: {{every: 1.0e-5}}}}
)",
                                             enforcement));
    EXPECT_GT(run.history.largest("contacts"), 0) << enforcement;
    EXPECT_LT(run.history.last("body_wy:hammer"), 5) << enforcement;
    EXPECT_LT(find_largest_error(run), 2e-3) << enforcement;
    EXPECT_LT(run.summary.momentum.linear_error, 1e-11) << enforcement;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-11) << enforcement;
  }
}

// A block hits a body that is held, and pushes one that is free, beside a pendulum that nothing touches.
TEST(Joint, LeavesOtherBodiesAlone) {
  const auto run = [](const std::string& joints) {
    return run_deck(R"(
time: {end: 4.0e-4}
parts:
  block: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0, 0, 0.0001], material: soft}
  anvil: {box: {size: [0.12, 0.05, 0.04], cells: [4, 2, 1]}, at: [-0.01, -0.01, -0.04], material: soft, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  slab: {box: {size: [0.12, 0.05, 0.04], cells: [4, 2, 1]}, at: [-0.01, 0.06, -0.04], material: soft, rigid: true}
  bob: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, at: [3, 0, 0], material: soft, rigid: true}
initial: [{part: block, velocity: [0, 0, -10]}]
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: all, friction: 0.2}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
output: {history: {every: 1.0e-5, parts: all}}
)" + joints);
  };
  const Outcome with = run("joints: {pin: {kind: spherical, bodies: [bob], at: [3.05, 0.05, 1]}}\n"), without = run("");
  EXPECT_GT(without.history.largest("contacts"), 0);
  EXPECT_GT(std::abs(without.history.last("momentum_z:slab")), 0.1);
  for (const char* column : {"momentum_z:block", "momentum_z:slab", "momentum_z:anvil", "internal:block"})
    EXPECT_EQ(with.history[column], without.history[column]) << column;
}

// A rod that flies and one at rest: the joint between their ends gives both an impulse P, as an inelastic impact does.
// P (1/m + (l/2)^2 / I) on each side makes the speeds of the ends one; half of P times the speed is lost.
TEST(Joint, BeginsWithItsImpulseWhereBodiesPart) {
  const Outcome run =
      run_deck("time: {end: 0.1, max_step: 1.0e-3}\nparts:\n" + describe_rod("a", "[0, -0.01, -0.01]", 1) +
               describe_rod("b", "[1, -0.01, -0.01]", 1) + materials +
               "joints: {ab: {kind: spherical, bodies: [a, b], at: [1, 0, 0]}}\n"
               "initial: [{part: a, velocity: [0, 0, 2]}]\noutput: {history: {every: 0.01}}\n");
  const double mass = 3.2, inertia = mass * (1 + 0.02 * 0.02) / 12, impulse = 2 / (2 * (1 / mass + 0.25 / inertia));
  EXPECT_NEAR(run.history["body_vz:a"].front(), 2 - impulse / mass, 1e-12);
  EXPECT_NEAR(run.history["body_vz:b"].front(), impulse / mass, 1e-12);
  EXPECT_NEAR(run.history["body_wy:b"].front(), 0.5 * impulse / inertia, 1e-12);
  EXPECT_NEAR(run.history["kinetic"].front(), 0.5 * mass * 4 - 0.5 * impulse * 2, 1e-12);
  EXPECT_NEAR(run.history.last("momentum_z"), 2 * mass, 1e-12);
  const auto& warnings = run.summary.warnings;
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), [](const Warning& w) { return w.rule == "joint_start"; }),
            1);
}

TEST(Joint, IsTornApartWhereItsBodiesAreDrivenApart) {
  const std::string scene = "time: {end: 1, max_step: 1.0e-3}\nparts:\n" + describe_rod("a", "[0, -0.01, -0.01]", 1) +
                            describe_rod("b", "[1, -0.01, -0.01]", 1) + materials +
                            "joints: {ab: {kind: spherical, bodies: [a, b], at: [1, 0, 0]}}\n"
                            "output: {history: {every: 0.1}}\n";
  EXPECT_ERROR(run_deck(scene + "conditions: [{nodes: a, velocity: {x: 0, y: 0, z: 0}}, {nodes: b, velocity: {x: 0, y: "
                                "0, z: 1}}]\n"),
               RunError, "is torn apart in step");
}

}  // namespace percuss::test::joint_test
