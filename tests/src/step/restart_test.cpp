// A run that is stopped and continues ends as one that never was; a restart that cannot be right is refused.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/output/checkpoint/checkpoint_file.hpp"
#include "src/step/restart/run_checkpoints.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Contact with a body, contact with a wall, friction, gravity, prescribed motion and plastic flow.
const std::string blocks = R"yaml(
time: {end: 1.5e-3}
parts:
  lower: {box: {size: [1, 1, 0.4], cells: [5, 5, 2]}, material: steel}
  upper: {box: {size: [0.5, 0.5, 0.5], cells: [3, 3, 3]}, at: [0.21, 0.22, 0.401], material: steel}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
initial: [{part: upper, velocity: [20, 5, -100]}]
loads: {gravity: [0, 0, -9.81], pressure: [{faces: upper/z_max, value: {expression: "1e7 * cos(1e4 * t)"}}]}
conditions: [{nodes: lower/x_min, velocity: {x: {expression: "3 * sin(1e4 * t)"}}}]
walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}]
contact: {surfaces: all, friction: 0.3}
output: {fields: {every: 2e-4, write: [velocity, stress, contact_force]}, history: {every: 0}}
)yaml";

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

RunResult run(const std::string& deck, const std::string& folder, const std::string& restart = "",
              bool in_place = true) {
  RunOptions options;
  options.out_dir = folder;
  options.restart = restart;
  options.goes_on_in_place = !restart.empty() && in_place;
  return run_scene(parse_deck(deck, "deck.yaml"), options);
}

/// The run is asked to stop as its first file is made, and makes one step.
RunResult run_and_stop(const std::string& deck, const std::string& folder) {
  RunOptions options;
  options.out_dir = folder;
  options.prepare_output = request_stop;
  return run_scene(parse_deck(deck, "deck.yaml"), options);
}

std::string take_refusal(const std::string& deck, const std::string& folder, const std::string& restart) {
  try {
    run(deck, folder, restart);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

const std::string checkpoint_name = "/checkpoint.h5";

std::string change(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The deck that stops after so many steps and leaves a checkpoint then.
std::string stopped(int steps) {
  return change(change(blocks, "end: 1.5e-3", "end: 1.5e-3, max_steps: " + std::to_string(steps)),
                "history: {every: 0}", "history: {every: 0}, checkpoint: {every: 1}");
}

}  // namespace

// Shells that yield, with held and driven rotations.
const std::string shells = R"yaml(
time: {end: 3e-4}
parts: {roof: {shell_tube: {radius: 1, length: 2, cells: [9, 11], arc: 70}, thickness: 0.02, points: 4, material: steel}}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
loads: {pressure: [{faces: roof/outer, value: 4e7}]}
conditions: [{nodes: roof/start, fixed: [x, y, z, rx, ry, rz]}, {nodes: roof/end, velocity: {z: -5, rx: {expression: "20 * sin(1e4 * t)"}}}]
output: {fields: {every: 1e-4, write: [stress_top, thickness]}, history: {every: 0}}
)yaml";

/// Expects that a deck stopped after `steps` and restarted ends with the same bits as the run that was not stopped.
void expect_same_end(const std::string& deck, const std::string& end, int steps) {
  const TemporaryFolder whole, parts;
  const Summary expected = run(deck, whole.path()).summary;
  run(change(change(deck, end, fmt::format("{}, max_steps: {}", end, steps)), "history: {every: 0}",
             "history: {every: 0}, checkpoint: {every: 1}"),
      parts.path());
  const Summary summary = run(deck, parts.path(), parts.path() + checkpoint_name).summary;
  EXPECT_GT(expected.steps, steps * 4 / 3);
  EXPECT_EQ(summary.state_hash, expected.state_hash);
  EXPECT_EQ(summary.steps, expected.steps);
  EXPECT_EQ(summary.energy.error, expected.energy.error);
  EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
}

TEST(Restart, OfShellsEndsInTheSameBits) { expect_same_end(shells, "end: 3e-4", 9); }

// Rigid bodies that turn, touch, are driven and joined to what deforms.
const std::string rigid_bodies = R"yaml(
time: {end: 4e-4}
parts:
  bar: {box: {size: [0.4, 0.1, 0.1], cells: [8, 3, 3]}, material: steel}
  mass: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0.4, 0, 0], material: steel, rigid: {mass: 12}}
  ball: {sphere: {radius: 0.05, cells: 8}, at: [0.3, 0.05, 0.152], material: steel, rigid: true}
  driver: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [-0.101, 0, 0], material: steel, rigid: true}
