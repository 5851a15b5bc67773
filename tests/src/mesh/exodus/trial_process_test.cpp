#include "src/mesh/formats/exodus/trial_process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "src/error.hpp"

namespace percuss {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::StrEq;
using testing::ThrowsMessage;

TEST(TrialProcess, PassesWithoutChangingThisProcess) {
  int value = 1;
  run_trial_process([&] { value = 2; }, 60);
  EXPECT_EQ(value, 1);
}

TEST(TrialProcess, HandsErrorsBack) {
  const std::string text(100000, 'x');  // more than a pipe holds at once
  EXPECT_THAT([&] { run_trial_process([&] { throw InputError(text); }, 60); }, ThrowsMessage<InputError>(StrEq(text)));
  EXPECT_THAT([&] { run_trial_process([] { throw SystemError("full"); }, 60); },
              ThrowsMessage<SystemError>(StrEq("full")));
  EXPECT_THAT([&] { run_trial_process([] { throw std::runtime_error("odd"); }, 60); },
              ThrowsMessage<SystemError>(StrEq("odd")));
}

TEST(TrialProcess, SurvivesACrash) {
  EXPECT_THAT([] { run_trial_process([] { std::abort(); }, 60); }, ThrowsMessage<InputError>(HasSubstr("crashes")));
}

TEST(TrialProcess, TakesALibraryThatEndsTheProcessForACrash) {
  EXPECT_THAT([] { run_trial_process([] { _exit(66); }, 60); }, ThrowsMessage<InputError>(HasSubstr("crashes")));
}

TEST(TrialProcess, EndsAHang) {
  EXPECT_THAT(
      [] {
        run_trial_process(
            [] {
              for (;;) pause();
            },
            1);
      },
      ThrowsMessage<InputError>(HasSubstr("hangs")));
}

TEST(TrialProcess, OfARehearsalOnlyCrashesAndHangsAreTold) {
  rehearse("a.h5", 0, [] { throw InputError("told in earnest"); });
  rehearse("a.h5", 0, [] { throw std::runtime_error("likewise"); });
  EXPECT_THAT([] { rehearse("a.h5", 0, [] { std::abort(); }); },
              ThrowsMessage<InputError>(AllOf(StartsWith("a.h5: error: "), HasSubstr("crashes"))));
}

TEST(TrialProcess, HasPatienceWithLargeFiles) {
  EXPECT_EQ(find_patience(0), 60u);
  EXPECT_EQ(find_patience(5'000'000'000), 60u + 5000u);
  EXPECT_EQ(find_patience(UINTMAX_MAX), 86400u);
}

TEST(TrialProcess, KeepsTheTrialSilent) {
  testing::internal::CaptureStderr();
  run_trial_process([] { write(STDERR_FILENO, "noise", 5) == 5 ? _exit(0) : _exit(1); }, 60);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace percuss
