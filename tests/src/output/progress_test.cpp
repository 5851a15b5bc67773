// The progress of a run, in the styles for a terminal and for log files.

#include "src/output/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace percuss {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Stream open_stream() { return {std::tmpfile(), std::fclose}; }

std::string read_all(const Stream& stream) {
  std::string text;
  std::rewind(stream.get());
  for (int c = std::fgetc(stream.get()); c != EOF; c = std::fgetc(stream.get())) text += static_cast<char>(c);
  return text;
}

ProgressState state_at(double share) {
  ProgressState state;
  state.step = std::lround(1000 * share);
  state.time = 2e-3 * share;
  state.end_time = 2e-3;
  state.dt = 2e-6;
  state.energy_error = 3.2e-4;
  state.contacts = 17;
  return state;
}

TEST(Progress, IsPlainWhereThereIsNoTerminal) {
  const auto stream = open_stream();
  EXPECT_EQ(Progress::choose_style(stream.get()), Progress::Style::plain);
}

TEST(Progress, PrintsOnePlainLineATenth) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::plain);
  for (int step = 0; step <= 1000; ++step) progress.report(state_at(step / 1000.0));
  const std::string text = read_all(stream);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);  // 0 % to 100 %
  EXPECT_THAT(text, Not(HasSubstr("\r")));
  EXPECT_THAT(text, HasSubstr("\n 50.0 %  t = 1.0000e-03  step 500  dt 2.00e-06 "));
  EXPECT_THAT(text, HasSubstr("energy error 3.2e-04  contacts 17\n"));
}

TEST(Progress, EndsThePlainLinesWithTheTimeTaken) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::plain);
  progress.report(state_at(0));
  progress.finish(state_at(1));
  EXPECT_THAT(read_all(stream), HasSubstr("\n100.0 %  t = 2.0000e-03  step 1000"));
  EXPECT_THAT(read_all(stream), HasSubstr(" steps/s  took 0 s  energy error"));
}

TEST(Progress, OverwritesTheLiveLineAndEndsIt) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::live);
  progress.report(state_at(0.25));
  EXPECT_THAT(read_all(stream), StartsWith("\r 25.0 %  t = 5.0000e-04  step 250"));
  EXPECT_THAT(read_all(stream), Not(HasSubstr("\n")));
  progress.finish(state_at(1));
  const std::string text = read_all(stream);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, LeavesItsLineToSomethingElse) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::live);
  progress.clear();
  EXPECT_EQ(read_all(stream), "");
  progress.report(state_at(0.25));
  progress.clear();
  progress.clear();
  const std::string text = read_all(stream);
  EXPECT_THAT(text, testing::EndsWith("\r\x1b[K"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
}

TEST(Progress, DoesNotKnowWhenItEndsBeforeAnythingIsDone) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::plain);
  progress.report(state_at(0));
  EXPECT_THAT(read_all(stream), HasSubstr("ETA ?  "));
}

TEST(Progress, SaysNothingWhenQuiet) {
  const auto stream = open_stream();
  Progress progress(stream.get(), Progress::Style::quiet);
  progress.report(state_at(0.5));
  progress.finish(state_at(1));
  EXPECT_EQ(read_all(stream), "");
}

}  // namespace
}  // namespace percuss
