// Cohesive ties: curves of a glued surface, the energies of mixes, momentum, and cracks of specimens in closed form.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::cohesive_test {
namespace {

constexpr double area = 1e-4;
constexpr double normal_strength = 30e6, shear_strength = 50e6, normal_energy = 300, shear_energy = 900;
constexpr double normal_stiffness = 2e13, shear_stiffness = 1e13;

/// The upper of two elements moves as the curves say, the lower one is held: the separation is exactly that of the
/// upper one. A third element moves, so that errors of momentum are compared with something.
std::string pull_block(const std::string& extra, const std::string& x, const std::string& z,
                       const std::string& contact = "surfaces: none") {
  return fmt::format(R"yaml(
time: {{end: 1e-4, max_step: 1e-7}}
parts:
  low: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, material: steel}}
  high: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, at: [0, 0, 0.01], material: steel}}
  flyer: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, at: [0, 1, 0], material: steel}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
contact:
  {}
  ties:
    - {{a: high/z_min, b: low/z_max, cohesive: {{normal_stiffness: 2e13, shear_stiffness: 1e13, normal_strength: 30e6, shear_strength: 50e6, normal_energy: 300, shear_energy: 900{}}}}}
conditions:
  - {{nodes: low, fixed: [x, y, z]}}
  - {{nodes: high, velocity: {{x: {}, y: 0, z: {}}}}}
initial: [{{part: flyer, velocity: [0, 0, 1]}}]
output: {{history: {{every: 0, forces: [{{name: held, support: low}}]}}}}
)yaml",
                     contact, extra, x, z);
}

/// Bilinear, or trapezoidal with a share of the energy at constant traction.
double find_traction(double separation, double stiffness, double strength, double energy, double plateau = 0) {
  const double onset = strength / stiffness, end_of_plateau = onset + plateau * energy / strength,
               end = (2 - plateau) * energy / strength;
  if (separation <= onset) return stiffness * separation;
  if (separation <= end_of_plateau) return strength;
  return separation < end ? strength * (end - separation) / (end - end_of_plateau) : 0;
}

}  // namespace

// Row n has the support of the forces at n - 1.
TEST(Cohesive, OpensByItsCurve) {
  for (const double plateau : {0.0, 0.3}) {
    const Outcome run = run_deck(pull_block(fmt::format(", plateau: {}", plateau), "0", "0.3"));
    const HistoryTable& history = run.history;
    for (std::size_t row = 1; row < history.rows(); ++row) {
      const double opening = 0.3 * history["time"][row - 1];
      const double exact = area * find_traction(opening, normal_stiffness, normal_strength, normal_energy, plateau);
      EXPECT_NEAR(history["fz:held"][row], -exact, 1e-9 * area * normal_strength) << row;
    }
    EXPECT_NEAR(history.last("glue_work"), area * normal_energy, 1e-4 * area * normal_energy);
    EXPECT_NEAR(history.last("glue_dissipated"), history.last("glue_work"), 1e-4 * area * normal_energy);
    EXPECT_NEAR(history.last("glue_failed"), area, 1e-12 * area);
    EXPECT_EQ(history.last("failed_ties"), 4);
    const auto& warnings = run.summary.warnings;
    EXPECT_TRUE(
        std::any_of(warnings.begin(), warnings.end(), [](const Warning& w) { return w.rule == "tie_failure"; }));
  }
}

TEST(Cohesive, SlidesByItsCurve) {
  const HistoryTable history = run_deck(pull_block("", "0.4", "0")).history;
  for (std::size_t row = 1; row < history.rows(); ++row) {
    const double slide = 0.4 * history["time"][row - 1];
    EXPECT_NEAR(history["fx:held"][row], -area * find_traction(slide, shear_stiffness, shear_strength, shear_energy),
                1e-9 * area * shear_strength);
  }
  EXPECT_NEAR(history.last("glue_work"), area * shear_energy, 1e-4 * area * shear_energy);
}

