// Overlap at the start that is pushed out while bodies close in: contact gives them no more than it gives bodies at
// rest.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::push_out_test {
namespace {

const std::string steel =
    "materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
    "output: {history: {every: 0}}\n";

/// Two blocks whose faces overlap by 0.0005, 0.02 of an element.
const std::string blocks = R"(
time: {end: 16e-4}
parts:
  low: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: m}
  high: {box: {size: [0.06, 0.06, 0.06], cells: [3, 3, 3]}, at: [0.013, 0.017, 0.0995], material: m}
)";
constexpr double block_masses[] = {7850 * 1e-3, 7850 * 2.16e-4}, overlap_of_blocks = 5e-4;

/// Crossed tubes of 16 elements around: two of their edges overlap by 0.001, 0.026 of the shortest edge, no node does.
const std::string tubes = R"(
time: {end: 40e-4}
parts:
  low: {tube: {inner_radius: 0.06, outer_radius: 0.1, length: 0.4, cells: [1, 16, 3]}, rotate: [{axis: x, angle: 90}], at: [0, 0.2, 0], material: m}
  high: {tube: {inner_radius: 0.06, outer_radius: 0.1, length: 0.41, cells: [1, 16, 3]}, rotate: [{axis: y, angle: 90}], at: [-0.2, 0, 0.199], material: m}
)";
constexpr double tube_masses[] = {7850 * 0.0078, 7850 * 0.0080}, overlap_of_tubes = 1e-3;

Outcome close_in(const std::string& bodies, const std::string& enforcement, double speed) {
  return run_deck(bodies + steel +
                  fmt::format("initial: [{{part: high, velocity: [0, 0, {:g}]}}]\n"
                              "contact: {{surfaces: all, overlap: push_out, enforcement: {}}}\n",
                              -speed, enforcement));
}

/// Springs alone store what contact has taken.
double find_largest_gain(const HistoryTable& history) {
  double largest = 0;
  for (std::size_t i = 0; i < history["contact"].size(); ++i)
    largest =
        std::max(largest, history["contact"][i] + (history.has("contact_stored") ? history["contact_stored"][i] : 0));
  return largest;
}

/// Faces that move apart by a thousandth of the overlap a step throw free bodies apart at twice that by their waves.
double find_thrown_energy(const double (&masses)[2], double overlap, const Outcome& run) {
  const double speed = 2 * overlap / 1000 / run.history.smallest("dt");
  return 0.5 * masses[0] * masses[1] / (masses[0] + masses[1]) * speed * speed;
}

}  // namespace

// Pushed against the load of the impact, the blocks would gain 14 J at 5 m/s, and 42 J by springs. Pushed at 1e-4 of an
// element a step, they would gain 4 J after it.
TEST(PushOut, OfBodiesThatCloseInGivesWhatItGivesAtRest) {
  for (const char* enforcement : {"kinematic", "penalty", "lagrange"}) {
    for (const double speed : {0.0, 1.0, 2.0, 3.0, 5.0, 10.0}) {
      const Outcome run = close_in(blocks, enforcement, speed);
      EXPECT_LT(find_largest_gain(run.history), 1.3 * find_thrown_energy(block_masses, overlap_of_blocks, run))
          << enforcement << " " << speed;
      if (speed > 1) {
        EXPECT_LT(find_largest_gain(run.history), 1e-3 * run.history["kinetic"].front()) << enforcement << " " << speed;
      }
    }
  }
}

TEST(PushOut, OfEdgesThatCloseInGivesWhatItGivesAtRest) {
  for (const double speed : {0.0, 1.0, 2.0, 5.0}) {
    const Outcome run = close_in(tubes, "kinematic", speed);
    EXPECT_LT(find_largest_gain(run.history), find_thrown_energy(tube_masses, overlap_of_tubes, run)) << speed;
    if (speed > 0) {
      EXPECT_LT(find_largest_gain(run.history), 1e-3 * run.history["kinetic"].front()) << speed;
    }
  }
}

// Held ends press the blocks by the overlap: what has been pushed out is no load to wait for, however stiff they are.
TEST(PushOut, EndsAgainstWhatItPresses) {
  for (const int layers : {1, 2, 4}) {
    const Outcome run = run_deck(fmt::format(R"(
time: {{end: 340}}
parts:
  a: {{box: {{size: [1, 1, 0.5], cells: [2, 2, {0}]}}, material: m}}
  b: {{box: {{size: [0.8, 0.8, 0.5], cells: [2, 2, {0}]}}, at: [0.1, 0.1, 0.48], material: m}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}}}
conditions: [{{nodes: a/z_min, fixed: [z]}}, {{nodes: b/z_max, fixed: [z]}}]
contact: {{surfaces: [[a, b]], overlap: push_out}}
output: {{history: {{every: 0, nodes: [{{name: a, near: [0.5, 0.5, 0.5], part: a}}, {{name: b, near: [0.5, 0.5, 0.48], part: b}}]}}}}
)",
                                             layers));
    EXPECT_LT(run.history.last("a_z") - run.history.last("b_z"), 0.05 * 0.02) << layers;
  }
}

}  // namespace percuss::test::push_out_test
