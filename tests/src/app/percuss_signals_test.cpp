// The executable is asked to stop: by which signals, when, and what it leaves.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "src/app/folder/lock_holder.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

// Flies until it is stopped.
const char* const blocks = R"yaml(title: Two blocks fly
time: {end: 1.0e+9}
parts:
  one: {box: {size: [1, 1, 1], cells: [8, 8, 8]}, material: soft}
  two: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0, 0, 3], material: soft}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: one, velocity: [0, 0, 0.1], angular_velocity: [0, 0, 1]}]
output: {history: {every: 0}}
)yaml";

class PercussSignals : public testing::Test {
 protected:
  std::vector<std::string> run() const { return {"run", deck_, "-o", out_}; }
  std::string read(const std::string& path) const {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
  std::string deck_ = folder_.write("deck.yaml", blocks), out_ = folder_.path() + "/out";
};

/// What starts percuss with a signal that has arrived, and is held back until the program can take it; on ranks only
/// where a condition of the shell holds.
std::string arrive_first(const std::string& signal, const std::string& condition = "true") {
  return " env --block-signal=" + signal + " sh -c 'if " + condition + "; then kill -" + signal +
         " $$; fi; exec \"$@\"' sh";
}

TEST_F(PercussSignals, ThatAskForAStopAllLeaveACheckpoint) {
  for (const int number : {SIGINT, SIGTERM, SIGUSR1, SIGHUP, SIGXCPU}) {
    const std::string out = out_ + std::to_string(number);
    const ProcessResult result =
        interrupt_percuss({"run", deck_, "-o", out}, out + "/history.csv", number, "env --default-signal=HUP,INT");
    EXPECT_EQ(result.exit_code, 130) << number << ": " << result.err;
    EXPECT_EQ(read_summary(out + "/summary.json").status, "interrupted");
    EXPECT_GT(read_checkpoint_header(out + "/checkpoint.h5").step, 0);
    EXPECT_FALSE(fs::exists(out + "/run.lock"));
  }
}

TEST_F(PercussSignals, MayBeFilesInTheFolderOfResults) {
  std::string text = blocks;
  text.replace(text.find("{history: {every: 0}}"), 21,
               "{history: {every: 1e9}, fields: {every: 1e9, write: [velocity]}}");
  const std::string frames = folder_.write("asked.yaml", text);
  const auto ask = [&](const char* what) {
    std::ofstream(out_ + "/" + what);
    while (fs::exists(out_ + "/" + what)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  const ProcessResult result = disturb_percuss({"run", frames, "-o", out_}, out_ + "/summary.json", [&](int) {
    for (const char* what : {"frame", "checkpoint", "stop"}) ask(what);
  });
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "interrupted");
  EXPECT_TRUE(fs::exists(out_ + "/checkpoint_previous.h5"));
  const std::string history = read(out_ + "/history.csv");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 4);  // heading, start, what was requested, the end
}

TEST_F(PercussSignals, ByFilesDuringStartUpActAtTheFirstLook) {
  std::string text = blocks;
  text.replace(text.find("cells: [8, 8, 8]"), 16, "cells: [40, 40, 40]");
  const std::vector<std::string> large{
      "run", folder_.write("large.yaml", text), "-o", out_, "--force", "--set", "time.max_steps=2000"};
  const ProcessResult result =
      disturb_percuss(large, out_ + "/run.lock", [&](int) { std::ofstream(out_ + "/stop").flush(); });
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "interrupted");
  EXPECT_FALSE(fs::exists(out_ + "/stop"));
}

TEST_F(PercussSignals, ByFilesToAnEarlierRunAreRemoved) {
  fs::create_directory(out_);
  for (const char* what : {"frame", "checkpoint", "stop"}) {
    const std::string file = out_ + "/" + what;
    std::ofstream(file).flush();
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
  }
  const std::vector<std::string> few{
      "run", deck_, "-o", out_, "--set", "time.max_steps=3", "--set", "output.checkpoint={at_end: false}"};
  EXPECT_EQ(run_percuss(few).exit_code, 2);
  EXPECT_TRUE(fs::exists(out_ + "/stop"));  // perhaps another program's
  std::vector<std::string> forced = few;
  forced.push_back("--force");
  EXPECT_EQ(run_percuss(forced).exit_code, 0);
  EXPECT_EQ(read_summary(out_ + "/summary.json").steps, 3);
  for (const char* what : {"frame", "checkpoint", "stop", "checkpoint.h5"}) EXPECT_FALSE(fs::exists(out_ + "/" + what));
}

TEST_F(PercussSignals, DuringStartUpEndARunBeforeItHasChangedAFile) {
  for (const char* signal : {"INT", "TERM", "USR1", "HUP", "XCPU"}) {
    const ProcessResult result = run_percuss(run(), arrive_first(signal));
    EXPECT_EQ(result.exit_code, 130) << signal << ": " << result.err;
    EXPECT_EQ(count(result.err, "percuss: interrupted before the deck was read"), 1) << result.err;
    EXPECT_FALSE(fs::exists(out_));
  }
}

