// Laminates of shells: classical laminate theory, transverse shear of a sandwich, energy of cracks on several meshes,
// perforation on ranks and over a restart.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::laminate_test {
namespace {

struct Ply {
  double thickness, angle;
};
using Plies = std::vector<Ply>;

constexpr double e1 = 140e3, e2 = 10e3, nu12 = 0.3, g12 = 5e3;
constexpr double length = 4, width = 2;

const std::string carbon =
    "model: orthotropic, density: 1.6e-9, moduli: [140e3, 10e3, 10e3], poissons_ratios: [0.3, 0.4, 0.3], shear_moduli: "
    "[5e3, 3.5e3, 5e3]";

std::string list_plies(const Plies& plies) {
  std::string text;
  for (const Ply& ply : plies)
    text += fmt::format("{}{{thickness: {}, angle: {}}}", text.empty() ? "" : ", ", ply.thickness, ply.angle);
  return text;
}

/// Strains and curvatures xx, yy, 2 xy of a laminate under the force per width along x (Jones, chapter 4).
std::array<double, 6> pull_in_theory(const Plies& plies, double force) {
  double abd[6][7] = {}, bottom = 0;
  for (const Ply& ply : plies) bottom -= 0.5 * ply.thickness;
  for (const Ply& ply : plies) {
    const double angle = ply.angle * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const double over = 1 / (1 - nu12 * nu12 * e2 / e1), q11 = e1 * over, q22 = e2 * over, q12 = nu12 * q22, q66 = g12;
    const double cc = c * c, ss = s * s, mixed = q12 + 2 * q66;
    const double q[3][3] = {{q11 * cc * cc + 2 * mixed * cc * ss + q22 * ss * ss,
                             (q11 + q22 - 4 * q66) * cc * ss + q12 * (cc * cc + ss * ss),
                             (q11 - q12 - 2 * q66) * s * c * cc + (q12 - q22 + 2 * q66) * s * ss * c},
                            {(q11 + q22 - 4 * q66) * cc * ss + q12 * (cc * cc + ss * ss),
                             q11 * ss * ss + 2 * mixed * cc * ss + q22 * cc * cc,
                             (q11 - q12 - 2 * q66) * s * ss * c + (q12 - q22 + 2 * q66) * s * c * cc},
                            {(q11 - q12 - 2 * q66) * s * c * cc + (q12 - q22 + 2 * q66) * s * ss * c,
                             (q11 - q12 - 2 * q66) * s * ss * c + (q12 - q22 + 2 * q66) * s * c * cc,
                             (q11 + q22 - 2 * q12 - 2 * q66) * cc * ss + q66 * (cc * cc + ss * ss)}};
    const double top = bottom + ply.thickness;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        abd[i][j] += q[i][j] * (top - bottom);
        abd[i][j + 3] += q[i][j] * (top * top - bottom * bottom) / 2;
        abd[i + 3][j] += q[i][j] * (top * top - bottom * bottom) / 2;
        abd[i + 3][j + 3] += q[i][j] * (top * top * top - bottom * bottom * bottom) / 3;
      }
    }
    bottom = top;
  }
  abd[0][6] = force;
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < 6; ++i) {
      if (i == k) continue;
      const double factor = abd[i][k] / abd[k][k];
      for (int j = k; j < 7; ++j) abd[i][j] -= factor * abd[k][j];
    }
  std::array<double, 6> strain{};
  for (std::size_t k = 0; k < 6; ++k) strain[k] = abd[k][6] / abd[k][k];
  return strain;
}

std::string select_corner(double x, double y) {
  return fmt::format("{{name: s, inside: [[{}, {}, -1], [{}, {}, 1]]}}", x - 0.01, y - 0.01, x + 0.01, y + 0.01);
}

