// The schema of `percuss schema`: it takes every deck that the reader takes, and knows keys, types, words and ranges.

#include "src/deck/reading/deck_schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "src/deck/keys/key_documentation.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/src/deck/json_schema.hpp"
#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const nlohmann::json& schema() {
  static const nlohmann::json all = nlohmann::json::parse(write_deck_schema());
  return all;
}

std::vector<std::string> faults_of(const std::string& deck) { return find_faults(schema(), read_as_json(deck)); }

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// The examples of a page from a place on, each behind the one before.
std::string join_examples(const std::string& page, std::size_t from) {
  const std::string fence = "```yaml\n";
  std::string deck;
  for (auto at = page.find(fence, from); at != std::string::npos; at = page.find(fence, at + 1)) {
    const auto start = at + fence.size();
    const std::string example = page.substr(start, page.find("```", start) - start);
    if (!example.starts_with("nodes:")) deck += example;  // a selector alone
  }
  return deck;
}

// What the reader says to a deck: nothing if it takes it.
std::string refusal_of(const std::string& deck, const std::string& file) {
  try {
    parse_deck(deck, file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DeckSchema, TakesTheDecksOfInputsAndOfTests) {
  int decks = 0;
  for (const char* folder : {"/inputs", "/tests", "/perf"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(PERCUSS_SOURCE_DIR + std::string(folder))) {
      if (entry.path().extension() != ".yaml") continue;
      const std::string deck = read_text(entry.path());
      const std::string refusal = refusal_of(deck, entry.path().string());
      if (!refusal.empty() && refusal.find("exodus.file") == std::string::npos) continue;  // a mesh is made elsewhere
      EXPECT_THAT(faults_of(deck), IsEmpty()) << entry.path();
      ++decks;
    }
  }
  EXPECT_GE(decks, 25);
}

TEST(DeckSchema, TakesTheExamplesOfTheDocumentation) {
  const std::string page = read_text(PERCUSS_SOURCE_DIR "/docs/deck.md");
  const auto scene = page.find("## The scene");
  ASSERT_NE(scene, std::string::npos);
  EXPECT_THAT(faults_of(join_examples(page.substr(0, scene), 0)), IsEmpty());
  const std::string all = join_examples(page, scene);
  EXPECT_THAT(all, HasSubstr("\noutput:"));
  EXPECT_THAT(faults_of(all), IsEmpty());
  EXPECT_THAT(faults_of(join_examples(read_text(PERCUSS_SOURCE_DIR "/README.md"), 0)), IsEmpty());
}

// Each form of the values that have several; the reader must take them, and the schema too.
TEST(DeckSchema, TakesEveryFormThatTheReaderTakes) {
  EXPECT_THAT(faults_of(right_deck), IsEmpty());
  for (const char* lines : {
           "title: 42",
           "title: true",
           "units: 'm, kg, s'",
           "elements: {hourglass: stiffness}",
           "elements: {integration: thick_shell}",
           "elements: {integration: {kind: thick_shell, points: 5, across: shortest}}",
           "elements: {hourglass: {kind: viscous, coefficient: 0}}",
           "conditions: [{nodes: rod, fixed: x}, {nodes: 'rod/x_min', fixed: [x, y]}]",
           "conditions: [{nodes: {inside: [[0, 0, 0], [1, 1, 1]]}, symmetry: y}]",
           "conditions: [{nodes: all, velocity: {x: 1, z: {table: [[0, 1], [1, 2]]}}}]",
           "conditions: [{nodes: {name: rod}, displacement: {y: {expression: \"t\"}, z: {expression: 0}}}]",
           "contact: {}",
           "contact: {surfaces: none}",
           "contact: {surfaces: [[rod, rod], {a: rod, b: rod/x_min, friction: 0}]}",
           "walls: [{normal: -z}, {normal: [0, 0, +1], nodes: rod}, {normal: y, nodes: [rod, {name: rod/x_min}]}]",
           "output: {history: {nodes: [{name: tip, near: [.5, 1., 1e0], part: rod}], elements: [{name: a, id: 1}]}}",
           "output: {fields: {every: 1, write: []}, checkpoint: {wall: 60}}",
           "output: {history: {parts: all}}",
           "output: {history: {parts: [rod]}}",
           "loads: {gravity: [0, 0, -9.81E+0], nodal: [{nodes: rod, force: {x: -1}}]}",
           "contact: {edges: FALSE, rebalance: \"auto\"}",
       }) {
    EXPECT_EQ(refusal_of(append(lines), "deck.yaml"), "") << lines;
    EXPECT_THAT(faults_of(append(lines)), IsEmpty()) << lines;
  }
}

// Mistakes of every kind that a schema can know, from the table of wrong decks.
TEST(DeckSchema, RefusesWhatTheReaderRefuses) {
  EXPECT_THAT(faults_of(right_deck), IsEmpty());
  std::set<std::string> names = {"KeyMisspelt",
                                 "SectionMisspelt",
                                 "SwappedLetters",
                                 "KeyInCapitals",
                                 "KeyOfNothing",
                                 "KeyOfOtherModel",
                                 "ShapeMisspelt",
                                 "UnknownModel",
                                 "UnknownField",
                                 "UnknownHourglass",
                                 "UnknownHourglassWord",
                                 "UnknownIntegration",
                                 "UnknownOverlap",
                                 "UnknownEnforcement",
                                 "UnknownSurfaces",
                                 "UnknownAxis",
                                 "UnknownFixedAxis",
                                 "UnknownCriterion",
                                 "NoTime",
                                 "NoEnd",
                                 "NoMaterials",
                                 "EmptyParts",
                                 "PartWithoutMaterial",
                                 "PartWithoutShape",
                                 "PartWithTwoShapes",
                                 "PartIsAWord",
                                 "PartNameWithSlash",
                                 "BoxWithoutCells",
                                 "MaterialWithoutModel",
                                 "MaterialWithoutDensity",
                                 "PlasticityWithoutYield",
                                 "PowerLawWithoutExponent",
                                 "RadialVelocityWithoutCenter",
                                 "ConditionWithoutKind",
                                 "FieldsWithoutEvery",
                                 "PointWithoutName",
                                 "WordForNumber",
                                 "EmptyForNumber",
                                 "ListForNumber",
                                 "TrueForNumber",
                                 "QuotedNumber",
                                 "FractionForInteger",
                                 "WordForInteger",
                                 "NumberForBoolean",
                                 "YesForBoolean",
                                 "ListForText",
                                 "NegativeDensity",
                                 "ZeroDensity",
                                 "IncompressibleRatio",
                                 "EndOfZero",
                                 "StepScaleAboveOne",
                                 "FlatBox",
                                 "NoCells",
                                 "HugeCell",
                                 "CoarseCylinder",
                                 "StaggerTooFar",
                                 "NegativeFriction",
                                 "NegativeFailureStrain",
                                 "LoadAlongNothing",
                                 "ShortVector",
                                 "LongVector",
                                 "NumberForVector",
                                 "EmptyTable",
                                 "TableOfNegativeStress",
                                 "TableIsANumber",
                                 "KinematicShareAboveOne"};
  for (const WrongDeck& deck : wrong_decks()) {
    if (names.erase(deck.name) == 0) continue;
    EXPECT_FALSE(faults_of(deck.text).empty()) << deck.name;
  }
  EXPECT_THAT(names, IsEmpty());
}

// What a key takes, means and is measured in, and the keys that go with a model.
TEST(DeckSchema, SaysOfAKeyWhatTheDocumentationSays) {
  const nlohmann::json& end = schema().at("properties").at("time").at("properties").at("end");
  EXPECT_EQ(
      end.at("description"),
      "a number, positive [time]; required. End time of the run, which starts at 0. The last step ends exactly there.");
  EXPECT_EQ(end.at("exclusiveMinimum"), 0);
  const nlohmann::json& material = schema().at("properties").at("materials").at("patternProperties").begin().value();
  EXPECT_EQ(material.at("required"), nlohmann::json::array({"model", "density"}));
  EXPECT_THAT(faults_of(change("poissons_ratio: 0.3",
                               "poissons_ratio: 0.3, equation_of_state: {kind: linear, "
                               "bulk_modulus: 1e9}")),
              testing::Contains(HasSubstr("/materials/steel/equation_of_state")));
}

TEST(KeyDocumentation, ReadsTheRowsOfAPage) {
  const auto rows = read_key_documentation(
      "| `a.b` | x \\| y | [0, 0] | - | See [there](b.md#c) and `d`. |\n| `5.0` | a form |\n| `e` | f | - | - | |\n");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows.at("a.b").takes, "x | y");
  EXPECT_EQ(rows.at("a.b").otherwise, "[0, 0]");
  EXPECT_EQ(rows.at("a.b").meaning, "See there and `d`.");
  EXPECT_EQ(rows.at("e").meaning, "");
}

}  // namespace
}  // namespace percuss
