// Dynamic relaxation ends in the static solution, in which the run then rests; preloads have the force of the deck.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::relaxation_test {
namespace {

using testing::HasSubstr;

constexpr double young = 200e9, density = 7850;

/// Steel without Poisson's ratio, and a start that relaxes it.
std::string make_deck(const std::string& time, const std::string& rest) {
  return fmt::format(R"yaml(
time: {{{}}}
materials: {{steel: {{model: elastic, density: {}, youngs_modulus: {}, poissons_ratio: 0}}}}
{}
)yaml",
                     time, density, young, rest);
}

/// The energy balance of the run, and the kinetic energy that it keeps: a share of what elements hold.
void expect_rest(const Outcome& run, double share) {
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  EXPECT_LT(run.history.largest("kinetic"), share * run.summary.relaxation.energy);
  EXPECT_NEAR(run.summary.energy.initial, run.summary.relaxation.energy, 1e-6 * run.summary.relaxation.energy);
  for (std::size_t row = 0; row < run.history.rows(); ++row)
    ASSERT_LT(std::abs(run.history["energy_error"][row]), 1e-9);
}

std::string hang(const std::string& bar) {
  return make_deck("end: 2e-3", R"yaml(
parts: {bar: {box: {size: [0.1, 0.1, 1.0], cells: [1, 1, 20]}, )yaml" +
                                    bar + R"yaml(material: steel}}
conditions: [{nodes: bar/z_max, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -1e4]}
start: {relaxation: {tolerance: 1e-12}}
output: {history: {every: 1e-5, nodes: [{name: tip, near: [0, 0, 0]}]}}
)yaml");
}

}  // namespace

TEST(Relaxation, AHangingBarIsAsLongAsItsWeightMakesIt) {
  const Outcome run = run_deck(hang(""));
  // rho g L^2 / (2 E) = 1.9625e-4 m; with lumped masses that of equal elements is exact. The strain at the top, 4e-4,
  // is logarithmic: its square counts.
  const double exact = density * 1e4 / (2 * young);
  const double z0 = run.history["tip_z"][0];
  fmt::print("{} damped steps, end moves by {:.6g}, exact {:.6g}\n", run.summary.relaxation.steps, z0, -exact);
  EXPECT_NEAR(z0, -exact, 5e-4 * exact);
  EXPECT_NEAR(run.history.smallest("tip_z"), z0, 1e-5 * exact);
  EXPECT_NEAR(run.history.largest("tip_z"), z0, 1e-5 * exact);
  // w^2 A L / (6 E) with the weight per area w at the top, of whole elements a little less: 1 / (4 n^2)
  const double stress = density * 1e4;
  EXPECT_NEAR(run.summary.relaxation.energy, stress * stress * 0.01 / (6 * young),
              2e-3 * stress * stress * 0.01 / (6 * young));
  EXPECT_EQ(run.history["external"][0], 0);
  expect_rest(run, 1e-9);
}

TEST(Relaxation, TheFirstFrequencyOfTheBarIsFound) {
  const Outcome run = run_deck(hang(""));
  const double exact = std::sqrt(young / density) / 4;  // of a bar held at one end
  EXPECT_NEAR(run.summary.relaxation.frequency, exact, 0.1 * exact);
}

TEST(Relaxation, OfTetrahedraEndsInTheSameLength) {
  const Outcome run = run_deck(hang("elements: tetrahedra, "));
  const double exact = density * 1e4 / (2 * young);
  EXPECT_NEAR(run.history["tip_z"][0], -exact, 0.01 * exact);
  expect_rest(run, 1e-8);
}

