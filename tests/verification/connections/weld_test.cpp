// Welds: their force against what pulls, when they fail, and what they leave as it was.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "tests/verification/connections/pulled_block.hpp"

namespace percuss::test::weld_test {
namespace {

std::string pull_block(const std::string& welds, const std::string& load) {
  return make_pulled_block(fmt::format("welds: {{spot: {{between: [low/z_max, high/z_min], normal: z{}}}}}", welds),
                           load);
}

}  // namespace

// Pulled along the normal, across it, and both: (N / 5e3)^2 + (S / 2e3)^1.5 reaches 1. Row n has the force at n - 1.
TEST(Weld, FailsWhereItsCriterionReachesOne) {
  const struct {
    const char* load;
    double normal, shear;  // per time
  } cases[] = {{"{z: {expression: 1e8 * t}}", 1e8, 0},
               {"{x: {expression: 6e7 * t}}", 0, 6e7},
               {"{x: {expression: -3e7 * t}, y: {expression: 4e7 * t}, z: {expression: -8e7 * t}}", -8e7, 5e7}};
  for (const auto& pulled : cases) {
    const Outcome run = run_deck(pull_block(", failure: {normal: 5e3, shear: 2e3, shear_exponent: 1.5}", pulled.load));
    const HistoryTable& history = run.history;
    const std::size_t failed = find_failure(history, "welds_failed");
    ASSERT_LT(failed, history.rows());
    for (std::size_t row = 1; row <= failed; ++row) {
      const double t = history["time"][row - 1], n = pulled.normal * t, s = pulled.shear * t;
      EXPECT_NEAR(history["weld_normal:spot_2"][row], n, 1e-10 * 5e3);
      EXPECT_NEAR(history["weld_shear:spot_2"][row], s, 1e-10 * 5e3);
      EXPECT_NEAR(history["fz:held"][row], -4 * n, 1e-9 * 5e3);
      const double reached = std::pow(std::abs(n) / 5e3, 2) + std::pow(s / 2e3, 1.5);
      EXPECT_EQ(reached >= 1, row == failed) << row;
    }
    EXPECT_EQ(history["welds_failed"][failed], 4);
    EXPECT_EQ(history.last("weld_normal:spot_2"), 0);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);  // of the block that swings when it is free
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
    const auto& warnings = run.summary.warnings;
    const auto told = std::find_if(warnings.begin(), warnings.end(),
                                   [](const Warning& warning) { return warning.rule == "weld_failure"; });
    ASSERT_NE(told, warnings.end());
    EXPECT_EQ(told->count, 4);
  }
}

TEST(Weld, FailsAtItsTimeAndNotBefore) {
  const Outcome run = run_deck(pull_block(", failure: {time: 5e-5}", "{z: 1e3}"));
  const std::size_t failed = find_failure(run.history, "welds_failed");
  ASSERT_LT(failed, run.history.rows());
  EXPECT_GE(run.history["time"][failed], 5e-5);
  EXPECT_LT(run.history["time"][failed - 1], 5e-5);
}

// Two free plates, one above the other, that turn, fly apart and bend: what holds them together keeps momentum, and
// does no work once they move as one.
TEST(Weld, OfFreeSheetsKeepsMomentumAndDistance) {
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-3}
parts:
  low: {shell_plate: {size: [0.1, 0.06], cells: [10, 6]}, thickness: 0.001, material: steel}
  high: {shell_plate: {size: [0.1, 0.06], cells: [10, 6]}, thickness: 0.001, at: [0, 0, 0.002], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
welds:
  a: {between: [{near: [0.02, 0.03, 0], part: low}, {near: [0.02, 0.03, 0.002], part: high}]}
  b: {between: [{near: [0.08, 0.03, 0], part: low}, {near: [0.08, 0.03, 0.002], part: high}]}
  c: {between: [{near: [0.05, 0.01, 0], part: low}, {near: [0.05, 0.01, 0.002], part: high}]}
initial:
  - {part: low, velocity: [3, 1, 5], angular_velocity: [0, 60, 20]}
  - {part: high, velocity: [3, 1, 5], angular_velocity: [0, 60, 20], center: [0.05, 0.03, 0]}
output:
  history:
    every: 1e-4
    nodes: [{name: p, near: [0.02, 0.03, 0]}, {name: q, near: [0.02, 0.03, 0.002]}]
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
  EXPECT_LT(std::abs(run.history.last("weld_work")), 1e-5 * run.summary.energy.initial);
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const auto apart = [&](const char* k) {
      return run.history[std::string("q_") + k][row] - run.history[std::string("p_") + k][row];
    };
    EXPECT_NEAR(std::hypot(apart("x"), apart("y"), apart("z")), 0.002, 1e-5 * 0.002);
  }
  EXPECT_GT(std::abs(run.history.last("q_x") - run.history.last("p_x")), 1e-5);  // they have turned
}

