// An elastic ball on a rigid wall against Hertz.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/graded_ball.hpp"
#include "tests/verification/run_deck.hpp"

namespace percuss::test {

TEST(Hertz, ABallOnARigidWallTouchesAndPushesAsLongAndAsHardAsHertzSays) {
  const double radius = 0.01, young = 210e9, poisson = 0.3, speed = 3;
  // a quarter of the ball; elements of 0.125 mm where it touches
  const std::string file = testing_mesh::write_exodus(make_graded_quarter_ball(radius, 36, 0.75), "hertz.exo");
  const Outcome run = run_deck(fmt::format(R"(
title: Hertz impact
time: {{end: 4.6e-5}}
parts: {{ball: {{exodus: {{file: {}}}, at: [0, 0, 0.0100001], material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3}}}}
initial: [{{part: ball, velocity: [0, 0, -3]}}]
conditions:
  - {{nodes: {{name: ball, inside: [[0, -1, -1], [0, 1, 1]]}}, symmetry: x}}
  - {{nodes: {{name: ball, inside: [[-1, 0, -1], [1, 0, 1]]}}, symmetry: y}}
walls: [{{normal: [0, 0, 1]}}]
output: {{history: {{every: 1e-7}}}}
)",
                                           file));
  const HistoryTable& h = run.history;
  const double contact_modulus = young / (1 - poisson * poisson);
  // The mass of the mesh: its far side is coarse, and its facets cut 7 % off the ball.
  const double mass = -4 * h["momentum_z"][0] / speed;
  const double depth = std::pow(15 * mass * speed * speed / (16 * contact_modulus * std::sqrt(radius)), 0.4);
  const double force = 4.0 / 3 * contact_modulus * std::sqrt(radius) * std::pow(depth, 1.5);
  const double time = 2.9433 * depth / speed;
  ASSERT_GT(std::sqrt(radius * depth) / 0.125e-3, 5);  // elements across the contact radius

  double first = 0, last = 0;
  for (std::size_t i = 0; i < h.rows(); ++i) {
    if (h["contacts"][i] == 0) continue;
    if (first == 0) first = h["time"][i];
    last = h["time"][i];
  }
  // Hertz's half-space is the limit of a small contact radius a: the ball of finite size is stiffer by some a / R = 6.5
  // % of a half, which shortens the contact by 1.7 % and raises the force by 2.3 % on any finer mesh.
  EXPECT_NEAR(last - first, time, 0.03 * time);
  EXPECT_NEAR(4 * h.largest("wall_force_z"), force, 0.05 * force);
  EXPECT_GT(h.last("momentum_z"), 0.97 * -h["momentum_z"][0]);  // vibration keeps some (Hunter 1957: 1 %)
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

}  // namespace percuss::test
