// Forces and energies of springs, and the step that they leave, against exact values.

#include "src/step/springs/spring_law.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "src/error.hpp"
#include "src/step/run/run_checks.hpp"
#include "src/step/springs/build_springs.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();

SpringLaw make_table() {
  SpringLaw law;
  law.rows = {{{-1, -10}, {0, 2}, {1, 4}, {3, 5}}};
  return law;
}

TEST(SpringLaw, IsLinearBetweenRowsAndBeyondThem) {
  const SpringLaw law = make_table();
  EXPECT_DOUBLE_EQ(find_elastic_force(law, -2), -22);
  EXPECT_DOUBLE_EQ(find_elastic_force(law, -0.5), -4);
  EXPECT_DOUBLE_EQ(find_elastic_force(law, 0.5), 3);
  EXPECT_DOUBLE_EQ(find_elastic_force(law, 2), 4.5);
  EXPECT_DOUBLE_EQ(find_elastic_force(law, 5), 6);
  EXPECT_DOUBLE_EQ(find_largest_slope(law), 12);
}

TEST(SpringLaw, StoresTheAreaBelowTheTable) {
  const SpringLaw law = make_table();
  EXPECT_DOUBLE_EQ(find_stored_energy(law, 0), 0);
  EXPECT_DOUBLE_EQ(find_stored_energy(law, 1), 3);
  EXPECT_DOUBLE_EQ(find_stored_energy(law, 5), 3 + 9 + 11);
  EXPECT_DOUBLE_EQ(find_stored_energy(law, -1), 4);  // integral of -10 .. 2 from 0 to -1
  EXPECT_DOUBLE_EQ(find_stored_energy(law, -2), 4 + 16);
}

TEST(SpringLaw, OfOneWayHasNoForceTheOther) {
  SpringLaw law;
  law.rows = {{{0, 0}, {1, 100}}};
  law.acts = SpringDeck::Acts::tension;
  EXPECT_EQ(find_elastic_force(law, -1), 0);
  EXPECT_EQ(find_elastic_force(law, 1), 100);
  EXPECT_EQ(find_stored_energy(law, -1), 0);
  law.acts = SpringDeck::Acts::compression;
  EXPECT_EQ(find_elastic_force(law, 1), 0);
  EXPECT_EQ(find_stored_energy(law, -1), 50);
}

TEST(SpringLaw, PullsAlongTheLineBetweenItsEnds) {
  SpringLaw law;
  law.rows = {{{0, 0}, {1, 100}}};
  law.largest_slope = find_largest_slope(law);
  law.damping = 10;
  const SpringState now = stretch_spring(law, 3, {}, {{{1, 1, 1}, {4, 5, 1}}, {{0, 0, 0}, {0.6, 0.8, 7}}});
  EXPECT_DOUBLE_EQ(now.length, 5);
  EXPECT_DOUBLE_EQ(now.elastic, 200);
  EXPECT_DOUBLE_EQ(now.damping, 10);  // 0.6 * 0.6 + 0.8 * 0.8 along the axis
  EXPECT_DOUBLE_EQ(now.axis.x, 0.6);
  EXPECT_DOUBLE_EQ(now.axis.y, 0.8);
  EXPECT_DOUBLE_EQ(bound_stiffness(law, now), 100);
  const SpringState taut = stretch_spring(law, 0, {}, {{{0, 0, 0}, {0.1, 0, 0}}, {{0, 0, 0}, {9, 0, 0}}});
  EXPECT_DOUBLE_EQ(bound_stiffness(law, taut), 1000);  // force over length, of 10 + 90
}

TEST(SpringLaw, StaysBroken) {
  SpringLaw law;
  law.rows = {{{0, 0}, {1, 100}}};
  law.largest_elongation = 0.5;
  const SpringState broken = stretch_spring(law, 1, {}, {{{0, 0, 0}, {0.4, 0, 0}}, {}});
  EXPECT_EQ(broken.is_broken, 1);
  EXPECT_EQ(broken.force(), 0);
  EXPECT_EQ(stretch_spring(law, 1, broken, {{{0, 0, 0}, {1.2, 0, 0}}, {}}).force(), 0);
}