/// A strip under a force along x, at rest.
HistoryTable pull_strip(const Plies& plies, double force, const std::string& axes = "") {
  std::string loads;
  const double half = 0.5 * force;
  for (const auto& [x, y, f] : {std::array{0.0, width, -half}, {length, 0.0, half}, {length, width, half}})
    loads += fmt::format("{}{{nodes: {}, force: {{x: {}}}}}", loads.empty() ? "" : ", ", select_corner(x, y), f);
  return run_deck(fmt::format(R"(
title: a laminate under a force
time: {{end: 1e-7}}
materials: {{ply: {{{}{}}}}}
parts: {{s: {{shell_plate: {{size: [{}, {}], cells: [4, 1]}}, material: ply, plies: [{}]}}}}
conditions: [{{nodes: {}, fixed: [x, y, z, rx, ry, rz]}}]
loads: {{nodal: [{}]}}
start: {{relaxation: {{tolerance: 1e-12, max_steps: 400000}}}}
output: {{history: {{every: 1e-7, nodes: [{{name: a, near: [{}, 0, 0]}}, {{name: b, near: [{}, {}, 0]}}, {{name: c, near: [0, {}, 0]}}]}}}}
)",
                              carbon, axes, length, width, list_plies(plies), select_corner(0, 0), loads, length,
                              length, width, width))
      .history;
}

void expect_theory(const Plies& plies, const HistoryTable& history, double force) {
  const std::array<double, 6> e = pull_in_theory(plies, force / width);
  const auto near = [&](const char* column, double start, double exact, double scale) {
    EXPECT_NEAR(history[column][0] - start, exact, 2e-5 * scale) << column;
  };
  near("a_x", length, e[0] * length, e[0] * length);
  near("c_y", width, e[1] * width, e[0] * width);
  const double shear = history["c_x"][0] / width + history["a_y"][0] / length;
  EXPECT_NEAR(shear, e[2], 2e-5 * e[0]);
  const auto deflect = [&](double x, double y) { return -(e[3] * x * x + e[4] * y * y + e[5] * x * y) / 2; };
  const double scale = std::abs(deflect(length, 0)) + std::abs(deflect(length, width)) + 1e-9 * length;
  near("a_z", 0, deflect(length, 0), scale);
  near("b_z", 0, deflect(length, width), scale);
  near("c_z", 0, deflect(0, width), scale);
}

}  // namespace

TEST(Laminate, AnswersAsLaminateTheorySays) {
  // One ply off its axis, a symmetric one, and two that bend and twist under a force in their plane.
  const Plies cases[] = {{{0.5, 30}},
                         {{0.25, 45}, {0.25, -45}, {0.25, -45}, {0.25, 45}},
                         {{0.75, 0}, {0.75, 90}},
                         {{0.4, 0}, {0.6, 30}, {0.3, -45}, {0.4, 90}}};
  for (const Plies& plies : cases) expect_theory(plies, pull_strip(plies, 1e-3), 1e-3);
}

TEST(Laminate, TheReferenceAxisIsThatOfSpaceOrOfTheElements) {
  const Plies plies{{0.4, 0}, {0.6, 30}, {0.3, -45}, {0.4, 90}};
  const double turn = std::numbers::pi / 6;  // the same laminate with its axes turned by 30 degrees
  const Plies turned{{0.4, -30}, {0.6, 0}, {0.3, -75}, {0.4, 60}};
  expect_theory(
      plies, pull_strip(turned, 1e-3, fmt::format(", first_axis: [{}, {}, 5]", 3 * std::cos(turn), 3 * std::sin(turn))),
      1e-3);
  expect_theory(plies, pull_strip(plies, 1e-3, ", first_axis: [0, 1, 0], axes: elements"), 1e-3);
}

