// Runs that go wrong end with an error that says what, where and when.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "kernels/core/common_record.hpp"
#include "src/error.hpp"
#include "src/output/vtkhdf/describe_fields.hpp"
#include "src/step/run/run.hpp"
#include "src/step/run/run_checks.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string take_run_error(const Deck& deck, const std::string& out_dir = "") {
  try {
    run_scene(deck, {out_dir, Progress::Style::quiet});
  } catch (const RunError& error) {
    return error.what();
  }
  return "no error";
}

// The end of the last of four elements jumps to the other side of its neighbour in the first step.
const std::string inverting = R"(
time: {end: 1e-3}
parts:
  other: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 9, 0], material: steel}
  bar: {box: {size: [4, 1, 1], cells: [4, 1, 1]}, material: steel}
conditions: [{nodes: bar/x_max, displacement: {x: {table: [[0, 0], [1e-9, -1.5]]}}}]
)" + steel_text;

}  // namespace

TEST(Failure, AnInvertedElementIsNamedWithItsPartAndPlace) {
  EXPECT_THAT(take_run_error(parse_deck(inverting, "deck.yaml")),
              AllOf(HasSubstr("element 5 of part 'bar' at (2.75, 0.5, 0.5) has inverted"), HasSubstr("in step 1 ")));
}

TEST(Failure, IsWrittenToTheSummary) {
  const TemporaryFolder folder;
  const std::string error = take_run_error(parse_deck(inverting, "deck.yaml"), folder.path());
  const Summary summary = read_summary(folder.path() + "/summary.json");
  EXPECT_EQ(summary.status, "failed");
  EXPECT_EQ(summary.error, error);
  EXPECT_EQ(summary.steps, 1);
}

TEST(Failure, NotANumberIsFoundInTheStepThatMadeIt) {
  Deck deck = parse_deck(R"(
time: {end: 1e-3}
parts: {bar: {box: {size: [4, 1, 1], cells: [4, 1, 1]}, material: steel}}
conditions: [{nodes: bar/x_max, velocity: {x: 1}}]
)" + steel_text,
                         "deck.yaml");
  deck.conditions[0].value[0] = Curve::expression("sqrt(3e-4 - t)");
  const std::string error = take_run_error(deck);
  EXPECT_THAT(error, HasSubstr("element 4 of part 'bar'"));
  EXPECT_THAT(error, HasSubstr("is not finite"));
  deck.time.end = 2.9e-4;
  EXPECT_EQ(take_run_error(deck), "no error");
}

TEST(Failure, ARunThatLeavesItsEnergyBoundStops) {
  // Bulk viscosity of a bar that rings keeps the balance good to 1e-4 or so, not to 1e-9.
  const std::string text = R"(
time: {end: 1e-3}
parts: {bar: {box: {size: [4, 1, 1], cells: [16, 4, 4]}, material: steel}}
initial: [{nodes: {name: bar, inside: [[0, 0, 0], [1, 1, 1]]}, velocity: [100, 0, 0]}]
)" + steel_text;
  EXPECT_EQ(take_run_error(parse_deck(text, "deck.yaml")), "no error");
  const std::string error = take_run_error(
      parse_deck(text + "audit: {max_energy_error: 1e-9}\noutput: {history: {every: 1e-5}}\n", "deck.yaml"));
  EXPECT_THAT(error, AllOf(HasSubstr("the energy balance is off by"), HasSubstr("audit.max_energy_error = 1e-09"),
                           HasSubstr("kinetic")));
}

TEST(Failure, ARunThatLeavesItsMomentumBoundStops) {
  // A body that flies and rings keeps its momentum to round-off, which is more than 1e-30.
  const std::string text = R"(
time: {end: 1e-4}
parts: {bar: {box: {size: [4, 1.1, 1.3], cells: [8, 2, 2]}, material: steel}}
initial: [{nodes: {name: bar, inside: [[0, 0, 0], [1, 1, 1]]}, velocity: [100, 3, 7]}]
output: {history: {every: 1e-6}}
)" + steel_text;
  EXPECT_EQ(take_run_error(parse_deck(text, "deck.yaml")), "no error");
  EXPECT_THAT(take_run_error(parse_deck(text + "audit: {max_momentum_error: 1e-30}\n", "deck.yaml")),
              AllOf(HasSubstr("momentum is off by"), HasSubstr("audit.max_momentum_error = 1e-30"),
                    HasSubstr(" of part 'bar' at ")));
}

TEST(Failure, TheStateThatFailedIsTheLastRowAndFrame) {
  const TemporaryFolder folder;
  const std::string output = "output: {fields: {every: 1}, history: {every: 1}}\n";
  take_run_error(parse_deck(inverting + output, "deck.yaml"), folder.path());
  EXPECT_EQ(HistoryTable(folder.path() + "/history.csv").last("step"), 1);
  EXPECT_THAT(describe_fields_file(folder.path() + "/fields.vtkhdf"), HasSubstr("frames:  2, time 0"));
}

TEST(Failure, WorkThatIsNotFiniteIsFoundInItsStepWithTheElement) {
  Scene scene(inverting);
  scene.stepper.start(scene.state);
  const CheckedRun run{scene.deck, scene.chunked, scene.model, scene.state, scene.stepper};
  EXPECT_NO_THROW(check_elements(run));
  scene.state.elements(scene.model.chunks.first_state(0) + SolidRecord::stress * pack_size<double>) = std::nan("");
  scene.state.x(0, 0) -= 0.01;  // makes the stress work
  scene.stepper.advance(scene.state);
  EXPECT_GE(scene.state.bound.broken_chunk, 0);
  EXPECT_ERROR(check_elements(run), RunError, "has no stable step any more");
}

TEST(Failure, ACollapsingStepNamesTheElementThatControlsIt) {
  const std::string text = R"(
time: {end: 1e-2, collapse_ratio: 0.9}
parts: {bar: {box: {size: [4, 1, 1], cells: [4, 1, 1]}, material: steel}}
conditions: [{nodes: bar/x_max, velocity: {x: {table: [[0, 0], [2e-3, -200]]}}}, {nodes: bar/x_min, fixed: [x]}]
)" + steel_text;
  EXPECT_THAT(take_run_error(parse_deck(text, "deck.yaml")),
              AllOf(HasSubstr("the time step has collapsed"), HasSubstr(" of part 'bar' at "),
                    HasSubstr("collapse_ratio (now 0.9)")));
}

TEST(Failure, AMaterialThatHeatsFailsWithTheRoomTemperatureThatTheDeckLeavesOut) {
  const std::string text = R"(
time: {end: 1}
parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: al}}
materials:
  al: {model: johnson_cook, density: 2700, youngs_modulus: 72e9, poissons_ratio: 0.33, a: 337e6, b: 343e6, n: 0.41, melt_temperature: 877, specific_heat: 890, failure: {plastic_strain: 0.5}}
)";
  Scene scene(text);
  const auto limits = to_host(scene.model.failing.limits);
  ASSERT_EQ(limits.extent(0), 1u);
  EXPECT_EQ(limits(0).room_temperature, 293.15);
  EXPECT_EQ(limits(0).melt_temperature, 877);
}

}  // namespace percuss::test
