// Piles of rigid bodies: their weight on the floor, and steps that converge however many bodies lean on each other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rigid_pile_test {
namespace {

constexpr double mass = 0.01, g = 9.81;

/// A number from -1 to 1, the same ones in the same order in each run.
double draw(unsigned& state) {
  state = state * 1103515245u + 12345u;
  return 2.0 * ((state >> 16) & 0x7fffu) / 0x7fff - 1;
}

/// Balls of radius 0.01 in layers of across x across above a floor between four walls, each a little off its place.
std::string describe_pile(int across, int layers, double restitution, double end) {
  constexpr double pitch = 0.022;
  unsigned state = 7;
  std::string parts;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        const double x = pitch * i + 1e-3 * draw(state), y = pitch * j + 1e-3 * draw(state);
        parts += fmt::format(
            "  b{}: {{sphere: {{radius: 0.01, cells: 6}}, at: [{:.6f}, {:.6f}, {:.6f}], material: stone, rigid: "
            "{{mass: {}}}}}\n",
            (k * across + j) * across + i, x, y, 0.0102 + 0.0205 * k, mass);
      }
  const double far = pitch * (across - 1) + 0.012;
  return fmt::format(R"(
time: {{end: {}, max_step: 1.0e-4}}
parts:
{}materials: {{stone: {{model: elastic, density: 2500, youngs_modulus: 1.0e8, poissons_ratio: 0.3}}}}
contact: {{surfaces: all, friction: 0.3, restitution: {}}}
loads: {{gravity: [0, 0, -{}]}}
walls:
- {{name: floor, normal: z, friction: 0.3}}
- {{point: [-0.012, 0, 0], normal: x}}
- {{point: [{}, 0, 0], normal: -x}}
- {{point: [0, -0.012, 0], normal: y}}
- {{point: [0, {}, 0], normal: -y}}
output: {{history: {{every: 0, forces: [{{name: f, wall: floor}}]}}}}
)",
                     end, parts, restitution, g, far, far);
}

/// Mean of a force over the last `share` of the run.
double find_mean(const HistoryTable& history, const std::string& column, double share) {
  double sum = 0, time = 0;
  for (std::size_t i = 1; i < history.rows(); ++i) {
    if (history["time"][i] < (1 - share) * history["time"].back()) continue;
    const double dt = history["time"][i] - history["time"][i - 1];
    sum += dt * history[column][i];
    time += dt;
  }
  return sum / time;
}

bool has_warning(const Outcome& run, const std::string& rule) {
  return std::any_of(run.summary.warnings.begin(), run.summary.warnings.end(),
                     [&](const auto& warning) { return warning.rule == rule; });
}

}  // namespace

// The walls have no friction: once at rest the floor carries m g of all, wherever the pile leans.
TEST(RigidPile, AtRestStandsOnTheFloorWithItsWeight) {
  const Outcome run = run_deck(describe_pile(3, 3, 0.3, 0.75));
  EXPECT_NEAR(find_mean(run.history, "fz:f", 0.05), 27 * mass * g, 1e-2 * 27 * mass * g);
  EXPECT_LT(run.summary.energy.kinetic, 1e-5 * 27 * mass * g * 0.01);
  EXPECT_FALSE(has_warning(run, "unconverged_contact"));
}

// The momentum of what falls and rebounds is that of gravity and of the floor, at every time.
TEST(RigidPile, ThatFallsTogetherConvergesInEachStep) {
  const Outcome run = run_deck(describe_pile(3, 3, 0.3, 0.06));
  EXPECT_FALSE(has_warning(run, "unconverged_contact"));
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
}

}  // namespace percuss::test::rigid_pile_test
