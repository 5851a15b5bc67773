// Sensors switch loads and conditions, and end runs, in the step in which the history shows their event.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::sensor_test {
namespace {

using testing::HasSubstr;

/// A block of 2 x 2 x 2 elements, 27 nodes and mass 8, with what the tests add.
std::string make_block(const std::string& rest) {
  return R"yaml(
time: {end: 1e-2, max_step: 1e-4}
parts: {block: {box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, material: steel}}
materials: {steel: {model: elastic, density: 1000, youngs_modulus: 1e8, poissons_ratio: 0.3}}
)yaml" + rest;
}

constexpr double mass = 8;

/// The row in which a sensor acts for the first time.
std::size_t find_switched_row(const HistoryTable& history, const std::string& sensor) {
  const std::vector<double>& acted = history["sensor:" + sensor];
  std::size_t row = 0;
  while (row < acted.size() && acted[row] == 0) ++row;
  return row;
}

std::string pull(const std::string& sensor) {
  return make_block(fmt::format(R"yaml(
initial: [{{part: block, velocity: [0, 0, 0.1]}}]
loads: {{gravity: [5, 0, 0], pressure: [{{faces: block/x_min, value: 1e4, direction: x, until: far}}]}}
sensors: {{far: {}}}
output: {{history: {{every: 0, nodes: [{{name: tip, near: [0.2, 0, 0]}}, {{name: other, near: [0.2, 0.2, 0]}}]}}}}
)yaml",
                                sensor));
}

const std::string fall = make_block(R"yaml(
initial: [{part: block, velocity: [0, 0, -1]}]
walls: [{name: floor, point: [0, 0, -1e-4], normal: z}]
contact: {surfaces: all}
sensors: {gone: {value: "fz:floor", falls_below: 1}, late: {time: 1e-2}}
output: {history: {every: 1e-4, forces: [{name: floor, wall: floor}]}, checkpoint: {every: 1}}
)yaml");

/// In a folder of its own, or on from the checkpoint that is there.
class FallingBlock {
 public:
  Summary run(const std::vector<std::string>& more, bool goes_on = false) const {
    std::vector<std::string> settings{"time.end=0.05"};
    settings.insert(settings.end(), more.begin(), more.end());
    RunOptions options;
    options.out_dir = folder_.path();
    if (goes_on) options.restart = folder_.path() + "/checkpoint.h5";
    options.goes_on_in_place = goes_on;
    return run_scene(parse_deck(fall, "deck.yaml", settings), options).summary;
  }
  std::string find_refusal(const std::vector<std::string>& more) const {
    try {
      run(more, true);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  }
  std::string read_history() const {
    std::ifstream file(folder_.path() + "/history.csv");
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST(Sensors, ALoadEndsInTheStepInWhichANodeHasMovedFar) {
  const Outcome run = run_deck(pull("{value: tip_x, from_start: true, rises_above: 1e-4}"));
  const std::size_t row = find_switched_row(run.history, "far");
  ASSERT_GT(row, 3U);
  ASSERT_LT(row + 10, run.history.rows());
  const std::vector<double>&x = run.history["tip_x"], &t = run.history["time"];
  EXPECT_GT(x[row - 1] - x[0], 1e-4);  // the row that the sensor saw
  EXPECT_LE(x[row - 2] - x[0], 1e-4);
  // The pressure has acted until that row, gravity always; momentum is that of half a step before its row.
  const double force = 1e4 * 0.04, half = 0.5e-4;
  for (std::size_t i = row; i < run.history.rows(); ++i)
    ASSERT_NEAR(run.history["momentum_x"][i], force * (t[row - 1] - half) + mass * 5 * (t[i] - half), 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);  // error of waves in the block, also without a sensor
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(Sensors, CheckpointsLeaveAReleasedBodyFree) {
  const HistoryTable history = run_deck(R"yaml(
units: m, kg, s
time: {end: 0.02, max_step: 1e-4}
parts:
  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: m, rigid: {}}
  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [0, 0, 5], material: m}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -10]}
sensors: {go: {time: 0.005}}
conditions: [{body: a, fixed: [z], until: go}]
output: {history: {every: 1e-3}, checkpoint: {every: 1e-3}}
)yaml")
                                   .history;
  EXPECT_EQ(history.at(0.004, "body_vz:a"), 0);
  EXPECT_NEAR(history.last("body_vz:a"), -10 * (0.02 - 0.005), 2e-3);  // two steps
}

TEST(Sensors, ADelayIsAddedToTheEvent) {
  const HistoryTable now = run_deck(pull("{time: 1e-3}")).history;
  const HistoryTable later = run_deck(pull("{time: 1e-3, delay: 5e-4}")).history;
  const double first = now["time"][find_switched_row(now, "far") - 1],
               second = later["time"][find_switched_row(later, "far") - 1];
  EXPECT_GE(first, 1e-3);
  EXPECT_LE(first, 1e-3 + now["dt"][5]);
  EXPECT_GE(second, 1.5e-3);
  EXPECT_LE(second, 1.5e-3 + now["dt"][5]);
}

