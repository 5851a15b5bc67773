// Decks that are right: what is read, and the defaults.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <numbers>
#include <string>
#include <variant>

#include "src/deck/reading/read_deck.hpp"
#include "src/deck/text/deck_text.hpp"
#include "src/error.hpp"
#include "tests/expect_error.hpp"

namespace percuss {
namespace {

// The deck by which the format was designed.
const std::string brick_wall = R"(title: A wall of bricks struck by a steel rod
units: m, kg, s
time: {end: 2.0e-3, step_scale: 0.9}
parts:
  rod:    {cylinder: {radius: 0.05, length: 0.4, cells: [8, 32]}, at: [-0.41, 0, 0.6], axis: x, material: steel}
  bricks: {box: {size: [0.2, 0.1, 0.06], cells: [6, 3, 3]}, array: {count: [1, 10, 14], pitch: [0.2, 0.1, 0.06], stagger: 0.5}, material: brick}
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
  brick: {model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}
initial: [{part: rod, velocity: [200, 0, 0]}]
contact: {surfaces: all, friction: 0.3}
output: {fields: {every: 1e-4, write: [velocity, stress, equivalent_plastic_strain]}, history: {every: 1e-6}}
)";

// A deck of one elastic block, to which `more` is added.
std::string block(const std::string& more) {
  return "time: {end: 1}\nparts: {a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: m}}\n"
         "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n" +
         more;
}

Deck parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_deck(text, "deck.yaml", overrides);
}

TEST(ReadDeck, ReadsTheDeckOfTheBrickWall) {
  const Deck deck = parse(brick_wall);
  EXPECT_EQ(deck.title, "A wall of bricks struck by a steel rod");
  EXPECT_EQ(deck.units, "m, kg, s");
  EXPECT_EQ(deck.time.end, 2e-3);
  ASSERT_EQ(deck.parts.size(), 2U);
  EXPECT_EQ(deck.parts[0].name, "rod");
  EXPECT_EQ(deck.parts[0].place.line, 5);
  EXPECT_EQ(deck.parts[0].place.column, 3);
  const auto& rod = std::get<CylinderShape>(deck.parts[0].shape);
  EXPECT_EQ(rod.across, 8);
  EXPECT_EQ(rod.along, 32);
  EXPECT_EQ(deck.parts[0].at, (Vec3{-0.41, 0, 0.6}));
  ASSERT_EQ(deck.parts[0].rotate.size(), 1U);
  EXPECT_EQ(deck.parts[0].rotate[0].axis, (Vec3{0, 1, 0}));  // z to x: a quarter turn about y
  EXPECT_EQ(deck.parts[0].rotate[0].degrees, 90);
  ASSERT_TRUE(deck.parts[1].array);
  EXPECT_EQ(deck.parts[1].array->count, (std::array<int, 3>{1, 10, 14}));
  EXPECT_EQ(deck.parts[1].array->stagger, 0.5);
  const LawDeck& steel = deck.materials[0].law;
  EXPECT_EQ(steel.model, "j2_plasticity");
  EXPECT_EQ(steel.numbers.at("youngs_modulus"), 200e9);
  EXPECT_EQ(steel.numbers.at("hardening_modulus"), 1e9);
  EXPECT_EQ(deck.materials[1].law.model, "elastic");
  EXPECT_EQ(deck.materials[1].law.numbers.at("poissons_ratio"), 0.2);
  EXPECT_EQ(deck.initial.at(0).where.name, "rod");
  EXPECT_EQ(deck.initial.at(0).velocity, (Vec3{200, 0, 0}));
  EXPECT_EQ(deck.contact.surfaces, ContactDeck::Surfaces::all);
  EXPECT_EQ(deck.contact.friction, 0.3);
  EXPECT_EQ(deck.output.fields.every, 1e-4);
  EXPECT_THAT(deck.output.fields.write, testing::ElementsAre("velocity", "stress", "equivalent_plastic_strain"));
  EXPECT_EQ(deck.output.history_every, 1e-6);
  EXPECT_THAT(deck.warnings, testing::IsEmpty());
}

