// Nodes that move equally: their common motion, the force that it takes, and what it leaves as it was.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "tests/verification/connections/two_cubes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::constraint_test {
namespace {

std::string refuse(const std::string& deck) {
  try {
    run_deck(deck);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace

// Pulled unequally they have the acceleration of their sum, and pass on what each lacks: forces of 8 nodes each.
TEST(Constraint, MovesMassesThatArePulledUnequallyAsOne) {
  const double first = 100, second = -20;
  const Outcome run = run_deck(
      make_cubes(fmt::format("constraints: {{both: {{equal: [x], nodes: all}}}}\n"
                             "loads: {{nodal: [{{nodes: a, force: {{x: {}}}}}, {{nodes: b, force: {{x: {}}}}}]}}\n",
                             first, second)));
  const HistoryTable& history = run.history;
  const double acceleration = 8 * (first + second) / (light + heavy);
  const double passed = 8 * first - light * acceleration;
  for (std::size_t row = 1; row < history.rows(); ++row) {
    const double t = history["time"][row], moved = 0.5 * acceleration * t * t;
    EXPECT_NEAR(history["p_x"][row], moved, 1e-13);
    EXPECT_NEAR(history["q_x"][row], 0.12 + moved, 1e-13);
    EXPECT_NEAR(history["equal_x:both"][row], passed, 1e-10 * passed);
  }
  // What the half step before time 0 would have made of each force alone, and nothing after the first step.
  const double dt = history["time"][1];
  const double of_start = 0.125 * dt * dt * 64 * (first * first / light + second * second / heavy) -
                          0.125 * dt * dt * std::pow(8 * (first + second), 2) / (light + heavy);
  EXPECT_NEAR(history["equal_work"][1], of_start, 1e-10 * of_start);
  EXPECT_NEAR(history.last("equal_work"), of_start, 1e-10 * of_start);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// The nodes follow those that a condition drives; the support takes the force of all.
TEST(Constraint, FollowsWhatIsHeld) {
  const Outcome run =
      run_deck(make_cubes("constraints: {both: {equal: [x], between: [b, a]}}\n"
                          "conditions: [{nodes: a, velocity: {x: {expression: 1e6 * t}}}]\n",
                          ", forces: [{name: held, support: a}]"));
  for (std::size_t row = 2; row < run.history.rows(); ++row) {
    EXPECT_NEAR(run.history["q_x"][row] - run.history["p_x"][row], 0.12, 1e-13);
    EXPECT_NEAR(run.history["fx:held"][row], 1e6 * (light + heavy), 1e-6 * 1e6 * heavy);
    EXPECT_NEAR(run.history["equal_x:both"][row], 1e6 * heavy, 1e-6 * 1e6 * heavy);
  }
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-10);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// A bar of periodic ends that is pulled at one of them moves as the same bar without a constraint that is pulled by
// half at both: the ends pass on that half, in each step.
TEST(Constraint, MakesTheEndsOfABarOnePlace) {
  const auto pull = [](const std::string& rest) {
    return run_deck(R"yaml(
time: {end: 2e-4}
parts: {bar: {box: {size: [0.2, 0.02, 0.02], cells: [10, 1, 1]}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
output: {history: {every: 0, nodes: [{name: p, near: [0, 0, 0]}, {name: m, near: [0.1, 0.02, 0]}, {name: q, near: [0.2, 0, 0]}]}}
)yaml" + rest);
  };
  const Outcome ring = pull(
      "constraints: {ring: {equal: [x, y, z], between: [bar/x_min, bar/x_max]}}\n"
      "loads: {nodal: [{nodes: bar/x_min, force: {x: 1}}]}\n");
  const Outcome free =
      pull("loads: {nodal: [{nodes: bar/x_min, force: {x: 0.5}}, {nodes: bar/x_max, force: {x: 0.5}}]}\n");
  ASSERT_EQ(ring.history.rows(), free.history.rows());
  for (std::size_t row = 1; row < ring.history.rows(); ++row) {
    for (const char* place : {"p_x", "m_x", "m_y", "q_x", "q_y", "q_z"})
      EXPECT_NEAR(ring.history[place][row], free.history[place][row], 1e-14) << place;
    EXPECT_NEAR(ring.history["equal_x:ring"][row], -2, 1e-6 * 2);  // of four nodes
  }
  EXPECT_EQ(ring.summary.steps, free.summary.steps);
  EXPECT_LT(std::abs(ring.summary.energy.error - free.summary.energy.error), 1e-10);
}

// A block whose faces are pairs in all directions, so that each edge and corner belongs to several, spins and is
// struck.
TEST(Constraint, OfSharedNodesKeepsMomentum) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-4}
parts:
  block: {box: {size: [0.06, 0.06, 0.06], cells: [3, 3, 3]}, material: steel}
  hammer: {box: {size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}, at: [0.02, 0.02, 0.0601], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
constraints:
  x: {equal: [x, y, z], between: [block/x_min, block/x_max]}
  y: {equal: [x, y, z], between: [block/y_min, block/y_max]}
initial: [{part: block, velocity: [3, 1, 5], angular_velocity: [10, 0, 50]}, {part: hammer, velocity: [3, 1, -20]}]
contact: {surfaces: all}
output: {history: {every: 0, nodes: [{name: a, near: [0, 0, 0]}, {name: b, near: [0.06, 0.06, 0]}]}}
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  EXPECT_GT(run.history.largest("contacts"), 0);
  EXPECT_LT(run.history.last("equal_work"), 0);  // its spin has been taken out
  const auto& history = run.history;
  for (const char* k : {"x", "y", "z"}) {
    const std::vector<double>&a = history[std::string("a_") + k], &b = history[std::string("b_") + k];
    EXPECT_NEAR(b.back() - a.back(), b.front() - a.front(), 1e-15);
  }
}

TEST(Constraint, IsRefusedWhereItCannotBe) {
  EXPECT_NE(refuse(make_cubes("constraints: {c: {equal: [x], between: [a/x_min, b]}}\n"))
                .find("has 4 nodes on its first side and 8 on its second"),
            std::string::npos);
  EXPECT_NE(refuse(make_cubes("constraints: {c: {equal: [x], nodes: all}}\n"
                              "conditions: [{nodes: a, fixed: [x]}, {nodes: b, velocity: {x: 1}}]\n"))
                .find("another condition holds"),
            std::string::npos);
  EXPECT_NE(refuse(make_cubes("constraints: {c: {equal: [x], nodes: a}}\nrigid_sets: {r: {nodes: a/x_min}}\n"))
                .find("belongs to a rigid body"),
            std::string::npos);
  EXPECT_NE(refuse(make_cubes("constraints: {c: {equal: [x], nodes: a}}\nwelds: {w: {between: [a/x_min, b/x_min]}}\n"))
                .find("is welded"),
            std::string::npos);
  EXPECT_NE(refuse(make_cubes("constraints: {c: {equal: [x]}}\n")).find("neither nodes nor between"),
            std::string::npos);
}

}  // namespace percuss::test::constraint_test
