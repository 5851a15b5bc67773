// A restart in the folder of its checkpoint takes nothing away that it does not compute again, unless that is asked
// for.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/output/frame/earlier_results.hpp"
#include "src/output/history_file.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

// A cube in free flight: steps of 1e-3, a row each, a frame every tenth.
const std::string cube = R"yaml(
time: {end: 0.03, max_step: 1e-3}
parts: {cube: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: soft}}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{velocity: [0, 0, 1], angular_velocity: [1, 2, 3]}]
)yaml";
const std::string rows = "output.history={every: 0}", frames = "output.fields={every: 0.01, write: [velocity]}",
                  checkpoints = "output.checkpoint={every: 0.01}";

enum class Removal { refused, allowed };

class RestartRemovals : public testing::Test {
 protected:
  /// Runs the deck with settings, from a checkpoint of the folder if one is named.
  RunResult run(const std::vector<std::string>& settings, const std::string& checkpoint = "",
                Removal removal = Removal::refused) const {
    RunOptions options;
    options.out_dir = folder_.path();
    options.restart = checkpoint.empty() ? "" : path(checkpoint);
    options.goes_on_in_place = !checkpoint.empty();
    options.may_remove_results = removal == Removal::allowed;
    return run_scene(parse_deck(cube, "deck.yaml", settings), options);
  }

  /// The message of a restart that must be refused, and must not have changed a byte.
  std::string refuse(const std::vector<std::string>& settings, const std::string& checkpoint) const {
    const auto before = read_all();
    try {
      run(settings, checkpoint);
    } catch (const InputError& error) {
      EXPECT_EQ(read_all(), before);
      return error.what();
    }
    return "no refusal";
  }

  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  std::string history() const { return read(path("history.csv")); }

  static std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  std::map<std::string, std::string> read_all() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_.path())) files[entry.path()] = read(entry.path());
    return files;
  }

  TemporaryFolder folder_;
};

TEST_F(RestartRemovals, OfAFinishedContinuationAreRefusedUnlessForced) {
  run({rows, frames, "output.checkpoint={every: 0.03}"});
  const std::string end = history();
  run({rows, frames, checkpoints, "time.end=0.04"}, "checkpoint.h5");
  EXPECT_THAT(refuse({rows, frames}, "checkpoint.h5"), HasSubstr("before the checkpoint's time"));
  EXPECT_THAT(
      refuse({rows, frames}, "checkpoint_previous.h5"),
      AllOf(HasSubstr(folder_.path() + ": error: continuing from "), HasSubstr("(t = 0.03)"),
            HasSubstr("10 rows of history.csv up to t = 0.04"), HasSubstr("1 frame of fields.vtkhdf up to t = 0.04"),
            HasSubstr("the summary of a run that was completed at t = 0.04"), HasSubstr("checkpoint.h5 of t = 0.04"),
            HasSubstr("--out"), HasSubstr("--force")));
  EXPECT_EQ(run({rows, frames}, "checkpoint_previous.h5", Removal::allowed).summary.time, 0.03);
  EXPECT_EQ(history(), end);
}

TEST_F(RestartRemovals, AreRefusedByTheRowsAlone) {
  run({rows, "time.max_steps=12", "output.checkpoint={every: 1}"});
  run({rows, "output.checkpoint={every: 1}"}, "checkpoint.h5");
  fs::remove(path("summary.json"));
  fs::remove(path("checkpoint.h5"));
  EXPECT_THAT(refuse({rows, "time.max_steps=20"}, "checkpoint_previous.h5"),
              AllOf(HasSubstr("10 rows of history.csv up to t = 0.03"), testing::Not(HasSubstr("summary"))));
}

TEST_F(RestartRemovals, AreNoneWhereTheRunGoesAtLeastAsFar) {
  run({rows, frames, checkpoints});
  const std::string whole = history(), hash = read_summary(path("summary.json")).state_hash;
  for (const char* checkpoint : {"checkpoint_previous.h5", "checkpoint.h5"}) {
    EXPECT_EQ(run({rows, frames, checkpoints}, checkpoint).summary.state_hash, hash);
    EXPECT_EQ(history(), whole);
  }
  EXPECT_EQ(run({rows, frames, "time.end=0.05"}, "checkpoint_previous.h5").summary.time, 0.05);
}