// Two masses that fly apart share their momentum at once; the weld takes the energy that is lost.
TEST(Weld, OfBodiesThatPartTakesTheirEnergy) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-5, max_step: 1e-7}
parts:
  low: {box: {size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}, material: steel}
  high: {box: {size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}, at: [0, 0, 0.01], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
welds: {spot: {between: [low, high]}}
initial: [{part: high, velocity: [0, 0, 4]}]
output: {history: {every: 0}}
)yaml");
  // All eight nodes of one with the nearest four of the other: both bodies move as one from the first step on.
  const double mass = 7850 * 1e-6;
  EXPECT_NEAR(run.history.last("kinetic") + run.history.last("internal") + run.history.last("hourglass") +
                  run.history.last("viscous"),
              0.5 * mass * 16, 1e-6 * mass * 16);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

// Plates at one place, each welded to the next: after 500 turns the end of 80 has hardly heard of the other, that of 4
// moves as one.
TEST(Weld, OfALongChainThatDoesNotSettleIsToldOf) {
  for (const int count : {4, 80}) {
    std::string parts, welds;
    for (int i = 0; i < count; ++i)
      parts += fmt::format(
          "  p{}: {{shell_plate: {{size: [0.01, 0.01], cells: [1, 1]}}, thickness: 0.001, material: "
          "steel}}\n",
          i);
    for (int i = 0; i + 1 < count; ++i)
      welds += fmt::format("  w{}: {{between: [{{near: [0, 0, 0], part: p{}}}, {{near: [0, 0, 0], part: p{}}}]}}\n", i,
                           i, i + 1);
    const Outcome run =
        run_deck("time: {end: 1, max_steps: 2}\nparts:\n" + parts +
                 "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
                 "welds:\n" +
                 welds + "initial: [{part: p0, velocity: [0, 0, 1]}]\noutput: {history: {every: 0}}\n");
    const auto& warnings = run.summary.warnings;
    const bool is_told = std::any_of(warnings.begin(), warnings.end(),
                                     [](const Warning& warning) { return warning.rule == "unsettled_welds"; });
    EXPECT_EQ(is_told, count == 80);
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  }
}

TEST(Weld, IsRefusedWhereItCannotBe) {
  const auto refuse = [](const std::string& deck) -> std::string {
    try {
      run_deck(deck);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  };
  const std::string good = pull_block(", failure: {normal: 5e3}", "{z: 1}");
  const auto change = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(refuse(change(", normal: z", "")).find("connects nodes at one place"), std::string::npos);
  EXPECT_NE(refuse(change("normal: 5e3", "time: 1, shear_exponent: 3")).find("shear_exponent has no effect"),
            std::string::npos);
  EXPECT_NE(refuse(change("[1, 1, 1]}, material", "[1, 1, 1]}, rigid: true, material")).find("rigid body"),
            std::string::npos);
  EXPECT_NE(refuse(change("high/z_min], normal", "low/z_max], normal")).find("a weld connects two different"),
            std::string::npos);
}

// Two blocks that lie apart, one moved along the gap: the weld carries the shear that the support has, and fails at its
// strength.
TEST(WeldOfSolids, ThatLieApartCarriesShearAndFailsByIt) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.02}
parts:
  low: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, at: [0, 0, 0.022], material: m}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 20e9, poissons_ratio: 0.3}}
