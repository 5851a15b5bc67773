// Beams on many ranks: every rank also holds the whole scene alone, and compares its share of the one with the other,
// bit by bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "src/error.hpp"
#include "tests/src/step/two_scenes.hpp"

namespace percuss::test {
namespace {

// Beams that yield on a plate, posts below it, trusses; a block hits the plate. Masses are scaled during the run.
const std::string frame_text = R"yaml(
time: {end: 1, mass_scaling: {step: 1.2e-6, max_added: 3, every: 5}}
parts:
  plate: {shell_plate: {size: [0.2, 0.2], cells: [10, 10]}, thickness: 2e-3, material: sheet}
  ribs: {line: {from: [0, 0, 0], to: [0.2, 0, 0], cells: 10}, array: {count: [1, 3, 1], pitch: [0, 0.1, 0]}, section: {rectangle: {size: [0.004, 0.012]}}, toward: y, material: sheet}
  posts: {line: {from: [0, 0, -0.1], to: [0, 0, 0], cells: 12}, array: {count: [2, 2, 1], pitch: [0.2, 0.2, 0]}, section: {round: {radius: 0.004}}, material: sheet}
  ties: {line: {from: [0, 0, -0.1], to: [0.2, 0, 0], cells: 1}, array: {count: [1, 2, 1], pitch: [0, 0.2, 0]}, section: {truss: {area: 1e-5}}, material: steel}
  block: {box: {size: [0.04, 0.04, 0.04], cells: [4, 4, 4]}, at: [0.07, 0.08, 0.0015], material: steel}
join: [{parts: [plate, ribs, posts, ties]}]
materials:
  sheet: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 200e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
initial: [{part: block, velocity: [5, 0, -100]}]
conditions: [{nodes: posts/start, fixed: [x, y, z, rx, ry, rz]}]
contact: {surfaces: all, friction: 0.2}
)yaml";

TEST(BeamsOnRanks, BesideShellsAndSolidsHaveTheBitsOfOneRank) {
  TwoScenes scenes(frame_text);
  expect_same_run(scenes, 20);
  EXPECT_GT(scenes.alone.stepper.contact_report().interactions, 0);
}

TEST(BeamsOnRanks, ThatFailHaveTheBitsOfOneRank) {
  std::string text = frame_text;
  text.replace(text.find("{radius: 0.004}}, material: sheet"), 33, "{radius: 0.004}}, material: weld");
  text.replace(
      text.find("  steel: {"), 10,
      "  weld: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, failure: {time: 1e-5, "
      "fade_steps: 3}}\n  steel: {");
  TwoScenes scenes(text);
  expect_same_run(scenes, 40);
  const auto left = to_host(scenes.alone.state.lives.steps_left);
  EXPECT_EQ(std::count(left.data(), left.data() + left.extent(0), 0), left.extent(0));  // all posts
}

// Without any other element, and without rotations.
TEST(BeamsOnRanks, OfTrussesAloneHaveTheBitsOfOneRank) {
  TwoScenes scenes(R"yaml(
time: {end: 1}
parts:
  a: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 40}, section: {truss: {area: 1e-4}}, material: steel}
  b: {line: {from: [0, 0, 1], to: [1, 0, 0], cells: 40}, section: {truss: {area: 1e-4}}, material: steel}
join: true
initial: [{part: a, velocity: [1, 2, 3]}]
conditions: [{nodes: b/start, fixed: [x, y, z]}]
)yaml" + steel_text);
  EXPECT_FALSE(scenes.alone.model.has_rotations);
  expect_same_run(scenes, 60);
}

TEST(BeamsOnRanks, AreRefusedWithWhatTheyDoNotHave) {
  const auto build = [](const std::string& part, const std::string& material) {
    const Scene scene("time: {end: 1}\nparts: {bar: {line: {from: [0, 0, 0], to: [1, 0, 0], cells: 9}, " + part +
                      ", material: m}}\nmaterials: {m: {" + material + "}}\n");
  };
  const std::string elastic = "model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0",
                    yielding =
                        "model: j2_plasticity, density: 1, youngs_modulus: 1, poissons_ratio: 0, yield_stress: 1, "
                        "hardening_modulus: 0",
                    round = "section: {round: {radius: 0.1}}";
  const auto expect = [&](const std::string& part, const std::string& material, const char* text) {
    EXPECT_THAT([&] { build(part, material); }, testing::ThrowsMessage<InputError>(testing::HasSubstr(text)));
  };
  build(round, elastic);
  expect(round, "model: neo_hookean, density: 1, youngs_modulus: 1, poissons_ratio: 0.3",
         "part 'bar' has beams of material 'm' (beams support elastic, j2_plasticity, power_law_plasticity");
  build(round, yielding + ", failure: {plastic_strain: 0.1}");
  for (const char* other : {"pressure: 1", "principal_strain: 0.1", "volume_above: 2"})
    expect(round, yielding + ", failure: {" + other + "}", "which fails by a criterion of other elements");
  expect(round, elastic + ", failure: {plastic_strain: 0.1}", "plastic_strain");
  expect("section: {general: {area: 1, inertia_y: 1, inertia_z: 1, torsion: 1, shear_area_y: 1, shear_area_z: 1}}",
         yielding, "with a general section of a material that yields");
  expect("section: {rectangle: {size: [1, 2]}}, toward: x", elastic,
         "toward of part 'bar' lies along element 1 of part 'bar'");
}

}  // namespace
}  // namespace percuss::test