join: [{parts: [bar, mass]}]
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
initial: [{part: ball, velocity: [5, 3, -100], angular_velocity: [100, 300, -200]}]
loads: {gravity: [0, 0, -9.81]}
conditions: [{nodes: driver, velocity: {x: {expression: "20 * sin(1e4 * t)"}, rx: 30}}]
contact: {surfaces: all, friction: 0.3}
output: {fields: {every: 1e-4, write: [velocity]}, history: {every: 0}}
)yaml";

TEST(Restart, OfRigidBodiesEndsInTheSameBits) { expect_same_end(rigid_bodies, "end: 4e-4", 30); }

// Springs of all kinds between a block that breaks up, a rigid one and one that is held; some of them break.
const std::string sprung_blocks = R"yaml(
time: {end: 4e-4}
parts:
  low: {box: {size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}, material: steel}
  high: {box: {size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}, at: [0, 0, 0.08], material: weak}
  mass: {box: {size: [0.1, 0.1, 0.05], cells: [2, 2, 2]}, at: [0.2, 0, 0.08], material: steel, rigid: true}
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  weak: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9, failure: {plastic_strain: 0.01}}
springs:
  pillars: {between: [low/z_max, high/z_min], stiffness: 2e8, damping: 2e3, acts: compression}
  rope: {between: [{near: [0.1, 0.1, 0.13], part: high}, mass/x_min], table: [[0, 0], [0.001, 2e5], [0.01, 3e5]], failure: {force: 4e4}}
erosion: {free_nodes: remove}
initial: [{part: high, velocity: [3, -2, -150]}, {part: mass, velocity: [60, 0, 20], angular_velocity: [0, 30, 100]}]
conditions: [{nodes: low/z_min, fixed: [x, y, z]}]
contact: {surfaces: all}
output: {fields: {every: 1e-4, write: [velocity]}, history: {every: 0}}
)yaml";

TEST(Restart, WithSpringsEndsInTheSameBits) {
  for (const int steps : {20, 90}) expect_same_end(sprung_blocks, "end: 4e-4", steps);
}

// Shells and a solid that hit a wall, fail, and are given mass.
const std::string scaled_crash = R"yaml(
time: {end: 3e-4, mass_scaling: {step: 1.5e-6, max_added: 9, every: 3}}
parts:
  sheet: {shell_plate: {size: [0.1, 0.1], cells: [7, 6]}, thickness: 0.002, material: steel, axis: y, at: [0, 0, 0.15]}
  block: {box: {size: [0.05, 0.05, 0.05], cells: [5, 5, 5]}, at: [0.2, 0, 0.001], material: steel, mass_scaling: {step: 1.1e-6, max_added: 0.02, every: 1}}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9, failure: {plastic_strain: 0.4}}}
erosion: {free_nodes: remove}
initial: [{velocity: [3, -2, -250]}]
loads: {gravity: [5, 0, -1e5]}
walls: [{normal: z, friction: 0.2}]
output: {fields: {every: 1e-4, write: [mass]}, history: {every: 0}}
)yaml";

TEST(Restart, WhileMassIsScaledEndsInTheSameBits) {
  for (const int steps : {40, 120}) expect_same_end(scaled_crash, "end: 3e-4", steps);
}

// A bar that breaks up at both ends; a sensor lets go of its top, of which some nodes have vanished by then.
const std::string released_bar = R"yaml(
time: {end: 1.5e-4}
parts: {bar: {box: {size: [0.02, 0.02, 0.06], cells: [4, 4, 12]}, at: [0, 0, 2e-4], material: steel}}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 300e6, failure: {plastic_strain: 0.15}}}
erosion: {free_nodes: remove}
initial: [{part: bar, velocity: [0, 0, -150]}]
sensors: {release: {time: 8e-5}}
conditions: [{nodes: bar/z_max, velocity: {z: -400}, until: release}]
walls: [{normal: z}]
output: {history: {every: 0}}
)yaml";