TEST(Laminate, ASandwichDeflectsByTheShearOfItsCore) {
  // A cantilever: P L^3 / 3 D + P L / K, with D and K of layers in cylindrical bending without Poisson's effect.
  constexpr double face = 0.5, core = 9, face_modulus = 70e3, core_modulus = 100, core_shear = 40, span = 200, load = 1;
  const HistoryTable history =
      run_deck(fmt::format(R"(
title: a sandwich
time: {{end: 1e-6}}
materials:
  metal: {{model: elastic, density: 2.7e-9, youngs_modulus: {0}, poissons_ratio: 0}}
  foam: {{model: orthotropic, density: 1e-10, moduli: [{1}, {1}, {1}], poissons_ratios: [0, 0, 0], shear_moduli: [{2}, {2}, {2}]}}
parts: {{s: {{shell_plate: {{size: [{3}, 20], cells: [40, 1]}}, material: metal, plies: [{{thickness: {4}}}, {{thickness: {5}, material: foam}}, {{thickness: {4}}}]}}}}
conditions: [{{nodes: s/x_min, fixed: [x, y, z, rx, ry, rz]}}, {{nodes: s, fixed: [y, rx, rz]}}]
loads: {{nodal: [{{nodes: s/x_max, force: {{z: {6}}}}}]}}
start: {{relaxation: {{tolerance: 1e-9, max_steps: 400000}}}}
output: {{history: {{every: 1e-6, nodes: [{{name: tip, near: [{3}, 0, 0]}}]}}}}
)",
                           face_modulus, core_modulus, core_shear, span, face, core, 0.5 * load))
          .history;
  const double half = 0.5 * core, outer = half + face;
  const double of_faces = 2.0 / 3 * face_modulus * (outer * outer * outer - half * half * half);
  const double bending = 20 * (of_faces + core_modulus * core * core * core / 12);
  // First moment of E beyond z about the middle: a + b (1 - (z / half)^2) in the core.
  const double a = face_modulus * face * (half + 0.5 * face), b = 0.5 * core_modulus * half * half;
  double flexibility = core * (a * a + 4.0 / 3 * a * b + 8.0 / 15 * b * b) / core_shear;
  for (int i = 0; i < 1000; ++i) {
    const double z = half + (i + 0.5) * face / 1000, moment = 0.5 * face_modulus * (outer * outer - z * z);
    flexibility += 2 * moment * moment / (0.5 * face_modulus) * face / 1000;
  }
  const double stiffness = (bending / 20) * (bending / 20) / flexibility;
  const double exact = load * std::pow(span, 3) / (3 * bending) + load * span / (20 * stiffness);
  fmt::print("sandwich: {:.6f} of {:.6f}, {:.3f} of it by shear\n", history.last("tip_z"), exact,
             load * span / (20 * stiffness) / exact);
  EXPECT_NEAR(history.last("tip_z"), exact, 2e-3 * exact);
}

TEST(Laminate, ALawOfMetalIsTheSameAsAPly) {
  // Two plies of one metal are the shell of that metal with as many points.
  const auto bend = [](const std::string& section) {
    return run_deck(fmt::format(R"(
title: a metal bends
time: {{end: 2e-4, max_step: 1e-7}}
materials: {{m: {{model: voce_plasticity, density: 2.7e-9, youngs_modulus: 70e3, poissons_ratio: 0.3, yield_stress: 100, saturation_stress: 80, saturation_rate: 20}}}}
parts: {{s: {{shell_plate: {{size: [10, 4], cells: [5, 2]}}, material: m, {}}}}}
conditions: [{{nodes: s/x_min, fixed: [x, y, z, rx, ry, rz]}}, {{nodes: s/x_max, velocity: {{ry: 3000, z: 5000}}}}]
output: {{history: {{every: 1e-5}}}}
audit: {{max_energy_error: 10}}
)",
                                section))
        .history;
  };
  const HistoryTable plies = bend("points: 2, plies: [{thickness: 0.5}, {thickness: 0.5}]");
  const HistoryTable other = bend("points: 4, plies: [{thickness: 1}]");
  const HistoryTable whole = bend("points: 4, thickness: 1");
  EXPECT_NEAR(other.last("internal"), whole.last("internal"), 1e-6 * whole.last("internal"));
  EXPECT_NEAR(plies.last("internal"), whole.last("internal"), 0.05 * whole.last("internal"));  // other places of points
}

