// `percuss check` on every wrong deck: exit code 2, a place, a helpful line, and nothing on standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <map>

#include "tests/src/app/percuss_process.hpp"
#include "tests/src/deck/wrong_decks.hpp"

namespace percuss {
namespace {

struct CheckedDeck {
  std::string file;
  ProcessResult result;
};

class CheckWrongDecks : public testing::TestWithParam<WrongDeck> {
 protected:
  // Some at a time: a process waits for the start of MPI most of its life.
  static void SetUpTestSuite() {
    const std::vector<WrongDeck> decks = wrong_decks();
    constexpr std::size_t at_a_time = 4;
    std::vector<std::future<std::vector<CheckedDeck>>> shares;
    for (std::size_t first = 0; first < at_a_time; ++first) {
      shares.push_back(std::async(std::launch::async, [&decks, first] {
        std::vector<CheckedDeck> share;
        for (std::size_t i = first; i < decks.size(); i += at_a_time) share.push_back(check(decks[i]));
        return share;
      }));
    }
    for (std::size_t first = 0; first < at_a_time; ++first) {
      const std::vector<CheckedDeck> share = shares[first].get();
      for (std::size_t i = 0; i < share.size(); ++i) checked[decks[first + i * at_a_time].name] = share[i];
    }
  }

  static std::map<std::string, CheckedDeck> checked;

 private:
  static CheckedDeck check(const WrongDeck& deck) {
    const TemporaryFolder folder;
    const std::string file = folder.write("deck.yaml", deck.text);
    return {file, run_percuss({"check", file})};
  }
};

std::map<std::string, CheckedDeck> CheckWrongDecks::checked;

TEST_P(CheckWrongDecks, ExitsWithTwoAndNamesThePlace) {
  const WrongDeck& deck = GetParam();
  const auto& [file, result] = checked.at(deck.name);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::HasSubstr(file + (deck.place.empty() ? "" : ":" + deck.place) + ": error: "));
  EXPECT_THAT(result.err, testing::HasSubstr(deck.message));
}

INSTANTIATE_TEST_SUITE_P(Table, CheckWrongDecks, testing::ValuesIn(wrong_decks()),
                         [](const auto& wrong) { return wrong.param.name; });

}  // namespace
}  // namespace percuss