TEST_F(RestartRemovals, AreNoneAfterAKillThatLeftRowsBehindTheCheckpoint) {
  run({rows, frames, checkpoints});
  const std::string whole = history();
  fs::rename(path("checkpoint_previous.h5"), path("checkpoint.h5"));  // as if the end had not been reached
  fs::remove(path("summary.json"));
  run({rows, frames, checkpoints}, "checkpoint.h5");
  EXPECT_EQ(history(), whole);
}

TEST_F(RestartRemovals, AreRefusedWhereFewerRowsOrFramesWouldTakeTheirPlace) {
  run({rows, frames, checkpoints});
  EXPECT_THAT(refuse({rows, frames, "output.history.every=0.005"}, "checkpoint_previous.h5"),
              HasSubstr("rows of history.csv up to t = 0.03"));
  EXPECT_THAT(refuse({rows, frames, "output.fields.every=1"}, "checkpoint_previous.h5"),
              HasSubstr("frame of fields.vtkhdf up to t = 0.03"));
  EXPECT_NO_THROW(run({rows, frames, "output.fields.every=0.005"}, "checkpoint_previous.h5"));
}

// The last row and frame of a run that was stopped are those of its checkpoint.
TEST_F(RestartRemovals, AreNoneOfTheStateInTheCheckpoint) {
  RunOptions options;
  options.out_dir = folder_.path();
  options.prepare_output = request_stop;
  ASSERT_EQ(run_scene(parse_deck(cube, "deck.yaml", {rows, frames, "output.history.every=0.002"}), options).exit_code,
            ExitCode::interrupted);
  EXPECT_NO_THROW(run({rows, frames, "output.history.every=0.02", "output.fields.every=0.02"}, "checkpoint.h5"));
}

TEST_F(RestartRemovals, AreRefusedOfFilesThatTheCheckpointDoesNotKnow) {
  run({rows, checkpoints, "time.max_steps=10"});
  run({checkpoints, "time.max_steps=20"}, "checkpoint.h5");
  EXPECT_THAT(refuse({rows}, "checkpoint.h5"), HasSubstr("11 rows of history.csv up to t = 0.01"));
}

TEST_F(RestartRemovals, RowsAndFramesBehindAPointAreFound) {
  run({rows, frames});
  const std::string text = history();
  const LaterStates all = find_later_rows(path("history.csv"), -1);
  ASSERT_EQ(all.size(), 31);
  EXPECT_EQ(all[7].step, 7);
  EXPECT_NEAR(all[30].time, 0.03, 1e-15);
  const auto bytes = static_cast<std::int64_t>(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(find_later_rows(path("history.csv"), bytes).size(), 1);
  fs::resize_file(path("history.csv"), text.size() - 1);  // half of a row is none
  EXPECT_EQ(find_later_rows(path("history.csv"), bytes).size(), 0);
  EXPECT_EQ(find_later_rows(path("none.csv"), -1).size(), 0);
  ASSERT_EQ(find_later_frames(vtkhdf_frames, path("fields.vtkhdf"), 2).size(), 2);
  EXPECT_EQ(find_later_frames(vtkhdf_frames, path("fields.vtkhdf"), 2)[0].step, 20);
  EXPECT_EQ(find_later_frames(vtkhdf_frames, path("fields.vtkhdf"), -1).size(), 4);
  EXPECT_EQ(find_later_frames(vtkhdf_frames, path("history.csv"), 0).size(), 0);
}

TEST(StopRequest, BeforeTheFirstFileEndsTheRunWithoutOne) {
  const TemporaryFolder folder;
  RunOptions options;
  options.out_dir = folder.path();
  request_stop();
  EXPECT_ERROR(run_scene(parse_deck(cube, "deck.yaml"), options), Interruption, "interrupted");
  forget_stop_request();
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace percuss::test