// A bar of 20 cells of 0.05, and one whose upper half has cells of 0.0025 and a material a hundred times as stiff:
// their stable steps are as 200 to 1. It takes no more steps than an even bar of as many cells, where steps go with
// their number; with the physical masses it would take 150 000. Gravity pulls on the physical masses.
TEST(Relaxation, AGradedBarTakesNoMoreStepsThanAnEvenOne) {
  const auto hang_two = [](const std::string& elements, int cells, const std::string& upper) {
    return run_deck(fmt::format(R"yaml(
time: {{end: 1e-6}}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
  diamond: {{model: elastic, density: 7850, youngs_modulus: 20e12, poissons_ratio: 0}}
parts:
  low: {{box: {{size: [0.1, 0.1, 0.5], cells: [1, 1, 10]}}, {0}material: steel}}
  high: {{box: {{size: [0.1, 0.1, 0.5], cells: [1, 1, {1}]}}, at: [0, 0, 0.5], {0}material: {2}}}
join: true
conditions: [{{nodes: high/z_max, fixed: [x, y, z]}}]
loads: {{gravity: [0, 0, -1e3]}}
start: {{relaxation: {{tolerance: 1e-10}}}}
output: {{history: {{every: 0, nodes: [{{name: tip, near: [0, 0, 0]}}], forces: [{{name: top, support: high/z_max}}]}}}}
)yaml",
                                elements, cells, upper));
  };
  const struct {
    const char* elements;
    int cells;
  } cases[] = {{"", 200}, {"elements: wedges, ", 200}, {"elements: tetrahedra, ", 10}};
  for (const auto& [elements, cells] : cases) {
    const Outcome even = hang_two(elements, 10, "steel"), graded = hang_two(elements, cells, "diamond");
    const double weight = density * 1e3 * 0.5;  // of half a bar, per area
    const double exact = 0.5 * (0.5 * weight + 1.5 * weight) / young,
                 stiff = 0.5 * (0.5 * weight + 1.5 * weight / 100) / young;
    const double even_steps = static_cast<double>(even.summary.relaxation.steps);
    fmt::print("{}{} and {} damped steps\n", elements, even_steps, graded.summary.relaxation.steps);
    EXPECT_NEAR(even.history["tip_z"][0], -exact, 0.01 * exact);
    EXPECT_NEAR(graded.history["tip_z"][0], -stiff, 0.01 * stiff);
    EXPECT_NEAR(graded.history.last("fz:top"), 2 * weight * 0.01, 0.01 * 2 * weight * 0.01);
    EXPECT_LT(static_cast<double>(graded.summary.relaxation.steps), (10 + cells) / 20.0 * even_steps);
  }
}

TEST(Relaxation, SpringsDoNotBreakInTheDampedSteps) {
  const double weight = density * 1e-3 * 10;
  const std::string deck = make_deck("end: 1e-3", fmt::format(R"yaml(
parts:
  base: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, at: [0, 0, 0.6], material: steel, rigid: {{fixed: [x, y, z, rx, ry, rz]}}}}
  block: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, material: steel}}
springs:
  hanger: {{between: [{{near: [0.05, 0.05, 0.6], part: base}}, {{near: [0.05, 0.05, 0.1], part: block}}],
           stiffness: 1e5, failure: {{force: {}}}}}
loads: {{gravity: [0, 0, -10]}}
start: {{relaxation: {{ramp: 0}}}}
output: {{history: {{every: 1e-4}}}}
)yaml",
                                                              0.9 * weight));
  const Outcome run = run_deck(deck);
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  // It breaks when the run begins, and what it held is gone.
  EXPECT_EQ(run.history["spring_force:hanger"][0], 0);
  EXPECT_EQ(run.history["spring_work"][0], 0);
  EXPECT_LT(run.summary.energy.initial, 0.01 * weight * weight / (2 * 1e5));
}

