// Messages are sorted, said once, and end somewhere.

#include "src/deck/text/deck_errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "src/error.hpp"
#include "tests/expect_error.hpp"

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
  EXPECT_ERROR(for (int line = 1; line <= 100'000; ++line) errors.add({{line, 1}, -1}, "wrong " + std::to_string(line)),
               InputError, "too many errors");
}

TEST(DeckErrors, AreSilentWithoutErrors) {
  DeckErrors errors("d.yaml", {});
  errors.warn({{3, 4}, -1}, "odd_value", "odd");
  EXPECT_EQ(text_of(errors), "");
  ASSERT_EQ(errors.warnings().size(), 1U);
  EXPECT_EQ(format_warning(errors.warnings()[0]), "d.yaml:3:4: warning: odd [odd_value]");
}

TEST(DeckErrors, WarningsThatRepeatBecomeOneWithACount) {
  DeckErrors errors("d.yaml", {});
  for (int line = 10; line >= 1; --line) errors.warn({{line, 1}, -1}, "odd_value", "odd");
  const std::vector<Warning> warnings = errors.warnings();
  ASSERT_EQ(warnings.size(), 4U);
  EXPECT_EQ(format_warning(warnings[0]), "d.yaml:1:1: warning: odd [odd_value]");
  EXPECT_EQ(format_warning(warnings[3]), "d.yaml: warning: odd [odd_value] (7 times)");
}

}  // namespace
}  // namespace percuss