welds:
  spot: {between: [{near: [0.05, 0.05, 0.02], part: low}, {near: [0.05, 0.05, 0.022], part: high}], failure: {normal: 5000, shear: 3000}}
conditions:
  - {nodes: low/z_min, fixed: [x, y, z]}
  - {nodes: high/z_max, velocity: {x: {table: [[0, 0], [0.004, 0.01], [0.02, 0.01]]}, y: 0, z: 0}}
output: {history: {every: 1e-5, forces: [{name: f, support: high/z_max}]}}
)yaml");
  const std::size_t failed = find_failure(run.history, "welds_failed");
  ASSERT_LT(failed, run.history.rows());
  EXPECT_NEAR(run.history.largest("weld_shear:spot"), 3000, 30);
  // The block rings by little: what the weld carries is what the support gives, less the mass between them.
  EXPECT_NEAR(run.history.largest("fx:f"), 3000, 150);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

// Free blocks that fly, turn and bend: their weld keeps both momenta and its length.
TEST(WeldOfSolids, KeepsMomentaAndItsLength) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.01}
parts:
  low: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, at: [0.03, 0.02, 0.025], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e8, poissons_ratio: 0.3}}
welds:
  spot: {between: [{near: [0.075, 0.05, 0.02], part: low}, {near: [0.08, 0.07, 0.025], part: high}]}
initial:
  - {part: low, velocity: [0, 0, -1], angular_velocity: [10, 0, 60]}
  - {part: high, velocity: [1, 0, 1], angular_velocity: [0, 30, -20]}
output: {history: {every: 1e-4, nodes: [{name: a, near: [0.075, 0.05, 0.02], part: low}, {name: b, near: [0.08, 0.07, 0.025], part: high}]}}
)yaml");
  const auto find_length = [&](std::size_t row) {
    double square = 0;
    for (const char* axis : {"_x", "_y", "_z"})
      square += std::pow(run.history[std::string("a") + axis][row] - run.history[std::string("b") + axis][row], 2);
    return std::sqrt(square);
  };
  for (std::size_t row = 0; row < run.history.rows(); ++row)
    EXPECT_NEAR(find_length(row), find_length(0), 0.05 * find_length(0)) << row;
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// A lap joint of two strips with two welds in its line, held in its plane: by symmetry each carries half of the load.
TEST(WeldOfSolids, LapJointSharesItsLoad) {
  const double load = 1000;
  const Outcome run = run_deck(R"yaml(
time: {end: 0.02}
parts:
  left: {box: {size: [0.2, 0.04, 0.004], cells: [20, 4, 2]}, material: m}
  right: {box: {size: [0.2, 0.04, 0.004], cells: [20, 4, 2]}, at: [0.12, 0, 0.005], material: m}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
welds:
  first: {between: [{near: [0.14, 0.02, 0.004], part: left}, {near: [0.14, 0.02, 0.005], part: right}]}
  second: {between: [{near: [0.18, 0.02, 0.004], part: left}, {near: [0.18, 0.02, 0.005], part: right}]}
conditions:
  - {nodes: left/x_min, fixed: [x, y, z]}
  - {nodes: right/x_max, fixed: [y, z]}
  - {nodes: left/z_min, fixed: [z]}
  - {nodes: right/z_max, fixed: [z]}
damping: [{nodes: all, coefficient: 4000}]
loads: {pressure: [{faces: right/x_max, value: {expression: "-6.25e6 * min(t / 0.005, 1)"}}]}
output: {history: {every: 1e-4, forces: [{name: f, support: left/x_min}]}}
)yaml");
  const double first = run.history.mean(0.015, 0.02, "weld_shear:first"),
               second = run.history.mean(0.015, 0.02, "weld_shear:second");
  EXPECT_NEAR(-run.history.mean(0.015, 0.02, "fx:f"), load, 0.01 * load);
  EXPECT_NEAR(first, 0.5 * load, 0.02 * load);
  EXPECT_NEAR(second, 0.5 * load, 0.02 * load);
}