TEST(ReadDeck, GivesTheDocumentedDefaults) {
  const Deck deck = parse(block(""));
  EXPECT_EQ(deck.time.step_scale, 0.9);
  EXPECT_FALSE(deck.time.max_step);
  EXPECT_EQ(deck.elements.hourglass, ElementDeck::Hourglass::assumed_strain);
  EXPECT_EQ(deck.elements.hourglass_coefficient, 0.05);
  EXPECT_EQ(deck.elements.linear_viscosity, 0.06);
  EXPECT_EQ(deck.elements.quadratic_viscosity, 1.2);
  EXPECT_EQ(deck.contact.surfaces, ContactDeck::Surfaces::none);
  EXPECT_FALSE(deck.output.fields.every);
  EXPECT_FALSE(deck.output.history_every);
  EXPECT_FALSE(deck.gravity.any());
  EXPECT_EQ(deck.audit.max_energy_error, 0.1);
}

TEST(ReadDeck, TakesContactWithoutSurfacesForAllSurfaces) {
  EXPECT_EQ(parse(block("contact: {friction: 0.2}")).contact.surfaces, ContactDeck::Surfaces::all);
}

TEST(ReadDeck, TakesHistoryWithoutEveryForEveryStep) {
  EXPECT_EQ(parse(block("output: {history: {}}")).output.history_every, 0.0);
}

TEST(ReadDeck, ReadsEveryShape) {
  const Deck deck = parse(
      "time: {end: 1}\n"
      "materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n"
      "parts:\n"
      "  t: {tube: {inner_radius: 1, outer_radius: 2, length: 3, cells: [1, 12, 4]}, material: m}\n"
      "  a: {tube: {inner_radius: 1, outer_radius: 2, length: 3, cells: [1, 12, 4], arc: 45.5}, material: m}\n"
      "  s: {sphere: {radius: 2, cells: 9}, material: m}\n");
  const auto& tube = std::get<TubeShape>(deck.parts[0].shape);
  EXPECT_EQ(tube.outer_radius, 2);
  EXPECT_EQ(tube.cells, (std::array<int, 3>{1, 12, 4}));
  EXPECT_EQ(tube.arc, 360);
  EXPECT_EQ(std::get<TubeShape>(deck.parts[1].shape).arc, 45.5);
  EXPECT_EQ(std::get<SphereShape>(deck.parts[2].shape).across, 9);
}

TEST(ReadDeck, PutsTheTurnOfTheAxisBeforeTheOtherTurns) {
  const Deck deck = parse(
      "time: {end: 1}\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n"
      "parts: {c: {rotate: [{axis: [0, 3, 4], angle: 30, center: [1, 2, 3]}], axis: [0, 0, -2], cylinder: {radius: 1, "
      "length: 1, "
      "cells: [4, 1]}, material: m}}\n");
  ASSERT_EQ(deck.parts[0].rotate.size(), 2U);
  EXPECT_EQ(deck.parts[0].rotate[0].degrees, 180);
  EXPECT_DOUBLE_EQ(deck.parts[0].rotate[1].axis[1], 0.6);
  EXPECT_DOUBLE_EQ(deck.parts[0].rotate[1].axis[2], 0.8);
  EXPECT_EQ(deck.parts[0].rotate[1].center, (Vec3{1, 2, 3}));
}

TEST(ReadDeck, TurnsTheLocalAxisOntoAnyDirection) {
  const Vec3 wanted{0.48, -0.6, 0.64};
  const Deck deck = parse(block(""), {"parts.a.axis=[0.48, -0.6, 0.64]"});
  const Rotation& turn = deck.parts[0].rotate.at(0);
  // Rodrigues' formula on +z, whose component along the turn's axis is zero.
  const double angle = turn.degrees * std::numbers::pi / 180;
  EXPECT_NEAR(turn.axis[1] * std::sin(angle), wanted[0], 1e-15);
  EXPECT_NEAR(-turn.axis[0] * std::sin(angle), wanted[1], 1e-15);
  EXPECT_NEAR(std::cos(angle), wanted[2], 1e-15);
}

