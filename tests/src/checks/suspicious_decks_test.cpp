// Every rule on suspicious input: a deck that it tells, with the place, and one near it that it leaves alone.

#include "tests/src/checks/suspicious_decks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "src/checks/rules.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/deck/warning_rules.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "src/output/warning_log.hpp"
#include "src/step/model/model.hpp"
#include "src/step/model/state.hpp"
#include "src/step/step.hpp"

namespace percuss {
namespace {

/// Warnings of `percuss check`.
std::vector<Warning> check(const std::string& text) {
  const Deck deck = parse_deck(text, "deck.yaml");
  const Communicator self(MPI_COMM_SELF);
  const ChunkedMesh chunked = load_mesh(deck, self);
  const Model model = build_model(deck, chunked);
  ContactStage contact(chunked, deck, self);
  State state = make_initial_state(model);
  if (contact.is_active()) contact.prepare(state.x, state.v);
  Stepper stepper(deck, chunked, model, contact);
  stepper.start(state);
  const SceneMeasures measures = measure_scene(deck, chunked, model.start_velocity);
  const TieMeasures ties = contact.measure_ties();
  const std::vector<double> part_steps = find_part_steps(chunked, state.results);
  const CheckedScene scene{deck, &measures, &contact.start_overlap(), state.bound.step, &ties, &part_steps};
  std::vector<Warning> warnings = deck.warnings;
  for (const auto& found : {chunked.mesh.warnings, check_input(scene), check_start(scene)})
    warnings.insert(warnings.end(), found.begin(), found.end());
  return warnings;
}

std::string list(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& warning : warnings) text += format_warning(warning) + "\n";
  return text;
}

/// "deck.yaml:LINE:COLUMN" of a text in a deck.
std::string find_place(const std::string& deck, const std::string& text) {
  const auto at = deck.find(text);
  if (at == std::string::npos) throw std::logic_error("the deck has no text '" + text + "'");
  const auto line_start = deck.rfind('\n', at) + 1;
  const auto line = 1 + std::count(deck.begin(), deck.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return fmt::format("deck.yaml:{}:{}", line, at - line_start + 1);
}

bool has_rule(const std::vector<Warning>& warnings, const std::string& rule) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const Warning& warning) { return warning.rule == rule; });
}

class SuspiciousDecks : public testing::TestWithParam<SuspiciousDeck> {};

TEST_P(SuspiciousDecks, AreToldWithTheirPlace) {
  const std::string text = change(GetParam().mistake), place = find_place(text, GetParam().place);
  const std::vector<Warning> warnings = check(text);
  const auto told = [&](const Warning& warning) { return warning.rule == GetParam().rule && warning.place == place; };
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), told)) << place << ", but told is:\n" << list(warnings);
}

TEST_P(SuspiciousDecks, AreLeftAloneBelowTheLimit) {
  const std::vector<Warning> warnings = check(change(GetParam().near));
  EXPECT_FALSE(has_rule(warnings, GetParam().rule)) << list(warnings);
}

INSTANTIATE_TEST_SUITE_P(Table, SuspiciousDecks, testing::ValuesIn(suspicious_decks()),
                         [](const auto& deck) { return deck.param.name; });

TEST(CheckRules, NameAPenaltyScaleThatIsStiffEnough) {
  const auto with_scale = [](const std::string& scale) {
    return check(change({{"friction: 0.2}\noutput", "enforcement: penalty, penalty_scale: " + scale + "}\noutput"}}));
  };
  const std::string text = list(with_scale("0.02")), before = "a penalty_scale of ";
  const auto at = text.find(before);
  ASSERT_NE(at, std::string::npos) << text;
  const std::string scale = text.substr(at + before.size(), text.find(' ', at + before.size()) - at - before.size());
  EXPECT_FALSE(has_rule(with_scale(scale), "penalty_speed")) << scale;
}

TEST(CheckRules, NameNoPenaltyScaleThatAddsEnergy) {
  const std::string text = list(
      check(change({{"[0, 0, -20]", "[0, 0, -800]"}, {"friction: 0.2}\noutput", "enforcement: penalty}\noutput"}})));
  EXPECT_NE(text.find("penalty_speed"), std::string::npos) << text;
  EXPECT_EQ(text.find("a penalty_scale of "), std::string::npos) << text;
}

