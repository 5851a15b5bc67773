// Sets of nodes that move as one: bodies of their own, and nodes of others.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rigid_set_test {
namespace {

constexpr double area = 0.01, h = 0.1, density = 8000, modulus = 200e9;
constexpr int cells = 10;

const std::string bar = R"(
time: {end: 1.0e-3, step_scale: 0.1}
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{part: bar/x_max, velocity: [1.0e-3, 0, 0]}]
output: {history: {every: 1.0e-6}}
)";

/// Largest deviation of the end of a bar from that of a chain of masses and springs with a mass at its end, over how
/// far it goes. The bar is one element wide, without lateral contraction: it is that chain, up to the square of the
/// strain.
double compare_with_chain(const HistoryTable& history, const std::string& column, double end_mass) {
  const double stiffness = modulus * area / h, m = density * area * h;
  std::array<double, cells + 1> x{}, v{}, mass{};
  for (std::size_t i = 0; i <= cells; ++i) mass[i] = i == 0 ? 0.5 * m : (i < cells ? m : 0.5 * m + end_mass);
  v[cells] = 1e-3;
  const int steps = 100000;
  const double dt = 1e-3 / steps;
  double farthest = 0, largest = 0;
  for (int n = 0; n < steps; ++n) {
    std::array<double, cells + 1> f{};
    for (std::size_t i = 0; i < cells; ++i) {
      const double pull = stiffness * (x[i + 1] - x[i]);
      f[i] += pull;
      f[i + 1] -= pull;
    }
    for (std::size_t i = 0; i <= cells; ++i) {
      v[i] += (n == 0 ? 0.5 : 1) * dt * f[i] / mass[i];
      x[i] += dt * v[i];
    }
    if ((n + 1) % 1000 != 0) continue;
    const double moved = history.at((n + 1) * dt, column) - history[column].front();
    farthest = std::max(farthest, std::abs(moved - x[cells]));
    largest = std::max(largest, std::abs(x[cells]));
  }
  return farthest / largest;
}

double find_distance(const HistoryTable& history, std::size_t row, const std::string& a, const std::string& b) {
  double square = 0;
  for (const char* axis : {"_x", "_y", "_z"}) square += std::pow(history[a + axis][row] - history[b + axis][row], 2);
  return std::sqrt(square);
}

}  // namespace

TEST(RigidSet, WithAddedMassMovesWithItsBarAsALumpedChain) {
  const Outcome run = run_deck(bar + R"(
parts: {bar: {box: {size: [1, 0.1, 0.1], cells: [10, 1, 1]}, material: steel}}
rigid_sets: {end: {nodes: bar/x_max, mass: 16}}
)");
  EXPECT_LT(compare_with_chain(run.history, "body_x:end", 16), 1e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
}

// Nodes that join a free body far from them, whose mass and centre they share.
TEST(RigidSet, JoinsAFreeBody) {
  std::string text = bar;
  text.replace(text.find("initial: [{part: bar/x_max"), 26, "initial: [{part: block");
  const Outcome run = run_deck(text + R"(
parts:
  bar: {box: {size: [1, 0.1, 0.1], cells: [10, 1, 1]}, material: steel}
  block: {box: {size: [0.2, 0.1, 0.1], cells: [2, 1, 1]}, at: [1.5, 0, 0], material: steel, rigid: true}
rigid_sets: {weld: {nodes: bar/x_max, body: block}}
)");
  const double block = density * area * 0.2, end = 0.5 * density * area * h;
  EXPECT_NEAR(run.history["body_x:block"].front(), (block * 1.6 + end * 1) / (block + end), 1e-12);
  EXPECT_LT(compare_with_chain(run.history, "body_x:block", block), 1e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
}

// One node each of two cubes, on a line: nothing turns the body about it, and nothing about it is not a number.
TEST(RigidSet, OfTwoNodesKeepsTheirDistance) {
  const Outcome run = run_deck(R"(
time: {end: 0.02}
parts:
  a: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, material: soft}
  b: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0.3, 0.02, 0.01], material: soft}
rigid_sets: {link: {nodes: {name: all, inside: [[0.09, 0.045, 0.045], [0.31, 0.075, 0.065]]}}}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
initial: [{part: all, velocity: [0, 0, 1], angular_velocity: [2, 3, 20]}]
output: {history: {every: 1.0e-4, nodes: [{name: p, near: [0.1, 0.05, 0.05]}, {name: q, near: [0.3, 0.07, 0.06]}]}}
)");
  EXPECT_NE(run.history["p_x"].front(), run.history["q_x"].front());
  for (std::size_t row = 0; row < run.history.rows(); ++row)
    EXPECT_NEAR(find_distance(run.history, row, "p", "q"), find_distance(run.history, 0, "p", "q"), 1e-13);
  EXPECT_GT(std::abs(run.history.last("body_q3:link")), 0.05);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
}

// The edge of a shell as one body, turned about its middle line by a moment of its nodes: their rotary inertia is
// there.
TEST(RigidSet, OfTheNodesOfAShellTakesMoments) {
  const Outcome run = run_deck(R"(
time: {end: 2.0e-3}
parts: {sheet: {shell_plate: {size: [0.2, 0.1], cells: [8, 4]}, thickness: 0.002, material: steel}}
rigid_sets: {edge: {nodes: sheet/x_max}}
conditions: [{nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}]
loads: {nodal: [{nodes: sheet/x_max, moment: {y: -1}}]}
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}
output: {history: {every: 1.0e-5}}
)");
  EXPECT_GT(std::abs(run.history.last("body_q2:edge")), 1e-4);
  EXPECT_NEAR(run.history.last("body_q1:edge"), 0, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
}

// The ram weighs 300 and the cube 8; the set brings 20.
TEST(RigidSet, ItsMassIsInNoPartUnlessItJoinsOneWithAGivenMass) {
  const std::string two = R"(
time: {end: 1.0e-3, max_step: 1.0e-4}
parts:
  ram: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel, rigid: {mass: 300}}
  cube: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [3, 0, 0], material: steel}
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e6, poissons_ratio: 0}}
initial: [{velocity: [2, 0, 0]}]
output: {history: {every: 0, parts: all}}
)";
  const HistoryTable alone = run_deck(two + "rigid_sets: {rim: {nodes: cube/x_max, mass: 20}}\n").history;
  EXPECT_NEAR(alone["momentum_x"].front(), 2 * 328, 1e-10);
  EXPECT_NEAR(alone["mass:ram"].front(), 300, 1e-10);
  EXPECT_NEAR(alone["mass:cube"].front(), 8, 1e-12);
  EXPECT_NEAR(alone["momentum_x:cube"].front(), 2 * 8, 1e-12);
  const HistoryTable joined = run_deck(two + "rigid_sets: {rim: {nodes: cube/x_max, body: ram, mass: 20}}\n").history;
  EXPECT_NEAR(joined["mass:ram"].front() + joined["mass:cube"].front(), 328, 1e-10);
  EXPECT_NEAR(joined["mass:cube"].front(), 6, 1e-12);  // the nodes of the set, a quarter, are of the body
  EXPECT_NEAR(joined["momentum_x:ram"].front(), 2 * 322, 1e-10);
}

}  // namespace percuss::test::rigid_set_test
