// The executable in a machine that fails it: a folder of results that is lost on the way, memory that is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/output/checkpoint/checkpoint_file.hpp"
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
  EXPECT_THAT(result.err, HasSubstr("cannot write '" + out_ + "/"));
  EXPECT_EQ(count(result.err, "percuss run"), 0) << result.err;  // there is none
  EXPECT_GT(fs::file_size(folder_.path() + "/moved/history.csv"), 0);
}

TEST_P(PercussFaults, AFolderThatIsRemovedEndsTheRunWithOneMessage) {
  const ProcessResult result = stop_without_folder([&] { fs::remove_all(out_); });
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cannot write '" + out_ + "/"));
}

// A frame is written every step, and rows within a second.
TEST_P(PercussFaults, AFileThatIsTakenAwayStopsTheRunWithACheckpoint) {
  for (const std::string file : {"history.csv", "fields.vtkhdf"}) {
    for (const bool replaced : {false, true}) {
      SCOPED_TRACE(file + (replaced ? " replaced" : " removed"));
      const std::string path = out_ + "/" + file;
      const ProcessResult result = disturb_percuss(
          {"run", deck_, "-o", out_, "--force", "--set", "output.checkpoint.wall=1e300", "--set",
           "output.fields.every=0.1", "--set", "time.end=1e5"},
          out_ + "/fields.xdmf",
          [&](int) {
            fs::rename(path, path + ".moved");
            if (replaced) std::ofstream(path) << "mine";
          },
          launch());
      EXPECT_EQ(result.exit_code, 4) << result.err;
      EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
      EXPECT_THAT(result.err,
                  HasSubstr("cannot write '" + path + "' (it was removed or replaced while the run wrote it)"));
      EXPECT_THAT(result.err, HasSubstr("--restart " + out_ + "/checkpoint.h5"));
      EXPECT_EQ(fs::exists(path), replaced);
      if (replaced) {
        EXPECT_EQ(fs::file_size(path), 4);
      }
      const std::string step = std::to_string(read_checkpoint_header(out_ + "/checkpoint.h5").step + 2);
      const ProcessResult again = run_percuss({"run", deck_, "-o", out_ + "_again", "--force", "--restart",
                                               out_ + "/checkpoint.h5", "--set", "time.max_steps=" + step});
      EXPECT_EQ(again.exit_code, 0) << again.err;
      fs::remove_all(out_);
    }
  }
}

// Open MPI cannot have memory that ranks share, which is a file, below such a limit: they send by loopback.
TEST_P(PercussFaults, AFileSizeLimitEndsTheRunWithItsReason) {
  for (const char* limit : {"1", "16", "300", "2000"}) {  // below the first bytes of a file, and within each of them
    SCOPED_TRACE(limit);
    const ProcessResult result = run_percuss(
        {"run", deck_, "-o", out_, "--force", "--set", "output.fields.every=0.1", "--set", "time.end=1e5", "--set",
         "time.max_steps=3", "--set", "silence=[idle_part, no_contact, output_count]"},  // stderr is limited, too
        launch() + " env OMPI_MCA_btl=self,tcp OMPI_MCA_btl_tcp_if_include=lo sh -c 'ulimit -f " + limit +
            "; exec \"$@\"' sh");
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("File too large): raise the limit on file sizes (ulimit -f)"));
    EXPECT_EQ(count(result.err, "Signal"), 0) << result.err;
  }
}

// In a mount of its own, which takes rights that not everybody has.
TEST_P(PercussFaults, AFullDiskEndsTheRunWithItsReasonAndASoundCheckpoint) {
  const std::string disk = folder_.path() + "/disk";
  fs::create_directory(disk);
  const std::string mount = "mount -t tmpfs -o size=1800k none '" + disk + "'";
  if (std::system(("unshare -m sh -c \"" + mount + "\" 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "no file system can be mounted here";
  const std::string out = disk + "/out", look = folder_.path() + "/info";
  const ProcessResult result =
      run_percuss({"run", deck_, "-o", out, "--set", "output.fields.every=0.1", "--set", "time.end=1e5"},
                  "unshare -m sh -c 'export PERCUSS_WAIT_FOR_SPACE=0; "
                  "mount -t tmpfs -o size=1800k none " +
                      disk + " && { " + launch() + " \"$@\"; code=$?; \"$1\" info " + out + "/checkpoint.h5 >" + look +
                      "; exit $code; }' sh");
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "percuss: error: "), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("No space left on device): free some space"));
  std::ifstream info(look);
  EXPECT_THAT(std::string(std::istreambuf_iterator<char>(info), {}), HasSubstr("whole and undamaged"));
}

TEST_P(PercussFaults, WhatAKilledRunLeftOfACheckpointIsRemoved) {
  ASSERT_EQ(run_percuss({"run", deck_, "-o", out_, "--set", "time.max_steps=3"}, launch()).exit_code, 0);
  for (const char* name : {"checkpoint.h5.tmp", "checkpoint_previous.h5.tmp"})
    std::ofstream(out_ + "/" + name) << "half";
  ASSERT_EQ(run_percuss(
                {"run", deck_, "--restart", out_, "--set", "time.max_steps=4", "--set", "output.checkpoint.wall=1e300"},
                launch())
                .exit_code,
            0);
  EXPECT_FALSE(fs::exists(out_ + "/checkpoint.h5.tmp"));
  EXPECT_FALSE(fs::exists(out_ + "/checkpoint_previous.h5.tmp"));
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