/// A tube of sheets 1.5 thick, whose nodes end at z = 150, and a wall at 151 that comes for 5 ms.
std::string tell_wall(const std::string& of_wall) {
  return list(
      check("units: mm, t, s\ntime: {end: 5.0e-3}\n"
            "parts:\n  tube: {shell_box_tube: {size: [50, 50], length: 150, cells: [4, 4, 8]}, thickness: 1.5, "
            "material: steel}\n"
            "materials:\n  steel: {model: elastic, density: 7.85e-9, youngs_modulus: 210e3, poissons_ratio: 0.3}\n"
            "conditions: [{nodes: tube/start, fixed: [x, y, z, rx, ry, rz]}]\n"
            "walls: [{point: [0, 0, 151], normal: -z, mass: 0.1, " +
            of_wall + "}]\ncontact: {surfaces: all}\n"));
}

TEST(CheckRules, SayHowFarAWallIsFromSheets) {
  EXPECT_THAT(tell_wall("start_speed: 100"), testing::HasSubstr("it moves 0.5 and starts 1 away"));
  EXPECT_THAT(tell_wall("start_speed: 10, thickness: included"),
              testing::HasSubstr("it moves 0.05 and starts 0.25 away"));
  EXPECT_THAT(tell_wall("start_speed: 100, thickness: included"), testing::Not(testing::HasSubstr("wall_motion")));
  EXPECT_THAT(tell_wall("start_speed: 300"), testing::Not(testing::HasSubstr("wall_motion")));
}

TEST(CheckRules, FindNothingInASoundDeck) { EXPECT_EQ(list(check(sound_deck)), ""); }

TEST(CheckRules, AreAllTriedByADeck) {
  std::set<std::string> tried;
  for (const SuspiciousDeck& deck : suspicious_decks()) tried.insert(deck.rule);
  for (const CheckRule& rule : check_rules()) EXPECT_EQ(tried.count(rule.name), 1U) << rule.name;
}

TEST(CheckRules, HaveNamesThatADeckCanSilence) {
  std::set<std::string> known;
  for (const WarningRule& rule : warning_rules()) EXPECT_TRUE(known.insert(rule.name).second) << rule.name;
  for (const CheckRule& rule : check_rules()) EXPECT_EQ(known.count(rule.name), 1U) << rule.name;
}

/// The rows of docs/checks.md: "| `rule` | what it looks for |".
std::multiset<std::string> list_documented() {
  std::ifstream page(PERCUSS_SOURCE_DIR "/docs/checks.md");
  std::multiset<std::string> rows;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| `")) rows.insert(line.substr(0, line.find('|', line.find("` | ") + 4) + 1));
  }
  return rows;
}

TEST(CheckRules, AreDocumentedOnceEach) {
  std::multiset<std::string> expected;
  for (const WarningRule& rule : warning_rules())
    expected.insert(fmt::format("| `{}` | {} |", rule.name, rule.looks_for));
  EXPECT_EQ(list_documented(), expected);
}

TEST(CheckRules, AreSilencedByTheDeck) {
  const Deck deck = parse_deck("silence: [friction, part_size]\n" + sound_deck, "deck.yaml");
  WarningLog log(deck.silenced);
  for (const char* rule : {"friction", "density"}) log.add({rule, "", "", 0, 1});
  ASSERT_EQ(log.list().size(), 1U);
  EXPECT_EQ(log.list().front().rule, "density");
}

TEST(CheckRules, ReadAsAProblemItsReasonAndWhatToDo) {
  std::set<std::string> rules;
  for (const CheckRule& rule : check_rules()) rules.insert(rule.name);
  for (const SuspiciousDeck& deck : suspicious_decks()) {
    for (const Warning& warning : check(change(deck.mistake))) {
      if (rules.count(warning.rule) == 0) continue;  // of deck or mesh alone
      EXPECT_THAT(warning.text, testing::MatchesRegex("[^(]+ \\(.+\\): .+")) << deck.name;
    }
  }
}

}  // namespace
}  // namespace percuss
