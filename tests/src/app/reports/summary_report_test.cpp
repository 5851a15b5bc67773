// Report of `percuss info` on a summary.

#include "src/app/reports/summary_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SummaryReport, TellsOfErodedElementsWhereThereAreAny) {
  Summary summary;
  summary.elements = 8400;
  EXPECT_THAT(format_summary(summary), Not(HasSubstr("eroded")));
  summary.eroded = {123, 4.5, 6789};
  EXPECT_THAT(format_summary(summary),
              HasSubstr("\neroded    123 of 8400 elements failed and were eroded, mass 4.5, energy 6789\n"));
}

TEST(SummaryReport, TellsWhatContactTookAboveFivePercent) {
  Summary summary;
  summary.energy.contact_taken = 0.49;
  summary.energy.largest = 10;
  EXPECT_THAT(format_summary(summary), Not(HasSubstr("contact took")));
  summary.energy.contact_taken = 5;
  EXPECT_THAT(format_summary(summary), HasSubstr("normal contact took 5, 50 % of the largest energy ("));
}

TEST(SummaryReport, SaysThatTheNumberOfStepsHasEndedARun) {
  Summary summary;
  summary.status = "completed";
  summary.time = 2.9e-2;
  EXPECT_THAT(format_summary(summary), HasSubstr("status    completed\n")) << "the end of older runs is not known";
  summary.end_time = 1;
  EXPECT_THAT(format_summary(summary),
              HasSubstr("status    completed, stopped by time.max_steps at 2.9 % of time.end\n"));
  summary.status = "interrupted";
  EXPECT_THAT(format_summary(summary), HasSubstr("status    interrupted\n"));
  summary.status = "completed";
  summary.time = 1 - 1e-12;
  EXPECT_THAT(format_summary(summary), HasSubstr("status    completed\n"));
}

}  // namespace
}  // namespace percuss