TEST(Relaxation, ACantileverOfShellsBendsAsABeam) {
  const Outcome run = run_deck(make_deck("end: 5e-3", R"yaml(
parts: {plate: {shell_plate: {size: [1.0, 0.1], cells: [20, 2]}, thickness: 0.02, material: steel}}
conditions: [{nodes: plate/x_min, fixed: [x, y, z, rx, ry, rz]}]
loads: {gravity: [0, 0, -9.81]}
start: {relaxation: {tolerance: 1e-10, ramp: 0}}
output: {history: {every: 1e-4, nodes: [{name: tip, near: [1, 0.05, 0]}]}}
)yaml"));
  // q L^4 / (8 E I) per width, and the shear of Timoshenko's beam, q L^2 / (2 G A 5 / 6), 2e-4 of it; 1 / (4 n^2) each
  // for lumped loads and rotations between nodes
  const double load = density * 9.81 * 0.02, exact = load / (8 * young * 0.02 * 0.02 * 0.02 / 12);
  const double bend = run.history["tip_z"][0];
  fmt::print("{} damped steps, tip {:.6g}, exact {:.6g}\n", run.summary.relaxation.steps, bend, -exact);
  EXPECT_NEAR(bend, -exact, 5e-3 * exact);
  EXPECT_NEAR(run.history.largest("tip_z"), bend, 1e-3 * exact);
  expect_rest(run, 1e-7);
}

TEST(Relaxation, AThinSkewPlateRestsThoughNothingBringsItsSpinsBack) {
  // Morley's plate, an angle of 30 degrees: 0.408e-3 q L^4 / D in its middle (Skew Plates and Structures, 1963).
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-6}
parts: {plate: {shell_plate: {size: [100, 50], cells: [16, 16]}, thickness: 1, material: m}}
imperfections: [{nodes: plate, direction: x, mode: "y*tan(pi/3)"}]
materials: {m: {model: elastic, density: 1e-3, youngs_modulus: 1e7, poissons_ratio: 0.3}}
start: {relaxation: {tolerance: 1e-9}}
conditions:
  - {nodes: plate, fixed: [x, y]}
  - {nodes: plate/x_min, fixed: [z]}
  - {nodes: plate/x_max, fixed: [z]}
  - {nodes: plate/y_min, fixed: [z]}
  - {nodes: plate/y_max, fixed: [z]}
loads: {pressure: [{faces: plate/bottom, value: 0.1, direction: z}]}
output: {history: {every: 0, nodes: [{name: middle, near: [93.3, 25, 0]}]}}
)yaml");
  const double exact = 0.408e-3 * 0.1 * 1e8 / (1e7 / (12 * (1 - 0.09)));
  fmt::print("{} damped steps, {:.4f} of {:.4g}\n", run.summary.relaxation.steps, run.history["middle_z"][0] / exact,
             exact);
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  EXPECT_LT(run.summary.relaxation.steps, 10000);
  EXPECT_NEAR(run.history["middle_z"][0], exact, 0.07 * exact);
}

TEST(Relaxation, ATwistedBeamBendsAsItsTheorySays) {
  // MacNeal and Harder, A proposed standard set of problems to test finite element accuracy, 1985: 5.424e-3.
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-9}
parts: {beam: {shell_plate: {size: [12, 1.1], cells: [12, 2]}, at: [0, -0.55, 0], thickness: 0.32, material: m}}
imperfections:
  - {nodes: beam, direction: y, mode: "y*cos(pi/24*x)-y"}
  - {nodes: beam, direction: z, mode: "y*sin(pi/24*x)"}
materials: {m: {model: elastic, density: 1e-3, youngs_modulus: 29e6, poissons_ratio: 0.22}}
start: {relaxation: {tolerance: 1e-8}}
conditions: [{nodes: beam/x_min, fixed: [x, y, z, rx, ry, rz]}]
loads: {nodal: [{nodes: beam/x_max, force: {z: 0.33333333}}]}
output: {history: {every: 0, nodes: [{name: tip, near: [12, 0, 0]}]}}
)yaml");
  fmt::print("{} damped steps, {:.4f} of 5.424e-3\n", run.summary.relaxation.steps, run.history["tip_z"][0] / 5.424e-3);
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  EXPECT_LT(run.summary.relaxation.steps, 16000);
  EXPECT_NEAR(run.history["tip_z"][0], 5.424e-3, 0.01 * 5.424e-3);
}

