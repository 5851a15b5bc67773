// Waves in bars against d'Alembert: speeds, a vibrating bar, impact on a wall and on each other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::bar_waves_test {
namespace {

constexpr double young = 200e9, poisson = 0.3, density = 7850;

const std::string steel = R"(
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
)";

/// A bar of 200 elements whose end is pushed at 1 m/s; stations at the elements 50 and 150.
HistoryTable push_bar(const std::string& name, const std::string& conditions) {
  return run_deck(fmt::format(R"(
title: {}
time: {{end: 3.9e-4, max_step: 5e-7}}
parts: {{bar: {{box: {{size: [2, 0.02, 0.02], cells: [200, 2, 2]}}, material: steel}}}}
conditions:
  - {{nodes: bar/x_min, velocity: {{x: 1}}}}
{}
output: {{history: {{elements: [{{name: a, near: [0.505, 0.015, 0.015]}}, {{name: b, near: [1.505, 0.015, 0.015]}}], nodes: [{{name: n, near: [0.5, 0, 0]}}]}}}}
)",
                              name, conditions) +
                  steel)
      .history;
}

}  // namespace

TEST(BarWaves, WithLateralRollersTravelAtTheDilatationalSpeed) {
  HistoryTable history = push_bar("bar with rollers", "  - {nodes: bar, fixed: [y, z]}");
  const double c = std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
  const double stress = density * c;  // rho c v
  // Viscosity and dispersion spread the front over some elements but not its middle: 0.2 % of 100 elements is a fifth
  // of one.
  const double travel = history.time_of_rise("b_von_mises", 0.5 * stress * (1 - 2 * poisson) / (1 - poisson)) -
                        history.time_of_rise("a_von_mises", 0.5 * stress * (1 - 2 * poisson) / (1 - poisson));
  fmt::print("speed {:.1f} of {:.1f} m/s\n", 1.0 / travel, c);
  EXPECT_NEAR(1.0 / travel, c, 2e-3 * c);
  // behind the front: 0.1 % is what is left of its ringing 100 elements later
  EXPECT_NEAR(history.at(2.8e-4, "a_stress_xx"), -stress, 1e-3 * stress);
  EXPECT_NEAR(history.at(2.8e-4, "a_stress_yy"), -stress * poisson / (1 - poisson), 1e-3 * stress);
  EXPECT_NEAR(history.at(2.8e-4, "n_vx"), 1, 1e-3);
}

TEST(BarWaves, InASlenderBarTravelAtTheBarSpeed) {
  HistoryTable history = push_bar("slender bar", "");
  const double c = std::sqrt(young / density), stress = density * c;
  // Lateral inertia turns the front into an integral of Airy's function (Skalak 1957), which passes one third at c t
  // and rings on behind it for long: levels and averages are taken accordingly. 0.2 % of 100 elements is a fifth of
  // one.
  const double travel =
      history.time_of_rise("b_von_mises", stress / 3) - history.time_of_rise("a_von_mises", stress / 3);
  fmt::print("speed {:.1f} of {:.1f} m/s\n", 1.0 / travel, c);
  EXPECT_NEAR(1.0 / travel, c, 2e-3 * c);
  EXPECT_NEAR(history.mean(1.5e-4, 3.9e-4, "a_stress_xx"), -stress, 5e-3 * stress);
  EXPECT_NEAR(history.mean(1.5e-4, 3.9e-4, "n_vx"), 1, 5e-3);
}