// The damaged glue goes back to the origin and comes again on the same line; pressure does not see damage.
TEST(Cohesive, UnloadsToTheOriginAndIsWholeInCompression) {
  const char* back_and_forth =
      "{table: [[0, 0.3], [3e-5, 0.3], [3.01e-5, -0.3], [8e-5, -0.3], [8.01e-5, 0.3], [1e-4, 0.3]]}";
  const HistoryTable history = run_deck(pull_block("", "0", back_and_forth)).history;
  const double farthest = 9e-6,
               secant = find_traction(farthest, normal_stiffness, normal_strength, normal_energy) / farthest;
  const auto force_at = [&](double time) { return -history.at(time, "fz:held") / area; };
  EXPECT_NEAR(force_at(4.5e-5), secant * 4.5e-6, 0.02 * secant * farthest);  // a step is 0.0033 of the way
  EXPECT_NEAR(force_at(7e-5), -normal_stiffness * 3e-6, 0.025 * normal_stiffness * 3e-6);
  EXPECT_NEAR(force_at(9e-5), -normal_stiffness * 3e-6, 0.025 * normal_stiffness * 3e-6);
}

// The energy of a mix is that of Benzeggagh and Kenane, or of the power law.
TEST(Cohesive, SpendsTheEnergyOfTheMix) {
  for (const double angle : {0.5, 0.9, 1.2}) {
    const double normal = std::cos(angle), shear = std::sin(angle);
    const double of_shear = shear_stiffness * shear * shear;
    const double share = of_shear / (of_shear + normal_stiffness * normal * normal);
    const std::string x = fmt::format("{}", 0.5 * shear), z = fmt::format("{}", 0.5 * normal);
    const double by_bk = normal_energy + (shear_energy - normal_energy) * std::pow(share, 1.7);
    const double by_power = 1 / std::sqrt(std::pow((1 - share) / normal_energy, 2) + std::pow(share / shear_energy, 2));
    EXPECT_NEAR(run_deck(pull_block(", exponent: 1.7", x, z)).history.last("glue_work"), area * by_bk,
                2e-4 * area * by_bk);
    EXPECT_NEAR(run_deck(pull_block(", mix: power_law, exponent: 2", x, z)).history.last("glue_work"), area * by_power,
                2e-4 * area * by_power);
  }
}

// A glued block is torn off and comes back: contact carries it then, with each enforcement.
TEST(Cohesive, LeavesSurfacesInContact) {
  for (const char* enforcement : {"kinematic", "lagrange", "penalty"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 4e-4, max_step: 1e-6}}
parts:
  low: {{box: {{size: [0.02, 0.02, 0.02], cells: [4, 4, 4]}}, material: m}}
  high: {{box: {{size: [0.02, 0.02, 0.02], cells: [3, 3, 3]}}, at: [0, 0, 0.02], material: m}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}}}
contact:
  surfaces: all
  enforcement: {}
  ties: [{{a: high/z_min, b: low/z_max, cohesive: {{normal_stiffness: 5e11, normal_strength: 1e6, shear_strength: 1e6, normal_energy: 20, shear_energy: 20}}}}]
conditions:
  - {{nodes: low/z_min, velocity: {{z: 0}}}}
  - {{nodes: high/z_max, velocity: {{z: {{table: [[0, 0], [1e-4, 2], [1.5e-4, 2], [2.5e-4, -3]]}}}}}}
output: {{history: {{every: 0, forces: [{{name: met, contact: [high, low]}}]}}}}
)yaml",
                                             enforcement));
    const HistoryTable& history = run.history;
    EXPECT_EQ(history.last("failed_ties"), 16) << enforcement;
    EXPECT_NEAR(history.last("glue_failed"), 4e-4, 1e-12);
    EXPECT_NEAR(history.last("glue_dissipated"), 4e-4 * 20, 0.01 * 4e-4 * 20);
    EXPECT_NEAR(history.last("glue_work"), 4e-4 * 20, 0.01 * 4e-4 * 20);
    EXPECT_GT(history.largest("fz:met"), 1e6 * 4e-4) << enforcement;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3) << enforcement;
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12) << enforcement;
  }
}

