// Nodes of bars embedded in solids: they keep their places there, and the composite moves as theory says.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::embedded_test {
namespace {

const std::string materials = R"yaml(
materials:
  concrete: {model: elastic, density: 2400, youngs_modulus: 30e9, poissons_ratio: 0}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
)yaml";

std::string refuse(const std::string& deck) {
  try {
    run_deck(deck);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

/// A spinning block of some kind of solid with a bent bar in it that a second one crosses.
std::string spin_block(const std::string& shape) {
  return fmt::format(R"yaml(
time: {{end: 3e-4}}
parts:
  block: {{{}, material: concrete}}
  bar: {{line: {{from: [0.011, 0.013, 0.017], to: [0.091, 0.087, 0.083], cells: 7}}, section: {{round: {{radius: 0.004}}}}, material: steel}}
  tie: {{line: {{from: [0.02, 0.05, 0.03], to: [0.085, 0.04, 0.06], cells: 4}}, section: {{truss: {{area: 5e-5}}}}, material: steel}}
embedded: {{bars: {{nodes: bar, in: block}}, ties: {{nodes: tie, in: [block]}}}}
initial: [{{part: all, velocity: [3, -2, 1], angular_velocity: [200, -100, 300]}}]
output: {{history: {{every: 1e-5, parts: all}}}}
)yaml",
                     shape) +
         materials;
}

/// A cantilever of 1.2 m with bars above and below its middle, or none, whose tip gets a push.
HistoryTable swing(bool has_bars) {
  std::string text = R"yaml(
time: {end: 0.027}
parts:
  beam: {box: {size: [1.2, 0.06, 0.1], cells: [48, 2, 4]}, hourglass: assumed_strain, material: concrete}
  low: {line: {from: [0.0, 0.03, 0.012], to: [1.2, 0.03, 0.012], cells: 43}, section: {truss: {area: 2e-4}}, material: steel}
  high: {line: {from: [0.0, 0.03, 0.088], to: [1.2, 0.03, 0.088], cells: 43}, section: {truss: {area: 2e-4}}, material: steel}
conditions: [{nodes: beam/x_min, fixed: [x, y, z]}]
initial: [{part: all, angular_velocity: [0, -1, 0], center: [0, 0, 0]}]
output: {history: {every: 2e-5, nodes: [{name: tip, near: [1.2, 0, 0], part: beam}]}}
)yaml";
  if (has_bars)
    return run_deck(text + "embedded: {low: {nodes: low, in: beam}, high: {nodes: high, in: beam}}\n" + materials)
        .history;
  for (const char* const bar : {"  low:", "  high:"}) {
    const std::size_t first = text.find(bar);
    text.erase(first, text.find('\n', first) + 1 - first);
  }
  return run_deck(text + materials).history;
}

/// From the start to the second passage of the middle.
double find_period(const HistoryTable& h) {
  const std::vector<double>&z = h["tip_z"], &t = h["time"];
  std::vector<double> passages;
  for (std::size_t i = 2; i < z.size(); ++i)
    if (z[i - 1] * z[i] < 0) passages.push_back(t[i - 1] - z[i - 1] * (t[i] - t[i - 1]) / (z[i] - z[i - 1]));
  return passages.size() < 2 ? NAN : passages[1];
}

}  // namespace

// Trusses with their nodes at those of solids are embedded as if they shared them.
TEST(Embedded, BarsAtTheCornersOfSolidsMoveAsIfTheySharedThem) {
  const std::string text = R"yaml(
time: {end: 2e-4}
parts:
  block: {box: {size: [0.2, 0.04, 0.04], cells: [10, 2, 2]}, material: concrete}
  bar: {line: {from: [0, 0.02, 0.02], to: [0.2, 0.02, 0.02], cells: 10}, section: {truss: {area: 1e-4}}, material: steel}
conditions: [{nodes: block/x_min, fixed: [x, y, z]}]
loads: {nodal: [{nodes: block/x_max, force: {x: 1e3, y: 200}}]}
output: {history: {every: 0, nodes: [{name: tip, near: [0.2, 0.04, 0], part: block}, {name: bar, near: [0.1, 0.02, 0.02], part: bar}]}}
)yaml" + materials;
  const Outcome apart = run_deck(text + "embedded: {bar: {nodes: bar, in: block}}\n");
  const Outcome shared = run_deck(text + "join: true\n");
  ASSERT_EQ(apart.history.rows(), shared.history.rows());
  for (std::size_t row = 1; row < apart.history.rows(); ++row)
    for (const char* const column : {"tip_x", "tip_y", "bar_x", "bar_y"})
      EXPECT_NEAR(apart.history[column][row], shared.history[column][row], 1e-14) << column;
  EXPECT_NEAR(apart.summary.energy.error, shared.summary.energy.error, 1e-9);
}