TEST(Restart, AfterHeldNodesHaveVanishedEndsInTheSameBits) {
  for (const int steps : {100, 230}) expect_same_end(released_bar, "end: 1.5e-4", steps);
}

// Shells that touch each other, a solid and themselves, by nodes and by edges.
const std::string touching_shells = R"yaml(
time: {end: 8e-5}
parts:
  sheet: {shell_plate: {size: [0.1, 0.1], cells: [6, 6]}, thickness: 0.004, material: steel}
  other: {shell_plate: {size: [0.08, 0.08], cells: [5, 5]}, at: [0.03, 0.013, 0.0032], thickness: 0.002, material: steel}
  brick: {box: {size: [0.04, 0.04, 0.02], cells: [3, 3, 2]}, at: [0.01, 0.03, -0.0222], material: steel}
materials: {steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9}}
initial: [{part: other, velocity: [5, 0, -40]}, {part: brick, velocity: [0, 0, 30]}]
contact: {surfaces: all, friction: 0.3}
output: {fields: {every: 2e-5, write: [stress_top, contact_force]}, history: {every: 0}}
)yaml";

TEST(Restart, OfTouchingShellsEndsInTheSameBits) { expect_same_end(touching_shells, "end: 8e-5", 25); }

// Blocks and a sheet that rest on one another until another block comes down on them.
const std::string resting_pile = R"yaml(
time: {end: 1.6e-5}
parts:
  blocks: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 2]}, array: {count: [2, 1, 2], pitch: [0.1, 0.1, 0.1]}, at: [0.3, 0.7, 0], material: steel}
  sheet: {shell_plate: {size: [0.1, 0.1], cells: [4, 4]}, at: [0.37, 0.71, 0.205], thickness: 0.01, material: steel}
  other: {box: {size: [0.05, 0.05, 0.05], cells: [2, 2, 2]}, at: [0.39, 0.73, 0.2104], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{part: other, velocity: [5, 0, -60]}]
contact: {surfaces: all, friction: 0.3, edges: true}
output: {fields: {every: 4e-6, write: [contact_force]}, history: {every: 0}}
)yaml";

TEST(Restart, WhileBodiesLieStillEndsInTheSameBits) { expect_same_end(resting_pile, "end: 1.6e-5", 3); }

// A soft strip is bent over a bar: edges of its upper side fold before the checkpoint.
const std::string folding_strip = R"yaml(
time: {end: 0.8}
parts:
  strip: {box: {size: [6, 1, 0.5], cells: [6, 1, 1]}, material: soft}
  bar: {box: {size: [0.4, 3, 0.4], cells: [1, 3, 1]}, at: [2.8, -1, -0.41], material: hard}
materials:
  soft: {model: neo_hookean, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}
  hard: {model: elastic, density: 1000, youngs_modulus: 1e8, poissons_ratio: 0.3}
conditions:
  - {nodes: strip/x_min, velocity: {z: -2}}
  - {nodes: strip/x_max, velocity: {z: -2}}
  - {nodes: bar, fixed: [x, y, z]}
contact: {surfaces: all}
output: {history: {every: 0}}
)yaml";
TEST(Restart, WithFoldsEndsInTheSameBits) { expect_same_end(folding_strip, "end: 0.8", 800); }

TEST(Restart, EndsInTheBitsOfTheRunThatWasNeverStopped) {
  const TemporaryFolder whole, parts;
  const Summary expected = run(blocks, whole.path()).summary;
  run(stopped(7), parts.path());
  for (const int steps : {8, 20}) run(stopped(steps), parts.path(), parts.path() + checkpoint_name);
  const Summary summary = run(blocks, parts.path(), parts.path() + checkpoint_name).summary;
  EXPECT_EQ(summary.state_hash, expected.state_hash);
  EXPECT_EQ(summary.steps, expected.steps);
  EXPECT_EQ(summary.dt.min, expected.dt.min);
  EXPECT_EQ(summary.dt.max, expected.dt.max);
  EXPECT_EQ(summary.energy.error, expected.energy.error);
  EXPECT_EQ(summary.momentum.angular_error, expected.momentum.angular_error);
  EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
  EXPECT_EQ(read_file(parts.path() + "/fields.xdmf"), read_file(whole.path() + "/fields.xdmf"));
}

