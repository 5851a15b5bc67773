// Shells of three and four nodes on many ranks: every rank also holds the whole scene alone, and compares its share of
// the one with the other, bit by bit.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "comm/agreement.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/two_scenes.hpp"
#include "tests/verification/support/mapped_shell.hpp"

namespace percuss::test {
namespace {

/// The file of a sheet of 18 x 14 cells in the plane, every other cell of two triangles, written by one rank for all.
class SheetFile {
 public:
  explicit SheetFile(const std::string& name) {
    auto mesh = make_mapped_shell({18, 14}, [](double u, double v) { return Vec3{0.09 * u, 0.07 * v, 0}; });
    halve(18, Halving::every_other, mesh);
    if (world_.rank() == 0) path_ = testing_mesh::write_exodus(mesh, name);
    path_ = broadcast_text(world_, path_, 0);
  }
  SheetFile(const SheetFile&) = delete;
  SheetFile& operator=(const SheetFile&) = delete;
  ~SheetFile() {
    world_.barrier();
    if (world_.rank() == 0) std::remove(path_.c_str());
  }

  /// The deck with the path in the place of its {0}.
  std::string put_into(const char* deck) const { return fmt::format(fmt::runtime(deck), path_); }

 private:
  Communicator world_ = Communicator::world();
  std::string path_;
};

/// Takes steps and compares; returns the interactions of the last.
std::int64_t step_and_compare(TwoScenes& scenes, int steps) {
  scenes.run(0);
  for (int i = 0; i < steps; ++i) {
    scenes.together.stepper.advance(scenes.together.state);
    scenes.alone.stepper.advance(scenes.alone.state);
  }
  expect_same_rows(scenes, scenes.together.state.x, scenes.alone.state.x, "position");
  expect_same_rows(scenes, scenes.together.state.v, scenes.alone.state.v, "velocity");
  expect_same_rows(scenes, scenes.together.state.w, scenes.alone.state.w, "angular velocity");
  EXPECT_EQ(hash_state(scenes.together.model, scenes.together.state),
            hash_state(scenes.alone.model, scenes.alone.state));
  return scenes.alone.stepper.contact_report().interactions;
}

TEST(ShellsOnRanks, OfTrianglesAndQuadrilateralsThatTouchHaveTheBitsOfOneRank) {
  const SheetFile sheet("triangles_on_ranks.exo");
  TwoScenes scenes(sheet.put_into(R"yaml(
time: {{end: 1}}
parts:
  low: {{exodus: {{file: {0}}}, thickness: 0.002, material: steel}}
  high: {{exodus: {{file: {0}}}, thickness: 0.001, at: [0.011, 0.007, 0.00155], material: copper}}
materials:
  copper: {{model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}}
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {{pressure: [{{faces: low/top, value: 1e6}}]}}
initial: [{{part: high, velocity: [3, 0, -50]}}]
contact: {{surfaces: all, friction: 0.2, enforcement: kinematic}}
)yaml"));
  EXPECT_GT(step_and_compare(scenes, 40), 0);
}

TEST(ShellsOnRanks, WithMassScalingInTheRunHaveTheBitsOfOneRank) {
  const SheetFile sheet("scaled_shells_on_ranks.exo");
  TwoScenes scenes(sheet.put_into(R"yaml(
time: {{end: 1, mass_scaling: {{step: 6.2e-7, max_added: 9, every: 2}}}}
parts:
  sheet: {{exodus: {{file: {0}}}, thickness: 0.002, axis: y, at: [0, 0, 0.0901], material: steel}}
  block: {{box: {{size: [0.02, 0.02, 0.02], cells: [6, 6, 6]}}, at: [0.1, 0.1, 0.0001], material: steel}}
materials:
  steel: {{model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
initial: [{{velocity: [0, 1, -200]}}]
loads: {{gravity: [0, 0, -1e5]}}
walls: [{{normal: z}}]
)yaml"));
  step_and_compare(scenes, 80);
  EXPECT_GT(scenes.alone.state.books.added_mass, 0);
  EXPECT_EQ(scenes.together.state.books.added_mass, scenes.alone.state.books.added_mass);
  EXPECT_EQ(scenes.together.state.total_mass, scenes.alone.state.total_mass);
}

TEST(ShellsOnRanks, WithImperfectionsAddedMassAndThicknessAtWallsHaveTheBitsOfOneRank) {
  const SheetFile sheet("imperfect_shells_on_ranks.exo");
  TwoScenes scenes(sheet.put_into(R"yaml(
time: {{end: 1}}
parts:
  sheet: {{exodus: {{file: {0}}}, thickness: 0.002, at: [0, 0, 0.0011], material: steel}}
  block: {{box: {{size: [0.02, 0.02, 0.02], cells: [6, 6, 6]}}, at: [0.1, 0.1, 0.0001], material: steel}}
materials:
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
imperfections:
  - {{nodes: sheet, mode: "1e-4 * sin(50 * x) * cos(30 * y)"}}
  - {{nodes: sheet, noise: {{amplitude: 5e-5, length: 0.01, seed: 4}}}}
  - {{nodes: block, noise: {{amplitude: 1e-5}}, direction: [1, 1, 1]}}
added_mass: [{{nodes: sheet, mass: 0.1, spread: evenly}}, {{nodes: block/z_max, mass: 2}}]
initial: [{{velocity: [0, 1, -20]}}]
walls: [{{normal: z, thickness: included}}]
)yaml"));
  step_and_compare(scenes, 60);
  EXPECT_EQ(scenes.together.state.total_mass, scenes.alone.state.total_mass);
  EXPECT_EQ(scenes.together.chunked.mesh.notes, scenes.alone.chunked.mesh.notes);
  EXPECT_EQ(scenes.together.model.mass_notes, scenes.alone.model.mass_notes);
}

TEST(ShellsOnRanks, OfTiesHaveTheBitsOfOneRank) {
  // On triangles and quadrilaterals a sheet; below them a block, whose nodes they hold; an upright sheet; a weight on
  // top.
  const SheetFile sheet("tied_shells_on_ranks.exo");
  TwoScenes scenes(sheet.put_into(R"yaml(
time: {{end: 1}}
parts:
  low: {{exodus: {{file: {0}}}, thickness: 0.002, material: steel}}
  high: {{shell_plate: {{size: [0.08, 0.05], cells: [16, 9]}}, thickness: 0.001, at: [0.004, 0.007, 0.0015], material: copper}}
  block: {{box: {{size: [0.07, 0.06, 0.02], cells: [8, 7, 3]}}, at: [0.011, 0.003, -0.0211], material: steel}}
  upright: {{shell_plate: {{size: [0.05, 0.04], cells: [9, 8]}}, rotate: [{{axis: x, angle: 90}}], thickness: 0.001, at: [0.02, 0.03, 0.002], material: steel}}
  weight: {{box: {{size: [0.01, 0.01, 0.01], cells: [3, 3, 3]}}, at: [0.01, 0.04, 0.00205], material: steel}}
materials:
  copper: {{model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}}
  steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {{pressure: [{{faces: low/top, value: 1e6}}]}}
initial: [{{part: weight, velocity: [3, 0, -50]}}, {{part: block, velocity: [0, 2, 1]}}]
contact:
  friction: 0.2
  ties: [{{a: high, b: low}}, {{a: block/z_max, b: low, distance: 2e-4}}, {{a: upright/y_min, b: high}}]
)yaml"));
  EXPECT_GT(step_and_compare(scenes, 30), 17 * 10 + 9 * 8 + 10);  // all tied nodes, and contact
}

}  // namespace
}  // namespace percuss::test
