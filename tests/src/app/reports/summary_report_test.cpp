// What `percuss info` tells of a summary.

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

}  // namespace
}  // namespace percuss