TEST(Restart, AnEstimatedStepGoesOnFromItsLastEstimate) {
  const auto text = [](int steps) {
    return change(change(stopped(steps), "1.5e-3, ", "1.5, step_estimate: global, "), "fields: {every: 2e-4,",
                  "fields: {every: 2e-2,");
  };
  const TemporaryFolder whole, parts;
  const Summary expected = run(text(40), whole.path()).summary;
  EXPECT_EQ(expected.dt.estimates, 1);
  EXPECT_GT(expected.dt.gain, 1.1);
  run(text(15), parts.path());
  const Summary summary = run(text(40), parts.path(), parts.path() + checkpoint_name).summary;
  EXPECT_EQ(summary.state_hash, expected.state_hash);
  EXPECT_EQ(summary.dt.gain, expected.dt.gain);
  EXPECT_EQ(summary.dt.estimates, 1);
}

/// The deck that stops after five steps, with checkpoints by the clock.
std::string by_the_clock(const std::string& seconds) {
  return change(stopped(5), "checkpoint: {every: 1}", "checkpoint: {wall: " + seconds + "}");
}

// Every step takes longer than 1e-300 s, and none 1e300 s.
TEST(Restart, FromACheckpointByTheClockEndsInTheSameBits) {
  const TemporaryFolder whole, parts;
  const Summary expected = run(blocks, whole.path()).summary;
  run(by_the_clock("1e-300"), parts.path());
  EXPECT_EQ(read_checkpoint_header(parts.path() + checkpoint_name).step, 5);
  const std::string previous = find_previous_checkpoint(parts.path() + checkpoint_name);
  EXPECT_EQ(read_checkpoint_header(previous).step, 4);
  EXPECT_EQ(run(blocks, parts.path(), previous).summary.state_hash, expected.state_hash);
  EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
}

TEST(Restart, ClockThatIsNotDueLeavesACheckpointAtTheEndAlone) {
  const TemporaryFolder folder;
  run(by_the_clock("1e300"), folder.path());
  EXPECT_EQ(read_checkpoint_header(folder.path() + checkpoint_name).step, 5);
  EXPECT_FALSE(std::filesystem::exists(find_previous_checkpoint(folder.path() + checkpoint_name)));
}

TEST(Restart, InAnotherFolderWritesWhatComesAfterTheCheckpoint) {
  const TemporaryFolder whole, first, second;
  run(blocks, whole.path());
  run(stopped(20), first.path());
  const std::string before = read_file(first.path() + "/history.csv");
  run(blocks, second.path(), first.path() + checkpoint_name, false);
  EXPECT_EQ(read_file(first.path() + "/history.csv"), before);
  const HistoryTable all(whole.path() + "/history.csv"), rest(second.path() + "/history.csv");
  EXPECT_EQ(rest["step"].front(), 21);
  EXPECT_EQ(rest.rows(), all.rows() - 21);
  EXPECT_EQ(rest.last("kinetic"), all.last("kinetic"));
}

TEST(Restart, AStoppedRunLeavesACheckpointAndIsInterrupted) {
  const TemporaryFolder whole, parts;
  const std::string rarely = change(blocks, "history: {every: 0}", "history: {every: 3e-4}");
  const Summary expected = run(rarely, whole.path()).summary;
  const RunResult stop = run_and_stop(rarely, parts.path());
  EXPECT_EQ(stop.exit_code, ExitCode::interrupted);
  EXPECT_EQ(stop.checkpoint, parts.path() + checkpoint_name);
  EXPECT_EQ(run(rarely, parts.path(), stop.checkpoint).summary.state_hash, expected.state_hash);
  EXPECT_EQ(read_file(parts.path() + "/history.csv"), read_file(whole.path() + "/history.csv"));
}