TEST(Laminate, WhatCannotBeIsRefused) {
  const auto expect_refused = [](const std::string& deck, const std::string& message) {
    try {
      run_deck(deck);
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  const std::string head =
      "title: t\ntime: {end: 1e-6}\nmaterials: {ply: {" + carbon +
      "}, hot: {model: johnson_cook, density: 1e-9, youngs_modulus: 70e3, poissons_ratio: 0.3, a: 100, "
      "b: 100, n: 0.5, c: 0.01, m: 1, melt_temperature: 900, specific_heat: 9e8}}\nparts: ";
  expect_refused(head +
                     "{s: {shell_plate: {size: [1, 1], cells: [1, 1]}, material: ply, plies: [{thickness: 1, material: "
                     "hot}]}}",
                 "cannot be a ply");
  expect_refused(head +
                     "{s: {shell_plate: {size: [1, 1], cells: [1, 1]}, material: ply, thickness: 1, plies: "
                     "[{thickness: 1}]}}",
                 "given beside plies");
  expect_refused(head + "{s: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: ply, plies: [{thickness: 1}]}}",
                 "only shells have a thickness");
  expect_refused(
      "title: t\ntime: {end: 1e-6}\nmaterials: {ply: {" + carbon +
          ", first_axis: [0, 0, 1]}}\nparts: {s: {shell_plate: {size: [1, 1], cells: [1, 1]}, material: ply, "
          "thickness: 1}}",
      "normal is first_axis");
  expect_refused("title: t\ntime: {end: 1e-6}\nmaterials: {ply: {" + carbon +
                     ", fibre_tension: 2000}}\nparts: {s: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: ply}}",
                 "strengths of plies");
}

TEST(Laminate, FailureOfAPlyThatDoesNothingIsTold) {
  const Outcome run =
      run_deck("title: t\ntime: {end: 1e-6}\nmaterials: {ply: {" + carbon +
               "}, weak: {model: elastic, density: 1e-9, youngs_modulus: 70e3, poissons_ratio: 0.3, "
               "failure: {principal_stress: 10}}}\nparts: {s: {shell_plate: {size: [10, 10], cells: [2, "
               "2]}, material: ply, plies: [{thickness: 1, material: weak}]}}");
  const auto& all = run.summary.warnings;
  EXPECT_TRUE(std::any_of(all.begin(), all.end(), [](const Warning& warning) {
    return warning.rule == "key_without_effect" && warning.text.find("plies.0") != std::string::npos;
  }));
}

TEST(Laminate, ACrackTakesTheSameEnergyOnAnyMesh) {
  // A strip of one ply across its fibres, a tenth weaker in one element, is pulled until it breaks there: energy times
  // width times thickness, nearly without waves.
  constexpr double crack = 0.1, thickness = 0.4, breadth = 2;
  for (const int cells : {5, 9, 15}) {
    const double side = 10.0 / cells, start = side * (cells / 2);
    const Outcome run = run_deck(fmt::format(R"(
title: a crack across a strip
time: {{end: 2e-4}}
materials:
  ply: {{{0}, first_axis: [0, 1, 0], matrix_tension: 10, shear: 80, matrix_tension_energy: {1}}}
  weak: {{{0}, first_axis: [0, 1, 0], matrix_tension: 9, shear: 80, matrix_tension_energy: {1}}}
parts:
  a: {{shell_plate: {{size: [{2}, {3}], cells: [{4}, 1]}}, material: ply, plies: [{{thickness: {5}}}]}}
  b: {{shell_plate: {{size: [{6}, {3}], cells: [1, 1]}}, at: [{2}, 0, 0], material: weak, plies: [{{thickness: {5}}}]}}
  c: {{shell_plate: {{size: [{2}, {3}], cells: [{4}, 1]}}, at: [{7}, 0, 0], material: ply, plies: [{{thickness: {5}}}]}}
join: true
conditions: [{{nodes: a/x_min, fixed: x}}, {{nodes: a, fixed: [z, rx, ry, rz]}}, {{nodes: b, fixed: [z, rx, ry, rz]}}, {{nodes: c, fixed: [z, rx, ry, rz]}}, {{nodes: c/x_max, velocity: {{x: 200}}}}]
output: {{history: {{every: 1e-6}}}}
)",
                                             carbon, crack, start, breadth, cells / 2, thickness, side, start + side));
    fmt::print("crack, {} cells: {:.4f}\n", cells, run.history.last("internal") / (crack * breadth * thickness));
    EXPECT_NEAR(run.history.last("internal"), crack * breadth * thickness, 0.01 * crack * breadth * thickness) << cells;
  }
}

}  // namespace percuss::test::laminate_test
