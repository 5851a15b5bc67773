// --set: what it reaches, what it makes, and how it says no.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

Deck parse_with(const std::vector<std::string>& settings) {
  return parse_deck(right_deck + "initial:\n  - {part: rod, velocity: [1, 2, 3]}\n", "deck.yaml", settings);
}

std::string refusal(const std::vector<std::string>& settings) {
  try {
    parse_with(settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Overrides, ReplaceValuesByPath) {
  const Deck deck = parse_with({"time.end=2.5", "parts.rod.at=[1, 2, 3]", "materials.steel.density=1000"});
  EXPECT_EQ(deck.time.end, 2.5);
  EXPECT_EQ(deck.parts[0].at, (Vec3{1, 2, 3}));
  EXPECT_EQ(deck.materials[0].density, 1000);
}

TEST(Overrides, ReachListsByIndex) {
  EXPECT_EQ(parse_with({"initial.0.velocity=[7, 0, 0]"}).initial.at(0).velocity, (Vec3{7, 0, 0}));
  EXPECT_EQ(parse_with({"initial.0.velocity.1=9"}).initial.at(0).velocity, (Vec3{1, 9, 3}));
}

TEST(Overrides, AppendAfterTheLastItem) {
  EXPECT_EQ(parse_with({"initial.1={velocity: [0, 0, 1]}"}).initial.size(), 2U);
  EXPECT_EQ(parse_with({"initial.1.velocity=[0, 0, 1]"}).initial.size(), 2U);
}

TEST(Overrides, MakeTheMapsOnTheirWay) {
  EXPECT_EQ(parse_with({"elements.hourglass.kind=viscous"}).elements.hourglass, ElementDeck::Hourglass::viscous);
  EXPECT_EQ(parse_with({"elements.hourglass=stiffness"}).elements.hourglass, ElementDeck::Hourglass::stiffness);
  EXPECT_EQ(parse_with({"elements.integration=full"}).elements.integration, ElementDeck::Integration::full);
  EXPECT_EQ(parse_with({"contact={surfaces: all, friction: 0.5}"}).contact.friction, 0.5);
  EXPECT_EQ(parse_with({"parts.ball={sphere: {radius: 1, cells: 4}, material: steel}"}).parts.size(), 2U);
}

TEST(Overrides, ApplyInOrder) { EXPECT_EQ(parse_with({"time.end=2", "time.end=3"}).time.end, 3); }

TEST(Overrides, TakeTextWithEqualSigns) { EXPECT_EQ(parse_with({"title=a = b"}).title, "a = b"); }

TEST(Overrides, MayGiveTheWholeDeck) {
  const Deck deck = parse_deck("", "deck.yaml",
                               {"time={end: 1}", "parts={a: {sphere: {radius: 1, cells: 4}, material: m}}",
                                "materials={m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}"});
  EXPECT_EQ(deck.parts.size(), 1U);
}

TEST(Overrides, AreNamedInErrorsOfTheirValues) {
  EXPECT_EQ(refusal({"parts.rod.at=[1, 2]"}),
            "--set parts.rod.at: error: at is [1, 2] in part 'rod' (must be a list of 3, each a number)");
  EXPECT_EQ(refusal({"time.end=-1"}), "--set time.end: error: time.end is -1 (must be positive)");
  EXPECT_EQ(refusal({"time.ends=1"}), "--set time.ends: error: unknown key 'ends' in 'time' (did you mean 'end'?)");
  EXPECT_EQ(refusal({"tme.end=1"}), "--set tme.end: error: unknown key 'tme' (did you mean 'time'?)");
}

TEST(Overrides, SayWhereTheirPathBreaks) {
  EXPECT_EQ(refusal({"parts.rodd.at=[1, 2, 3]"}),
            "--set parts.rodd.at: error: there is no 'rodd' in parts (did you mean 'rod'?)");
  EXPECT_EQ(
      refusal({"initial.5.velocity=[1, 2, 3]"}),
      "--set initial.5.velocity: error: 'initial' is a list of 1 value ('5' is not a valid index; items count from 0)");
  EXPECT_EQ(refusal({"initial.first.velocity=[1, 2, 3]"}),
            "--set initial.first.velocity: error: 'initial' is a list of 1 value ('first' is not a valid index; items "
            "count from 0)");
  EXPECT_EQ(refusal({"time.end.seconds=1"}),
            "--set time.end.seconds: error: 'time.end' is 1.0 (a value, not a map that could hold 'seconds')");
}

TEST(Overrides, RefuseWhatIsNoSetting) {
  EXPECT_THAT(refusal({"time.end"}),
              testing::HasSubstr("--set time.end: error: 'time.end' is not a setting (must be path.to.key=value)"));
  EXPECT_THAT(refusal({"=1"}), testing::HasSubstr("is not a setting"));
  EXPECT_THAT(refusal({"time..end=1"}), testing::HasSubstr("a key between the dots is empty"));
  EXPECT_THAT(refusal({"time.end=[1"}), testing::HasSubstr("--set time.end: error: not valid YAML"));
  EXPECT_THAT(refusal({"time.end=[1"}), testing::HasSubstr("a '[' is not closed"));
  EXPECT_THAT(refusal({"time.end=*a"}), testing::HasSubstr("aliases are not supported"));
  EXPECT_THAT(refusal({"time.end=\xff"}), testing::HasSubstr("not UTF-8"));
  EXPECT_THAT(refusal({"time.end="}), testing::HasSubstr("time.end is empty"));
}

TEST(Overrides, TellAllTheirErrorsAtOnce) {
  EXPECT_EQ(refusal({"time.end=x", "time.step_scale=2"}),
            "--set time.end: error: time.end is 'x' (must be a number)\n"
            "--set time.step_scale: error: time.step_scale is 2 (must be above 0, at most 1)");
}

}  // namespace
}  // namespace percuss
