#pragma once
// A tank of water, 1 m long and 0.5 m deep, one element across: decks, and what a wave in it is.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {

inline constexpr double tank_length = 1, tank_depth = 0.5, gravity = 9.81;
/// Angular frequency of the first sloshing mode of water without viscosity, sqrt(g k tanh(k h)).
inline const double sloshing = std::sqrt(gravity * std::numbers::pi * std::tanh(std::numbers::pi * tank_depth));
inline const double sloshing_period = 2 * std::numbers::pi / sloshing;

struct Tank {
  std::string shape = "box: {size: [1, 0.05, 0.5], cells: [20, 1, 10]}";
  double bulk_modulus = 4e6;  // a five hundredth of water's: the waves of 0.5 m are as fast to 1e-3
  double push = 0;            // largest acceleration along the tank, half a sine over the first half period
  double periods = 1;
  std::string more;  // of the deck: elements
  std::string start = "relaxation: {max_steps: 30000, unsettled: warn}";
};

/// At rest at first; walls hold the water across themselves. History: the surface at both ends.
inline std::string make_tank(const Tank& tank) {
  return fmt::format(R"(
title: a tank of water
time: {{end: {end:.17g}, collapse_ratio: 0.02}}
parts: {{w: {{{shape}, material: water}}}}
materials: {{water: {{model: fluid, density: 1000, equation_of_state: {{kind: linear, bulk_modulus: {modulus}}}}}}}
conditions:
  - {{nodes: {{name: w, inside: [[-1, -1, -1], [1e-6, 2, 2]]}}, fixed: [x]}}
  - {{nodes: {{name: w, inside: [[0.999999, -1, -1], [2, 2, 2]]}}, fixed: [x]}}
  - {{nodes: {{name: w, inside: [[-1, -1, -1], [2, 1e-6, 2]]}}, fixed: [y]}}
  - {{nodes: {{name: w, inside: [[-1, 0.049999, -1], [2, 2, 2]]}}, fixed: [y]}}
  - {{nodes: {{name: w, inside: [[-1, -1, -1], [2, 2, 1e-6]]}}, fixed: [z]}}
loads: {{gravity: [{{expression: "(t < {half:.17g}) ? {push:.17g} * sin({rate:.17g} * t) : 0"}}, 0, {g}]}}
start: {{{start}}}
{more}
output:
  history:
    every: {every:.17g}
    nodes: [{{name: left, near: [0, 0, 0.5]}}, {{name: right, near: [1, 0, 0.5]}}]
)",
                     fmt::arg("end", tank.periods * sloshing_period), fmt::arg("shape", tank.shape),
                     fmt::arg("modulus", tank.bulk_modulus), fmt::arg("half", 0.5 * sloshing_period),
                     fmt::arg("push", tank.push), fmt::arg("rate", sloshing), fmt::arg("g", -gravity),
                     fmt::arg("start", tank.start), fmt::arg("more", tank.more),
                     fmt::arg("every", sloshing_period / 100));
}

/// Largest of a column within a period, counted from 0.
inline double find_largest(const HistoryTable& history, const std::string& column, double period) {
  double largest = 0;
  for (std::size_t row = 0; row < history.rows(); ++row) {
    const double at = history["time"][row] / sloshing_period;
    if (at >= period && at < period + 1) largest = std::max(largest, std::abs(history[column][row]));
  }
  return largest;
}

/// Frequency of the difference of both surfaces over what it is to be, from where it rises through its mean after the
/// first period.
inline double find_frequency_ratio(const HistoryTable& history) {
  const auto height = [&](std::size_t row) { return history["left_z"][row] - history["right_z"][row]; };
  double first = 0, last = 0;
  int rises = -1;
  for (std::size_t row = 1; row < history.rows(); ++row) {
    const double before = height(row - 1), now = height(row), time = history["time"][row];
    if (time < sloshing_period || !(before < 0 && now >= 0)) continue;
    last = time - (time - history["time"][row - 1]) * now / (now - before);
    if (rises < 0) first = last;
    ++rises;
  }
  return rises < 1 ? 0 : rises * sloshing_period / (last - first);
}

}  // namespace percuss::test
