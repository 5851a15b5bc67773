// Cracks along cohesive ties, in specimens with closed forms: the double cantilever beam and the end-loaded split beam.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::crack_test {
namespace {

constexpr double youngs_modulus = 70e9, height = 2e-3, width = 1e-3, length = 50e-3, stiffness = 3e12;

/// Two beams of 50 mm, one on the other, glued from x = start on; Poisson's ratio is 0.
std::string make_specimen(double start, const std::string& glue, const std::string& rest) {
  return fmt::format(R"yaml(
parts:
  low: {{box: {{size: [0.05, 0.001, 0.002], cells: [50, 1, 2]}}, at: [0, 0, -0.002], material: m}}
  high: {{box: {{size: [0.05, 0.001, 0.002], cells: [50, 1, 2]}}, material: m}}
materials: {{m: {{model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0}}}}
contact:
  surfaces: none
  ties: [{{a: {{name: high/z_min, inside: [[{}, -1, -1], [1, 1, 1]]}}, b: low/z_max, cohesive: {{normal_stiffness: 3e12, {}}}}}]
{})yaml",
                     start - 1e-4, glue, rest);
}

}  // namespace

// The opening of both arms on the glue as an elastic foundation (Kanninen, Int. J. Fracture 9, 1973), and the energy
// that the crack spends as it grows: P^2 D is the same for every length of the crack, by beam theory.
TEST(Crack, OfADoubleCantileverBeam) {
  constexpr double crack = 20e-3, energy = 200;
  const Outcome run = run_deck("time: {end: 6e-3}\n" + make_specimen(crack,
                                                                     "normal_strength: 20e6, shear_strength: 60e6, "
                                                                     "normal_energy: 200, shear_energy: 700",
                                                                     R"yaml(
damping: [{coefficient: 1e3}]
conditions:
  - {nodes: high/x_min, velocity: {z: {table: [[0, 0], [5e-4, 0.15], [6e-3, 0.15]]}}}
  - {nodes: low/x_min, velocity: {z: {table: [[0, 0], [5e-4, -0.15], [6e-3, -0.15]]}}}
output: {history: {every: 5e-6, forces: [{name: pull, support: high/x_min}]}}
)yaml"));
  const HistoryTable& history = run.history;
  const auto opening_at = [](double t) { return 2 * 0.15 * (t - 2.5e-4); };  // from 5e-4 on
  const double stiff = youngs_modulus * width * std::pow(height, 3);
  const double lambda = std::pow(6 * stiffness / (youngs_modulus * std::pow(height, 3)), 0.25), la = lambda * crack;
  const double compliance = 8 * std::pow(crack, 3) / stiff * (1 + 3 / la + 3 / (la * la) + 1.5 / (la * la * la));
  const double elastic = history.mean(0.8e-3, 1.1e-3, "fz:pull");
  EXPECT_NEAR(elastic, opening_at(0.95e-3) / compliance, 0.04 * elastic);
  const double of_energy =
      8 * std::pow(width, 3) / stiff * std::pow(energy * youngs_modulus * std::pow(height, 3) / 12, 1.5);
  double last = 0;
  for (const double start : {3e-3, 4e-3, 5e-3}) {
    const double force = history.mean(start, start + 1e-3, "fz:pull");
    const double reached = std::pow(force * force * opening_at(start + 0.5e-3) / of_energy, 2.0 / 3.0);  // G over G_c
    EXPECT_NEAR(reached, 1, 0.05) << start;
    const double failed = history.at(start + 0.5e-3, "glue_failed");
    EXPECT_GT(failed, last);
    last = failed;
  }
  EXPECT_GT(last, 8e-6);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

// A cantilever whose free end is split and pushed: both arms bend alike, so that the crack is one of shear alone. Its
// length follows from the compliance (3 a^3 + L^3) / (2 E b h^3) and the shear of the whole beam, its energy from P and
// a.
TEST(Crack, OfAnEndLoadedSplitBeam) {
  constexpr double crack = 30e-3, energy = 600;
  const Outcome run = run_deck("time: {end: 7e-3}\n" + make_specimen(crack,
                                                                     "normal_strength: 60e6, shear_strength: 40e6, "
                                                                     "normal_energy: 700, shear_energy: 600",
                                                                     R"yaml(
damping: [{coefficient: 1e3}]
conditions:
  - {nodes: low/x_max, fixed: [x, y, z]}
  - {nodes: high/x_max, fixed: [x, y, z]}
  - {nodes: high/x_min, velocity: {z: {table: [[0, 0], [1e-3, -0.45], [7e-3, -0.45]]}}}
  - {nodes: low/x_min, velocity: {z: {table: [[0, 0], [1e-3, -0.45], [7e-3, -0.45]]}}}
output: {history: {every: 5e-6, forces: [{name: high, support: high/x_min}, {name: low, support: low/x_min}]}}
)yaml"));
  const HistoryTable& history = run.history;
  const double stiff = 2 * youngs_modulus * width * std::pow(height, 3);
  const double shear = 1.2 * length / (0.5 * youngs_modulus * width * 2 * height);  // G = E / 2
  const auto find_crack = [&](double start, double& force) {
    force = -history.mean(start, start + 1e-3, "fz:high") - history.mean(start, start + 1e-3, "fz:low");
    return std::cbrt(((0.45 * start / force - shear) * stiff - std::pow(length, 3)) / 3);  // at the middle of the mean
  };
  double force = 0;
  EXPECT_NEAR(find_crack(3e-3, force), crack, 0.07 * crack);  // the glue yields ahead of the crack
  for (const double start : {5.5e-3, 6e-3}) {
    const double reached = find_crack(start, force);
    EXPECT_GT(reached, 1.1 * crack) << start;
    const double spent = 9 * force * force * reached * reached / (2 * width * stiff);
    EXPECT_NEAR(spent, energy, 0.08 * energy) << start;
  }
  EXPECT_GT(history.at(6.5e-3, "glue_failed"), 5e-6);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

}  // namespace percuss::test::crack_test