// Blocks that spin, with meshes that do not match and a gap of glue between them, part.
TEST(Cohesive, KeepsMomentumAndEnergy) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-3}
parts:
  left: {box: {size: [0.6, 0.2, 0.2], cells: [6, 4, 4]}, at: [-0.6, -0.1, -0.1], material: soft}
  right: {box: {size: [0.6, 0.2, 0.2], cells: [9, 6, 6]}, at: [0.002, -0.1, -0.1], material: soft}
initial:
  - {angular_velocity: [30, 100, 200]}
  - {part: right, velocity: [0, -20, 5]}
contact:
  surfaces: all
  ties: [{a: right/x_min, b: left/x_max, distance: 0.005, cohesive: {normal_stiffness: 2e10, shear_stiffness: 1e10, normal_strength: 4e6, shear_strength: 6e6, normal_energy: 2e3, shear_energy: 5e3, plateau: 0.2, exponent: 1.5}}]
output: {history: {every: 0}}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_NEAR(run.history.last("glue_failed"), 0.04, 1e-12);
  EXPECT_GT(run.history.last("glue_dissipated"), 0.04 * 2e3);
  EXPECT_NEAR(run.history.last("glue_dissipated"), run.history.last("glue_work"), 0.01 * run.history.last("glue_work"));
}

// Half a shell lies between a node and the glue, and turns with the node: shells that are drawn apart bend as beams on
// an elastic foundation (Kanninen, Int. J. Fracture 9, 1973), whatever the stiffness of the glue against sliding.
TEST(Cohesive, LetsGluedShellsBendApart) {
  const double young = 70e9, width = 2e-3, height = 1e-3, stiffness = 1e11, crack = 0.015, opening = 0.1 * 2.25e-3;
  const double x = std::pow(6 * stiffness / (young * height * height * height), 0.25) * crack;
  const double compliance =
      8 * std::pow(crack / height, 3) / (young * width) * (1 + 3 / x + 3 / (x * x) + 1.5 / (x * x * x));
  for (const char* sides : {"a: {name: high/bottom, inside: [[0.0149, -1, -1], [1, 1, 1]]}, b: low/top",
                            "a: {name: low/top, inside: [[0.0149, -1, -1], [1, 1, 1]]}, b: high/bottom"}) {
    const HistoryTable history = run_deck(fmt::format(R"yaml(
time: {{end: 3e-3}}
parts:
  low: {{shell_plate: {{size: [0.04, 0.002], cells: [40, 1]}}, thickness: 0.001, at: [0, 0, -0.0005], material: m}}
  high: {{shell_plate: {{size: [0.04, 0.002], cells: [40, 1]}}, thickness: 0.001, at: [0, 0, 0.0005], material: m}}
materials: {{m: {{model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}}}}
contact:
  surfaces: none
  ties: [{{{}, cohesive: {{normal_stiffness: 1e11, shear_stiffness: 1e12, normal_strength: 1e9, shear_strength: 1e9, normal_energy: 1e9, shear_energy: 1e9}}}}]
damping: [{{coefficient: 3e3}}]
conditions:
  - {{nodes: high/x_min, velocity: {{z: {{table: [[0, 0], [5e-4, 0.05], [3e-3, 0.05]]}}}}}}
  - {{nodes: low/x_min, velocity: {{z: {{table: [[0, 0], [5e-4, -0.05], [3e-3, -0.05]]}}}}}}
output: {{history: {{every: 1e-5, forces: [{{name: pull, support: high/x_min}}]}}}}
)yaml",
                                                      sides))
                                     .history;
    double sum = 0;
    int count = 0;
    for (std::size_t row = 0; row < history.rows(); ++row) {
      if (history["time"][row] < 2e-3) continue;
      sum += history["fz:pull"][row];
      ++count;
    }
    EXPECT_NEAR(sum / count, opening / compliance, 0.03 * opening / compliance) << sides;
  }
}

