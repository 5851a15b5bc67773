// Linear equations of displacements: levers, slopes and periodic cells against mechanics; what they take and give.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/verification/connections/two_cubes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::equation_test {
namespace {

/// A bar of one material between periodic ends, whose difference is driven; free across.
std::string make_cell(const std::string& constraints, double end) {
  return fmt::format(R"yaml(
time: {{end: {}}}
parts: {{cell: {{box: {{size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
output: {{history: {{every: 0, nodes: [{{name: p, near: [0, 0, 0]}}, {{name: q, near: [0.02, 0, 0]}}, {{name: r, near: [0.02, 0.02, 0]}}]}}}}
{}
)yaml",
                     end, constraints);
}

template <class Error>
std::string find_refusal(const std::string& deck) {
  try {
    run_deck(deck);
  } catch (const Error& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace

// A massless lever with arms of 1 and 2: m_a a_a = f + 2 r, m_b a_b = -r, a_b = 2 a_a.
TEST(Equation, IsALever) {
  const double force = 100;
  const Outcome run =
      run_deck(make_cubes(fmt::format("constraints:\n"
                                      "  lever: {{equation: [{{nodes: a, direction: x, factor: 2}}, "
                                      "{{nodes: b, direction: y, factor: -1}}]}}\n"
                                      "loads: {{nodal: [{{nodes: a, force: {{x: {}}}}}]}}\n",
                                      force)));
  const double acceleration = 8 * force / (light + 4 * heavy), row = 2 * acceleration * heavy;
  for (std::size_t i = 1; i < run.history.rows(); ++i) {
    const double t = run.history["time"][i], moved = 0.5 * acceleration * t * t;
    EXPECT_NEAR(run.history["p_x"][i], moved, 1e-13);
    EXPECT_NEAR(run.history["q_y"][i], 0.07 + 2 * moved, 1e-13);
    EXPECT_NEAR(run.history["equation:lever"][i], -row, 1e-10 * row);
  }
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// A cube on a frictionless slope of 30 degrees slides with g sin 30.
TEST(Equation, HoldsNodesOnASlope) {
  const double sine = 0.5, cosine = std::sqrt(0.75), g = 1000;
  const Outcome run =
      run_deck(make_cubes(fmt::format("constraints:\n"
                                      "  slope: {{equation: [{{nodes: a, direction: x, factor: {:.17g}}}, "
                                      "{{nodes: a, direction: z, factor: {:.17g}}}]}}\n"
                                      "loads: {{gravity: [0, 0, -{}]}}\n",
                                      sine, cosine, g)));
  for (std::size_t i = 1; i < run.history.rows(); ++i) {
    const double t = run.history["time"][i], way = 0.5 * g * sine * t * t;
    EXPECT_NEAR(run.history["p_x"][i], way * cosine, 1e-15);
    EXPECT_NEAR(run.history["p_z"][i], -way * sine, 1e-15);
    EXPECT_NEAR(run.history["equation:slope"][i], light * g * cosine, 1e-10 * light * g);
  }
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-11);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// A periodic cell whose ends move apart slowly has uniaxial stress: force E A eps, contraction nu eps, energy E V eps^2
// / 2. Edges and corners have several equations, which depend on each other.
TEST(Equation, DrivesAPeriodicCell) {
  const std::string periodic =
      "  pull: {equation: [{nodes: cell/x_max, direction: x, factor: 1}, {nodes: cell/x_min, direction: x, factor: "
      "-1}], "
      "sum: {expression: 2e-5 * (t / 4e-4)^3 * (10 - 15 * t / 4e-4 + 6 * (t / 4e-4)^2)}}\n"
      "  level: {equal: [y, z], between: [cell/x_max, cell/x_min]}\n"
      "  side: {equal: [x, z], between: [cell/y_max, cell/y_min]}\n"
      "  flat: {equal: [x, y], between: [cell/z_max, cell/z_min]}\n"
      "  broad: {equal: [y], nodes: cell/y_max}\n"
      "  thick: {equal: [z], nodes: cell/z_max}\n";
  const Outcome run = run_deck(make_cell("constraints:\n" + periodic, 4e-4));
  const double strain = 1e-3, modulus = 200e9, area = 4e-4, length = 0.02;
  const HistoryTable& history = run.history;
  EXPECT_NEAR(history.last("q_x") - history.last("p_x"), length * (1 + strain), 1e-12 * length);
  EXPECT_NEAR(history.last("r_y") - history.last("q_y"), length * (1 - 0.3 * strain), 0.02 * 0.3 * strain * length);
  EXPECT_NEAR(history.last("equation:pull"), modulus * area * strain, 0.005 * modulus * area * strain);
  EXPECT_NEAR(history.last("external"), 0.5 * modulus * area * length * strain * strain,
              0.005 * 0.5 * modulus * area * length * strain * strain);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-10);
}

// Four terms: the difference of two corners of one cube is that of two corners of the other.
TEST(Equation, OfFourTermsKeepsDifferencesEqual) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-4, max_step: 1e-6}
parts:
  a: {box: {size: [0.02, 0.02, 0.02], cells: [1, 1, 1]}, material: soft}
  b: {box: {size: [0.02, 0.02, 0.02], cells: [1, 1, 1]}, at: [0.1, 0, 0], material: soft}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
constraints:
  shape:
    equation:
      - {nodes: {near: [0.02, 0, 0]}, direction: y, factor: 1}
      - {nodes: {near: [0, 0, 0]}, direction: y, factor: -1}
      - {nodes: {near: [0.12, 0, 0]}, direction: y, factor: -1}
      - {nodes: {near: [0.1, 0, 0]}, direction: y, factor: 1}
initial: [{part: a, velocity: [0, 0, 0], angular_velocity: [0, 0, 100]}]
output:
  history:
    every: 0
    nodes: [{name: p, near: [0, 0, 0]}, {name: p2, near: [0.02, 0, 0]}, {name: q, near: [0.1, 0, 0]}, {name: q2, near: [0.12, 0, 0]}]
)yaml");
  const HistoryTable& history = run.history;
  EXPECT_GT(std::abs(history.last("q2_y") - history.last("q_y")), 1e-6);
  for (std::size_t i = 0; i < history.rows(); ++i)
    EXPECT_NEAR(history["p2_y"][i] - history["p_y"][i], history["q2_y"][i] - history["q_y"][i], 1e-15);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// Pairs and sets as rows beside an equation move as they do as groups without one.
TEST(Equation, LeavesEqualNodesAsTheyAre) {
  const std::string block = R"yaml(
time: {end: 1e-4}
parts:
  block: {box: {size: [0.06, 0.06, 0.06], cells: [3, 3, 3]}, material: steel}
  lone: {box: {size: [0.06, 0.06, 0.06], cells: [1, 1, 1]}, at: [1, 0, 0], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{part: block, velocity: [3, 1, 5], angular_velocity: [10, 0, 50]}]
output: {history: {every: 0, nodes: [{name: a, near: [0, 0, 0]}, {name: b, near: [0.06, 0.06, 0]}]}}
constraints:
  x: {equal: [x, y, z], between: [block/x_min, block/x_max]}
  y: {equal: [x, y, z], between: [block/y_min, block/y_max]}
  top: {equal: [z], nodes: block/z_max}
)yaml";
  const Outcome groups = run_deck(block);
  const Outcome rows = run_deck(block +
                                "  lone: {equation: [{nodes: lone/x_min, direction: x, factor: 1}, "
                                "{nodes: lone/x_max, direction: x, factor: 1}]}\n");
  ASSERT_EQ(groups.history.rows(), rows.history.rows());
  for (std::size_t i = 0; i < rows.history.rows(); ++i)
    for (const char* column : {"a_x", "a_y", "a_z", "b_x", "b_y", "b_z"})
      EXPECT_NEAR(rows.history[column][i], groups.history[column][i], 1e-13) << column;
}

TEST(Equation, IsRefusedWhereItCannotBe) {
  const std::string both = "equation: [{nodes: a, direction: x, factor: 1}, {nodes: b, direction: x, factor: -1}]";
  EXPECT_NE(
      find_refusal<RunError>(make_cubes("constraints: {c: {" + both +
                                        "}}\nconditions: [{nodes: a, fixed: [x]}, {nodes: b, velocity: {x: 1}}]\n"))
          .find("constraint 'c' does not hold at t = 0"),
      std::string::npos);
  EXPECT_NE(
      find_refusal<InputError>(make_cubes("constraints: {c: {equation: [{nodes: a/x_min, direction: x, factor: 1}, "
                                          "{nodes: b, direction: x, factor: -1}]}}\n"))
          .find("has 4 nodes on its first side and 8 on its second"),
      std::string::npos);
  EXPECT_NE(find_refusal<InputError>(make_cubes("constraints: {c: {" + both + ", sum: 1}}\n")).find("is 1 at time 0"),
            std::string::npos);
  EXPECT_NE(
      find_refusal<InputError>(make_cubes("constraints: {c: {equal: [x], " + both + "}}\n")).find("equation and equal"),
      std::string::npos);
  EXPECT_NE(find_refusal<InputError>(make_cubes("constraints: {c: {nodes: a}}\n")).find("must have equal or equation"),
            std::string::npos);
  EXPECT_NE(
      find_refusal<InputError>(make_cubes("constraints: {c: {equation: [{nodes: a, direction: x, factor: 0}]}}\n"))
          .find("has a factor of 0"),
      std::string::npos);
}

}  // namespace percuss::test::equation_test