TEST(Restart, AtTheEndFindsTheRunDone) {
  const TemporaryFolder folder;
  const Summary expected = run(stopped(9), folder.path()).summary;
  const std::string history = read_file(folder.path() + "/history.csv");
  EXPECT_EQ(run(stopped(9), folder.path(), folder.path() + checkpoint_name).summary.state_hash, expected.state_hash);
  EXPECT_EQ(read_file(folder.path() + "/history.csv"), history);
}

TEST(Restart, AtTheEndHasWhatContactDidInTheLastStep) {
  for (const auto& [enforcement, column] :
       {std::pair("penalty", "contact_stored"), std::pair("lagrange", "complementarity")}) {
    const TemporaryFolder folder;
    const std::string deck = change(stopped(20), "friction: 0.3", fmt::format("enforcement: {}", enforcement));
    run(deck, folder.path());
    const std::string history = read_file(folder.path() + "/history.csv");
    EXPECT_GT(HistoryTable(folder.path() + "/history.csv").last(column), 0);
    run(deck, folder.path(), folder.path() + checkpoint_name);
    EXPECT_EQ(read_file(folder.path() + "/history.csv"), history) << enforcement;
  }
}

TEST(Restart, OfAnotherDeckIsRefusedAndNamesWhatDiffers) {
  const TemporaryFolder folder;
  run(stopped(5), folder.path());
  const std::string checkpoint = folder.path() + checkpoint_name, history = read_file(folder.path() + "/history.csv");
  EXPECT_THAT(take_refusal(change(blocks, "friction: 0.3", "friction: 0.4"), folder.path(), checkpoint),
              AllOf(HasSubstr("contact.friction is 0.4 (0.3 in the checkpoint)"), HasSubstr("time.end")));
  EXPECT_THAT(take_refusal(change(blocks, "time: {", "time: {step_scale: 0.5, "), folder.path(), checkpoint),
              HasSubstr("time.step_scale is 0.5 (not given in the checkpoint)"));
  EXPECT_THAT(take_refusal(change(blocks, ", friction: 0.3", ""), folder.path(), checkpoint),
              HasSubstr("contact.friction is not given (0.3 in the checkpoint)"));
  EXPECT_THAT(take_refusal(change(blocks, "1.5e-3", "1e-9"), folder.path(), checkpoint),
              HasSubstr("before the checkpoint's time"));
  EXPECT_EQ(read_file(folder.path() + "/history.csv"), history);
  EXPECT_EQ(take_refusal(change(blocks, "200e9", "2.0e+11"), folder.path(), checkpoint), "no refusal");
}