namespace {

/// Two strips that lap, of length 120 and width 20, clamped at one end; a weld in the middle of the lap; a force across
/// the other end. Lengths in mm.
std::string lap_strips(bool are_shells, double size, const std::string& rest) {
  const auto count = [&](double length) { return static_cast<int>(std::lround(length / size)); };
  const double thickness = are_shells ? 4 : 5, apart = are_shells ? 4 : 5.5;
  const auto strip = [&](const std::string& at) {
    return are_shells
               ? fmt::format("{{shell_plate: {{size: [120, 20], cells: [{}, {}]}}, thickness: 4, {}material: m}}",
                             count(120), count(20), at)
               : fmt::format("{{box: {{size: [120, 20, 5], cells: [{}, {}, 2]}}, {}material: m}}", count(120),
                             count(20), at);
  };
  return fmt::format(R"yaml(
time: {{end: 1e-7}}
parts:
  a: {}
  b: {}
materials: {{m: {{model: elastic, density: 7.85e-9, youngs_modulus: 2e5, poissons_ratio: 0}}}}
welds: {{spot: {{between: [{}], at: [100, 10, {}], radius: 6}}}}
conditions: [{{nodes: a/x_min, fixed: [x, y, z{}]}}]
{}
start: {{relaxation: {{tolerance: 1e-8}}}}
output: {{history: {{every: 0, nodes: [{{name: tip, near: [200, 10, {}], part: b}}]}}}}
)yaml",
                     strip(""), strip(fmt::format("at: [80, 0, {}], ", apart)),
                     are_shells ? "a, b" : "a/z_max, b/z_min", 0.5 * (apart + (are_shells ? 0 : thickness)),
                     are_shells ? ", rx, ry, rz" : "", rest, apart);
}

/// A force on the end of the second strip, shared by its nodes.
std::string load_end(bool are_shells, double size, double x, double z) {
  const double nodes = static_cast<double>(std::lround(20 / size) + 1) * (are_shells ? 1 : 3);
  return fmt::format("loads: {{nodal: [{{nodes: b/x_max, force: {{x: {:.17g}, z: {:.17g}}}}}]}}", x / nodes, z / nodes);
}

}  // namespace

// Across: a beam of the length of both, F L^3 / (3 E I). The weld passes on the force, whatever the mesh.
TEST(WeldOfFaces, LapJointBendsAsOneBeamOnAnyMesh) {
  for (const bool are_shells : {true, false}) {
    const double thickness = are_shells ? 4 : 5, force = 1e-3 * std::pow(thickness, 3), exact = 0.008;
    std::vector<double> tips;
    for (const double size : {10.0, 5.0}) {
      const Outcome run = run_deck(lap_strips(are_shells, size, load_end(are_shells, size, 0, force)));
      const double start = are_shells ? 4 : 5.5;
      tips.push_back(run.history["tip_z"][0] - start);
      fmt::print("{} of {} mm: tip {:.4g}, exact {:.4g}\n", are_shells ? "shells" : "solids", size, tips.back(), exact);
      EXPECT_NEAR(tips.back(), exact, 0.035 * exact);
      EXPECT_NEAR(run.history["weld_normal:spot"].back(), force, 1e-3 * force);
      EXPECT_LT(run.history["weld_shear:spot"].back(), 1e-3 * force);
    }
    EXPECT_NEAR(tips[0], tips[1], 0.025 * exact);
  }
}

// Along: the weld carries the force as shear.
TEST(WeldOfFaces, LapJointCarriesItsPullAsShear) {
  const Outcome run = run_deck(lap_strips(true, 10, load_end(true, 10, 1, 0)));
  EXPECT_NEAR(run.history["weld_shear:spot"].back(), 1, 2e-3);
  EXPECT_LT(std::abs(run.history["weld_normal:spot"].back()), 2e-3);
}