// A reinforced rod that is pulled: its end moves at F / sqrt(sum EA sum rho A), by the wave of the composite.
TEST(Embedded, WavesOfAReinforcedRodHaveTheSpeedOfTheComposite) {
  const double stiffness = 30e9 * 1e-2 + 200e9 * 1e-3, mass = 2400 * 1e-2 + 7850 * 1e-3, length = 2;
  const double speed = std::sqrt(stiffness / mass);
  const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: {0}}}
parts:
  rod: {{box: {{size: [2, 0.1, 0.1], cells: [80, 3, 3]}}, material: concrete}}
  bar: {{line: {{from: [0, 0.046, 0.052], to: [2, 0.046, 0.052], cells: 93}}, section: {{truss: {{area: 1e-3}}}}, material: steel}}
embedded: {{bar: {{nodes: bar, in: rod}}}}
conditions: [{{nodes: rod/x_min, fixed: [x]}}, {{nodes: rod, fixed: [y, z]}}, {{nodes: bar, fixed: [y, z]}}]
loads: {{pressure: [{{faces: rod/x_max, value: -1e6}}]}}
output: {{history: {{every: 1e-5, nodes: [{{name: end, near: [2, 0, 0], part: rod}}, {{name: bar, near: [2, 0.05, 0.05], part: bar}}]}}}}
)yaml",
                                              1.95 * length / speed) +
                                  materials)
                             .history;
  const double force = 1e4, moved = h.last("end_x") - 2;
  EXPECT_NEAR(moved, force / std::sqrt(stiffness * mass) * h.last("time"), 0.01 * moved);
  EXPECT_NEAR(h.last("bar_x") - 2, moved, 0.02 * moved);
}

// Bars raise the stiffness of a cantilever by E A z^2 (parallel axes) and its mass by theirs.
TEST(Embedded, BarsStiffenACantileverByTheParallelAxes) {
  const double plain = find_period(swing(false)), reinforced = find_period(swing(true));
  const double bending = 30e9 * 0.06 * 1e-3 / 12, more = 200e9 * 2 * 2e-4 * 0.038 * 0.038;
  const double mass = 2400 * 6e-3, more_mass = 7850 * 4e-4;
  const double ratio = std::sqrt((1 + more_mass / mass) / (1 + more / bending));
  EXPECT_NEAR(reinforced / plain, ratio, 0.01 * ratio);
}

// A cantilever with a bar on one side hangs by w L^4 / (8 E I) after a relaxation; its neutral axis lies off the
// middle.
TEST(Embedded, ARelaxedCantileverWithABarOnOneSideHangsByTheParallelAxes) {
  const double bar_radius = 0.008, bar_area = 3.141592653589793 * bar_radius * bar_radius;
  const HistoryTable h = run_deck(R"yaml(
time: {end: 4e-4}
start: {relaxation: {}}
parts:
  beam: {box: {size: [1.2, 0.06, 0.1], cells: [24, 2, 4]}, hourglass: assumed_strain, material: concrete}
  low: {line: {from: [0.0, 0.03, 0.012], to: [1.2, 0.03, 0.012], cells: 20}, section: {round: {radius: 0.008}}, material: steel}
embedded: {low: {nodes: low}}
conditions: [{nodes: beam/x_min, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -9.81]}
output: {history: {every: 2e-5, forces: [{name: s, support: beam/x_min}], nodes: [{name: tip, near: [1.2, 0, 0], part: beam}]}}
)yaml" + materials)
                             .history;
  const double concrete = 30e9 * 6e-3, steel = 200e9 * bar_area;
  const double bending = 30e9 * 0.06 * 1e-3 / 12 + concrete * steel / (concrete + steel) * 0.038 * 0.038;
  const double weight = 9.81 * 1.2 * (2400 * 6e-3 + 7850 * bar_area), sag = weight * std::pow(1.2, 3) / (8 * bending);
  EXPECT_NEAR(h["tip_z"][0], -sag, 0.015 * sag);
  EXPECT_NEAR(h.last("tip_z"), h["tip_z"][0], 1e-3 * sag);
  EXPECT_NEAR(h.last("fz:s"), weight, 1e-3 * weight);
}