/// Largest x(n) of a spring and damper of mass 1 with central differences and the velocity half a step before.
double swing(double stiffness, double damping, double dt) {
  double x = 0, v = 1, largest = 0;
  for (int n = 0; n < 20000; ++n) {
    v -= dt * (stiffness * x + damping * v);
    x += dt * v;
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

// 2 (sqrt(1 + xi^2) - xi) / omega, which is the limit itself: a little more grows without bound.
TEST(SpringStep, IsTheLimitOfStability) {
  for (const double ratio : {0.0, 0.1, 1.0, 5.0}) {
    const double omega = 30, damping = 2 * ratio * omega;
    const double step = find_step_with_springs({omega * omega, damping}, infinite);
    EXPECT_NEAR(step, 2 / omega * (std::sqrt(1 + ratio * ratio) - ratio), 1e-14);
    EXPECT_LT(swing(omega * omega, damping, 0.999 * step), 2);
    EXPECT_GT(swing(omega * omega, damping, 1.001 * step), 1e3);
  }
  EXPECT_DOUBLE_EQ(find_step_with_springs({0, 4}, infinite), 0.5);  // h c <= 2
  EXPECT_LT(find_step_with_springs({1, 0}, 2.0), 2.0);
}

// --- in a scene

const std::string blocks = R"yaml(
time: {end: 1}
parts:
  a: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, material: m, rigid: {mass: 4}}
  b: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, at: [5, 0, 0], material: m, rigid: {mass: 1}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
)yaml";
const std::string centres = "between: [{near: [1, 1, 1]}, {near: [6, 1, 1]}]";

double find_bound(const std::string& springs) {
  Scene scene(blocks + "springs: " + springs + "\n");
  scene.stepper.start(scene.state);
  return scene.state.bound.step;
}

TEST(SpringStep, IsExactForASpringBetweenCentres) {
  EXPECT_DOUBLE_EQ(find_bound("{s: {" + centres + ", stiffness: 100}}"), 2 / std::sqrt(100 * (1 + 0.25)));
  EXPECT_DOUBLE_EQ(find_bound("{s: {" + centres + ", stiffness: 60}, t: {" + centres + ", stiffness: 40}}"),
                   2 / std::sqrt(100 * (1 + 0.25)));
  EXPECT_DOUBLE_EQ(find_bound("{s: {" + centres + ", damping: 10}}"), 2 / (10 * (1 + 0.25)));
}

// The cube of 2 has I = 4 m_node sums about each axis: off its centre a spring also turns it.
TEST(SpringStep, IsShorterOffTheCentre) {
  const double off = find_bound("{s: {between: [{near: [1, 1, 2]}, {near: [6, 1, 2]}], stiffness: 100}}");
  EXPECT_LT(off, 2 / std::sqrt(100 * (1 + 0.25)));
  EXPECT_GT(off, 0.5 / std::sqrt(100 * (1 + 0.25)));
}

std::int64_t find_controller(const std::string& text) {
  Scene scene(text);
  scene.stepper.start(scene.state);
  return scene.state.bound.spring;
}

// A cube of two cells an edge, E = 1 and density 1 allows 0.3 to 1; springs of 1e-3 and of 1e6 between nodes of mass
// 1 / 8 and more allow far more and far less.
TEST(SpringStep, IsPutDownToASpringThatAllowsLessThanTheElements) {
  std::string three = blocks;
  three.replace(three.find("materials:"), 0,
                "  c: {box: {size: [2, 2, 2], cells: [2, 2, 2]}, at: [8, 0, 0], material: m}\n");
  const auto find = [&](double first, double second) {
    return find_controller(
        three + fmt::format("springs: {{s: {{between: [{{near: [8, 0, 0]}}, {{near: [10, 0, 0]}}], stiffness: {}}}, "
                            "t: {{between: [{{near: [8, 2, 2]}}, {{near: [10, 2, 2]}}], stiffness: {}}}}}\n",
                            first, second));
  };
  EXPECT_EQ(find(1e-3, 1e-3), -1);
  EXPECT_EQ(find(1e6, 1e-3), 0);
  EXPECT_EQ(find(1e-3, 1e6), 1);
  EXPECT_EQ(find(1e6, 1e6), 0);  // the lowest of equals
  // Rigid bodies have no bound of elements.
  EXPECT_EQ(find_controller(blocks + "springs: {s: {" + centres + ", stiffness: 60}}\n"), 0);
}

