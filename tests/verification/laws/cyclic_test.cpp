// Bars of one cell that are pulled and pressed until their loop repeats, and cubes with voids that are pulled alike in
// all directions, in every kind of element, against closed forms.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::cyclic_test {
namespace {

struct Body {
  const char* name;
  const char* part;
};

const Body bodies[] = {
    {"one point", "box: {size: [1, 1, 1], cells: [1, 1, 1]}"},
    {"full", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, integration: full"},
    {"tetrahedra", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: tetrahedra"},
    {"wedges", "box: {size: [1, 1, 1], cells: [1, 1, 1]}, elements: wedges"},
    {"shells", "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1"},
};

/// Ten loops of 1 % each way, slow beside sound.
Outcome cycle(const Body& body) {
  return run_deck(fmt::format(
      R"yaml(
title: loops of a bar
time: {{end: 10}}
parts: {{bar: {{{0}, material: steel}}}}
materials: {{steel: {{model: chaboche, density: 1e5, youngs_modulus: 210e9, poissons_ratio: 0.3, yield_stress: 200e6, back_stresses: [[40, 4e9], [500, 60e9]], cyclic_stress: 80e6, cyclic_rate: 25}}}}
conditions:
  - {{nodes: bar/x_min, symmetry: x}}
  - {{nodes: bar/y_min, symmetry: y}}
  - {{nodes: {{inside: [[0, 0, 0], [1, 1, 0]]}}, fixed: [z]}}
  - {{nodes: bar/x_max, displacement: {{x: {{expression: "0.01 * sin(2 * pi * t)"}}}}}}
damping: [{{coefficient: 20}}]
output: {{history: {{every: 0.005, elements: [{{name: m, near: [0.5, 0.5, 0.5]}}]}}}}
)yaml",
      body.part));
}

/// Largest stress of the last loop, and the plastic strain of half of it.
struct Loop {
  double stress = 0, strain = 0;
};

Loop find_last_loop(const HistoryTable& h) {
  const std::vector<double>&t = h["time"], &s = h["m_stress_xx"], &p = h["m_eps"];
  Loop loop;
  double first = -1;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] < 9 - 1e-9) continue;
    if (first < 0) first = p[i];
    loop.stress = std::max(loop.stress, std::abs(s[i]));
    loop.strain = 0.5 * (p[i] - first);
  }
  return loop;
}

TEST(Chaboche, LoopThatRepeatsHasItsClosedForm) {
  for (const Body& body : bodies) {
    const HistoryTable h = cycle(body).history;
    const Loop loop = find_last_loop(h);
    const double p = h.last("m_eps"), size = 200e6 + 80e6 * (1 - std::exp(-25 * p));
    const double right =
        size + 4e9 / 40 * std::tanh(0.5 * 40 * loop.strain) + 60e9 / 500 * std::tanh(0.5 * 500 * loop.strain);
    fmt::print("{}: {:.5g} MPa, closed form {:.5g} MPa, p of half a loop {:.5g}\n", body.name, 1e-6 * loop.stress,
               1e-6 * right, loop.strain);
    EXPECT_GT(loop.strain, 0.014) << body.name;
    EXPECT_NEAR(loop.stress, right, 1e-3 * right) << body.name;
  }
}

constexpr double yield = 300e6;

TEST(Gurson, PulledAlikeInAllDirectionsHasItsClosedForm) {
  for (const Body& body : {bodies[0], bodies[1], bodies[2], bodies[3]}) {
    const Outcome run = run_deck(fmt::format(
        R"yaml(
title: voids that grow
time: {{end: 1}}
parts: {{cube: {{{0}, material: metal}}}}
materials: {{metal: {{model: gurson, density: 1e5, youngs_modulus: 210e9, poissons_ratio: 0.3, hardening: [[0, 300e6]], void_fraction: 0.01}}}}
conditions:
  - {{nodes: cube/x_min, symmetry: x}}
  - {{nodes: cube/y_min, symmetry: y}}
  - {{nodes: cube/z_min, symmetry: z}}
  - {{nodes: cube/x_max, displacement: {{x: {{expression: "0.02 * t"}}}}}}
  - {{nodes: cube/y_max, displacement: {{y: {{expression: "0.02 * t"}}}}}}
  - {{nodes: cube/z_max, displacement: {{z: {{expression: "0.02 * t"}}}}}}
damping: [{{coefficient: 20}}]
output: {{history: {{every: 0.01, elements: [{{name: m, near: [0.5, 0.5, 0.5]}}]}}}}
)yaml",
        body.part));
    const double f = run.history.last("m_void_fraction"), mean = -run.history.last("m_pressure");
    const double right = 2 * yield / 3 * std::acosh((1 + 2.25 * f * f) / (3 * f));
    const double voids = 1 - 0.99 * std::exp(-(3 * std::log(1.02) - right / 175e9));
    fmt::print("{}: {:.5g} MPa, closed form {:.5g} MPa, voids {:.5g}, {:.5g}\n", body.name, 1e-6 * mean, 1e-6 * right,
               f, voids);
    EXPECT_NEAR(mean, right, 1e-3 * right) << body.name;
    EXPECT_NEAR(f, voids, 1e-3 * voids) << body.name;
  }
}

}  // namespace
}  // namespace percuss::test::cyclic_test
