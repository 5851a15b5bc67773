#pragma once
// A square tube with a trigger, crushed by a sled to 30 % of its length, and the mean force of theory.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::square_tube {

inline constexpr double width = 0.06, thickness = 0.0015, length = 0.12, flow_stress = 300e6;

/// 52.22 (c/t)^(1/3) M0, static; the law has no rate effects. What share of a fold is crushed and the first fold leave
/// some 15 % open.
inline const double expected_force = 52.22 * std::cbrt(width / thickness) * flow_stress * thickness * thickness / 4;

/// Perfectly plastic, so that there is one flow stress; the trigger is half a fold, two walls in and two out. cells:
/// across a wall.
inline Outcome crush(int cells, const std::string& scaling) {
  return run_deck(fmt::format(R"yaml(
title: a square tube that folds
units: m, kg, s
time: {{end: 9.2e-3}}
parts:
  tube: {{shell_box_tube: {{size: [0.06, 0.06], length: 0.12, cells: [{0}, {0}, {1}]}}, thickness: 0.0015, material: steel{2}}}
  sled: {{box: {{size: [0.12, 0.12, 0.05], cells: [4, 4, 2]}}, at: [-0.06, -0.06, 0.1208], material: stiff}}
materials:
  steel: {{model: j2_plasticity, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3, yield_stress: 300e6, hardening_modulus: 0}}
  stiff: {{model: elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3}}
added_mass: [{{nodes: sled, mass: 294.348}}]
imperfections:
  - {{nodes: tube, mode: "0.5e-3 * (abs(x) >= abs(y) ? cos(pi * y / 0.06) : -cos(pi * x / 0.06)) * sin(pi * (z - 0.085) / 0.035) * step(z - 0.085)"}}
initial: [{{part: sled, velocity: [0, 0, -10]}}]
conditions: [{{nodes: sled, velocity: {{x: 0, y: 0}}}}]
walls: [{{normal: z, friction: 0.2}}]
contact: {{surfaces: all, friction: 0.2}}
output: {{history: {{every: 2.0e-5, nodes: [{{name: sled, part: sled, near: [0, 0, 0.1708]}}]}}}}
)yaml",
                              cells, 2 * cells, scaling));
}

/// Energy that the sled has given when it has come so far.
inline double find_given(const HistoryTable& history, double way) {
  const std::vector<double>&z = history["sled_z"], &kinetic = history["kinetic"];
  std::size_t i = 1;
  while (i + 1 < z.size() && z[0] - z[i] - 0.0008 < way) ++i;
  const double before = z[0] - z[i - 1] - 0.0008, after = z[0] - z[i] - 0.0008;
  return kinetic[0] - kinetic[i - 1] - (way - before) / (after - before) * (kinetic[i] - kinetic[i - 1]);
}

inline double find_mean_force(const HistoryTable& history) {
  return (find_given(history, 0.7 * length) - find_given(history, 0.08 * length)) / (0.62 * length);
}

inline void expect_sound(const Outcome& run) {
  EXPECT_GT(run.history["sled_z"].front() - run.history.last("sled_z"), 0.7 * length);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-5);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

}  // namespace percuss::test::square_tube
