// Orders of convergence in space and in time, apart from each other: the first mode of a fixed bar.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::convergence_test {
namespace {

constexpr double pi = std::numbers::pi;
const double speed = std::sqrt(200e9 / 7850), end = 5 / speed;  // a period and a quarter

/// u = A sin(pi x / 2) sin(w t) in a bar of length 1, A = 1e-6: root of the mean square error of the free end over A.
double find_error(int cells, double step, double frequency) {
  const double amplitude = 1e-6;
  std::string planes;
  for (int i = 1; i <= cells; ++i) {
    const double x = static_cast<double>(i) / cells, around = 0.25 / cells;
    planes += fmt::format("  - {{nodes: {{inside: [[{}, -1, -1], [{}, 1, 1]]}}, velocity: [{:.17g}, 0, 0]}}\n",
                          x - around, x + around, amplitude * frequency * std::sin(0.5 * pi * x));
  }
  const Outcome run = run_deck(fmt::format(R"(
title: first mode, {} elements
time: {{end: {:.17g}, max_step: {:.17g}}}
parts: {{bar: {{box: {{size: [1, 0.125, 0.125], cells: [{}, 1, 1]}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}}}
elements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}
initial:
{}conditions: [{{nodes: bar/x_min, fixed: [x, y, z]}}]
output: {{history: {{every: 0, nodes: [{{name: end, near: [1, 0, 0]}}]}}}}
)",
                                           cells, end, step, cells, planes));
  double sum = 0;
  for (std::size_t i = 0; i < run.history.rows(); ++i) {
    const double exact = amplitude * std::sin(frequency * run.history["time"][i]);
    sum += std::pow(run.history["end_x"][i] - 1 - exact, 2);
  }
  return std::sqrt(sum / static_cast<double>(run.history.rows())) / amplitude;
}

}  // namespace

TEST(Convergence, IsOfSecondOrderInTheSizeOfTheElements) {
  // Steps so short that their error, of order (w dt)^2 / 24, is a thousandth of that of the mesh, (pi h / 2)^2 / 24.
  const double exact = 0.5 * pi * speed, coarse = find_error(8, 2e-7, exact), fine = find_error(16, 2e-7, exact);
  fmt::print("space: {:.3e} and {:.3e}, order {:.3f}\n", coarse, fine, std::log2(coarse / fine));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);  // the next term is of fourth order: (pi h / 2)^2 / 80 of this one
  EXPECT_LT(coarse, 0.01);
}

TEST(Convergence, IsOfSecondOrderInTheStep) {
  // against the exact motion of the chain of lumped masses that the mesh is
  const double chain = 16 * speed * std::sin(pi / 32);
  const double coarse = find_error(8, end / 80, chain), fine = find_error(8, end / 160, chain);
  fmt::print("time: {:.3e} and {:.3e}, order {:.3f}\n", coarse, fine, std::log2(coarse / fine));
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
  EXPECT_LT(coarse, 0.01);
}

}  // namespace percuss::test::convergence_test
