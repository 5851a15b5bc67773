// Messages are sorted, said once, and end somewhere.

#include "src/deck/deck_errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "src/error.hpp"

namespace percuss {
namespace {

std::string text_of(const DeckErrors& errors) {
  try {
    errors.throw_if_any();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DeckErrors, AreSortedByPlaceAndSettingsComeLast) {
  DeckErrors errors("d.yaml", {"a.b"});
  errors.add({{}, 0}, "four");
  errors.add({{7, 1}, -1}, "three");
  errors.add({{2, 9}, -1}, "two");
  errors.add({{2, 3}, -1}, "one");
  EXPECT_EQ(text_of(errors),
            "d.yaml:2:3: error: one\nd.yaml:2:9: error: two\nd.yaml:7:1: error: three\n--set a.b: error: four");
}

TEST(DeckErrors, AreSaidOnceForOnePlace) {
  DeckErrors errors("d.yaml", {});
  errors.add({{1, 1}, -1}, "same");
  errors.add({{1, 1}, -1}, "same");
  EXPECT_EQ(text_of(errors), "d.yaml:1:1: error: same");
}

TEST(DeckErrors, AreCountedWhenTheyRepeat) {
  DeckErrors errors("d.yaml", {});
  for (int line = 1; line <= 10; ++line) errors.add({{line, 1}, -1}, "same");
  EXPECT_EQ(
      text_of(errors),
      "d.yaml:1:1: error: same\nd.yaml:2:1: error: same\nd.yaml:3:1: error: same\nd.yaml: error: 7 more times: same");
}

TEST(DeckErrors, StopWhenThereAreTooMany) {
  DeckErrors errors("d.yaml", {});
  EXPECT_THROW(for (int line = 1; line <= 100'000; ++line) errors.add({{line, 1}, -1}, "wrong " + std::to_string(line)),
               InputError);
}

TEST(DeckErrors, AreSilentWithoutErrors) {
  DeckErrors errors("d.yaml", {});
  errors.warn({{3, 4}, -1}, "odd");
  EXPECT_EQ(text_of(errors), "");
  EXPECT_THAT(errors.warnings(), testing::ElementsAre("d.yaml:3:4: warning: odd"));
}

}  // namespace
}  // namespace percuss
