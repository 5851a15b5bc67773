// `percuss check` on every wrong deck: exit code 2, a place, a helpful line, and nothing on standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/src/app/percuss_process.hpp"
#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

class CheckWrongDecks : public testing::TestWithParam<WrongDeck> {};

TEST_P(CheckWrongDecks, ExitsWithTwoAndNamesThePlace) {
  const WrongDeck& deck = GetParam();
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", deck.text);
  const ProcessResult result = run_percuss({"check", file});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::HasSubstr(file + (deck.place.empty() ? "" : ":" + deck.place) + ": error: "));
  EXPECT_THAT(result.err, testing::HasSubstr(deck.message));
}

INSTANTIATE_TEST_SUITE_P(Table, CheckWrongDecks, testing::ValuesIn(wrong_decks()),
                         [](const auto& wrong) { return wrong.param.name; });

}  // namespace
}  // namespace percuss
