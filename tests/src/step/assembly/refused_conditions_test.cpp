// Conditions and selections that are refused when the model is built, with the place of the deck, on every rank.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

/// A block of hexahedra and a plate of shells.
const std::string text = R"yaml(
time: {end: 1}
parts:
  block: {box: {size: [9, 3, 3], cells: [9, 3, 3]}, material: m}
  plate: {shell_plate: {size: [2, 2], cells: [2, 2]}, thickness: 0.1, at: [0, 0, 9], material: m}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
)yaml";

/// What building the scene says with one more condition, on every rank.
std::string take_error(const std::string& condition) {
  try {
    const Scene scene(text + "conditions: [" + condition + "]\n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HeldRotations, AreRefusedWhereNoNodeHasOne) {
  for (const char* motion : {"fixed: [x, ry]", "velocity: {ry: 3}"}) {
    EXPECT_THAT(take_error(std::string("{nodes: block/x_min, ") + motion + "}"),
                HasSubstr("deck.yaml:7:22: error: ry has no effect here (only nodes of shells, beams and rigid"));
    EXPECT_EQ(take_error(std::string("{nodes: plate/x_min, ") + motion + "}"), "");
    EXPECT_EQ(take_error(std::string("{nodes: all, ") + motion + "}"), "");  // some have
  }
  EXPECT_EQ(take_error("{nodes: block/x_min, symmetry: x}"), "");
}

/// What building the scene says if its material is another, on every rank.
std::string take_material_error(const std::string& model) {
  try {
    const std::string elastic = "model: elastic";
    std::string other = text;
    const Scene scene(other.replace(other.find(elastic), elastic.size(), model));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ShellsOfAMaterial, AreRefusedWhereItHasNoLayer) {
  EXPECT_THAT(
      take_material_error("model: neo_hookean"),
      HasSubstr("error: part 'plate' has shells of material 'm' (shells support elastic, j2_plasticity, power_law"));
  for (const char* known : {"j2_plasticity, yield_stress: 1",
                            "power_law_plasticity, yield_stress: 1, "
                            "hardening_coefficient: 1, hardening_exponent: 0.5",
                            "combined_hardening, yield_stress: 1, kinematic_share: 0.5",
                            "johnson_cook, a: 1, b: 1, n: 1, melt_temperature: 1000, specific_heat: 1"}) {
    EXPECT_EQ(take_material_error(std::string("model: ") + known), "") << known;
  }
}

/// Error of building the scene with a pressure, on every rank.
std::string take_pressure_error(const std::string& pressure) {
  try {
    const Scene scene(text + "loads: {pressure: [" + pressure + "]}\n");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Pressures, OnBothSidesOfShellsAreRefusedWithTheNamesOfTheSides) {
  EXPECT_EQ(take_pressure_error("{faces: plate, value: 1}"),
            "deck.yaml:7:28: error: the pressure acts on both sides of the shells of part 'plate' (on which it "
            "cancels): name one side: plate/bottom, plate/top");
  EXPECT_THAT(take_pressure_error("{faces: {inside: [[0, 0, 8], [1, 1, 10]]}, value: 1}"),
              HasSubstr("both sides of the shells of part 'plate'"));
  EXPECT_THAT(take_pressure_error("{faces: all, value: 1, direction: z}"), HasSubstr("count them twice"));
  for (const char* side : {"plate/top", "plate/bottom", "block", "block/x_min"})
    EXPECT_EQ(take_pressure_error(std::string("{faces: ") + side + ", value: 1}"), "");
}

TEST(Selections, OfASettingAreRefusedByItsKey) {
  const Deck deck = parse_deck(text + "conditions: [{nodes: block, fixed: x}]\n", "deck.yaml",
                               {"time.end=2", "conditions.0.nodes={name: block, inside: [[50, 0, 0], [60, 1, 1]]}"});
  try {
    const Scene scene(deck);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--set conditions.0.nodes: error: 'block' has no nodes inside the box"));
  }
}

}  // namespace
}  // namespace percuss::test
