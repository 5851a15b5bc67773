// Beams and trusses from the deck on, against exact answers: deflections of slow loads, a frequency, limit loads,
// frames, and lines that are joined to shells.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::beam_test {
namespace {

constexpr double pi = std::numbers::pi, young = 200e9, poisson = 0.3, density = 7800, shear = young / 2.6;

const std::string steel =
    "materials: {steel: {model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

/// From 0 to a value in a time, without a jump of its first derivative; then constant.
std::string rise_to(double value, double time) {
  return fmt::format("{{expression: \"{} * (t < {} ? 0.5 * (1 - cos(pi * t / {})) : 1)\"}}", value, time, time);
}

/// A line along x of length 1 from a clamped end, with its tip followed.
std::string describe_cantilever(int cells, const std::string& section, const std::string& rest) {
  return fmt::format(R"yaml(
parts: {{bar: {{line: {{from: [0, 0, 0], to: [1, 0, 0], cells: {}}}, section: {}, toward: y, material: steel}}}}
conditions: [{{nodes: bar/start, fixed: [x, y, z, rx, ry, rz]}}]
{})yaml",
                     cells, section, rest);
}

std::string output_of_tip(double every) {
  return fmt::format("output: {{history: {{every: {}, nodes: [{{name: tip, near: [1, 0, 0]}}]}}}}\n", every);
}

}  // namespace

// An end load bends n elements by L^3 / (3 E I) (1 - 1 / (4 n^2)) + L / (G A_s): about the strong and the weak axis.
TEST(Beam, CantileverBendsByItsLoad) {
  constexpr double width = 0.1, depth = 0.15, load = 1000, area = width * depth;
  for (const char axis : {'y', 'z'}) {
    const double inertia = area * std::pow(axis == 'y' ? width : depth, 2) / 12;
    const double exact = load / (3 * young * inertia) * (1 - 1.0 / 400) + load / (shear * area * 5 / 6);
    const Outcome run = run_deck(describe_cantilever(
        10, "{rectangle: {size: [0.1, 0.15]}}",
        steel + "time: {end: 0.15}\n" + output_of_tip(1e-4) +
            fmt::format("loads: {{nodal: [{{nodes: bar/end, force: {{{}: {}}}}}]}}\n", axis, rise_to(load, 0.12))));
    EXPECT_NEAR(run.history.mean(0.125, 0.15, fmt::format("tip_{}", axis)), exact, 2e-3 * exact) << axis;
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  }
}