// Sheets of shells that are glued, one of them to a block too, spin and bend: their glue neither turns nor drives them.
TEST(Cohesive, KeepsMomentumAndEnergyOfGluedShells) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3}
parts:
  low: {shell_plate: {size: [0.2, 0.1], cells: [8, 4]}, thickness: 0.006, at: [0, 0, -0.003], material: m}
  high: {shell_plate: {size: [0.2, 0.1], cells: [10, 5]}, thickness: 0.004, at: [0, 0, 0.002], material: m}
  block: {box: {size: [0.1, 0.1, 0.02], cells: [5, 5, 2]}, at: [0.05, 0, 0.004], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
contact:
  surfaces: none
  ties:
    - {a: low/top, b: high/bottom, cohesive: {normal_stiffness: 1e11, shear_stiffness: 3e11, normal_strength: 1e6, shear_strength: 2e6, normal_energy: 200, shear_energy: 600}}
    - {a: high/top, b: block/z_min, cohesive: {normal_stiffness: 1e11, shear_stiffness: 3e11, normal_strength: 1e9, shear_strength: 1e9, normal_energy: 1e9, shear_energy: 1e9}}
initial:
  - {angular_velocity: [100, 60, 200]}
  - {part: low, velocity: [2, 0, -3]}
output: {history: {every: 0}}
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_GT(run.history.last("glue_failed"), 0);
}

// The step that glue leaves is stable: stiff glue alone on rigid ends, at nearly all of it.
TEST(Cohesive, AsksForAStableStep) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3, step_scale: 1.0}
parts:
  left: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, at: [-0.1, 0, 0], material: m}
  right: {box: {size: [0.1, 0.1, 0.1], cells: [2, 3, 3]}, at: [0, 0, 0], material: m}
initial: [{part: right, velocity: [0.01, 0.003, 0]}]
contact:
  surfaces: none
  ties: [{a: right/x_min, b: left/x_max, cohesive: {normal_stiffness: 2e12, normal_strength: 1e12, shear_strength: 1e12, normal_energy: 1e12, shear_energy: 1e12}}]
output: {history: {every: 0}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
)yaml");
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  EXPECT_EQ(run.history.last("glue_failed"), 0);
  EXPECT_NEAR(run.history.last("glue_dissipated"), 0, 1e-12);
}

// Elements behind the glued face die: their glue goes with them, and the books close (a rigid tie has the same error).
TEST(Cohesive, GoesWithDeadElements) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-4, step_scale: 0.2}
parts:
  left: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [-0.1, 0, 0], material: weak}
  right: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0, 0, 0], material: m}
initial: [{part: right, velocity: [20, 0, 0]}]
contact:
  surfaces: none
  ties: [{a: right/x_min, b: left/x_max, cohesive: {normal_stiffness: 2e11, normal_strength: 1e8, shear_strength: 1e8, normal_energy: 1e6, shear_energy: 1e6}}]
output: {history: {every: 0}}
materials:
  m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}
  weak: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, failure: {principal_stress: 6e6}}
)yaml");
  EXPECT_GT(run.summary.eroded.elements, 0);
  EXPECT_EQ(run.history.last("glue_failed"), 0);
  EXPECT_NEAR(run.history.last("glue_dissipated"), run.history.last("glue_work"),
              1e-3 * run.history.largest("glue_work"));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(Cohesive, RefusesWhatMakesNoSense) {
  EXPECT_ERROR(run_deck(pull_block("", "0", "0.3"), {"contact.ties.0.rotations=true"}), InputError,
               "rotations has no effect with cohesive");
  EXPECT_ERROR(run_deck(pull_block("", "0", "0.3"), {"contact.ties.0.cohesive.normal_energy=20"}), InputError,
               "normal_energy is 20 (must be above");
  EXPECT_ERROR(run_deck(pull_block("", "0", "0.3"), {"contact.ties.0.cohesive.plateau=0.95"}), InputError,
               "normal_energy is 300 (must be above");
}

}  // namespace percuss::test::cohesive_test
