// Tension of rolled sheet, as a run: strain ratio and yield stress by the angle to the rolling direction.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rolled_sheet_test {
namespace {

constexpr double modulus = 70e3, poissons_ratio = 0.33, yield = 200, slope = 400, length = 10;

/// What a test of a strip gives: stress, plastic strains along it and across it, equivalent plastic strain, the work of
/// the stress over the volume at the start, and how far the axes have turned by the shear of the strip [degrees].
struct Strip {
  double stress, along, width, p, work, turn;

  double ratio() const { return width / -(along + width); }
};

/// element: its shape and its section. A velocity that begins smoothly pulls it to 1.05 of its length.
Strip pull(const std::string& law, const std::string& element, double volume) {
  const HistoryTable history = run_deck(fmt::format(R"(
title: a strip of rolled sheet
time: {{end: 2e-3}}
materials: {{m: {{{}, density: 2.7e-9, youngs_modulus: {}, poissons_ratio: {}, hardening: [[0, {}], [1, {}]]}}}}
parts: {{s: {{{}, material: m}}}}
conditions: [{{nodes: s/x_min, fixed: [x]}}, {{nodes: {{name: s, inside: [[-1, -1, -1], [0.1, 0.1, 0.1]]}}, fixed: [y, z]}}, {{nodes: s/x_max, velocity: {{x: {{table: [[0, 0], [1e-3, 333.333], [2e-3, 333.333]]}}}}}}]
output: {{history: {{every: 2e-5, nodes: [{{name: a, near: [10, 10, 0]}}, {{name: b, near: [10, 0, 0]}}], elements: [{{name: e, near: [5, 5, 0]}}]}}}}
)",
                                                    law, modulus, poissons_ratio, yield, yield + slope, element))
                                   .history;
  const double stress = history.last("e_stress_xx");
  const double longer = std::log(history.last("a_x") / length);
  const double wider = std::log((history.last("a_y") - history.last("b_y")) / length);
  return {stress,
          longer - stress / modulus,
          wider + poissons_ratio * stress / modulus,
          history.last("e_eps"),
          history.last("internal") / volume,
          90 / std::numbers::pi * history.last("b_y") / history.last("a_x")};
}

std::string turn(double degrees) {
  const double angle = -degrees * std::numbers::pi / 180;
  return fmt::format("first_axis: [{}, {}, 0]", std::cos(angle), std::sin(angle));
}

Strip pull_shell(const std::string& law) {
  return pull(law, "shell_plate: {size: [10, 10], cells: [1, 1]}, thickness: 1", 100);
}

/// The stress is on the hardening curve, and its work is that of the curve: thickness, width and length fit together.
void expect_curve(const Strip& strip, double stress_over_yield) {
  EXPECT_NEAR(strip.stress, stress_over_yield * (yield + slope * strip.p), 1e-3 * yield);
  const double plastic = yield * strip.p + 0.5 * slope * strip.p * strip.p;
  EXPECT_NEAR(strip.work, plastic + 0.5 * strip.stress * strip.stress / modulus, 2e-3 * plastic);
  EXPECT_GT(strip.p, 0.03);
}

}  // namespace

TEST(RolledSheet, HasTheStrainRatiosOfItsDeckInARun) {
  const double ratios[3] = {0.7, 0.5, 0.9};
  for (const char* exponent : {"2", "8"}) {
    for (int k = 0; k < 3; ++k) {
      const Strip strip = pull_shell(fmt::format(
          "model: anisotropic_plasticity, r_values: [0.7, 0.5, 0.9], exponent: {}, {}", exponent, turn(45 * k)));
      fmt::print("exponent {}, {} degrees: r {:.5f}, stress {:.3f}\n", exponent, 45 * k, strip.ratio(), strip.stress);
      EXPECT_NEAR(strip.ratio(), ratios[k], 2e-3 * ratios[k]);
    }
  }
}

TEST(RolledSheet, YieldsByTheAngleToTheRollingDirection) {
  // Hill (1948): F, G, H and N of the ratios 1.8, 1.2 and 2.3.
  const double f = 1.8 / (2.3 * 2.8), g = 1 / 2.8, h = 1.8 / 2.8, n = (1.8 + 2.3) * 3.4 / (2 * 2.3 * 2.8);
  for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
    const Strip strip = pull_shell("model: anisotropic_plasticity, r_values: [1.8, 1.2, 2.3], " + turn(degrees));
    const double angle = (degrees - strip.turn) * std::numbers::pi / 180, cc = std::pow(std::cos(angle), 2),
                 ss = 1 - cc;
    const double square = f * ss + g * cc + h + (2 * n - f - g - 4 * h) * cc * ss;
    fmt::print("{} degrees, turned by {:.3f}: stress {:.4f} of the curve\n", degrees, strip.turn,
               strip.stress / (yield + slope * strip.p));
    expect_curve(strip, 1 / std::sqrt(square));
  }
}

TEST(RolledSheet, BarlatsSurfaceIsThatOfItsParameters) {
  // Across the rolling direction the yield stress is 1 / h, and the strain ratio c / (2 h - c).
  const Strip strip = pull_shell("model: anisotropic_plasticity, barlat: [0.9, 1.1, 0.95], exponent: 6, " + turn(90));
  expect_curve(strip, 1 / 1.1);
  EXPECT_NEAR(strip.ratio(), 0.9 / (2.2 - 0.9), 2e-3);
}

TEST(RolledSheet, ASolidOfItDoesTheSame) {
  const std::string box = "box: {size: [10, 10, 1], cells: [1, 1, 1]}";
  const Strip strip =
      pull("model: anisotropic_plasticity, r_values: [1.8, 1.2, 2.3], first_axis: [0, 1, 0], second_axis: [1, 0, 0]",
           box, 100);
  expect_curve(strip, std::sqrt(2.3 * 2.8 / (1.8 * 3.3)));
  EXPECT_NEAR(strip.ratio(), 2.3, 5e-3 * 2.3);
}

TEST(RolledSheet, WithoutDirectionsItIsTheIsotropicSheet) {
  const std::string isotropic = "model: tabulated_plasticity";
  const Strip a = pull_shell("model: anisotropic_plasticity"), b = pull_shell(isotropic);
  EXPECT_NEAR(a.stress, b.stress, 1e-9 * b.stress);
  EXPECT_NEAR(a.p, b.p, 1e-9);
  EXPECT_NEAR(a.work, b.work, 1e-9 * b.work);
}

TEST(RolledSheet, WhatCannotBeIsRefused) {
  const auto expect_refused = [](const std::string& law, const std::string& element, const std::string& message) {
    try {
      pull(law, element, 1);
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  const std::string box = "box: {size: [10, 10, 1], cells: [1, 1, 1]}";
  const std::string plate = "shell_plate: {size: [10, 10], cells: [1, 1]}, thickness: 1";
  expect_refused("model: anisotropic_plasticity, exponent: 8", box, "exponent is not 2");
  expect_refused("model: anisotropic_plasticity, axes: elements", box, "axes: elements");
  expect_refused("model: anisotropic_plasticity, r_values: [1, 0, 1]", plate, "r_values that are not positive");
  expect_refused("model: anisotropic_plasticity, first_axis: [0, 0, 1]", plate, "normal is first_axis");
}

}  // namespace percuss::test::rolled_sheet_test