// A torque twists by T L / (G J), a moment bends by M L^2 / (2 E I) exactly, both in a tube.
TEST(Beam, CantileverTwistsAndBendsByMoments) {
  const double i = pi / 4 * (std::pow(0.05, 4) - std::pow(0.04, 4)), moment = 500;
  const Outcome run =
      run_deck(describe_cantilever(8, "{tube: {outer_radius: 0.05, inner_radius: 0.04}}",
                                   steel + "time: {end: 0.15}\n" + output_of_tip(1e-4) +
                                       fmt::format("loads: {{nodal: [{{nodes: bar/end, moment: {{x: {}, z: {}}}}}]}}\n",
                                                   rise_to(moment, 0.12), rise_to(moment, 0.12))));
  const double exact = moment / (2 * young * i);
  EXPECT_NEAR(run.history.mean(0.125, 0.15, "tip_y"), exact, 2e-3 * exact);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

// The first frequency of a clamped beam, 1.87510^2 / (2 pi) sqrt(E I / (rho A L^4)); shear and rotary inertia lower it
// by under 1 % here. From the times at which a released tip passes its rest.
TEST(Beam, CantileverSwingsAtItsFrequency) {
  const double radius = 0.02, frequency = 1.8751 * 1.8751 / (2 * pi) * std::sqrt(young / density) * radius / 2;
  const double period = 1 / frequency;
  const Outcome run = run_deck(
      describe_cantilever(20, "{round: {radius: 0.02}}",
                          steel + fmt::format("time: {{end: {}}}\n", 6 * period) + output_of_tip(period / 200) +
                              fmt::format("loads: {{nodal: [{{nodes: bar/end, force: {{z: {{expression: \"t < {} ? 100 "
                                          "* sin(pi * t / {})^2 : 0\"}}}}}}]}}\n",
                                          period, period)));
  double first = 0, last = 0;
  int passes = 0;
  const auto &z = run.history["tip_z"], &t = run.history["time"];
  for (std::size_t row = 1; row < run.history.rows(); ++row) {
    if (t[row - 1] < period || !(z[row - 1] < 0 && z[row] >= 0)) continue;
    last = t[row - 1] + (t[row] - t[row - 1]) * z[row - 1] / (z[row - 1] - z[row]);
    if (passes++ == 0) first = last;
  }
  ASSERT_GE(passes, 4);
  const double found = (passes - 1) / (last - first);
  EXPECT_NEAR(found, frequency, 0.01 * frequency);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

// Two bars at 45 degrees carry a load at their joint: N = F / (2 cos), down by N L / (E A cos).
TEST(Truss, CarriesALoadByTwoBars) {
  const double area = 1e-4, load = 1e4, length = std::sqrt(2.0), force = load / std::sqrt(2.0);
  const Outcome run = run_deck(fmt::format(R"yaml(
parts:
  left:  {{line: {{from: [-1, 0, 1], to: [0, 0, 0], cells: 1}}, section: {{truss: {{area: 1e-4}}}}, material: steel}}
  right: {{line: {{from: [1, 0, 1], to: [0, 0, 0], cells: 1}}, section: {{truss: {{area: 1e-4}}}}, material: steel}}
join: true
conditions: [{{nodes: left/start, fixed: [x, y, z]}}, {{nodes: right/start, fixed: [x, y, z]}}, {{nodes: left, fixed: [y]}}]
loads: {{nodal: [{{nodes: left/end, force: {{z: {}}}}}]}}
time: {{end: 0.03}}
output: {{history: {{every: 1e-5, nodes: [{{name: joint, near: [0, 0, 0]}}], elements: [{{name: bar, near: [-0.5, 0, 0.5]}}]}}}}
)yaml",
                                           rise_to(-load, 0.02)) +
                               steel);
  const double down = force * length / (young * area) * std::sqrt(2.0);
  EXPECT_NEAR(run.history.mean(0.022, 0.03, "joint_z"), -down, 2e-3 * down);
  EXPECT_NEAR(run.history.mean(0.022, 0.03, "bar_axial_force"), force, 2e-3 * force);
  EXPECT_NEAR(run.history.mean(0.022, 0.03, "bar_stress_zx"), -0.5 * force / area, 2e-3 * force / area);
  EXPECT_FALSE(run.history.has("bar_no"));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

// A bar that yields under a slow pull: the stress follows the tangent E H / (E + H).
TEST(Truss, YieldsAlongItsTangent) {
  const double strain = 0.01, tangent = young * 1e9 / (young + 1e9), yield = 300e6;
  const Outcome run = run_deck(R"yaml(
parts: {bar: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 1}, section: {truss: {area: 1e-4}}, material: steel}}
materials: {steel: {model: j2_plasticity, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, hardening_modulus: 1e9}}
conditions: [{nodes: bar/start, fixed: [x, y, z]}, {nodes: bar/end, velocity: {x: 1}}]
time: {end: 0.01005016708}
output: {history: {every: 0, elements: [{name: bar, near: [0.5, 0, 0]}]}}
)yaml");
  EXPECT_NEAR(run.history.last("bar_axial_force"), 1e-4 * (yield + tangent * (strain - yield / young)), 1);
  EXPECT_NEAR(run.history.last("bar_eps"), strain - run.history.last("bar_axial_force") / (1e-4 * young), 1e-5);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

// The tip of a cantilever without hardening is pushed aside slowly: the first element carries at most the limit moment,
// for each shape of the section.
TEST(Beam, FormsAPlasticHinge) {
  const double yield = 100e6, arm = 1 - 0.5 / 10;
  const auto push = [&](const std::string& section) {
    const Outcome run = run_deck(fmt::format(R"yaml(
parts: {{bar: {{line: {{from: [0, 0, 0], to: [1, 0, 0], cells: 10}}, section: {}, toward: y, material: steel}}}}
materials: {{steel: {{model: j2_plasticity, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 100e6, hardening_modulus: 0}}}}
conditions: [{{nodes: bar/start, fixed: [x, y, z, rx, ry, rz]}}, {{nodes: bar/end, velocity: {{z: {}}}}}]
time: {{end: 0.4}}
output: {{history: {{every: 1e-3, forces: [{{name: root, support: bar/start}}], elements: [{{name: first, near: [0.05, 0, 0]}}]}}}}
)yaml",
                                             section, rise_to(0.1, 0.1)));
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
    EXPECT_NEAR(run.history.mean(0.3, 0.4, "fz:root") * arm, -std::abs(run.history.mean(0.3, 0.4, "first_moment_y")),
                2e-2 * std::abs(run.history.mean(0.3, 0.4, "first_moment_y")));
    return std::abs(run.history.mean(0.3, 0.4, "first_moment_y"));
  };
  EXPECT_NEAR(push("{rectangle: {size: [0.02, 0.04]}}"), yield * 0.02 * 0.04 * 0.04 / 4, 0.01 * yield * 8e-6);
  EXPECT_NEAR(push("{round: {radius: 0.02}}"), yield * 4.0 / 3 * 8e-6, 0.02 * yield * 4.0 / 3 * 8e-6);
  const double i_shape = yield * (0.03 * 0.04 * 0.04 - 0.026 * 0.03 * 0.03) / 4;  // an outline less what it lacks
  EXPECT_NEAR(push("{i_shape: {size: [0.03, 0.04], flange: 0.005, web: 0.004}}"), i_shape, 0.01 * i_shape);
}