// In every kind of solid, momenta and energy are kept, and the constraint does no work.
TEST(Embedded, BarsInSpinningBlocksKeepMomentaAndEnergy) {
  for (const char* const shape : {"box: {size: [0.1, 0.1, 0.1], cells: [3, 4, 3]}",
                                  "box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, elements: tetrahedra",
                                  "box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, elements: wedges"}) {
    const Outcome run = run_deck(spin_block(shape));
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12) << shape;
    EXPECT_LT(run.summary.momentum.angular_error, 1e-11) << shape;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3) << shape;
    const double kinetic = run.history["kinetic"][0];
    EXPECT_LT(std::abs(run.history.last("equal_work") - run.history["equal_work"][1]), 1e-11 * kinetic) << shape;
  }
}

// The middle of a cube is the mean of its corners, wherever these go.
TEST(Embedded, ANodeInTheMiddleStaysTheMeanOfTheCorners) {
  std::string nodes;
  for (int i = 0; i < 8; ++i)
    nodes += fmt::format("{{name: c{}, near: [{}, {}, {}], part: cube}}, ", i, i & 1, (i >> 1) & 1, i >> 2);
  const HistoryTable h = run_deck(fmt::format(R"yaml(
time: {{end: 0.05, max_step: 2e-4}}
parts:
  cube: {{box: {{size: [1, 1, 1], cells: [1, 1, 1]}}, material: soft}}
  bar: {{line: {{from: [0.5, 0.5, 0.5], to: [0.8, 0.6, 0.5], cells: 1}}, section: {{truss: {{area: 0.1}}}}, material: soft}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.2}}}}
embedded: {{bar: {{nodes: bar}}}}
loads: {{nodal: [{{nodes: {{inside: [[0.9, 0.9, 0.9], [1.1, 1.1, 1.1]]}}, force: {{x: 4e5, y: 2e5, z: -3e5}}}}]}}
initial: [{{part: all, angular_velocity: [3, 10, 2]}}]
output: {{history: {{every: 1e-3, nodes: [{}{{name: m, near: [0.5, 0.5, 0.5], part: bar}}]}}}}
)yaml",
                                              nodes))
                             .history;
  for (std::size_t row = 0; row < h.rows(); ++row)
    for (const char axis : {'x', 'y', 'z'}) {
      double mean = 0;
      for (int i = 0; i < 8; ++i) mean += 0.125 * h[fmt::format("c{}_{}", i, axis)][row];
      EXPECT_NEAR(h[fmt::format("m_{}", axis)][row], mean, 1e-12);
    }
}

// Once the solid has died its bar flies on by itself.
TEST(Embedded, ABarIsFreeWhenItsSolidHasDied) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-3}
parts:
  block: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, material: weak}
  bar: {line: {from: [0.02, 0.05, 0.05], to: [0.08, 0.05, 0.05], cells: 2}, section: {truss: {area: 1e-4}}, material: steel}
materials:
  weak: {model: j2_plasticity, density: 2400, youngs_modulus: 30e9, poissons_ratio: 0, yield_stress: 3e6, failure: {plastic_strain: 1e-3}}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
embedded: {bar: {nodes: bar, in: block}}
conditions: [{nodes: block/x_min, velocity: {x: -1}}, {nodes: block/x_max, velocity: {x: 1}}]
loads: {nodal: [{nodes: bar, force: {z: 10}}]}
erosion: {free_nodes: remove}
output: {history: {every: 1e-5, parts: all}}
)yaml");
  const double force = 30;  // of three nodes
  const HistoryTable& h = run.history;
  EXPECT_NEAR(h.last("momentum_z:bar") - h.at(6e-4, "momentum_z:bar"), force * 4e-4, 1e-3 * force * 4e-4);
}

TEST(Embedded, RefusesWhatItCannotHold) {
  const std::string parts = R"yaml(
time: {end: 1e-6}
parts:
  block: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: concrete}
  bar: {line: {from: [2, 0.5, 0.5], to: [3, 0.5, 0.5], cells: 2}, section: {truss: {area: 1e-3}}, material: steel}
)yaml" + materials;
  EXPECT_NE(refuse(parts + "embedded: {bar: {nodes: bar, in: block}}\n").find("holds nothing"), std::string::npos);
  EXPECT_NE(refuse(parts + "embedded: {bar: {nodes: bar, in: blocks}}\n").find("unknown part 'blocks'"),
            std::string::npos);
  std::string rigid = parts;
  rigid.replace(rigid.find("[2, "), 4, "[0.3, ");
  rigid.replace(rigid.find("cells: [1, 1, 1]}"), 17, "cells: [1, 1, 1]}, rigid: {}");
  EXPECT_NE(refuse(rigid + "embedded: {bar: {nodes: bar, in: block}}\n").find("rigid body"), std::string::npos);
}

}  // namespace percuss::test::embedded_test
