// Elastic sheets that touch flush: nothing takes their energy, and nothing gives them any.
//
// A node of a sheet carries its whole thickness. Contact that stops it takes all energy of the relative motion, however
// fine the mesh. The energy of motion and strain is that of the start, 1/2 m v^2 of the sheet that moves.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::flush_sheets_test {
namespace {

constexpr const char* materials =
    "materials: {steel: {model: elastic, density: 7.85e-9, youngs_modulus: 210e3, poissons_ratio: 0.3}}\n";

/// Kinetic, strain and hourglass energy, and that of the springs of contact, of a row of the history.
double find_energy(const HistoryTable& history, std::size_t row) {
  double sum = 0;
  for (const char* column : {"kinetic", "internal", "hourglass"}) sum += history[column][row];
  return history.has("contact_stored") ? sum + history["contact_stored"][row] : sum;
}

struct KeptEnergy {
  double least = 1, most = 1, error = 0;  // shares of that of the start
};

KeptEnergy measure(const Outcome& run) {
  const double start = find_energy(run.history, 0);
  KeptEnergy kept;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double share = find_energy(run.history, row) / start;
    kept.least = std::min(kept.least, share);
    kept.most = std::max(kept.most, share);
  }
  kept.error = std::abs(run.summary.energy.error);
  fmt::print("energy kept {:.4f} to {:.4f}, balance {:.1e}\n", kept.least, kept.most, kept.error);
  return kept;
}

void expect_kept(const Outcome& run) {
  const KeptEnergy kept = measure(run);
  EXPECT_GT(kept.least, 0.95);
  EXPECT_LT(kept.most, 1.02);
  EXPECT_LT(kept.error, 2e-3);
}

/// Two strips, held at the same ends, the upper one at 1 m/s onto the lower one.
std::string make_strips(const std::string& cells, double ratio) {
  return fmt::format(R"(
title: two strips
units: mm, t, s
time: {{end: 2e-3}}
parts:
  lower: {{shell_plate: {{size: [100, 20], cells: {0}}}, thickness: 1.0, material: steel}}
  upper: {{shell_plate: {{size: [100, 20], cells: {0}}}, thickness: {1}, at: [0, 0, {2}], material: steel}}
{3}initial: [{{part: upper, velocity: [0, 0, -1000]}}]
conditions:
  - {{nodes: lower/x_min, fixed: [x, y, z]}}
  - {{nodes: lower/x_max, fixed: [x, y, z]}}
  - {{nodes: upper/x_min, fixed: [x, y, z]}}
  - {{nodes: upper/x_max, fixed: [x, y, z]}}
contact: {{surfaces: all, friction: 0}}
output: {{history: {{every: 5e-5}}}}
)",
                     cells, ratio, 0.5 + 0.5 * ratio, materials);
}

/// Sheets of one mesh, node over node, the lowest one held, under 1 MPa that comes in 0.2 ms.
std::string make_stack(int sheets, double friction) {
  std::string parts;
  for (int s = 0; s < sheets; ++s)
    parts += fmt::format(
        "  s{0}: {{shell_plate: {{size: [20, 10], cells: [4, 2]}}, thickness: 1, at: [0, 0, {0}], material: steel}}\n",
        s);
  return fmt::format(R"(
title: a stack of sheets
units: mm, t, s
time: {{end: 2e-3}}
parts:
{0}{1}conditions: [{{nodes: s0, fixed: [x, y, z]}}]
loads: {{pressure: [{{faces: s{2}/top, value: {{table: [[0, 0], [2e-4, 1]]}}, direction: -z}}]}}
contact: {{surfaces: all, friction: {3}}}
output: {{history: {{every: 5e-5}}}}
)",
                     parts, materials, sheets - 1, friction);
}

}  // namespace

TEST(FlushSheets, KeepTheirEnergyForAnyMeshAndThickness) {
  for (const char* cells : {"[10, 2]", "[20, 4]", "[30, 6]"}) expect_kept(run_deck(make_strips(cells, 1.5)));
  for (const double ratio : {1.0, 3.0}) expect_kept(run_deck(make_strips("[20, 4]", ratio)));
}

// A solid block at 1 m/s onto two flush strips, and a strip that falls flat on a block: what contact takes. Bulk
// viscosity takes a share of the waves in the solid.
TEST(FlushSheets, GiveASolidItsEnergyBack) {
  std::string text = make_strips("[20, 4]", 1.5);
  text.replace(text.find("materials:"), 0,
               "  block: {box: {size: [20, 20, 5], cells: [4, 4, 2]}, at: [40, 0, 2], material: steel}\n");
  text.replace(text.find("part: upper, velocity"), 11, "part: block");
  const Outcome run = run_deck(text);
  EXPECT_LT(std::abs(run.summary.energy.contact), 1e-3 * run.summary.energy.initial);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  const std::string flat = R"(
units: mm, t, s
time: {end: 1e-4}
parts:
  block: {box: {size: [20, 20, 10], cells: [4, 4, 4]}, material: steel}
  sheet: {shell_plate: {size: [10, 10], cells: [3, 3]}, thickness: 1, at: [5, 5, 10.5], material: steel}
initial: [{part: sheet, velocity: [0, 0, -1000]}]
conditions: [{nodes: block/z_min, fixed: [x, y, z]}]
contact: {surfaces: all, friction: 0}
)";
  const Outcome fall = run_deck(flat + materials);
  EXPECT_LT(std::abs(fall.summary.energy.contact), 1e-2 * fall.summary.energy.initial);
  EXPECT_LT(std::abs(fall.summary.energy.error), 1e-3);
}

TEST(FlushSheets, KeepTheirEnergyOnARigidBody) {
  std::string text = make_strips("[10, 2]", 1);
  const std::string shells = "lower: {shell_plate: {size: [100, 20], cells: [10, 2]}, thickness: 1.0, material: steel}";
  text.replace(text.find(shells), shells.size(),
               "lower: {box: {size: [100, 20, 5], cells: [7, 2, 1]}, at: [0, 0, -4.5], material: steel, rigid: {}}");
  const std::string held = "  - {nodes: lower/x_min, fixed: [x, y, z]}\n  - {nodes: lower/x_max, fixed: [x, y, z]}\n";
  text.replace(text.find(held), held.size(), "");  // it is free, and moves as a whole
  expect_kept(run_deck(text));
}

// The rows of the wall are iterated, those between the sheets are springs, which the iteration does not change.
TEST(FlushSheets, ConvergeOnAWallThatRubs) {
  std::string text = make_stack(3, 0.3);
  const std::string held = "conditions: [{nodes: s0, fixed: [x, y, z]}]\n";
  text.replace(text.find(held), held.size(), "walls: [{name: floor, point: [0, 0, 0], normal: z, friction: 0.3}]\n");
  const Outcome run = run_deck(text);
  double most = 0;
  for (std::size_t row = 0; row < run.history.rows(); ++row) most = std::max(most, run.history["iterations"][row]);
  EXPECT_GT(most, 1);
  EXPECT_LT(most, 60);
}

// Springs that push along the normals of faces make such a stack flutter: its sheets bend, though they lie flat.
TEST(FlushSheets, StayFlatInAStackUnderPressure) {
  const Outcome run = run_deck(make_stack(9, 0));
  const double external = run.history.last("external");
  const double bending = run.history.largest("internal") + run.history.largest("hourglass");
  fmt::print("bending {:.3g} of {:.3g}\n", bending, external);
  EXPECT_LT(bending, 1e-3 * external);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

}  // namespace percuss::test::flush_sheets_test