namespace {

/// A bar between two clamps, with a preload of 60 kN.
std::string clamp(const std::string& bar, const std::string& more = "") {
  return make_deck("end: 1e-3", R"yaml(
parts: {bar: {box: {size: [0.02, 0.03, 0.4], cells: [2, 3, 20]}, )yaml" +
                                    bar + R"yaml(material: steel}}
conditions: [{nodes: bar/z_max, fixed: [x, y, z]}, {nodes: bar/z_min, fixed: [x, y, z]}]
start:
  relaxation: {tolerance: 1e-12}
  preload: {bolt: {part: bar, point: [0, 0, 0.21], normal: z, force: 60e3}}
output: {history: {every: 0, forces: [{name: cut, section: {part: bar, point: [0, 0, 0.1], normal: z}}]}}
)yaml" + more);
}

/// The force of the section in each step: impulses over steps, which are a force where steps do not change.
void expect_force(const Outcome& run, double force, double share) {
  for (std::size_t row = 2; row < run.history.rows(); ++row) {
    const double dt = run.history["dt"][row], before = run.history["dt"][row - 1];
    if (std::abs(dt - before) > 1e-9 * dt) continue;
    ASSERT_NEAR(run.history["fz:cut"][row], force, share * std::abs(force)) << "row " << row;
  }
}

class ClampedBar : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Elements, ClampedBar, testing::Values("", "integration: full, ", "hourglass: viscous, "));

TEST_P(ClampedBar, HasItsPreloadAndItsEnergy) {
  const Outcome run = run_deck(clamp(GetParam()));
  EXPECT_LT(run.summary.relaxation.preload_error, 1e-6);
  expect_force(run, 60e3, 1e-6);
  // F^2 L / (2 E A): the layer that was shortened holds its share. Its length, a twentieth, has lost 1e-2, and the
  // stress 5e-4 of E changes energies by as much.
  const double exact = 60e3 * 60e3 * 0.4 / (2 * young * 6e-4);
  fmt::print("energy {:.6g}, exact {:.6g}\n", run.summary.relaxation.energy, exact);
  EXPECT_NEAR(run.summary.relaxation.energy, exact, 2e-3 * exact);
  expect_rest(run, 1e-9);
}

}  // namespace

// Their layer is ragged or shares its rates with the next, and holds stresses of its own.
TEST(Preload, OfTetrahedraWedgesAndPyramidsHasItsForce) {
  for (const char* elements : {"elements: tetrahedra, ", "elements: wedges, ", "elements: pyramids, "}) {
    const Outcome run = run_deck(clamp(elements));
    expect_force(run, 60e3, 1e-5);
    expect_rest(run, 1e-7);
  }
}

TEST(Preload, PushesToo) {
  const Outcome run = run_deck(clamp(""), {"start.preload.bolt.force=-60e3"});
  expect_force(run, -60e3, 1e-6);
  expect_rest(run, 1e-9);
}

/// After time 0 the layer is ordinary material: the end that moves by u changes the force by E A u / L.
TEST(Preload, IsReleasedIntoOrdinaryMaterial) {
  const std::string text = clamp("");
  const Outcome run =
      run_deck(text, {"time.end=4e-3", "conditions.0.fixed=[x, y]", "output.history.every=2e-5",
                      "conditions.2={nodes: bar/z_max, displacement: {z: {expression: \"1e-4 * sin(pi * "
                      "t / 8e-3) ^ 2\"}}}"});
  const double more = young * 6e-4 * 1e-4 / 0.4;
  EXPECT_NEAR(run.history.last("fz:cut"), 60e3 + more, 0.01 * more);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

TEST(Relaxation, AStackStandsOnAWallWithItsWeight) {
  const Outcome run = run_deck(R"yaml(
time: {end: 5e-3}
parts:
  low: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: m}
  top: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0, 0, 0.1], material: m}
  ball: {sphere: {radius: 0.03, cells: 8}, at: [0.05, 0.05, 0.3], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
walls: [{name: floor, point: [0, 0, 0], normal: z}]
initial: [{part: ball, velocity: [0, 0, -1]}]
loads: {gravity: [0, 0, -100]}
contact: {friction: 0.3}
start: {relaxation: {hold: [ball]}}
output: {history: {every: 5e-5, nodes: [{name: ball, near: [0.05, 0.05, 0.3]}], forces: [{name: floor, wall: floor}, {name: joint, contact: [top, low]}]}}
)yaml");
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  const double weight = 1000 * 1e-3 * 100;
  EXPECT_NEAR(run.history.mean(1e-4, 5e-3, "fz:floor"), 2 * weight, 0.01 * weight);
  EXPECT_NEAR(run.history.mean(1e-4, 5e-3, "fz:joint"), weight, 0.01 * weight);
  EXPECT_EQ(run.history["ball_z"][0], 0.3);
  EXPECT_EQ(run.history["ball_vz"][0], -1);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

// Springs of contact come after the damping of a step; at rest they carry the whole weight, tangents included. What the
// relaxation leaves moves the forces by the root of its share of kinetic energy.
TEST(Relaxation, SpringsOfPenaltyContactCarryTheWholeWeight) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3}
parts:
  base: {box: {size: [0.14, 0.14, 0.02], cells: [3, 3, 1]}, at: [-0.02, -0.02, -0.02], material: m, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  block: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, material: m}
  ram: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0, 0, 0.1], material: m, rigid: true}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
