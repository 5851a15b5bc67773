// Fabric as whole runs: a sheet that is sheared far, one that is compressed and pulled again, and what is refused.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "src/error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::fabric_test {
namespace {

constexpr double young = 200, poisson = 0.25;

std::string write_law(const std::string& more) {
  return fmt::format(
      "model: fabric, density: 1e-3, warp_modulus: {0}, weft_modulus: {0}, shear_modulus: {1}, "
      "warp_poissons_ratio: {2}, {3}",
      young, young / (2 * (1 + poisson)), poisson, more);
}

/// A square of 1, whose upper side moves along x and y by a table of velocities.
Outcome move_side(const std::string& law, const std::string& velocity, double end) {
  return run_deck(fmt::format(R"yaml(
time: {{end: {}}}
parts: {{cloth: {{shell_plate: {{size: [1, 1], cells: [1, 1]}}, thickness: 0.1, material: m, integration: membrane}}}}
materials: {{m: {{{}}}}}
conditions: [{{nodes: cloth/y_min, fixed: [x, y, z]}}, {{nodes: cloth/y_max, fixed: [z]}}, {{nodes: cloth/y_max, velocity: {}}}]
output: {{history: {{every: 0, elements: [{{name: e, near: [0.5, 0.5, 0]}}], nodes: [{{name: n, near: [0, 1, 0]}}]}}}}
audit: {{max_energy_error: 1e-3}}
)yaml",
                              end, law, velocity));
}

}  // namespace

TEST(Fabric, ASheetThatIsShearedFarIsATensionField) {
  // Simple shear g: E = [[0, g / 2], [g / 2, g^2 / 2]]; tension E e1 along its larger principal direction;
  // sigma = F S F^T, J = 1.
  const Outcome run = move_side(write_law("no_compression: true, compression_share: 0"),
                                "{x: {table: [[0, 0], [0.5, 1], [1, 1]]}, y: 0}", 1);
  const double g = run.history.last("n_x");
  EXPECT_NEAR(g, 0.75, 0.01);
  const double e12 = 0.5 * g, e22 = 0.5 * g * g, half = 0.5 * e22, size = std::hypot(half, e12);
  const double principal = half + size, c2 = 0.5 * (1 - half / size), s2 = 1 - c2, cs = 0.5 * e12 / size;
  const double tension = young * principal;
  const double s11 = tension * c2, s22 = tension * s2, s12 = tension * cs;
  const double exact[3] = {s11 + 2 * g * s12 + g * g * s22, s22, s12 + g * s22};
  const char* const names[3] = {"e_stress_xx", "e_stress_yy", "e_stress_xy"};
  for (int k = 0; k < 3; ++k) {
    fmt::print("{}: {:.6f} of {:.6f}\n", names[k], run.history.last(names[k]), exact[k]);
    EXPECT_NEAR(run.history.last(names[k]), exact[k], 1e-9 * exact[0]);
  }
  EXPECT_NEAR(run.history.last("internal"), 0.1 * 0.5 * young * principal * principal, 1e-9 * young);
}

TEST(Fabric, ASheetIsPulledComesBackAndIsSlackWhenItIsCompressed) {
  // Along the weft by the stretch l with a width that stays: S22 = E / (1 - nu^2) (l^2 - 1) / 2.
  const std::string velocity = "{x: 0, y: {table: [[0, 0.4], [0.999, 0.4], [1, -0.4], [3, -0.4]]}}";
  const Outcome run = move_side(write_law("no_compression: true, compression_share: 1e-3"), velocity, 3);
  const double stretch = run.history.largest("n_y"), modulus = young / (1 - poisson * poisson);
  EXPECT_NEAR(run.history.largest("e_stress_yy"), stretch * stretch * modulus * 0.5 * (stretch * stretch - 1) / stretch,
              1e-2 * modulus);
  EXPECT_NEAR(stretch, 1.4, 1e-2);
  const double least = run.history.smallest("n_y");
  EXPECT_NEAR(least, 0.6, 1e-2);
  // A thousandth of what the sheet would bear.
  EXPECT_NEAR(run.history.last("e_stress_yy"), 1e-3 * least * modulus * 0.5 * (least * least - 1), 2e-5 * modulus);
  EXPECT_NEAR(run.history.at(2.0, "internal"), 0, 1e-3 * run.history.largest("internal"));
}

TEST(Fabric, WhatCannotBeIsRefused) {
  const auto expect_refused = [](const std::string& part, const std::string& law, const std::string& message) {
    try {
      run_deck(
          fmt::format("time: {{end: 1e-9}}\nparts: {{p: {{{}, material: m}}}}\nmaterials: {{m: {{{}}}}}\n", part, law));
      ADD_FAILURE() << message;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  };
  const std::string plate = "shell_plate: {size: [1, 1], cells: [1, 1]}", sheet = plate + ", thickness: 0.1";
  const std::string cloth = sheet + ", integration: membrane", box = "box: {size: [1, 1, 1], cells: [1, 1, 1]}";
  const std::string elastic = "model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3";
  expect_refused(sheet, write_law("axes: elements"), "it needs integration: membrane");
  expect_refused(box, write_law("axes: elements"), "only shells can");
  expect_refused(cloth, write_law("first_axis: [0, 0, 1]"), "normal is first_axis");
  expect_refused(cloth + ", stiffness_damping: 1e-6", write_law("axes: elements"), "cannot be damped");
  expect_refused(cloth + ", points: 3", elastic, "points has no effect");
  expect_refused(cloth + ", reference: top", elastic, "reference has no effect");
  expect_refused(box + ", integration: membrane", elastic, "membranes are shells");
}

}  // namespace percuss::test::fabric_test
