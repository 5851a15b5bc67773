// A bar of one cell that is pulled at a constant rate has the stress of the table of rates, in every kind of element.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rate_table_test {
namespace {

constexpr double young = 210e9, strain = 0.06;

/// 250 MPa, 320 MPa at a plastic strain of 0.1, at 0.1 / s; 350 and 448 MPa at 100 / s, whose rows are others.
constexpr const char* table = "[[0.1, [[0, 250e6], [0.1, 320e6]]], [100, [[0, 350e6], [0.04, 389.2e6], [0.1, 448e6]]]]";

double slow(double p) { return 250e6 + 700e6 * p; }
double fast(double p) { return 350e6 + 980e6 * p; }

struct Bar {
  const char* name;
  const char* part;
};

const Bar bars[] = {
    {"one point", "box: {size: [1, 1, 1], cells: [1, 1, 1]}"},
    {"full", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, integration: full"},
    {"tetrahedra", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: tetrahedra"},
    {"wedges", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: wedges"},
    {"shells", "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1"},
};

/// Pulls to a logarithmic strain at a constant rate, so slowly beside sound that inertia is nothing.
Outcome pull(const Bar& bar, double rate, const char* interpolation) {
  const double time = strain / rate, sound = 2000 / time, density = young / (sound * sound);
  return run_deck(fmt::format(
      R"(
title: bar at a constant rate
time: {{end: {0:.17g}}}
parts: {{bar: {{{1}, material: steel}}}}
materials: {{steel: {{model: rate_table_plasticity, density: {2:.17g}, youngs_modulus: 210e9, poissons_ratio: 0.3, rate_interpolation: {3}, hardening_at_rates: {4}}}}}
conditions:
  - {{nodes: bar/x_min, symmetry: x}}
  - {{nodes: bar/y_min, symmetry: y}}
  - {{nodes: {{inside: [[0, 0, 0], [1, 1, 0]]}}, fixed: [z]}}
  - {{nodes: bar/x_max, displacement: {{x: {{expression: "exp({5:.17g} * t) - 1"}}}}}}
damping: [{{coefficient: {6:.17g}}}]
output: {{history: {{every: {7:.17g}, elements: [{{name: m, near: [0.5, 0.5, 0.5]}}]}}}}
)",
      time, bar.part, density, interpolation, table, rate, 100 / time, time / 50));
}

/// The flow stress at p where p grows at the rate less that of the elastic strain.
double find_stress(double p, double rate, bool logarithmic) {
  const auto at = [&](double r) {
    const double share = logarithmic ? std::log(r / 0.1) / std::log(1000.0) : (r - 0.1) / 99.9;
    const double bounded = std::min(std::max(share, 0.0), 1.0);
    return slow(p) + bounded * (fast(p) - slow(p));
  };
  const double slope = (at(rate) - slow(p)) / (fast(p) - slow(p)) * 280e6 + 700e6;
  return at(rate / (1 + slope / young));
}

TEST(RateTable, BarOfOneCellHasTheStressOfTheTable) {
  for (const Bar& bar : bars) {
    for (const double rate : {0.01, 1.0, 10.0, 1000.0}) {
      for (const bool logarithmic : {false, true}) {
        const HistoryTable h = pull(bar, rate, logarithmic ? "logarithmic" : "linear").history;
        const double p = h.last("m_eps"), right = find_stress(p, rate, logarithmic);
        fmt::print("{}, {} / s, {}: {:.5g} MPa, table {:.5g} MPa\n", bar.name, rate,
                   logarithmic ? "logarithmic" : "linear", 1e-6 * h.last("m_von_mises"), 1e-6 * right);
        EXPECT_NEAR(p, strain - right / young, 1e-3 * strain);
        EXPECT_NEAR(h.last("m_von_mises"), right, 1e-3 * right);  // the rate swings by some share of the damped waves
        EXPECT_NEAR(h.last("m_stress_xx"), right, 2e-3 * right);
      }
    }
  }
}

}  // namespace
}  // namespace percuss::test::rate_table_test