// A truss that is pulled at a rate r yields at Y (1 + (r / D)^(1/q)); after it turns back it yields at the stress less
// twice the isotropic part of that, the back stress stays. One element, so the rate is that of its ends.
TEST(Truss, YieldsLaterAtAHigherRateAndMovesItsYieldSurface) {
  const double yield = 300e6, hardening = 2e9, factor = 1 + std::pow(100.0 / 40, 0.2);
  const Outcome run = run_deck(R"yaml(
parts: {bar: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 1}, section: {truss: {area: 1e-4}}, material: steel}}
materials: {steel: {model: combined_hardening, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, hardening_modulus: 2e9, kinematic_share: 1, cowper_symonds_rate: 40, cowper_symonds_exponent: 5}}
conditions: [{nodes: bar/start, fixed: [x, y, z]}, {nodes: bar/end, velocity: {x: {expression: "(t < 2e-4 ? 100 : -100)"}}}]
time: {end: 4e-4, max_step: 1e-7}
output: {history: {every: 0, elements: [{name: bar, near: [0.5, 0, 0]}]}}
)yaml");
  const auto stress = [&](double time) { return run.history.at(time, "bar_axial_force") / 1e-4; };
  const auto strain = [](double time) { return std::log(time < 2e-4 ? 1 + 100 * time : 1 + 0.04 - 100 * time); };
  // p = strain - stress / E, stress = Y factor + H p; its rate is that of the strain over 1 + H / E, which p lowers
  const auto expect = [&](double time, double p, double sign, double back) {
    const double rate = 100 / std::exp(strain(time));
    const double flow = yield * (1 + std::pow(rate / (1 + hardening / young) / 40, 0.2));
    EXPECT_NEAR(stress(time), sign * flow + back, 2e-3 * yield) << time << " " << p;
  };
  const double out = (strain(1.9e-4) - yield * factor / young) / (1 + hardening / young);
  expect(1.9e-4, out, 1, hardening * out);
  const double top = (strain(2e-4) - yield * factor / young) / (1 + hardening / young);
  // back by the width of the surface, then on
  const double before = strain(2e-4) - 2 * yield * factor / young;
  const double again = (before - strain(3.8e-4)) / (1 + hardening / young);
  expect(3.8e-4, again, -1, hardening * (top - again));
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
}

