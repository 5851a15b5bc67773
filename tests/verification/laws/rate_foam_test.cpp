// Foam with curves for several rates: a bar of one cell has the stress of its curves in every kind of solid; releases
// lose what their closed forms say; a column that is crushed to a twentieth of its height keeps its energy balance.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rate_foam_test {
namespace {

constexpr double young = 5e6;
constexpr const char* curves =
    "[[0.01, [[0, 0], [0.05, 1e5], [0.6, 2e5], [0.8, 8e5], [0.9, 4e6], [0.97, 4e7], [0.995, 1e9]]], "
    "[1, [[0, 0], [0.04, 1.4e5], [0.6, 3e5], [0.8, 1.2e6], [0.9, 5e6], [0.97, 5e7], [0.995, 1.1e9]]], "
    "[100, [[0, 0], [0.05, 2.5e5], [0.55, 5e5], [0.8, 2e6], [0.9, 7e6], [0.97, 6e7], [0.995, 1.3e9]]]]";

/// At the strain 0.45 by the rows above.
constexpr double at_strain = 0.45;
constexpr double rates[] = {0.01, 1, 100};
const double stresses[] = {1e5 + 0.4 / 0.55 * 1e5, 1.4e5 + 0.41 / 0.56 * 1.6e5, 2.5e5 + 0.4 / 0.5 * 2.5e5};

struct Bar {
  const char* name;
  const char* part;
};

const Bar bars[] = {
    {"one point", "box: {size: [1, 1, 1], cells: [1, 1, 1]}"},
    {"full", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, integration: full"},
    {"tetrahedra", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: tetrahedra"},
    {"wedges", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: wedges"},
};

/// Leads the end of a bar by an expression over the time, so slowly beside sound that inertia is nothing. x: at 1.
HistoryTable lead(const std::string& part, const std::string& keys, double time, const std::string& motion) {
  const double sound = 500 / time, density = young / (sound * sound);
  return run_deck(fmt::format(R"(
title: foam that is led
time: {{end: {0:.17g}}}
parts: {{bar: {{{1}, material: foam}}}}
materials: {{foam: {{model: rate_table_foam, density: {2:.17g}, youngs_modulus: 5e6, rate_measure: engineering, compression_at_rates: {3}{4}}}}}
conditions:
  - {{nodes: bar/x_min, symmetry: x}}
  - {{nodes: bar/y_min, symmetry: y}}
  - {{nodes: {{inside: [[0, 0, 0], [1, 1, 0]]}}, fixed: [z]}}
  - {{nodes: bar/x_max, displacement: {{x: {{expression: "{5}"}}}}}}
damping: [{{coefficient: {6:.17g}}}]
output: {{history: {{every: {7:.17g}, elements: [{{name: m, near: [0.5, 0.5, 0.5]}}]}}}}
)",
                              time, part, density, curves, keys, motion, 100 / time, time / 200))
      .history;
}

double find_stress(double rate, bool logarithmic) {
  const double inside = std::min(std::max(rate, rates[0]), rates[2]);
  const int k = inside < rates[1] ? 0 : 1;
  const double share = logarithmic ? std::log(inside / rates[k]) / std::log(rates[k + 1] / rates[k])
                                   : (inside - rates[k]) / (rates[k + 1] - rates[k]);
  return (1 - share) * stresses[k] + share * stresses[k + 1];
}

TEST(RateFoam, BarOfOneCellHasTheStressOfItsCurvesAndBetweenThem) {
  for (const Bar& bar : bars) {
    for (const double rate : {0.01, 0.3, 1.0, 20.0, 100.0}) {
      for (const bool logarithmic : {false, true}) {
        if (logarithmic && rate != 0.3 && rate != 20) continue;  // on a curve it is the same
        const std::string keys = logarithmic ? ", rate_interpolation: logarithmic" : "";
        const HistoryTable h = lead(bar.part, keys, at_strain / rate, fmt::format("-{:.17g} * t", rate));
        const double right = find_stress(rate, logarithmic);
        fmt::print("{}, {} / s, {}: {:.5g} kPa, curves {:.5g} kPa\n", bar.name, rate,
                   logarithmic ? "logarithmic" : "linear", -1e-3 * h.last("m_stress_xx"), 1e-3 * right);
        EXPECT_NEAR(-h.last("m_stress_xx"), right, 5e-3 * right);
        EXPECT_NEAR(h.last("m_stress_yy"), 0, 5e-3 * right);
      }
    }
  }
}

/// Area below the slow curve up to 0.7.
constexpr double stored = 0.5 * 0.05 * 1e5 + 0.55 * 1.5e5 + 0.1 * 0.5 * (2e5 + 5e5);

TEST(RateFoam, SlowCrushAndReleaseLoseTheShareOfTheClosedForm) {
  for (const auto& [share, shape, exponent] : {std::array{1.0, 1.0, 1.0}, {0.2, 1.0, 1.0}, {0.1, 3.0, 2.0}}) {
    const std::string keys =
        fmt::format(", hysteretic_unloading: {}, unloading_shape: {}, unloading_exponent: {}", share, shape, exponent);
    const HistoryTable h = lead(bars[0].part, keys, 1e3, "-0.7 * sin(pi * t / 1e3)^2");
    const double lost = (1 - share) * std::beta(1 / shape, exponent + 1) / shape;
    EXPECT_NEAR(h.largest("internal"), stored, 5e-3 * stored);
    EXPECT_NEAR(h.last("internal"), lost * stored, 5e-3 * stored);
    EXPECT_LT(h.largest("energy_error"), 1e-3);
  }
}

TEST(RateFoam, FastCrushAndReleaseLoseTheAreaBetweenTheCurves) {
  // up at 100 / s, down along the slow curve but for what the overstress gives back along its slope
  const HistoryTable h = lead(bars[0].part, "", 9e-3, "-0.45 + abs(0.45 - 100 * t)");
  const double up = 0.5 * 0.05 * 2.5e5 + 0.4 * 0.5 * (2.5e5 + stresses[2]),
               down = 0.5 * 0.05 * 1e5 + 0.4 * 0.5 * (1e5 + stresses[0]);
  EXPECT_NEAR(h.largest("internal"), up, 5e-3 * up);
  const double over = stresses[2] - stresses[0], elastic = over * over / (2 * (young + 5e5 - 1e5 / 0.55));
  EXPECT_LT(h.last("internal"), (up - down) + 5e-3 * up);
  EXPECT_GT(h.last("internal"), (up - down) - elastic - 5e-3 * up);
}

TEST(RateFoam, ColumnCrushedToATwentiethKeepsItsEnergyBalance) {
  for (const double time : {1e-2, 10.0}) {
    const HistoryTable h = lead("box: {size: [1, 0.2, 0.2], cells: [8, 2, 2]}", ", hysteretic_unloading: 0.3", time,
                                fmt::format("-0.95 * sin(pi * t / {:.17g})^2", time));
    fmt::print("{} s: largest error {:.2e}, {:.4g} of {:.4g} J lost\n", time, h.largest("energy_error"),
               h.last("internal"), h.largest("internal"));
    EXPECT_LT(std::max(h.largest("energy_error"), -h.smallest("energy_error")), 1e-3);
    EXPECT_GT(h.last("internal"), 0.3 * h.largest("internal"));
  }
}

}  // namespace
}  // namespace percuss::test::rate_foam_test
