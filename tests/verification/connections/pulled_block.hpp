#pragma once
// Two elements that a connection holds together while a load pulls.

#include <fmt/format.h>

#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {

/// Two elements one above the other. The lower one is held, and the lower face of the upper one is connected to it and
/// pulled: it cannot move, so that each of its four nodes passes on the force of its load at n, to round-off. A third
/// element moves, so that errors of momentum are compared with something. connection: a line of the deck; load: of a
/// node.
inline std::string make_pulled_block(const std::string& connection, const std::string& load) {
  return fmt::format(R"yaml(
time: {{end: 1e-4, max_step: 1e-6}}
parts:
  low: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, material: steel}}
  high: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, at: [0, 0, 0.01], material: steel}}
  flyer: {{box: {{size: [0.01, 0.01, 0.01], cells: [1, 1, 1]}}, at: [0, 1, 0], material: steel}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
{}
conditions: [{{nodes: low, fixed: [x, y, z]}}]
initial: [{{part: flyer, velocity: [0, 0, 1]}}]
loads: {{nodal: [{{nodes: high/z_min, force: {}}}]}}
output: {{history: {{every: 0, forces: [{{name: held, support: low}}]}}}}
)yaml",
                     connection, load);
}

/// Row in which this count of failures is above 0 first; as many as there are rows: none.
inline std::size_t find_failure(const HistoryTable& history, const char* count) {
  std::size_t row = 0;
  while (row < history.rows() && history[count][row] == 0) ++row;
  return row;
}

}  // namespace percuss::test
