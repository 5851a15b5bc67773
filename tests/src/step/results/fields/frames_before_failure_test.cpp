// The frames of states before a failure, which are kept in memory until then.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/output/summary.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/hdf5_file_view.hpp"
#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using sample::Hdf5FileView;

/// A cube that a held side and a moving one turn inside out.
std::string make_crushed(const std::string& more) {
  return R"(
time: {end: 1}
parts: {cube: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
conditions: [{nodes: cube/z_min, fixed: [x, y, z]}, {nodes: cube/z_max, velocity: {z: -3}}]
output: {fields: {every: 0.3, write: [velocity])" +
         more + "}}\n";
}

/// Steps and times of the frames of a run that fails; on rank 0.
struct Written {
  std::vector<double> steps, times, displacement;
};
Written run_to_failure(const std::string& deck, const std::string& folder) {
  EXPECT_ERROR(run_scene(parse_deck(deck, "deck.yaml"), {folder, Progress::Style::quiet}), RunError, ", in step ");
  if (Communicator::world().rank() != 0) return {};
  const Hdf5FileView file(folder + "/fields.vtkhdf");
  return {file.numbers("percuss/step"), file.numbers("VTKHDF/Steps/Values"),
          file.numbers("VTKHDF/PointData/displacement")};
}

/// Runs the deck to its failure, and again from its checkpoint, which is that of the first step that ends at `time` or
/// later.
Written run_twice_to_failure(const std::string& text, const std::string& folder, double time) {
  const Deck deck = parse_deck(text, "deck.yaml", {fmt::format("output.checkpoint={{every: {:.17g}}}", time)});
  EXPECT_ERROR(run_scene(deck, {folder, Progress::Style::quiet}), RunError, ", in step ");
  RunOptions options{folder, Progress::Style::quiet};
  options.restart = folder + "/checkpoint.h5";
  options.goes_on_in_place = options.may_remove_results = true;
  EXPECT_ERROR(run_scene(deck, options), RunError, ", in step ");
  if (Communicator::world().rank() != 0) return {};
  const Hdf5FileView file(folder + "/fields.vtkhdf");
  return {file.numbers("percuss/step"), file.numbers("VTKHDF/Steps/Values"),
          file.numbers("VTKHDF/PointData/displacement")};
}

int count_lost_frames(const std::string& folder) {
  const std::vector<Warning> warnings = read_summary(folder + "/summary.json").warnings;
  return static_cast<int>(std::count_if(warnings.begin(), warnings.end(),
                                        [](const Warning& warning) { return warning.rule == "lost_frames"; }));
}

}  // namespace

TEST(FramesBeforeFailure, AreTheLastTwoThatWereKept) {
  const SharedFolder plain, kept;
  const Written without = run_to_failure(make_crushed(""), plain.path());
  const Written with = run_to_failure(make_crushed(", before_failure: 4"), kept.path());
  if (Communicator::world().rank() != 0) return;
  ASSERT_GE(without.steps.size(), 3u);
  ASSERT_EQ(with.steps.size(), without.steps.size() + 2);
  const std::size_t last = with.steps.size() - 1;
  EXPECT_EQ(with.steps[last], without.steps.back());
  const auto failed = static_cast<long>(with.steps[last]);
  const long newest = (failed - 1) / 4 * 4;
  EXPECT_EQ(with.steps[last - 1], newest);
  EXPECT_EQ(with.steps[last - 2], newest - 4);
  for (std::size_t i = 1; i <= last; ++i) EXPECT_GT(with.times[i], with.times[i - 1]);
  // The moving side is where its speed has brought it: all frames are those of their times.
  const std::size_t numbers = with.displacement.size() / with.steps.size();
  for (std::size_t i = 0; i <= last; ++i) {
    double nearest = 1;
    for (std::size_t k = 2; k < numbers; k += 3)
      nearest = std::min(nearest, std::abs(with.displacement[i * numbers + k] + 3 * with.times[i]));
    EXPECT_LT(nearest, 1e-12) << i;
  }
}

TEST(FramesBeforeFailure, AreNotWrittenTwice) {
  const SharedFolder folder;
  std::string deck = make_crushed(", before_failure: 1");
  deck.replace(deck.find("every: 0.3"), 10, "every: 1e-5");
  deck += "audit: {max_energy_error: 1e-4}\n";  // soon broken
  const Written all = run_to_failure(deck, folder.path());
  if (Communicator::world().rank() != 0) return;
  ASSERT_GE(all.steps.size(), 2u);
  for (std::size_t i = 1; i < all.steps.size(); ++i) EXPECT_EQ(all.steps[i], all.steps[i - 1] + 1);
}

TEST(FramesBeforeFailure, AreKeptFromACheckpointOnAndAWarningTellsOfThoseBefore) {
  const SharedFolder whole, all, one;
  const std::string deck = make_crushed(", before_failure: 4");
  const Written expected = run_to_failure(deck, whole.path());
  double time = 0;  // of the older frame that was kept
  if (Communicator::world().rank() == 0 && expected.times.size() > 2) time = expected.times[expected.times.size() - 3];
  all_reduce(Communicator::world(), Reduce::largest, time);
  const Written same = run_twice_to_failure(deck, all.path(), time * (1 - 1e-9));
  const Written less = run_twice_to_failure(deck, one.path(), time * (1 + 1e-9));
  if (Communicator::world().rank() != 0) return;
  EXPECT_EQ(same.steps, expected.steps);
  EXPECT_EQ(same.displacement, expected.displacement);
  EXPECT_EQ(less.steps.size(), expected.steps.size() - 1);
  EXPECT_EQ(count_lost_frames(whole.path()), 0);
  EXPECT_EQ(count_lost_frames(all.path()), 0);
  EXPECT_EQ(count_lost_frames(one.path()), 1);
}

TEST(FramesBeforeFailure, LeaveARunThatDoesNotFailAsItIs) {
  const SharedFolder folder;
  std::string deck = make_crushed(", before_failure: 3");
  deck.replace(deck.find("velocity: {z: -3}"), 17, "velocity: {z: -0.1}");
  run_scene(parse_deck(deck, "deck.yaml"), {folder.path(), Progress::Style::quiet});
  if (Communicator::world().rank() != 0) return;
  EXPECT_EQ(Hdf5FileView(folder.path() + "/fields.vtkhdf").numbers("VTKHDF/Steps/Values").size(), 5u);
}

}  // namespace percuss::test