TEST(ReadDeck, ReadsLoadsConditionsAndWalls) {
  const Deck deck = parse(
      block("loads: {gravity: [0, 0, -9.81], pressure: [{faces: a/x_min, value: {table: [[0, 0], [1, 5]]}}]}\n"
            "initial: [{velocity: [1, 2, 3]}, {nodes: {inside: [[0, 0, 0], [1, 1, 0.5]]}, angular_velocity: [0, 0, 7], "
            "center: [0, 0, 0]}, {radial_velocity: {speed: -3, center: [4, 5, 6], axis: [0, 3, 4]}}]\n"
            "conditions:\n"
            "  - {nodes: a/z_min, fixed: [x, z]}\n"
            "  - {nodes: a/x_min, symmetry: x}\n"
            "  - {nodes: {name: a, inside: [[0, 0, 0], [1, 1, 0]]}, velocity: {y: 3, z: {expression: \"2 * t\"}}}\n"
            "  - {nodes: all, displacement: {x: 0}}\n"
            "walls: [{point: [0, 0, -1], normal: [0, 0, 5], friction: 0.4, nodes: [a, a/x_max]}, {normal: -x, nodes: "
            "all}]\n"));
  EXPECT_EQ(deck.gravity.at(0), (Vec3{0, 0, -9.81}));
  EXPECT_EQ(deck.pressures.at(0).where.name, "a/x_min");
  EXPECT_DOUBLE_EQ(deck.pressures.at(0).value(0.5), 2.5);
  EXPECT_EQ(deck.initial.at(0).where.name, "");
  ASSERT_TRUE(deck.initial.at(1).where.inside);
  EXPECT_EQ((*deck.initial.at(1).where.inside)[1], (Vec3{1, 1, 0.5}));
  EXPECT_EQ(deck.initial.at(1).angular_velocity, (Vec3{0, 0, 7}));
  ASSERT_TRUE(deck.initial.at(2).radial_velocity);
  EXPECT_EQ(deck.initial.at(2).radial_velocity->speed, -3);
  EXPECT_EQ(deck.initial.at(2).radial_velocity->center, (Vec3{4, 5, 6}));
  EXPECT_EQ(deck.initial.at(2).radial_velocity->axis, (Vec3{0, 0.6, 0.8}));
  ASSERT_EQ(deck.conditions.size(), 4U);
  EXPECT_EQ(deck.conditions[0].active, (std::array<bool, 6>{true, false, true}));
  EXPECT_EQ(deck.conditions[1].kind, ConditionDeck::Kind::symmetry);
  EXPECT_EQ(deck.conditions[2].kind, ConditionDeck::Kind::velocity);
  EXPECT_EQ(deck.conditions[2].where.name, "a");
  EXPECT_DOUBLE_EQ(deck.conditions[2].value[2](3.0), 6.0);
  EXPECT_EQ(deck.conditions[3].kind, ConditionDeck::Kind::displacement);
  EXPECT_EQ(deck.walls.at(0).normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(deck.walls.at(0).nodes.size(), 2U);
  EXPECT_EQ(deck.walls.at(1).normal, (Vec3{-1, 0, 0}));
  EXPECT_TRUE(deck.walls.at(1).nodes.empty());
}

TEST(ReadDeck, ReadsPairsOfSurfacesInBothForms) {
  const Deck deck =
      parse(block("contact: {surfaces: [[a/x_min, a/x_max], {a: a, b: a, friction: 0.5}], overlap: push_out, "
                  "enforcement: lagrange, search: points_in_box, reuse_search: false, edges: false}"));
  EXPECT_EQ(deck.contact.surfaces, ContactDeck::Surfaces::pairs);
  EXPECT_EQ(deck.contact.pairs.at(0).b.name, "a/x_max");
  EXPECT_FALSE(deck.contact.pairs.at(0).friction);
  EXPECT_EQ(deck.contact.pairs.at(1).friction, 0.5);
  EXPECT_EQ(deck.contact.overlap, ContactDeck::Overlap::push_out);
  EXPECT_EQ(deck.contact.enforcement, ContactDeck::Enforcement::lagrange);
  EXPECT_EQ(deck.contact.search, ContactDeck::Search::points_in_box);
  EXPECT_FALSE(deck.contact.reuse_search);
  EXPECT_FALSE(deck.contact.edges);
}

TEST(ReadDeck, ReadsHistoryPoints) {
  const Deck deck =
      parse(block("output: {history: {every: 0.1, nodes: [{name: tip, near: [1, 1, 1], part: a}], elements: [{name: "
                  "mid, id: 4}]}}"));
  ASSERT_EQ(deck.output.points.size(), 2U);
  EXPECT_EQ(deck.output.points[0].name, "tip");
  EXPECT_EQ(deck.output.points[0].part, "a");
  EXPECT_FALSE(deck.output.points[0].is_element);
  EXPECT_TRUE(deck.output.points[1].is_element);
  EXPECT_EQ(deck.output.points[1].id, 4);
}

std::vector<std::string> format_all(const std::vector<Warning>& warnings) {
  std::vector<std::string> lines;
  for (const Warning& warning : warnings) lines.push_back(format_warning(warning));
  return lines;
}

TEST(ReadDeck, WarnsOfAMaterialThatNoPartUses) {
  const Deck deck =
      parse(block(""), {"materials.spare={model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}"});
  EXPECT_THAT(
      format_all(deck.warnings),
      testing::ElementsAre("--set materials.spare: warning: material 'spare' is used by no part [unused_material]"));
}

TEST(ReadDeck, WarnsOfSettingsOfContactThatDoNothing) {
  const auto read = [](const char* contact) { return format_all(parse(block(contact)).warnings); };
  EXPECT_THAT(read("contact: {surfaces: all, friction: 0.2, tolerance: 1e-4}\n"), testing::IsEmpty());
  EXPECT_THAT(read("contact: {surfaces: all, enforcement: penalty, penalty_scale: 0.2}\n"), testing::IsEmpty());
  EXPECT_THAT(
      read("contact: {surfaces: none, friction: 0.2, penalty_scale: 0.2}\n"),
      testing::ElementsAre(
          testing::HasSubstr("warning: contact.friction does nothing (contact.surfaces is none)"),
          testing::HasSubstr(
              "warning: contact.penalty_scale does nothing (it applies only to contact.enforcement: penalty)")));
  EXPECT_THAT(read("contact: {enforcement: lagrange, tolerance: 1e-4}\n"),
              testing::ElementsAre(testing::HasSubstr("warning: contact.tolerance does nothing (it applies only to "
                                                      "contact.enforcement: automatic and kinematic)")));
}

TEST(ReadDeck, AcceptsAByteOrderMarkWindowsLineEndsAndADocumentStart) {
  std::string text = "\xEF\xBB\xBF---\n" + block("title: Stoß\n...\n");
  for (auto i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 2)) text.replace(i, 1, "\r\n");
  EXPECT_EQ(parse(text).title, "Stoß");
}

