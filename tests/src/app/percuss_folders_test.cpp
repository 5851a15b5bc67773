// Folders of results that are in use, that would lose results, and that a run has left.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/app/folder/lock_holder.hpp"
#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

// Flies until it is stopped; every step takes 1e-3.
const char* const cube = R"yaml(title: A cube flies
time: {end: 1.0e+9, max_step: 1.0e-3}
parts: {cube: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: soft}}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{velocity: [0, 0, 1], angular_velocity: [1, 2, 3]}]
output: {history: {every: 0}}
)yaml";

class PercussFolders : public testing::TestWithParam<int> {
 protected:
  std::string launch() const { return GetParam() == 1 ? "" : launch_on(GetParam()); }
  std::vector<std::string> run(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"run", deck_, "-o", out_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  bool is_locked() const { return fs::exists(out_ + "/run.lock"); }
  std::string read_lock() const {
    std::ifstream file(out_ + "/run.lock");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
  std::string deck_ = folder_.write("deck.yaml", cube), out_ = folder_.path() + "/out";
};

TEST_P(PercussFolders, ASecondRunIsRefusedAndNamesTheFirst) {
  std::vector<ProcessResult> others;
  std::string lock, info;
  const ProcessResult first = disturb_percuss(
      run({}), out_ + "/summary.json",
      [&](int process) {
        others.push_back(run_percuss(run({}), launch()));
        others.push_back(run_percuss(run({"--force"}), launch()));
        info = run_percuss({"info", out_}).out;
        lock = read_lock();
        kill(process, SIGUSR1);
      },
      launch());
  EXPECT_EQ(first.exit_code, 130) << first.err;
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "interrupted");
  ASSERT_EQ(others.size(), 2);
  for (const ProcessResult& other : others) {
    EXPECT_EQ(other.exit_code, 2) << other.err;
    EXPECT_EQ(count(other.err, "run.lock: error: another run writes into this folder (process "), 1) << other.err;
    EXPECT_THAT(other.err, HasSubstr("run " + deck_ + " -o " + out_));
  }
  EXPECT_THAT(lock, AllOf(HasSubstr("host: "), HasSubstr("process: "), HasSubstr("started: "), HasSubstr("command: ")));
  EXPECT_THAT(info, AllOf(HasSubstr("run       a run is under way (process "), HasSubstr("status    running")));
  EXPECT_FALSE(is_locked());
}

TEST_P(PercussFolders, AreUnlockedAtEveryEnd) {
  for (const auto& [setting, code] :
       {std::pair("time.max_steps=3", 0), std::pair("initial=[{part: none, velocity: [0, 0, 1]}]", 2),
        std::pair("initial=[{part: {name: cube, inside: [[8, 8, 8], [9, 9, 9]]}, velocity: [0, 0, 1]}]", 2),
        std::pair("audit={max_energy_error: 1e-30}", 3)}) {
    const ProcessResult result = run_percuss(run({"--force", "--set", setting}), launch());
    EXPECT_EQ(result.exit_code, code) << setting << ": " << result.err;
    EXPECT_FALSE(is_locked()) << setting;
  }
}

TEST_P(PercussFolders, ARunThatWasKilledGoesOnInItsFolderWithoutForce) {
  const std::string every = "output.checkpoint={wall: 1e-300}", whole = folder_.path() + "/whole";
  disturb_percuss(
      run({"--set", every}), out_ + "/checkpoint.h5",
      [&](int) { kill(static_cast<int>(parse_holder(read_lock()).process), SIGKILL); }, launch());
  EXPECT_EQ(read_summary(out_ + "/summary.json").status, "running");
  fs::rename(out_ + "/run.lock", folder_.path() + "/aside");  // as where the run could not write its end
  EXPECT_THAT(run_percuss({"info", out_}).out,
              HasSubstr("it was killed or could not write its final summary: the summary says"));
  fs::rename(folder_.path() + "/aside", out_ + "/run.lock");
  const ProcessResult result = run_percuss({"run", deck_, "--restart", out_, "--set", "time.max_steps=2000"}, launch());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(count(result.err, "note: an earlier run in this folder was killed"), 1) << result.err;
  EXPECT_FALSE(is_locked());
  ASSERT_EQ(run_percuss({"run", deck_, "-o", whole, "--set", "time.max_steps=2000"}).exit_code, 0);
  EXPECT_EQ(read_summary(out_ + "/summary.json").state_hash, read_summary(whole + "/summary.json").state_hash);
}

TEST_P(PercussFolders, LoseNothingByARestartUnlessForced) {
  const std::string checkpoint = out_ + "/checkpoint.h5";
  ASSERT_EQ(run_percuss(run({"--set", "time.end=0.01", "--set", "output.checkpoint={every: 0.01}"})).exit_code, 0);
  ASSERT_EQ(run_percuss({"run", deck_, "--restart", out_, "--set", "time.end=0.02", "--set",
                         "output.checkpoint={at_end: false}"},
                        launch())
                .exit_code,
            0);
  const std::vector<std::string> again{"run", deck_, "--restart", out_, "--set", "time.end=0.01"};
  const ProcessResult refused = run_percuss(again, launch());
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_EQ(
      count(refused.err, "10 rows of history.csv up to t = 0.02, the summary of a run that was completed at t = 0.02"),
      1)
      << refused.err;
  EXPECT_DOUBLE_EQ(read_summary(out_ + "/summary.json").time, 0.02);
  std::vector<std::string> forced = again;
  forced.push_back("--force");
  const ProcessResult done = run_percuss(forced, launch());
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(count(done.err, "note: removed, since --force is given: 10 rows"), 1) << done.err;
  EXPECT_DOUBLE_EQ(read_summary(out_ + "/summary.json").time, 0.01);
}

TEST_P(PercussFolders, KeepTheCheckpointThatALinkLeadsTo) {
  const std::string checkpoint = out_ + "/checkpoint.h5", link = folder_.path() + "/link.h5",
                    moved = folder_.path() + "/moved.h5";
  ASSERT_EQ(run_percuss(run({"--set", "time.end=0.01", "--set", "output.checkpoint={every: 0.01}"})).exit_code, 0);
  fs::create_symlink(checkpoint, link);
  const std::vector<std::string> again = run({"--restart", link, "--force", "--set", "time.end=0.02"});
  const ProcessResult done = run_percuss(again, launch());
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_TRUE(fs::exists(checkpoint));
  fs::rename(checkpoint, moved);
  fs::create_symlink(moved, checkpoint);
  const ProcessResult refused = run_percuss(again, launch());
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_EQ(count(refused.err, "link.h5: error: --force would remove this checkpoint"), 1) << refused.err;
  EXPECT_TRUE(fs::exists(checkpoint));
}

TEST_P(PercussFolders, AnEmptyNameOfACheckpointDeletesNothing) {
  ASSERT_EQ(run_percuss(run({"--set", "time.max_steps=3"})).exit_code, 0);
  EXPECT_EQ(run_percuss(run({"--restart", "", "--force"}), launch()).exit_code, 2);
  EXPECT_EQ(read_summary(out_ + "/summary.json").steps, 3);
}

INSTANTIATE_TEST_SUITE_P(OnRanks, PercussFolders, testing::Values(1, 2));

}  // namespace
}  // namespace percuss
