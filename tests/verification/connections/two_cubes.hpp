#pragma once
// Two cubes that do not deform where all of their nodes move alike.

#include <string>

namespace percuss::test {

inline constexpr double light = 8e-3, heavy = 24e-3;  // masses of the cubes below

/// forces: more outputs of the history. rest: sections of the deck behind these.
inline std::string make_cubes(const std::string& rest, const std::string& forces = "") {
  return R"yaml(
time: {end: 1e-4, max_step: 1e-6}
parts:
  a: {box: {size: [0.02, 0.02, 0.02], cells: [1, 1, 1]}, material: light}
  b: {box: {size: [0.02, 0.02, 0.02], cells: [1, 1, 1]}, at: [0.1, 0.05, 0.02], material: heavy}
materials:
  light: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}
  heavy: {model: elastic, density: 3000, youngs_modulus: 1e9, poissons_ratio: 0.3}
output:
  history: {every: 0, nodes: [{name: p, near: [0, 0, 0]}, {name: q, near: [0.12, 0.07, 0.04]}])yaml" +
         forces + "}\n" + rest;
}

}  // namespace percuss::test