TEST(SpringStep, ThatCollapsesNamesTheSpring) {
  Scene scene(blocks + "springs: {strap: {" + centres + ", stiffness: 100}}\n");
  scene.stepper.start(scene.state);
  try {
    check_step({scene.deck, scene.chunked, scene.model, scene.state, scene.stepper}, 1e9);
    FAIL() << "no collapse";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("spring 'strap' controls it; try a softer spring or damper"));
  }
}

// Faces of nine nodes each, opposite each other: nine springs, in the order of the nodes.
TEST(Springs, JoinEachNodeOfASetWithTheNearest) {
  const Scene scene(blocks + "springs: {s: {between: [a/x_max, b/x_min], stiffness: 1}}\n");
  const SpringModel& springs = scene.model.springs;
  ASSERT_EQ(springs.springs.size(), 9U);
  EXPECT_EQ(springs.springs.front().name, "s_1");
  EXPECT_EQ(springs.nodes.size(), 18U);
  for (const Spring& spring : springs.springs) EXPECT_DOUBLE_EQ(spring.start_length, 3);
  EXPECT_THAT(springs.notes.front(), HasSubstr("9 of them, 3 to 3 long"));
}

// Faces of 100 and of 121 nodes.
TEST(Springs, OfLargeSetsHaveNoColumns) {
  for (const int cells : {9, 10}) {
    const std::string size = fmt::format("{{size: [2, 2, 2], cells: [1, {0}, {0}]}}", cells);
    Scene scene(fmt::format(R"yaml(
time: {{end: 1}}
parts: {{a: {{box: {0}, material: m}}, b: {{box: {0}, at: [5, 0, 0], material: m}}}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}}}
springs: {{s: {{between: [a/x_max, b/x_min], stiffness: 1}}, one: {{{1}, stiffness: 1}}}}
)yaml",
                            size, centres));
    scene.stepper.start(scene.state);
    const std::size_t expected = 3 + 2 + (cells == 9 ? 200 : 0);
    EXPECT_EQ(scene.stepper.list_columns().size(), expected);
    std::vector<double> row;
    scene.stepper.append_values(scene.state, row);
    EXPECT_EQ(row.size(), expected);
    EXPECT_EQ(scene.stepper.list_columns().back().name, "spring_elongation:one");
  }
}

std::string take_error(const std::string& springs) {
  try {
    const Scene scene(blocks + "springs: " + springs + "\n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Springs, OfOneNodeAreRefused) {
  EXPECT_THAT(take_error("{s: {between: [{near: [1, 1, 1]}, a], stiffness: 1}}"),
              HasSubstr("deck.yaml:7:11: error: both ends of spring 's' are node 14 (a spring connects two"));
  EXPECT_THAT(take_error("{s: {between: [{id: 999}, a], stiffness: 1}}"),
              HasSubstr("no node has the id 999 (end of spring 's')"));
}

// The square of 1e155 is beyond the largest double.
TEST(Springs, AcrossDistancesThatOverflowAreRefused) {
  EXPECT_THAT(take_error("{s: {between: [{near: [1e155, 0, 0]}, a], stiffness: 1}}"),
              HasSubstr("no node is near [1e+155, 0, 0] (end of spring 's'; squares of distances overflow)"));
  const Deck deck = parse_deck(R"yaml(
time: {end: 1}
parts:
  a: {box: {size: [1e140, 1, 1], cells: [1, 1, 1]}, material: m}
  b: {box: {size: [1e142, 1, 1], cells: [1, 1, 1]}, at: [1e155, 0, 0], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
springs: {s: {between: [a/x_max, b/x_min], stiffness: 1}}
)yaml",
                               "deck.yaml");
  const ChunkedMesh chunked = load_mesh(deck, Communicator::world());
  try {
    find_springs(deck, chunked);
    FAIL() << "found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("deck.yaml:7:11: error: spring 's' has no node at its second end"));
  }
}

TEST(Springs, OfOneNameAreRefused) {
  const std::string nine = "s: {between: [a/x_max, b/x_min], stiffness: 1}",
                    one = "s_2: {" + centres + ", stiffness: 1}";
  EXPECT_THAT(take_error("{" + nine + ", " + one + "}"),
              HasSubstr("deck.yaml:7:59: error: entry 's_2' makes a second spring 's_2'"));
  EXPECT_THAT(take_error("{" + one + ", " + nine + "}"), HasSubstr("error: entry 's' makes a second spring 's_2'"));
}

}  // namespace
}  // namespace percuss::test