TEST_F(PercussSignals, DuringStartUpOfOneRankEndAllRanks) {
  const ProcessResult result = run_percuss(run(), launch_on(2) + arrive_first("TERM", "[ $OMPI_COMM_WORLD_RANK = 1 ]"));
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(count(result.err, "percuss: interrupted before the deck was read"), 1) << result.err;
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(PercussSignals, DuringStartUpLeaveEarlierResults) {
  ASSERT_EQ(run_percuss({"run", deck_, "-o", out_, "--set", "time.max_steps=3"}).exit_code, 0);
  const std::string before = read(out_ + "/history.csv");
  std::vector<std::string> again = run();
  again.push_back("--force");
  EXPECT_EQ(run_percuss(again, arrive_first("USR1")).exit_code, 130);
  EXPECT_EQ(read(out_ + "/history.csv"), before);
}

TEST_F(PercussSignals, EndCommandsThatLeaveNothingBehindAtOnce) {
  EXPECT_EQ(run_percuss({"check", deck_}, arrive_first("USR1")).exit_code, -SIGUSR1);
}

/// Whether a number is in a set of signals of /proc/PID/status.
bool is_in_set(int process, const std::string& set, int number) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(set + ":"))
      return (std::stoull(line.substr(set.size() + 1), nullptr, 16) >> (number - 1) & 1) != 0;
  }
  return false;
}

TEST_F(PercussSignals, AHangUpThatIsIgnoredStaysIgnored) {
  for (const bool is_ignored : {true, false}) {
    const std::string out = out_ + (is_ignored ? "1" : "0");
    bool seen_ignored = false, seen_caught = false;
    disturb_percuss(
        {"run", deck_, "-o", out}, out + "/history.csv",
        [&](int process) {
          seen_ignored = is_in_set(process, "SigIgn", SIGHUP);
          seen_caught = is_in_set(process, "SigCgt", SIGHUP);
          kill(process, SIGUSR1);
        },
        is_ignored ? "nohup" : "env --default-signal=HUP");
    EXPECT_EQ(seen_ignored, is_ignored);
    EXPECT_NE(seen_caught, is_ignored);
  }
}

// mpirun kills its ranks soon after a signal: what is needed to continue must be there by then, and the folder must
// tell.
TEST_F(PercussSignals, ARunThatIsKilledSaysSoInItsFolder) {
  const ProcessResult result = interrupt_percuss(run(), out_ + "/summary.json", SIGKILL);
  EXPECT_EQ(result.exit_code, -SIGKILL);
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "running");
  const ProcessResult info = run_percuss({"info", out_});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("the last run was killed (process "), HasSubstr("status    running")));
  const ProcessResult again = run_percuss({"run", deck_, "-o", out_, "--force", "--set", "time.max_steps=3"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(count(again.err, "note: an earlier run in this folder was killed (process "), 1) << again.err;
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "completed");
  EXPECT_FALSE(fs::exists(out_ + "/run.lock"));
}

// Open MPI's mpirun sends its ranks SIGCONT first when it is about to end them.
TEST_F(PercussSignals, ARankThatIsToContinueLeavesACheckpointAndGoesOn) {
  bool is_written = false;
  const ProcessResult result = disturb_percuss(
      run(), out_ + "/history.csv",
      [&](int process) {
        kill(static_cast<int>(parse_holder(read(out_ + "/run.lock")).process), SIGCONT);
        for (int wait = 0; wait < 6000 && !is_written; ++wait) {
          is_written = fs::exists(out_ + "/checkpoint.h5");
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        kill(process, SIGUSR1);
      },
      launch_on(2));
  EXPECT_TRUE(is_written);
  EXPECT_EQ(result.exit_code, 130) << result.err;
  const std::string older = find_previous_checkpoint(out_ + "/checkpoint.h5");
  EXPECT_LT(read_checkpoint_header(older).step, read_checkpoint_header(out_ + "/checkpoint.h5").step);
}

#ifndef PERCUSS_SANITIZED  // sanitizers need larger stacks than these, and more address space
TEST_F(PercussSignals, AStackThatIsTooSmallIsToldInsteadOfASignal) {
  const ProcessResult result = run_percuss(run(), "sh -c 'ulimit -s 64; exec \"$@\"' sh env OMP_NUM_THREADS=2");
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_THAT(result.err, HasSubstr("percuss: error: the stack is limited to 64 KiB (a run needs at least 512 KiB)"));
  // Where only the soft limit is small, it is raised.
  std::vector<std::string> few = run();
  few.insert(few.end(), {"--set", "time.max_steps=3"});
  const ProcessResult raised = run_percuss(few, "sh -c 'ulimit -S -s 64; exec \"$@\"' sh env OMP_NUM_THREADS=2");
  EXPECT_EQ(raised.exit_code, 0) << raised.err;
}

TEST_F(PercussSignals, ThreadsThatCannotBeStartedAreToldInsteadOfASignal) {
  for (const std::string& launch : {std::string(), launch_on(2) + " env"}) {
    const ProcessResult many =
        run_percuss(run(), launch.empty() ? "env OMP_NUM_THREADS=100000" : launch + " OMP_NUM_THREADS=100000");
    EXPECT_EQ(many.exit_code, 4) << many.err;
    EXPECT_EQ(count(many.err, "percuss: error: 100000 threads are too many for one rank (it can have 512)"), 1)
        << many.err;
  }
  std::vector<std::string> few_steps = run();
  few_steps.insert(few_steps.end(), {"--set", "time.max_steps=3"});
  const ProcessResult refused =
      run_percuss(few_steps, "sh -c 'ulimit -s 8192; ulimit -v 3000000; exec \"$@\"' sh env OMP_NUM_THREADS=500");
  EXPECT_EQ(refused.exit_code, 4) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("percuss: error: 500 threads cannot be started ("));
}
#endif

}  // namespace
}  // namespace percuss
