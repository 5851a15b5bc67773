// Failure strains over the size of elements: sheets of three meshes that neck break at the same elongation.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/verification/support/deaths.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::failure_size_test {
namespace {

// A sheet that keeps its width: with the logarithmic strain e its force is 2/sqrt(3) Y(2/sqrt(3) e) exp(-e) t, and the
// neck forms where that is greatest (Considere). The neck is one row of shells, of a strength `weak` of the others.
constexpr double length = 40, width_share = 1.1547005383792515, weak = 0.85, opening = 3;
constexpr double first_yield = 100, coefficient = 400, exponent = 0.3;

double find_force(double strain) {
  return (first_yield + coefficient * std::pow(width_share * strain, exponent)) * std::exp(-strain);
}

/// Strain of the whole rows when the weak one carries its greatest force: they stretch no more.
double find_whole_strain() {
  double peak = 0.01;
  while (find_force(peak + 1e-5) > find_force(peak)) peak += 1e-5;
  double strain = 1e-4;
  while (find_force(strain) < weak * find_force(peak)) strain += 1e-6;
  return strain;
}

/// The law of the neck: it opens by the same length beyond what whole rows have, whatever the length of the row.
double find_failure_strain(double size) {
  return width_share * std::log(std::exp(find_whole_strain()) + opening / size);
}

/// Elongation at which the weak row of this length is gone, with the plastic strain `limit` times the factors of
/// `sizes`.
double find_elongation(double size, double limit, const std::string& sizes) {
  const std::string law = fmt::format(
      "model: power_law_plasticity, density: 7.85e-9, youngs_modulus: 200e3, poissons_ratio: 0.3, hardening_exponent: "
      "{}, "
      "failure: {{plastic_strain: {:.17g}{}}}",
      exponent, limit, sizes);
  const HistoryTable h = run_deck(fmt::format(R"(
title: a sheet necks
units: mm, t, s
time: {{end: 3.2e-3}}
parts:
  weak: {{shell_plate: {{size: [{0}, {0}], cells: [1, 1]}}, thickness: 1, material: weak}}
  sheet: {{shell_plate: {{size: [{1}, {0}], cells: [{2:.0f}, 1]}}, at: [{0}, 0, 0], thickness: 1, material: whole}}
join: [{{parts: [weak, sheet]}}]
materials:
  weak: {{{3}, yield_stress: {4}, hardening_coefficient: {5}}}
  whole: {{{3}, yield_stress: {6}, hardening_coefficient: {7}}}
conditions:
  - {{nodes: all, fixed: [y, z, rx, ry, rz]}}
  - {{nodes: weak/x_min, fixed: [x]}}
  - {{nodes: sheet/x_max, velocity: {{x: {{table: [[0, 0], [2e-4, 2e3], [3.2e-3, 2e3]]}}}}}}
output: {{history: {{every: 5e-6, nodes: [{{name: end, near: [40, 0, 0]}}]}}}}

)",
                                              size, length - size, length / size - 1, law, weak * first_yield,
                                              weak * coefficient, first_yield, coefficient))
                             .history;
  const std::size_t death = find_death(h);
  return death < h.rows() ? h["end_x"][death] - length : 0;
}

TEST(FailureSize, LetsSheetsOfThreeMeshesBreakAtTheSameElongation) {
  const double coarse = find_failure_strain(4);
  std::string table = ", size: [";
  for (const double size : {1.0, 2.0, 4.0})
    table += fmt::format("{}[{}, {:.17g}]", size > 1 ? ", " : "", size, find_failure_strain(size) / coarse);
  table += "]";
  // Whole rows stretch by e, the neck opens by `opening` beyond that. Inertia while the neck forms and elastic strain
  // add 0.3 % of the length.
  const double right = length * (std::exp(find_whole_strain()) - 1) + opening;
  std::vector<double> all;
  for (const double size : {1.0, 2.0, 4.0}) {
    const double found = find_elongation(size, coarse, table), without = find_elongation(size, coarse, "");
    fmt::print("row of {}: {:.3f} mm, {:.3f} with one failure strain for all, right {:.3f}\n", size, found, without,
               right);
    EXPECT_NEAR(found, right, 0.04 * right) << size;
    all.push_back(found);
    if (size == 1) {
      EXPECT_LT(without, 0.7 * right);
    }
  }
  EXPECT_LT(*std::max_element(all.begin(), all.end()), 1.02 * *std::min_element(all.begin(), all.end()));
}

}  // namespace
}  // namespace percuss::test::failure_size_test
