// The executable in a machine that fails it: a folder of results that is lost on the way, memory that is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "src/output/checkpoint_file.hpp"
#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Flies until it is stopped; a checkpoint after every step if nothing else is said.
const char* const blocks = R"yaml(title: Two blocks fly
time: {end: 1.0e+9}
parts:
  one: {box: {size: [1, 1, 1], cells: [8, 8, 8]}, material: soft}
  two: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0, 0, 3], material: soft}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: one, velocity: [0, 0, 0.1], angular_velocity: [0, 0, 1]}]
output: {history: {every: 0}, checkpoint: {wall: 1.0e-300}}
)yaml";

class PercussFaults : public testing::TestWithParam<int> {
 protected:
  std::string launch() const { return GetParam() == 1 ? "" : launch_on(GetParam()); }

  /// A run, once it is under way, loses its folder by `lose` and is stopped, for which it writes a checkpoint.
  ProcessResult stop_without_folder(const std::function<void()>& lose) const {
    return disturb_percuss(
        {"run", deck_, "-o", out_, "--set", "output.checkpoint.wall=1e300"}, out_ + "/summary.json",
        [&](int process) {
          lose();
          kill(process, GetParam() == 1 ? SIGINT : SIGUSR1);  // mpirun leaves its ranks only a second after SIGINT
        },
        launch());
  }

  TemporaryFolder folder_;
  std::string deck_ = folder_.write("deck.yaml", blocks), out_ = folder_.path() + "/out";
};

TEST_P(PercussFaults, AFolderThatBecomesAFileEndsTheRunWithOneMessage) {
  const ProcessResult result = stop_without_folder([&] {
    fs::rename(out_, folder_.path() + "/moved");
    std::ofstream(out_) << "no folder";
  });
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(out_ + "/checkpoint.h5"));
  EXPECT_EQ(count(result.err, "--restart"), 0) << result.err;  // there is none
  EXPECT_GT(fs::file_size(folder_.path() + "/moved/history.csv"), 0);
}

TEST_P(PercussFaults, AFolderThatIsRemovedEndsTheRunWithOneMessage) {
  const ProcessResult result = stop_without_folder([&] { fs::remove_all(out_); });
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(out_ + "/checkpoint.h5"));
}

TEST_P(PercussFaults, CheckpointsByTheClockAreAgreedOn) {
  const ProcessResult result = run_percuss({"run", deck_, "-o", out_, "--set", "time.max_steps=6"}, launch());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_checkpoint_header(out_ + "/checkpoint.h5").step, 6);
  EXPECT_EQ(read_checkpoint_header(out_ + "/checkpoint_previous.h5").step, 5);
}

#ifndef PERCUSS_SANITIZED  // sanitizers take terabytes of addresses for themselves
TEST_P(PercussFaults, MemoryThatIsRefusedEndsTheRunWithOneMessage) {
  // Enough for the program itself; the mesh alone takes more.
  const ProcessResult result = run_percuss({"run", deck_, "-o", out_, "--set", "parts.one.box.cells=[300, 300, 300]"},
                                           launch() + " sh -c 'ulimit -v 2000000; exec \"$@\"' sh");
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("percuss: error: memory is exhausted (the scene is too large for this machine)"));
  EXPECT_FALSE(fs::exists(out_ + "/run.lock"));
}
#endif

INSTANTIATE_TEST_SUITE_P(OnRanks, PercussFaults, testing::Values(1, 2));

}  // namespace
}  // namespace percuss