// A portal frame with fixed feet, columns h and beam L of one section: sway P h^3 / (12 E I) (2 + 3 k) / (1 + 6 k),
// with k = h / L. (From slope and deflection of its members; shear adds half a percent.)
TEST(Beam, FrameSwaysUnderALoadAtItsCorner) {
  const double inertia = pi / 4 * std::pow(0.02, 4), load = 100, k = 1.0 / 2;
  const Outcome run = run_deck(fmt::format(R"yaml(
parts:
  left:  {{line: {{from: [0, 0, 0], to: [0, 0, 1], cells: 10}}, section: {{round: {{radius: 0.02}}}}, material: steel}}
  right: {{line: {{from: [2, 0, 0], to: [2, 0, 1], cells: 10}}, section: {{round: {{radius: 0.02}}}}, material: steel}}
  top:   {{line: {{from: [0, 0, 1], to: [2, 0, 1], cells: 20}}, section: {{round: {{radius: 0.02}}}}, material: steel}}
join: true
conditions: [{{nodes: left/start, fixed: [x, y, z, rx, ry, rz]}}, {{nodes: right/start, fixed: [x, y, z, rx, ry, rz]}}]
loads: {{nodal: [{{nodes: left/end, force: {{x: {}}}}}]}}
time: {{end: 0.4}}
output: {{history: {{every: 1e-3, nodes: [{{name: corner, near: [0, 0, 1]}}]}}}}
)yaml",
                                           rise_to(load, 0.3)) +
                               steel);
  const double exact = load / (12 * young * inertia) * (2 + 3 * k) / (1 + 6 * k);
  EXPECT_NEAR(run.history.mean(0.32, 0.4, "corner_x"), exact, 0.01 * exact);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

// A strip of shells (Poisson's ratio 0) with a beam along each edge, joined to it: the stiffnesses add up. With shells
// alone, and with beams alone, the deflections of the same load are larger by that.
TEST(Beam, StiffensAStripOfShellsThatItIsJoinedTo) {
  const double load = 10, thickness = 0.01, side = 0.012;
  const Outcome run =
      run_deck(fmt::format(R"yaml(
parts:
  strip: {{shell_plate: {{size: [0.5, 0.05], cells: [20, 2]}}, thickness: {}, material: metal}}
  low:   {{line: {{from: [0, 0, 0], to: [0.5, 0, 0], cells: 20}}, section: {{rectangle: {{size: [{}, {}]}}}}, toward: y, material: metal}}
  high:  {{line: {{from: [0, 0.05, 0], to: [0.5, 0.05, 0], cells: 20}}, section: {{rectangle: {{size: [{}, {}]}}}}, toward: y, material: metal}}
join: true
materials: {{metal: {{model: elastic, density: 7800, youngs_modulus: 200e9, poissons_ratio: 0}}}}
conditions: [{{nodes: strip/x_min, fixed: [x, y, z, rx, ry, rz]}}]
loads: {{nodal: [{{nodes: low/end, force: {{z: {}}}}}, {{nodes: high/end, force: {{z: {}}}}}]}}
time: {{end: 0.2}}
output: {{history: {{every: 1e-3, nodes: [{{name: tip, near: [0.5, 0, 0]}}]}}}}
)yaml",
                           thickness, side, side, side, side, rise_to(load, 0.15), rise_to(load, 0.15)));
  const double inertia = 0.05 * std::pow(thickness, 3) / 12 + 2 * std::pow(side, 4) / 12;
  const double area = 0.05 * thickness + 2 * side * side, length = 0.5;
  const double exact =
      2 * load *
      (std::pow(length, 3) / (3 * young * inertia) * (1 - 1.0 / 1600) + length / (0.5 * young * area * 5 / 6));
  EXPECT_NEAR(run.history.mean(0.16, 0.2, "tip_z"), exact, 0.01 * exact);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

// A cross of beams and a truss that flies and tumbles: momentum to round-off, energy to the square of the step's turn.
TEST(Beam, FliesAndTumblesFreely) {
  const Outcome run = run_deck(R"yaml(
parts:
  a: {line: {from: [-0.5, 0, 0], to: [0.5, 0, 0], cells: 6}, section: {box: {size: [0.04, 0.06], wall: 0.004}}, toward: y, material: steel}
  b: {line: {from: [0, -0.3, 0], to: [0, 0.3, 0], cells: 4}, section: {round: {radius: 0.01}}, material: steel}
  c: {line: {from: [0.5, 0, 0], to: [0, 0.3, 0], cells: 1}, section: {truss: {area: 1e-4}}, material: steel}
join: true
initial: [{part: all, velocity: [3, 1, -2], angular_velocity: [20, -30, 50]}]
time: {end: 0.2}
output: {history: {every: 1e-3}}
)yaml" + steel);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
}

}  // namespace percuss::test::beam_test