TEST(ReadDeck, ReadsAFileAndSaysWhenThereIsNone) {
  EXPECT_ERROR(read_deck("no/such/deck.yaml"), InputError, "no such file");
  EXPECT_ERROR(read_deck("."), InputError, "a folder, not a deck");
  EXPECT_ERROR(read_deck("/dev/zero"), InputError, "the deck is a device");
  const std::string pipe = testing::TempDir() + "percuss_deck_" + std::to_string(getpid());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  try {
    read_deck(pipe);  // nobody writes to it
    ADD_FAILURE() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the deck is a pipe (a regular file is needed)"));
  }
  std::remove(pipe.c_str());
}

TEST(ReadDeck, NamesAPlaceForLaterMessages) {
  Deck deck;
  deck.file = "deck.yaml";
  EXPECT_EQ(deck.where({14, 12}), "deck.yaml:14:12");
  EXPECT_EQ(deck.where({}), "deck.yaml");
}

TEST(ReadDeck, NamesTheProgramOfAModelByItsExtension) {
  const std::string text = "\r\n$ a comment\n*KEYWORD\n";
  EXPECT_EQ(describe_other_model(text, "car.k"),
            "this is an LS-DYNA model (percuss runs decks in YAML): percuss import car.k --out DIR");
  EXPECT_THAT(describe_other_model(text, "car.inp"), testing::StartsWith("this is an Abaqus model "));
  EXPECT_THAT(describe_other_model(text, "car"), testing::StartsWith("this is an LS-DYNA or Abaqus model "));
  for (const char* other : {"", "time: {end: 1}", "*", "* a", "$ only a comment", "# *KEYWORD"})
    EXPECT_EQ(describe_other_model(other, "car.k"), "") << other;
}

}  // namespace
}  // namespace percuss