TEST(Sensors, TheDistanceOfTwoNodesIsSeen) {
  // Pulled by one side alone the block is compressed in x and widens in y, by a wave that comes first.
  const Outcome run = run_deck(pull("{distance: [tip, other], from_start: true, rises_above: 1e-7}"));
  const std::size_t row = find_switched_row(run.history, "far");
  ASSERT_LT(row, run.history.rows());
  const auto gap = [&](std::size_t at) {
    const double dx = run.history["other_x"][at] - run.history["tip_x"][at],
                 dy = run.history["other_y"][at] - run.history["tip_y"][at],
                 dz = run.history["other_z"][at] - run.history["tip_z"][at];
    return std::sqrt(dx * dx + dy * dy + dz * dz) - 0.2;
  };
  EXPECT_GT(gap(row - 1), 1e-7);
  EXPECT_LE(gap(row - 2), 1e-7);
}

TEST(Sensors, ALoadBeginsWithAnEvent) {
  const Outcome run = run_deck(make_block(R"yaml(
loads: {nodal: [{nodes: block, force: {x: 2}, from: go}]}
sensors: {go: {time: 2e-3}}
output: {history: {every: 0}}
)yaml"));
  const std::size_t row = find_switched_row(run.history, "go");
  EXPECT_EQ(run.history["momentum_x"][row - 1], 0);
  const std::vector<double>& t = run.history["time"];
  EXPECT_NEAR(run.history["momentum_x"].back(), 54 * (t.back() - t[row - 1]), 1e-12);  // 27 nodes
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(Sensors, ARunEndsWhenTheForceOfTheWallIsGone) {
  const Outcome run = run_deck(make_block(R"yaml(
initial: [{part: block, velocity: [0, 0, -1]}]
walls: [{name: floor, point: [0, 0, -1e-4], normal: z}]
contact: {surfaces: all}
sensors: {gone: {value: "fz:floor", falls_below: 1}}
output: {history: {every: 1e-4, forces: [{name: floor, wall: floor}]}}
)yaml"),
                               {"time.until=gone", "time.end=1"});
  EXPECT_EQ(run.summary.status, "completed");
  EXPECT_LT(run.summary.time, 0.1);
  const std::vector<double>& force = run.history["fz:floor"];
  EXPECT_LT(force.back(), 1);
  EXPECT_GE(force[force.size() - 2], 1);
  EXPECT_EQ(force.front(), 0);  // below from the start: no event
  EXPECT_GT(run.history["momentum_z"].back(), 0);
}

TEST(Sensors, ARunThatOneHasEndedGoesOnPastIt) {
  const FallingBlock whole, parted;
  const Summary end = whole.run({});
  const Summary first = parted.run({"time.until=gone"});
  EXPECT_EQ(first.ended_by, "gone");
  EXPECT_LT(first.time, 0.01);
  const Summary second = parted.run({"time.until=late"}, true);
  EXPECT_EQ(second.ended_by, "late");
  EXPECT_GE(second.time, 0.01);
  EXPECT_LT(second.time, 0.0101);
  const Summary last = parted.run({}, true);
  EXPECT_EQ(last.ended_by, "");
  EXPECT_EQ(last.steps, end.steps);
  EXPECT_EQ(last.state_hash, end.state_hash);
  EXPECT_EQ(last.sensors.size(), 2U);
  EXPECT_EQ(parted.read_history(), whole.read_history());
}

TEST(Sensors, ARestartThatLooksAtOtherRowsIsRefused) {
  const FallingBlock block;
  block.run({"time.until=gone"});
  const std::string refusal = block.find_refusal({"output.history.every=2e-4"});
  EXPECT_THAT(refusal, HasSubstr("output.history.every is 0.0002 (0.0001 in the checkpoint)"));
  EXPECT_THAT(refusal, HasSubstr("output without output.history, which sensors look at"));
  EXPECT_THAT(refusal, HasSubstr("time.until"));
}

TEST(Sensors, ABlockFallsWhenItsSupportIsReleased) {
  const Outcome run = run_deck(make_block(R"yaml(
loads: {gravity: [0, 0, -10]}
conditions: [{nodes: block, fixed: [x, y, z], until: drop}]
sensors: {drop: {time: 2e-3}}
output: {history: {every: 0, forces: [{name: hand, support: block}]}}
)yaml"));
  const std::size_t row = find_switched_row(run.history, "drop");
  const std::vector<double>&t = run.history["time"], &dt = run.history["dt"], &p = run.history["momentum_z"];
  EXPECT_EQ(p[row - 1], 0);
  for (std::size_t i = row + 1; i < run.history.rows(); ++i)
    EXPECT_NEAR(p[i] - p[i - 1], -10 * mass * dt[i], 1e-9 * 10 * mass * dt[i]);
  EXPECT_NEAR(p.back(), -10 * mass * (t.back() - t[row - 1]), 10 * mass * dt[row]);
  EXPECT_NEAR(run.history["fz:hand"][row - 1], 10 * mass, 1e-9 * 10 * mass);
  EXPECT_EQ(run.history["fz:hand"].back(), 0);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
}

TEST(Sensors, ABlockStopsWhereItIsHeldFromAnEventOn) {
  const Outcome run = run_deck(make_block(R"yaml(
initial: [{part: block, velocity: [3, 0, 0]}]
conditions: [{nodes: block, fixed: [x], from: catch}]
sensors: {catch: {value: tip_x, rises_above: 0.21}}
output: {history: {every: 0, nodes: [{name: tip, near: [0.2, 0, 0]}]}}
)yaml"));
  EXPECT_NEAR(run.history["momentum_x"].front(), 3 * mass, 1e-12 * 3 * mass);
  EXPECT_EQ(run.history["momentum_x"].back(), 0);
  EXPECT_NEAR(run.history.last("tip_x"), 0.21, 2 * 3 * 1e-4);
  EXPECT_NEAR(run.history.last("external"), -0.5 * mass * 9, 1e-9 * mass);  // the condition takes the energy
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
}

TEST(Sensors, AnUnknownColumnIsToldWithItsPlace) {
  try {
    run_deck(pull("{value: tip_xx, rises_above: 1}"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("sensor 'far' looks at 'tip_xx' (the history has no such column)"));
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'tip_x'?"));
    EXPECT_THAT(error.what(), HasSubstr("deck.yaml:"));
  }
}

TEST(Sensors, TwoConditionsOfWhichOneIsSwitchedCannotShareANode) {
  try {
    run_deck(make_block(R"yaml(
conditions: [{nodes: block/x_min, fixed: [x]}, {nodes: block/z_min, fixed: [x], until: go}]
sensors: {go: {time: 2e-3}}
)yaml"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("of which a sensor switches one"));
  }
}

TEST(Sensors, ALoadThatASensorSwitchesOnAtTimeZeroActsFromTheStart) {
  const auto load = [](const std::string& sensor) {
    return make_block("loads: {nodal: [{nodes: block, force: {x: 2}" + sensor + "}]}\noutput: {history: {every: 0}}\n");
  };
  const HistoryTable always = run_deck(load("")).history;
  const Outcome switched = run_deck(load(", from: go") + "sensors: {go: {time: 0}}\n");
  EXPECT_EQ(switched.history["momentum_x"], always["momentum_x"]);
  EXPECT_LT(std::abs(switched.summary.energy.error), 1e-12);
}

TEST(Sensors, NodesThatAreCaughtUnderGravityKeepTheBalance) {
  // A face at 3 m/s is held from 3 ms on: its kinetic energy goes, and with it what gravity had begun to do.
  const Outcome run = run_deck(R"yaml(
time: {end: 2e-2, max_step: 1e-4}
parts: {block: {box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, material: steel}}
materials: {steel: {model: elastic, density: 1000, youngs_modulus: 1e6, poissons_ratio: 0.3}}
loads: {gravity: [-10, 0, 0]}
initial: [{nodes: block/x_max, velocity: [3, 0, 0]}]
conditions: [{nodes: block/x_max, fixed: [x], from: catch}]
sensors: {catch: {time: 3e-3}}
output: {history: {every: 0}}
)yaml");
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);
}

TEST(Sensors, ARelaxationHoldsWhatItIsToldTo) {
  const Outcome run = run_deck(R"yaml(
time: {end: 1e-3}
parts:
  block: {box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, material: steel}
  other: {box: {size: [0.2, 0.2, 0.2], cells: [2, 2, 2]}, at: [1, 0, 0], material: steel}
materials: {steel: {model: elastic, density: 1000, youngs_modulus: 1e8, poissons_ratio: 0.3}}
conditions: [{nodes: block/z_min, fixed: [x, y, z]}, {nodes: other/z_min, fixed: [z], from: go}]
loads: {gravity: [0, 0, -10]}
start: {relaxation: {hold: [other], ramp: 10}}
sensors: {go: {time: 5e-4}}
output: {history: {every: 0, nodes: [{name: tip, near: [1.2, 0, 0]}]}}
)yaml");
  EXPECT_EQ(run.history["tip_z"].front(), 0);
  EXPECT_LT(run.history["tip_z"].back(), 0);  // it falls until it is caught
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

TEST(Sensors, ASpringBetweenHeldNodesBoundsTheStepBeforeTheyAreReleased) {
  const Outcome run = run_deck(make_block(R"yaml(
conditions: [{nodes: block, fixed: [x, y, z], until: go}]
springs: {s: {between: [{near: [0, 0, 0]}, {near: [0.2, 0, 0]}], stiffness: 1e8, rest_length: 0.1999}}
sensors: {go: {time: 1e-3}}
output: {history: {every: 0}}
)yaml"));
  EXPECT_LE(run.history["dt"][1], 5e-5);  // 2 sqrt(m / 2 k) of two corners of 1/8 kg each, before the release
  EXPECT_LT(std::abs(run.summary.energy.error), 2e-2);  // the spring moves with the largest step
  EXPECT_EQ(run.summary.status, "completed");
}

}  // namespace percuss::test::sensor_test