// Free sheets of different meshes and a block that fly, turn and bend.
TEST(WeldOfFaces, KeepsMomenta) {
  const Outcome run = run_deck(R"yaml(
time: {end: 5e-4}
parts:
  low: {shell_plate: {size: [0.1, 0.06], cells: [10, 6]}, thickness: 0.001, material: steel}
  high: {shell_plate: {size: [0.1, 0.06], cells: [7, 4]}, thickness: 0.001, at: [0, 0, 0.002], material: steel}
  block: {box: {size: [0.04, 0.06, 0.02], cells: [3, 5, 2]}, at: [0.02, 0, 0.003], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
welds:
  a: {between: [low, high], at: [[0.02, 0.03, 0.001], [0.083, 0.0331, 0.001], [0.05, 0.01, 0.001]], radius: 0.006}
  b: {between: [high, block/z_min], at: [0.05, 0.03, 0.0025], radius: 0.008}
initial:
  - {part: low, velocity: [3, 1, 5], angular_velocity: [0, 60, 20]}
  - {part: high, velocity: [3, 1, 5], angular_velocity: [0, 60, 20], center: [0.05, 0.03, 0]}
output: {history: {every: 1e-4}}
)yaml");
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

// Blocks of different meshes, one moved along the gap, the other held wholly: the weld fails at its strength in shear.
TEST(WeldOfFaces, FailsByShearAlsoWhereOneSideIsHeld) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.004}
parts:
  low: {box: {size: [0.1, 0.1, 0.02], cells: [4, 4, 2]}, material: m}
  high: {box: {size: [0.1, 0.1, 0.02], cells: [5, 3, 2]}, at: [0, 0, 0.022], material: m}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 20e9, poissons_ratio: 0.3}}
welds:
  spot: {between: [low/z_max, high/z_min], at: [0.053, 0.047, 0.021], radius: 0.01, failure: {normal: 5000, shear: 3000}}
conditions:
  - {nodes: low, fixed: [x, y, z]}
  - {nodes: high/z_max, velocity: {x: {table: [[0, 0], [0.004, 0.01]]}, y: 0, z: 0}}
output: {history: {every: 1e-5, forces: [{name: f, support: high/z_max}]}}
)yaml");
  EXPECT_EQ(run.history.last("welds_failed"), 1);
  EXPECT_NEAR(run.history.largest("weld_shear:spot"), 3000, 30);
}

TEST(WeldOfFaces, IsRefusedOrWarnedOfWhereItHoldsLittle) {
  const std::string good = lap_strips(true, 10, "");
  const auto change = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const auto refuse = [](const std::string& deck) -> std::string {
    try {
      run_deck(deck);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  };
  EXPECT_NE(refuse(change("at: [100, 10, 2]", "at: [100, 10, 100]")).find("finds no faces of its first end"),
            std::string::npos);
  EXPECT_NE(refuse(change("[a, b]", "[a, a]")).find("both ends of weld 'spot' have node"), std::string::npos);
  EXPECT_NE(refuse(change(", radius: 6", "")).find("radius is missing"), std::string::npos);
  EXPECT_NE(refuse(change("[a, b]", "[{near: [0, 0, 0]}, b]")).find("is a node"), std::string::npos);
  const auto warns = [&](const std::string& deck, const std::string& rule) {
    const Outcome run = run_deck(deck);
    return std::any_of(run.summary.warnings.begin(), run.summary.warnings.end(),
                       [&](const Warning& warning) { return warning.rule == rule; });
  };
  const std::string still = R"yaml(
time: {end: 1e-7}
parts:
  a: {shell_plate: {size: [120, 20], cells: [12, 2]}, thickness: 2, material: m}
  b: {shell_plate: {size: [120, 20], cells: [12, 2]}, thickness: 2, at: [80, 0, 2], material: m}
materials: {m: {model: elastic, density: 7.85e-9, youngs_modulus: 2e5, poissons_ratio: 0}}
welds: {spot: {between: [a, b], at: AT, radius: 6}}
output: {history: {every: 0}}
)yaml";
  const auto put = [&](const std::string& at) {
    std::string text = still;
    return text.replace(text.find("AT"), 2, at);
  };
  EXPECT_TRUE(warns(put("[100, 10, 20]"), "weld_distance"));
  EXPECT_TRUE(warns(put("[120, 10, 1]"), "weld_rim"));
  EXPECT_FALSE(warns(put("[100, 10, 1]"), "weld_distance"));
  EXPECT_FALSE(warns(put("[100, 10, 1]"), "weld_rim"));
}

}  // namespace percuss::test::weld_test
