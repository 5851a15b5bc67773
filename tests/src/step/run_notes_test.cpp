// What a run says at its end, by the numbers of its summary.

#include "src/step/run_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace percuss::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Summary make_summary(double internal, double hourglass, double initial) {
  Summary summary;
  summary.steps = 40;
  summary.energy.initial = initial;
  summary.energy.internal = internal;
  summary.energy.hourglass = hourglass;
  return summary;
}

std::vector<std::string> find_texts(const Summary& summary) {
  std::vector<std::string> texts;
  for (const Warning& warning : find_end_warnings(summary)) texts.push_back(warning.rule + ": " + warning.text);
  return texts;
}

TEST(RunNotes, ARunWithoutDoubtsEndsInSilence) {
  EXPECT_THAT(find_texts(make_summary(0, 0, 100)), IsEmpty());
  EXPECT_THAT(find_texts(make_summary(10, 0.99, 100)), IsEmpty());
}

TEST(RunNotes, TellHourglassModesAboveATenthOfTheInternalEnergy) {
  EXPECT_THAT(find_texts(make_summary(10, 2.5, 100)), ElementsAre(HasSubstr("hold 25 % of the internal")));
}

TEST(RunNotes, DoNotTellHourglassModesOfEnergiesThatNobodySees) {
  EXPECT_THAT(find_texts(make_summary(1e-2, 5e-3, 100)), IsEmpty());
  Summary loaded = make_summary(1e-2, 5e-3, 0);
  loaded.energy.external = -100;  // taken out
  EXPECT_THAT(find_texts(loaded), IsEmpty());
}

TEST(RunNotes, TellContactThatGivesEnergy) {
  Summary summary = make_summary(0, 0, 100);
  summary.energy.contact = 0.9;
  EXPECT_THAT(find_texts(summary), IsEmpty());
  summary.energy.contact = 30;
  EXPECT_THAT(find_texts(summary), ElementsAre(HasSubstr("given 30 of energy, 30 %")));
  summary.energy.initial = 0;  // began at rest
  EXPECT_THAT(find_texts(summary), ElementsAre(HasSubstr("given 30 of energy: look")));
}

}  // namespace
}  // namespace percuss::test
