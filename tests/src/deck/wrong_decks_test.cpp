// Every wrong deck is refused at its place, in words that help, and with nothing said beside it.

#include "tests/src/deck/wrong_decks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"

namespace percuss {
namespace {

// What the reader says to a deck, line by line; nothing if it takes it.
std::vector<std::string> messages_of(const std::string& text) {
  std::vector<std::string> lines;
  try {
    parse_deck(text, "deck.yaml");
  } catch (const InputError& error) {
    std::istringstream stream(error.what());
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
  }
  return lines;
}

class WrongDecks : public testing::TestWithParam<WrongDeck> {};

TEST_P(WrongDecks, AreRefusedAtTheirPlaceWithAMessageThatHelps) {
  const WrongDeck& deck = GetParam();
  const std::vector<std::string> lines = messages_of(deck.text);
  const std::string start = "deck.yaml" + (deck.place.empty() ? "" : ":" + deck.place) + ": error: ";
  EXPECT_THAT(lines, testing::Contains(testing::AllOf(testing::StartsWith(start), testing::HasSubstr(deck.message))));
  EXPECT_EQ(static_cast<int>(lines.size()), deck.errors) << testing::PrintToString(lines);
}

INSTANTIATE_TEST_SUITE_P(Table, WrongDecks, testing::ValuesIn(wrong_decks()),
                         [](const auto& wrong) { return wrong.param.name; });

TEST(WrongDeckTable, DifferFromADeckThatIsRight) { EXPECT_THAT(messages_of(right_deck), testing::IsEmpty()); }

TEST(WrongDeckTable, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const WrongDeck& deck : wrong_decks()) EXPECT_TRUE(names.insert(deck.name).second) << deck.name;
  EXPECT_GE(names.size(), 70U);
}

}  // namespace
}  // namespace percuss
