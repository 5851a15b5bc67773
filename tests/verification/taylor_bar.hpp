#pragma once
// The copper Taylor bar, its foot held to the plane of impact as in the reference, or free to leave a rigid wall.

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "tests/verification/run_deck.hpp"

namespace percuss::test {

/// Shape of the bar at 80 us [m].
struct TaylorShape {
  double length = 0;
  double foot_on_axes = 0;      // radius of the foot along the lattice of the core
  double foot_on_diagonal = 0;  // and along its diagonal
};

enum class TaylorFoot { held, on_wall };

/// Runs the bar with `across` elements on a diameter and five times as many along it.
inline TaylorShape run_taylor_bar(int across, TaylorFoot foot) {
  const std::string support =
      foot == TaylorFoot::held ? "conditions: [{nodes: bar/start, fixed: [z]}]" : "walls: [{normal: [0, 0, 1]}]";
  const std::string cells = "[" + std::to_string(across) + ", " + std::to_string(5 * across) + "]";
  const Outcome run = run_deck(R"(
title: Taylor bar
time: {end: 80e-6}
parts: {bar: {cylinder: {radius: 3.2e-3, length: 32.4e-3, cells: )" +
                               cells + R"(}, material: copper}}
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 400e6, hardening_modulus: 100e6}
initial: [{part: bar, velocity: [0, 0, -227]}]
)" + support + R"(
output:
  history:
    every: 1e-6
    nodes:
      - {name: top, near: [0, 0, 32.4e-3]}
      - {name: foot, near: [0, 0, 0]}
      - {name: axis, near: [3.2e-3, 0, 0]}
      - {name: diagonal, near: [2.2627417e-3, 2.2627417e-3, 0]}
)");
  const HistoryTable& h = run.history;
  const TaylorShape shape{h.last("top_z") - h.last("foot_z"), h.last("axis_x"),
                          std::hypot(h.last("diagonal_x"), h.last("diagonal_y"))};
  fmt::print("{} across: L {:.3f} mm, R {:.3f} mm on the axes, {:.3f} mm on the diagonal\n", across, 1e3 * shape.length,
             1e3 * shape.foot_on_axes, 1e3 * shape.foot_on_diagonal);
  return shape;
}

// Two independent codes on several meshes give 21.42 +- 0.01 mm and 7.225 +- 0.008 mm.
inline constexpr double taylor_length = 21.42e-3, taylor_radius = 7.225e-3;

}  // namespace percuss::test