TEST(BarWaves, AFixedBarThatStartsToMoveVibratesAsItsSeriesSays) {
  // u = sum 8 L V / (c (2n-1)^2 pi^2) sin(w_n t) sin((2n-1) pi x / 2L); at the free end a triangle of height V L / c.
  // Poisson's ratio is 0: the series is one-dimensional.
  const double length = 1, v = 1, c = std::sqrt(young / density), end = 8 * length / c;
  const Outcome run = run_deck(fmt::format(R"(
title: vibrating bar
time: {{end: {:.17g}}}
parts: {{bar: {{box: {{size: [1, 0.005, 0.005], cells: [200, 1, 1]}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
initial: [{{part: bar, velocity: [1, 0, 0]}}]
conditions: [{{nodes: bar/x_min, fixed: [x, y, z]}}]
output: {{history: {{every: 2e-6, nodes: [{{name: end, near: [1, 0, 0]}}, {{name: middle, near: [0.5, 0, 0]}}]}}}}
)",
                                           end));
  const auto series = [&](double x, double t) {
    double u = 0;
    for (int n = 1; n <= 2000; ++n) {
      const double k = (2 * n - 1) * std::numbers::pi / (2 * length);
      u += 2 * v / (c * length * k * k) * std::sin(k * c * t) * std::sin(k * x);
    }
    return u;
  };
  const HistoryTable& h = run.history;
  for (std::size_t i = 0; i < h.rows(); ++i) {
    const double t = h["time"][i];
    // Dispersion rounds the corners of the triangle: after a way D = 8 L over a width of (h^2 D / 16)^(1/3) = 2 % of L,
    // which takes about half of that off its tip.
    EXPECT_NEAR(h["end_x"][i] - 1, series(1, t), 1e-2 * v * length / c) << "t = " << t;
    EXPECT_NEAR(h["middle_x"][i] - 0.5, series(0.5, t), 1e-2 * v * length / c) << "t = " << t;
  }
  // Corners of the waves are as short as the elements: (omega dt)^2 / 12 of their share of the energy.
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(BarImpact, OnARigidWallLastsTwoTransitsAndReturnsTheSpeed) {
  // In inches, pounds and seconds: c = 202721 in/s, impact at 4.9456e-5 s, end at 1.48114e-4 s, force 29923 lbf.
  const Outcome run = run_deck(R"(
title: bar on a wall
time: {end: 2e-4}
parts: {bar: {box: {size: [10, 1, 1], cells: [200, 1, 1]}, at: [0.01, 0, 0], material: steel}}
materials: {steel: {model: elastic, density: 0.73e-3, youngs_modulus: 3e7, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0}}
initial: [{part: bar, velocity: [-202.2, 0, 0]}]
walls: [{normal: [1, 0, 0]}]
output: {history: {elements: [{name: middle, near: [5, 0.5, 0.5]}]}}
)");
  const HistoryTable& h = run.history;
  double first = 0, last = 0;
  for (std::size_t i = 0; i < h.rows(); ++i) {
    if (h["wall_force_x"][i] <= 0) continue;
    if (first == 0) first = h["time"][i];
    last = h["time"][i];
  }
  // The first push is in the step that reaches the wall; the last one within a front of some elements.
  fmt::print("contact {:.5e} to {:.5e} s, force {:.1f} lbf, rebound {:.4f}\n", first, last,
             h.mean(5.5e-5, 1.4e-4, "wall_force_x"), -h.last("momentum_x") / h["momentum_x"][0]);
  EXPECT_NEAR(first, 4.9456e-5, 1.1 * run.summary.dt.max);
  EXPECT_NEAR(last - first, 2 * 10 / 202721.0, 0.01 * 2 * 10 / 202721.0);
  EXPECT_NEAR(h.mean(5.5e-5, 1.4e-4, "wall_force_x"), 29923, 1e-3 * 29923);
  EXPECT_NEAR(h.mean(8.5e-5, 1.1e-4, "middle_stress_xx"), -29923, 1e-3 * 29923);  // of 1 square inch
  // The node row that hits loses its energy, that of half an element in 200, and some stays as waves of the shortest
  // length. (Linear viscosity rounds the fronts over h^(1/2) and would keep 2 % here.)
  EXPECT_NEAR(h.last("momentum_x") / h["momentum_x"][0], -1, 0.01);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

namespace {

struct Bar {
  double length, speed, young, density;
  int cells;
};

/// Two bars of section 0.01 x 0.01 that touch at x = 0 at the start, the first on the left; Poisson's ratio is 0. Bulk
/// viscosity is weak: at its default it rounds the fronts enough to keep 1 % of the speed.
Outcome strike(const std::string& title, const Bar& left, const Bar& right, double end) {
  return run_deck(fmt::format(R"(
title: {}
time: {{end: {:.17g}}}
parts:
  left: {{box: {{size: [{}, 0.01, 0.01], cells: [{}, 1, 1]}}, at: [{}, 0, 0], material: a}}
  right: {{box: {{size: [{}, 0.01, 0.01], cells: [{}, 1, 1]}}, material: b}}
materials:
  a: {{model: elastic, density: {}, youngs_modulus: {}, poissons_ratio: 0}}
  b: {{model: elastic, density: {}, youngs_modulus: {}, poissons_ratio: 0}}
elements: {{bulk_viscosity: {{linear: 0.02}}}}
initial: [{{part: left, velocity: [{}, 0, 0]}}, {{part: right, velocity: [{}, 0, 0]}}]
contact: {{surfaces: all}}
output:
  history:
    nodes: [{{name: left, near: [0, 0, 0], part: left}}, {{name: right, near: [0, 0, 0], part: right}}]
    elements: [{{name: stress, near: [{}, 0, 0]}}]
)",
                              title, end, left.length, left.cells, -left.length, right.length, right.cells,
                              left.density, left.young, right.density, right.young, left.speed, right.speed,
                              0.25 * right.length));
}

double last_contact(const HistoryTable& h) {
  double last = 0;
  for (std::size_t i = 0; i < h.rows(); ++i) {
    if (h["contacts"][i] > 0) last = h["time"][i];
  }
  return last;
}

constexpr double area = 1e-4;

}  // namespace

TEST(BarImpact, EqualBarsExchangeTheirSpeedsAfterTwoTransits) {
  const double c = std::sqrt(young / density), transit = 0.5 / c;
  const Outcome run =
      strike("equal bars", {0.5, 8, young, density, 200}, {0.5, -2, young, density, 200}, 4.3 * transit);
  const HistoryTable& h = run.history;
  const double stress = density * c * 5;  // rho c (v1 - v2) / 2
  EXPECT_NEAR(h.mean(0.2 * transit, 1.8 * transit, "left_vx"), 3, 0.01 * 5);
  EXPECT_NEAR(h.mean(0.2 * transit, 1.8 * transit, "right_vx"), 3, 0.01 * 5);
  EXPECT_NEAR(h.mean(0.5 * transit, 1.5 * transit, "stress_stress_xx"), -stress, 2e-3 * stress);
  EXPECT_NEAR(last_contact(h), 2 * transit, 0.02 * 2 * transit);
  EXPECT_NEAR(h.mean(2.2 * transit, 4.2 * transit, "left_vx"), -2, 0.01 * 10);  // over one period
  EXPECT_NEAR(h.mean(2.2 * transit, 4.2 * transit, "right_vx"), 8, 0.01 * 10);
  fmt::print("speeds after it {:.4f} and {:.4f}\n", h.mean(2.2 * transit, 4.2 * transit, "left_vx"),
             h.mean(2.2 * transit, 4.2 * transit, "right_vx"));
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(BarImpact, BarsOfDifferentImpedanceMeetAtTheWeightedSpeed) {
  const double c1 = std::sqrt(young / density), young2 = 70e9, density2 = 2700, c2 = std::sqrt(young2 / density2);
  const double z1 = density * c1 * area, z2 = density2 * c2 * area, transit = 0.5 / c1;
  const Outcome run =
      strike("steel on aluminium", {0.5, 10, young, density, 100}, {0.5, 0, young2, density2, 100}, 1.6 * transit);
  const HistoryTable& h = run.history;
  const double speed = z1 * 10 / (z1 + z2), force = z1 * z2 * 10 / (z1 + z2);
  EXPECT_NEAR(h.mean(0.2 * transit, 1.6 * transit, "left_vx"), speed, 5e-3 * 10);
  EXPECT_NEAR(h.mean(0.2 * transit, 1.6 * transit, "right_vx"), speed, 5e-3 * 10);
  EXPECT_NEAR(h.mean(0.6 * transit, 1.6 * transit, "stress_stress_xx"), -force / area, 2e-3 * force / area);
}

TEST(BarImpact, AShortBarStopsAndTheContactEndsAfterItsTwoTransits) {
  const double c = std::sqrt(young / density), transit = 0.2 / c;
  const Outcome run =
      strike("short on long", {0.2, 10, young, density, 80}, {0.6, 0, young, density, 240}, 2.9 * transit);
  const HistoryTable& h = run.history;
  // The interface is at rest then, and may continue touching without force: the pulse in the long bar tells the time.
  const double stress = density * c * 5;
  EXPECT_NEAR(h.time_of_rise("stress_stress_xx", -0.5 * stress) - h.time_of_rise("stress_von_mises", 0.5 * stress),
              2 * transit, 0.01 * 2 * transit);
  EXPECT_NEAR(h.mean(2.3 * transit, 2.9 * transit, "left_vx"), 0, 0.01 * 10);
  // all its momentum is in the long bar
  EXPECT_NEAR(h.mean(2.3 * transit, 2.9 * transit, "right_vx"), 0, 0.01 * 10);
  EXPECT_NEAR(h.last("momentum_x") / (density * area * 0.2 * 10), 1, 1e-12);
}

}  // namespace percuss::test::bar_waves_test