TEST(Restart, OfAMeshFileWithOtherThicknessesIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/sheet.k", deck = fmt::format(R"yaml(
time: {{end: 1, max_steps: 2}}
parts: {{sheet: {{mesh: {{file: {}}}, thickness: {{file: true}}, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
initial: [{{part: sheet, velocity: [0, 0, 1]}}]
output: {{checkpoint: {{every: 1}}}}
)yaml",
                                                                          path);
  const auto write_sheet = [&](double thickness) {
    std::ofstream(path) << "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*PART\nsheet\n1,\n"
                        << "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n"
                        << fmt::format("{0},{0},{0},{0}\n*END\n", thickness);
  };
  write_sheet(0.1);
  run(deck, folder.path());
  write_sheet(0.2);
  EXPECT_THAT(take_refusal(deck, folder.path(), folder.path() + checkpoint_name), HasSubstr("the mesh differs"));
}

TEST(Restart, WithFilesThatDoNotFitIsRefusedAndChangesNothing) {
  const TemporaryFolder folder;
  run(stopped(5), folder.path());
  const std::string checkpoint = folder.path() + checkpoint_name;
  const auto frames = std::filesystem::file_size(folder.path() + "/fields.vtkhdf");
  EXPECT_THAT(take_refusal(change(blocks, "contact_force]", "mass]"), folder.path(), checkpoint),
              HasSubstr("its fields are not those of this deck"));
  EXPECT_THAT(
      take_refusal(change(blocks, "{every: 0}", "{every: 0, nodes: [{name: a, id: 1}]}"), folder.path(), checkpoint),
      HasSubstr("its columns are not those of this run"));
  std::filesystem::resize_file(folder.path() + "/history.csv", 700);
  EXPECT_THAT(take_refusal(blocks, folder.path(), checkpoint), HasSubstr("it lacks rows"));
  EXPECT_EQ(std::filesystem::file_size(folder.path() + "/fields.vtkhdf"), frames);
  EXPECT_EQ(std::filesystem::file_size(folder.path() + "/history.csv"), 700);
  std::filesystem::remove(folder.path() + "/history.csv");
  EXPECT_THAT(take_refusal(blocks, folder.path(), checkpoint), HasSubstr("it cannot be opened"));
}

TEST(Restart, ACheckpointThatCannotBeWrittenEndsTheRunAndLeavesItsResults) {
  const TemporaryFolder folder;
  // Nothing can be created where a folder has the name already.
  std::filesystem::create_directories(folder.path() + checkpoint_name + ".tmp/full");
  EXPECT_ERROR(run(stopped(5), folder.path()), SystemError, "cannot create");
  EXPECT_EQ(HistoryTable(folder.path() + "/history.csv").last("step"), 5);
  EXPECT_EQ(read_summary(folder.path() + "/summary.json").status, "failed");
}

TEST(RunSummary, TellsTheEndThoughTheTableOfRanksCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/ranks.csv.tmp/full");
  EXPECT_ERROR(run(stopped(5), folder.path()), SystemError, "cannot write");
  EXPECT_EQ(read_summary(folder.path() + "/summary.json").status, "completed");
}

TEST(RunCheckpoints, QuoteWordsForTheShell) {
  EXPECT_EQ(quote_for_shell("time.end=1e-3"), "time.end=1e-3");
  EXPECT_EQ(quote_for_shell(""), "''");
  EXPECT_EQ(quote_for_shell("a b"), "'a b'");
  EXPECT_EQ(quote_for_shell("$HOME"), "'$HOME'");
  EXPECT_EQ(quote_for_shell("initial.0.velocity=[1, 0, 0]"), "'initial.0.velocity=[1, 0, 0]'");
  EXPECT_EQ(quote_for_shell("it's"), "'it'\\''s'");
}

TEST(RunCheckpoints, AreDueByTimeAndNameTheLastOne) {
  const TemporaryFolder folder;
  std::string text = blocks;
  const std::string output = "output: {";
  const Deck deck = parse_deck(text.insert(text.find(output) + output.size(), "checkpoint: {every: 1e-3}, "), "d.yaml",
                               {"time.step_scale=0.5", "title=a drop"});
  RunCheckpoints checkpoints(deck, folder.path(), false);
  EXPECT_TRUE(checkpoints.is_wanted_at_end());
  EXPECT_FALSE(checkpoints.is_clock_due());
  checkpoints.begin(0);
  EXPECT_FALSE(checkpoints.is_due(0));
  EXPECT_FALSE(checkpoints.is_due(9e-4));
  EXPECT_TRUE(checkpoints.is_due(1e-3));
  EXPECT_EQ(checkpoints.step(), -1);
  EXPECT_EQ(checkpoints.describe(), "");
  const std::string file = folder.path() + "/one.h5";
  std::ofstream(file) << "a checkpoint";
  State state;
  state.step = 7;
  state.time = 2.5e-3;
  checkpoints.note(file, state);
  EXPECT_EQ(checkpoints.step(), 7);
  EXPECT_FALSE(checkpoints.is_due(2.9e-3));
  EXPECT_TRUE(checkpoints.is_due(3e-3));
  EXPECT_THAT(checkpoints.describe(),
              AllOf(HasSubstr("step 7, t = 0.0025;"),
                    HasSubstr("percuss run d.yaml --set time.step_scale=0.5 --set 'title=a drop' --restart " + file)));
  RunCheckpoints external(deck, folder.path(), true);
  external.note(file, state);
  EXPECT_THAT(external.describe(), testing::EndsWith(" --restart " + file + " --allow-external"));
  std::filesystem::remove(file);
  EXPECT_EQ(checkpoints.describe(), "");
  text = blocks;
  const Deck without =
      parse_deck(text.insert(text.find(output) + output.size(), "checkpoint: {at_end: false}, "), "d.yaml");
  EXPECT_FALSE(RunCheckpoints(without, folder.path(), false).is_wanted_at_end());
}

}  // namespace percuss::test