loads: {gravity: [30, 0, -100]}
contact: {friction: 0.5, enforcement: penalty}
start: {relaxation: {tolerance: 1e-10}}
output: {history: {every: 5e-5, forces: [{name: floor, contact: [block, base]}, {name: joint, contact: [ram, block]}]}}
)yaml");
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  const double mass = 1;
  // The first mean lacks the half step before time 0, and a mean is a force where steps do not change.
  for (std::size_t row = 2; row < run.history.rows(); ++row) {
    const double dt = run.history["dt"][row];
    if (std::abs(dt - run.history["dt"][row - 1]) > 1e-9 * dt) continue;
    ASSERT_NEAR(run.history["fz:floor"][row], 2 * mass * 100, 2e-3);
    ASSERT_NEAR(run.history["fz:joint"][row], mass * 100, 2e-3);
    ASSERT_NEAR(run.history["fx:floor"][row], -2 * mass * 30, 6e-3);
    ASSERT_NEAR(run.history["fx:joint"][row], -mass * 30, 6e-3);
  }
  // Energy in springs is not given by contact.
  EXPECT_GT(run.summary.relaxation.contact_stored, 0);
  EXPECT_DOUBLE_EQ(run.history["contact_stored"][0], run.summary.relaxation.contact_stored);
  EXPECT_NEAR(run.history.last("contact_stored"), run.summary.relaxation.contact_stored,
              1e-4 * run.summary.relaxation.contact_stored);
  for (const Warning& warning : run.summary.warnings) EXPECT_NE(warning.rule, "contact_energy");
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

// Without friction, too, their force at rest is the weight, whatever the step before has stored.
TEST(Relaxation, SpringsWithoutFrictionCarryTheWeight) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3}
parts:
  base: {box: {size: [0.14, 0.14, 0.02], cells: [3, 3, 1]}, at: [-0.02, -0.02, -0.02], material: m, rigid: {fixed: [x, y, z, rx, ry, rz]}}
  block: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -100]}
contact: {enforcement: penalty}
start: {relaxation: {tolerance: 1e-10}}
output: {history: {every: 5e-5, forces: [{name: floor, contact: [block, base]}]}}
)yaml");
  EXPECT_EQ(run.summary.relaxation.state, "settled");
  for (std::size_t row = 2; row < run.history.rows(); ++row) {
    const double dt = run.history["dt"][row];
    if (std::abs(dt - run.history["dt"][row - 1]) > 1e-9 * dt) continue;
    ASSERT_NEAR(run.history["fz:floor"][row], 100, 2e-3) << row;
  }
}

TEST(Relaxation, ThatDoesNotSettleIsRefusedOrWarnedOf) {
  const std::string text = hang("");
  try {
    run_deck(text, {"start.relaxation.max_steps=50"});
    ADD_FAILURE() << "it settled";
  } catch (const RunError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr(
            "the relaxation is not at rest after 50 steps (start.relaxation.tolerance is 1e-12; kinetic energy "));
  }
  const Outcome run = run_deck(text, {"start.relaxation.max_steps=50", "start.relaxation.unsettled=warn"});
  EXPECT_EQ(run.summary.relaxation.state, "unsettled");
  EXPECT_EQ(run.summary.relaxation.steps, 50);
  EXPECT_EQ(run.summary.warnings.back().rule, "unsettled_relaxation");
}

TEST(Preload, ThatCutsNothingIsRefused) {
  const auto expect_refused = [](const std::string& text, const std::vector<std::string>& set, const char* message) {
    try {
      run_deck(text, set);
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  };
  expect_refused(clamp(""), {"start.preload.bolt.point=[0, 0, 2]"},
                 ": error: preload 'bolt' cuts no element (its plane lies beside part 'bar', which begins ");
  // Two bars one above the other: a part has elements on both sides of the plane.
  expect_refused(clamp("array: {count: [1, 1, 2], pitch: [1, 1, 0.5]}, "), {"start.preload.bolt.point=[0, 0, 0.45]"},
                 ": error: preload 'bolt' cuts no element (its plane lies between elements of part 'bar', which begins "
                 "-0.45 and ends 0.45 from it along the normal): move its point into an element");
}

}  // namespace percuss::test::relaxation_test
