// Warnings that are printed, counted, silenced and kept.

#include "src/output/warning_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/error.hpp"
#include "tests/expect_error.hpp"

namespace percuss {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A log and what it has told.
struct ToldLog {
  explicit ToldLog(std::set<std::string> silenced = {})
      : log(std::move(silenced), [this](const Warning& warning) { told.push_back(format_warning(warning)); }) {}
  std::vector<std::string> told;
  WarningLog log;
};

std::vector<std::string> format_all(const std::vector<Warning>& warnings) {
  std::vector<std::string> lines;
  for (const Warning& warning : warnings) lines.push_back(format_warning(warning));
  return lines;
}

TEST(WarningLog, TellsAWarningOnceAndCountsItWhenItComesAgain) {
  ToldLog told;
  for (int step = 1; step <= 3; ++step) told.log.add({"unconverged_contact", "left over", "", 0.5 * step, 1});
  told.log.add({"unconverged_contact", "left over", "walls.0", 2, 1});
  EXPECT_THAT(told.told, ElementsAre("warning: left over [unconverged_contact] (t = 0.5)",
                                     "walls.0: warning: left over [unconverged_contact] (t = 2)"));
  EXPECT_THAT(format_all(told.log.list()),
              ElementsAre("warning: left over [unconverged_contact] (first at t = 0.5, 3 times)",
                          "walls.0: warning: left over [unconverged_contact] (t = 2)"));
}

TEST(WarningLog, RenewsTheFiguresOfAWarningOfOnePlace) {
  ToldLog told;
  told.log.renew({"inverted_corners", "3 elements", "part 'a'", 0.5, 1});
  told.log.renew({"inverted_corners", "1 element", "part 'b'", 0.5, 1});
  told.log.renew({"inverted_corners", "4 elements", "part 'a'", 1, 1});
  EXPECT_EQ(told.told.size(), 2U);
  EXPECT_THAT(format_all(told.log.list()),
              ElementsAre("part 'a': warning: 4 elements [inverted_corners] (first at t = 0.5, 2 times)",
                          "part 'b': warning: 1 element [inverted_corners] (t = 0.5)"));
}

TEST(WarningLog, DropsWhatIsSilencedHoweverItComes) {
  ToldLog told({"idle_ranks"});
  const Warning idle{"idle_ranks", "1 of 2", "", 0, 1};
  told.log.add(idle);
  told.log.renew(idle);
  told.log.restore({idle, {"behind_wall", "behind", "", 0, 1}});
  EXPECT_THAT(told.told, IsEmpty());
  EXPECT_THAT(format_all(told.log.list()), ElementsAre("warning: behind [behind_wall]"));
}

TEST(WarningLog, GoesOnCountingWhatAnEarlierPartOfTheRunHasTold) {
  ToldLog told;
  told.log.restore({{"unconverged_contact", "left over", "", 0.5, 7}});
  told.log.add({"unconverged_contact", "left over", "", 3, 1});
  EXPECT_THAT(told.told, IsEmpty());
  EXPECT_THAT(format_all(told.log.list()),
              ElementsAre("warning: left over [unconverged_contact] (first at t = 0.5, 8 times)"));
}

TEST(WarningLog, IsWrittenAndReadBack) {
  const std::vector<Warning> warnings = {{"a_rule", "a \"text\"\nof lines", "part 'x'", 0.1, 2}, {"", "", "", 0, 1}};
  EXPECT_EQ(format_all(read_warnings(write_warnings(warnings))), format_all(warnings));
  EXPECT_THAT(read_warnings(write_warnings({})), IsEmpty());
  for (const char* wrong : {"", "{}", "[1]", "[{\"rule\": \"a\"}]"})
    EXPECT_ERROR(read_warnings(wrong), InputError, "not a list of warnings");
}

TEST(CountWarnings, KnowsOneFromMany) {
  EXPECT_EQ(count_warnings(std::vector<Warning>(1)), "1 warning");
  EXPECT_EQ(count_warnings(std::vector<Warning>(3)), "3 warnings");
}

}  // namespace
}  // namespace percuss
