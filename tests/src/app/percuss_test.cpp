// The executable: its commands, what they leave behind and their exit codes.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A cube that hits a wall; some tens of steps.
const char* const cube = R"yaml(title: A cube hits a wall
time: {end: 0.5}
parts: {cube: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [0, 0, 0.001], material: soft}}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{velocity: [0, 0, -0.1]}]
walls: [{normal: z}]
output: {fields: {every: 0.25, write: [velocity]}, history: {}}
)yaml";

TEST(PercussCheck, SaysWhatTheSceneIs) {
  const TemporaryFolder folder;
  const ProcessResult result = run_percuss({"check", folder.write("deck.yaml", cube)});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("A cube hits a wall"));
  EXPECT_THAT(result.out, HasSubstr("8 elements, 27 nodes, 1 body, mass 2\n"));
  EXPECT_THAT(result.out, HasSubstr("1 wall"));
  EXPECT_THAT(result.out, HasSubstr("No errors in the deck or its meshes."));
}

TEST(PercussCheck, NamesTheSpringThatLimitsTheStep) {
  const TemporaryFolder folder;
  const std::string ends = "springs: {s: {between: [{near: [-9, -9, -9]}, {near: [9, 9, 9]}], stiffness: ";
  const ProcessResult stiff = run_percuss({"check", folder.write("stiff.yaml", cube + ends + "1e20}}\n")});
  EXPECT_THAT(stiff.out, HasSubstr("(spring 's' controls it)")) << stiff.err;
  const ProcessResult soft = run_percuss({"check", folder.write("soft.yaml", cube + ends + "1e-20}}\n")});
  EXPECT_THAT(soft.out, HasSubstr("of part 'cube' controls it)")) << soft.err;
}

TEST(PercussCheck, NamesTheDampingThatMakesTheStepShorter) {
  // beta = 0.75 h halves the step h, which is 0.9 of that bound. The end is far: it does not change the step.
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const auto check = [&](const std::string& before, double beta) {
    return run_percuss(
        {"check", file, "--set", "time.end=50", "--set", fmt::format("elements.stiffness_damping={}", beta)}, before);
  };
  const double plain =
      nlohmann::json::parse(run_percuss({"check", file, "--set", "time.end=50", "--json"}).out)["first_step"];
  const std::string shorter = check("", 0.75 * plain / 0.9).out, without = check("", 0).out;
  EXPECT_THAT(shorter, HasSubstr(fmt::format("first step {:.4g} (stiffness_damping of element ", plain / 2)));
  EXPECT_THAT(shorter,
              HasSubstr(fmt::format(" of part 'cube' controls it; without this damping {:.4g}), about ", plain)));
  EXPECT_EQ(without.find("damping"), std::string::npos) << without;
  // An end that limits the first step is not of the damping.
  const std::vector<std::string> ends{"check", file,
                                      "--set", fmt::format("time.end={}", 0.3 * plain),
                                      "--set", fmt::format("elements.stiffness_damping={}", 0.75 * plain / 0.9)};
  const std::string at_end = run_percuss(ends).out;
  EXPECT_THAT(at_end, HasSubstr(fmt::format("first step {:.4g} (element ", 0.3 * plain)));
  EXPECT_EQ(at_end.find("damping"), std::string::npos) << at_end;
  const std::string on_ranks = check(launch_on(2), 0.75 * plain / 0.9).out;  // of which one has no elements
  EXPECT_THAT(on_ranks, HasSubstr(shorter.substr(0, shorter.find("No errors"))));
}

TEST(PercussCheck, RefusesAPreloadThatCutsNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const std::string start =
      "start={relaxation: {}, preload: {bolt: {part: cube, point: [0, 0, 9], normal: z, force: 1}}}";
  for (const std::string& before : {std::string(), launch_on(2)}) {
    for (const char* command : {"check", "run"}) {
      const ProcessResult result = run_percuss({command, file, "--set", start}, before);
      EXPECT_EQ(result.exit_code, 2) << result.err;
      EXPECT_EQ(
          count(result.err, "error: preload 'bolt' cuts no element (its plane lies beside part 'cube', which begins "),
          1)
          << result.err;
    }
  }
  const ProcessResult held = run_percuss({"check", file, "--set", "start={relaxation: {hold: [none]}}"});
  EXPECT_EQ(held.exit_code, 2) << held.err;
}

TEST(PercussCheck, TellsTheFormOfCylindersAndSpheres) {
  const TemporaryFolder folder;
  const std::string walls =
      "walls=[{cylinder: {axis: y, radius: 2, length: 5}, point: [0, 0, -2]}, {point: [0, 0, 9], "
      "sphere: {radius: 3}}]";
  const auto json =
      nlohmann::json::parse(run_percuss({"check", folder.write("deck.yaml", cube), "--json", "--set", walls}).out);
  const auto &pole = json["walls"][0], &ball = json["walls"][1];
  EXPECT_EQ(pole["axis"], (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(pole["radius"], 2);
  EXPECT_EQ(pole["length"], 5);
  EXPECT_EQ(ball["shape"], "sphere");
  EXPECT_EQ(ball["radius"], 3);
}

TEST(PercussCheck, TellsOfSpringsWeldsAndPairsWithFrictionOfTheirOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "deck.yaml", std::string(cube) + "springs: {s: {between: [{near: [1, 1, 1]}, cube/z_min], stiffness: 1}}\n" +
                       "welds: {w: {between: [cube/z_max, {near: [0, 0, 0]}]}}\n" +
                       "contact: {friction: {default: 0.1, pairs: [{a: cube/x_min, friction: 0.3}]}}\n");
  EXPECT_THAT(run_percuss({"check", file}).out, HasSubstr("all surfaces, friction 0.1, 0.3 of 1 pair; "));
  const auto json = nlohmann::json::parse(run_percuss({"check", file, "--json"}).out);
  std::map<std::string, int> counts;
  for (const auto& selection : json["selections"]) counts[selection["key"]] = selection["count"];
  EXPECT_EQ(counts["springs.s.between.0"], 1);
  EXPECT_EQ(counts["springs.s.between.1"], 9);
  EXPECT_EQ(counts["welds.w.between.0"], 9);
  EXPECT_EQ(counts["welds.w.between.1"], 1);
  EXPECT_EQ(counts["contact.friction.pairs.0.a"], 9);
}

TEST(PercussCheck, WritesNoFile) {
  const TemporaryFolder folder;
  run_percuss({"check", folder.write("deck.yaml", cube)});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(PercussCheck, ShowsWarnings) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const ProcessResult result = run_percuss(
      {"check", file, "--set", "materials.spare={model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("warning: material 'spare' is used by no part [unused_material]\n"));
  EXPECT_THAT(result.out, testing::EndsWith("The deck and its meshes can be run; 1 warning.\n"));
}

// Warnings about the deck, the mesh with the deck, and what the stepper does at the start: the rods part at their
// joint.
TEST(PercussCheck, WarnsOfAllThatARunWarnsOfAtItsStart) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", R"yaml(
time: {end: 0.1, max_step: 1.0e-3}
parts:
  a: {box: {size: [1, 0.02, 0.02], cells: [4, 2, 2]}, at: [0, -0.01, -0.01], material: steel, rigid: true}
  b: {box: {size: [1, 0.02, 0.02], cells: [4, 2, 2]}, at: [1, -0.01, -0.01], material: steel, rigid: true}
materials:
  steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}
  spare: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}
joints: {ab: {kind: spherical, bodies: [a, b], at: [1, 0, 0]}}
initial: [{part: a, velocity: [0, 0, 2]}]
)yaml");
  const auto checked = nlohmann::json::parse(run_percuss({"check", file, "--json"}).out)["warnings"];
  const std::string out = folder.path() + "/out";
  ASSERT_EQ(run_percuss({"run", file, "--quiet", "--out", out, "--set", "time.max_steps=1"}).exit_code, 0);
  std::vector<std::string> of_check, of_run;
  for (const auto& warning : checked) of_check.push_back(warning["rule"]);
  for (const Warning& warning : read_summary(out + "/summary.json").warnings) of_run.push_back(warning.rule);
  EXPECT_EQ(of_check, of_run);
  for (const char* rule : {"unused_material", "joint_start"}) EXPECT_THAT(of_check, testing::Contains(rule));
}

TEST(PercussCheck, RefusesASceneThatCoordinatesDoNotResolveAsARunDoes) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  std::vector<std::string> arguments = {"check", file, "--set", "parts.cube.at=[1e13, 0, 0]"};
  for (int i = 0; i < 2; ++i) {
    const ProcessResult result = run_percuss(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments[0];
    EXPECT_THAT(result.err, HasSubstr("error: at coordinates as large as 1e+13 the resolution of double precision is "))
        << arguments[0];
    EXPECT_THAT(result.err, HasSubstr("move the scene to the origin with `at` of its parts")) << arguments[0];
    arguments[0] = "run";
    arguments.insert(arguments.end(), {"--out", folder.path() + "/out"});
  }
}

TEST(PercussCheck, TellsEverySelectionThatFindsNothing) {
  const TemporaryFolder folder;
  const std::string empty = "{inside: [[8, 8, 8], [9, 9, 9]]}";
  const std::string file =
      folder.write("deck.yaml", std::string(cube) + "conditions: [{nodes: " + empty + ", fixed: x}]\n" +
                                    "loads: {pressure: [{faces: " + empty + ", value: 1}]}\n");
  const ProcessResult result = run_percuss({"check", file});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr(file + ":8:22"));
  EXPECT_THAT(result.err, HasSubstr(file + ":9:28"));
}

/// Two rigid cubes of one mass, one at rest, that meet with a coefficient of restitution e: (1 - e^2) / 2 of the energy
/// is lost.
TEST(PercussRun, EndsWithWhatContactTook) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", R"yaml(time: {end: 2, max_step: 0.01}
parts:
  a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: soft, rigid: true}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [1.1, 0, 0], material: soft, rigid: true}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: a, velocity: [0.1, 0, 0]}]
contact: {surfaces: all, restitution: 0.5}
)yaml");
  const auto run = [&](const std::string& e) {
    const std::string out = folder.path() + "/" + e;
    const std::string last_lines = run_percuss({"run", file, "--out", out, "--set", "contact.restitution=" + e}).err;
    return last_lines + run_percuss({"info", out}).out;
  };
  EXPECT_THAT(run("0.5"), AllOf(HasSubstr("contact: normal contact took 0.00375, 37.5 % of the largest energy ("),
                                HasSubstr("\n          normal contact took 0.00375, 37.5 %")));
  EXPECT_THAT(run("0.96"), Not(HasSubstr("contact took")));  // 3.9 %
}

TEST(PercussRun, WritesItsResultsAndInfoReadsThem) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/new/results";
  const ProcessResult result = run_percuss({"run", folder.write("deck.yaml", cube), "--out", out});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, testing::ContainsRegex("energy error -?[0-9.]+e-[0-9]+  contacts"));
  EXPECT_THAT(result.err, testing::ContainsRegex("\ncompleted: .*; energy error -?[0-9.]+e-[0-9]+\nresults: "));
  for (const char* file : {"summary.json", "ranks.csv", "history.csv", "fields.vtkhdf", "fields.xdmf"}) {
    EXPECT_TRUE(fs::exists(out + "/" + file)) << file;
  }
  const Summary summary = read_summary(out + "/summary.json");
  EXPECT_EQ(summary.status, "completed");
  EXPECT_EQ(summary.elements, 8);
  EXPECT_DOUBLE_EQ(summary.time, 0.5);
  const ProcessResult info = run_percuss({"info", out});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr("completed"));
  EXPECT_THAT(info.out, HasSubstr(summary.state_hash));
  EXPECT_THAT(info.out, HasSubstr("velocity"));
  EXPECT_EQ(run_percuss({"info", out + "/fields.vtkhdf"}).exit_code, 0);
  EXPECT_EQ(run_percuss({"info", out + "/summary.json"}).exit_code, 0);
}

TEST(PercussInfo, ListsTimesAndFieldsOfMeshFilesWithResults) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const ProcessResult run = run_percuss({"run", folder.write("deck.yaml", cube), "--out", out, "--set",
                                         "output.fields={every: 0.25, format: exodus, write: [velocity, stress]}"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string exodus = run_percuss({"info", out + "/fields.exo"}).out;
  EXPECT_THAT(exodus, HasSubstr("times       3 steps, 0 to 0.5\nfields      displacement, of nodes, 3 components\n"));
  EXPECT_THAT(exodus, HasSubstr("\n            velocity, of nodes, 3 components\n"));
  EXPECT_THAT(exodus, HasSubstr("\n            stress, of elements, 6 components\n"));
  const std::string vtu = run_percuss({"info", folder.write("cube.vtu", R"xml(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">
<CellData><DataArray type="Float64" Name="temperature" format="ascii">300</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)xml")})
                              .out;
  EXPECT_THAT(vtu, HasSubstr("\nfields      temperature, of elements\n"));
}

TEST(PercussHelp, IsThatOfTheToolItself) {
  for (const char* tool :
       {"plot", "report", "watch", "stop", "render", "import", "view", "export", "sweep", "build-law"}) {
    const ProcessResult help = run_percuss({"help", tool});
    EXPECT_EQ(help.exit_code, 0) << help.err;
    EXPECT_THAT(help.out, testing::StartsWith(std::string("Usage: percuss ") + tool + " ")) << help.err;
    EXPECT_EQ(help.out, run_percuss({tool, "--help"}).out);
  }
}

TEST(PercussRun, SaysThatTheNumberOfStepsHasEndedIt) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out", file = folder.write("deck.yaml", cube);
  const ProcessResult result =
      run_percuss({"run", file, "--out", out, "--set", "time.max_steps=2", "--set", "time.max_step=1e-3"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_summary(out + "/summary.json").status, "completed");
  EXPECT_THAT(result.err, HasSubstr("\nstopped by time.max_steps at 0.4 % of time.end\n"));  // 2e-3 of 0.5
  EXPECT_THAT(run_percuss({"info", out}).out,
              HasSubstr("status    completed, stopped by time.max_steps at 0.4 % of time.end\n"));
}

TEST(PercussRun, TellsOfElementsThatHaveFailed) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", R"yaml(
time: {end: 0.02, max_step: 1.0e-3}
parts: {bar: {box: {size: [3, 1, 1], cells: [3, 1, 1]}, material: weak}}
materials: {weak: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0, failure: {principal_stress: 1}}}
conditions: [{nodes: bar/x_min, fixed: x}, {nodes: bar/x_max, velocity: {x: 1}}]
)yaml");
  const ProcessResult result = run_percuss({"run", file, "--out", folder.path() + "/out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("\neroded: 1 of 3 elements failed and were eroded, mass 2, energy "));
  EXPECT_THAT(run_percuss({"info", folder.path() + "/out"}).out,
              HasSubstr("\neroded    1 of 3 elements failed and were eroded, mass 2, energy "));
}

TEST(PercussRun, AuditsTheSameEnergiesWithAndWithoutOutput) {
  const TemporaryFolder folder;
  const std::string scene =
      "time: {end: 2.0e-4}\n"
      "parts:\n"
      "  cube: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, material: steel}\n"
      "materials:\n"
      "  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}\n"
      "initial: [{part: cube, velocity: [-10, 0, 0]}]\n"
      "walls: [{point: [0, 0, 0], normal: [1, 0, 0]}]\n";
  Summary summaries[2];
  for (int i = 0; i < 2; ++i) {
    const std::string file = folder.write("deck.yaml", scene + (i == 0 ? "" : "output: {history: {every: 0}}\n"));
    const std::string out = folder.path() + "/" + std::to_string(i);
    EXPECT_EQ(run_percuss({"run", file, "--quiet", "--out", out}).exit_code, 0);
    summaries[i] = read_summary(out + "/summary.json");
  }
  EXPECT_NEAR(summaries[0].energy.initial, 392.5, 1e-9);  // m v^2 / 2
  EXPECT_EQ(summaries[0].energy.initial, summaries[1].energy.initial);
  EXPECT_EQ(summaries[0].energy.kinetic, summaries[1].energy.kinetic);
  EXPECT_NE(summaries[0].energy.error, 0);
}

TEST(PercussRun, AnEnergyBoundThatIsLeftEndsItWithoutAnyOutput) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", std::string(cube) + "audit: {max_energy_error: 1.0e-30}\n");
  const ProcessResult result = run_percuss({"run", file, "--quiet", "--out", folder.path() + "/out", "--set",
                                            "initial=[{part: all, angular_velocity: [1, 2, 3]}]"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("audit.max_energy_error"));
  EXPECT_EQ(read_summary(folder.path() + "/out/summary.json").status, "failed");
}

TEST(PercussRun, AReaderThatGoesAwayDoesNotEndIt) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  run_percuss({"run", folder.write("deck.yaml", cube), "--out", out}, "sh -c '\"$@\" 2>&1 | true' sh");
  EXPECT_EQ(read_summary(out + "/summary.json").status, "completed");
}

TEST(PercussRun, ForceKeepsEarlierResultsUntilTheSceneIsSound) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  ASSERT_EQ(run_percuss({"run", folder.write("deck.yaml", cube), "--quiet", "--out", out}).exit_code, 0);
  const std::string wrong = folder.write(
      "wrong.yaml",
      std::string(cube) + "conditions: [{nodes: {name: all, inside: [[90, 90, 90], [91, 91, 91]]}, fixed: x}]\n");
  EXPECT_EQ(run_percuss({"run", wrong, "--quiet", "--force", "--out", out}).exit_code, 2);
  EXPECT_EQ(read_summary(out + "/summary.json").status, "completed");
}

TEST(PercussRun, GivesTheSameStateAgain) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  std::string hashes[2];
  for (int i = 0; i < 2; ++i) {
    const std::string out = folder.path() + "/" + std::to_string(i);
    EXPECT_EQ(run_percuss({"run", file, "--quiet", "--out", out}, i == 0 ? "env OMP_NUM_THREADS=1" : "").exit_code, 0);
    hashes[i] = read_summary(out + "/summary.json").state_hash;
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(PercussRun, IsSilentWhenItIsToldTo) {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_percuss({"run", folder.write("deck.yaml", cube), "-q", "-o", folder.path() + "/out"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
}

/// Two warnings: one of the deck, one of the start.
const std::vector<std::string> doubtful = {
    "--set", "materials.spare={model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}",
    "--set", "parts.cube.at=[0, 0, -5]",
    "--set", "initial=[]",
    "--set", "silence=[still_scene]"};

ProcessResult run_doubtful(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "run");
  arguments.insert(arguments.end(), doubtful.begin(), doubtful.end());
  return run_percuss(arguments);
}

TEST(PercussRun, TellsWarningsWhenItIsQuietAndKeepsThem) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube), out = folder.path() + "/out";
  const ProcessResult result = run_doubtful({file, "--quiet", "--out", out});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, testing::StartsWith("--set materials.spare: warning: material 'spare' is used by no part"));
  EXPECT_EQ(count(result.err, "warning: "), 2) << result.err;
  EXPECT_EQ(count(result.err, "\n"), 2) << result.err;
  const std::vector<Warning> warnings = read_summary(out + "/summary.json").warnings;
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].rule, "unused_material");
  EXPECT_EQ(warnings[1].rule, "behind_wall");
  for (const std::string& results : {out, out + "/summary.json"}) {
    const ProcessResult info = run_percuss({"info", results});
    for (const Warning& warning : warnings) EXPECT_THAT(info.out, HasSubstr(format_warning(warning) + "\n"));
    EXPECT_THAT(info.out, HasSubstr("\n2 warnings\n"));
  }
}

TEST(PercussRun, CountsItsWarningsInItsLastLine) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const ProcessResult result = run_doubtful({folder.write("deck.yaml", cube), "--out", out});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(count(result.err, ": warning: ") + count(result.err, "\nwarning: "), 2) << result.err;
  EXPECT_THAT(result.err, testing::EndsWith("\n2 warnings: see " + out + "/summary.json\n"));
}

TEST(PercussRun, KeepsItsWarningsOverARestart) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube), out = folder.path() + "/out";
  ASSERT_EQ(run_doubtful(
                {file, "--quiet", "--out", out, "--set", "time.end=0.25", "--set", "output.checkpoint={every: 0.25}"})
                .exit_code,
            0);
  const ProcessResult result =
      run_doubtful({file, "--quiet", "--restart", out + "/checkpoint.h5", "--set", "output.checkpoint={every: 0.25}"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(count(result.err, "warning: "), 1) << result.err;  // of the deck, which is read again
  const std::vector<Warning> warnings = read_summary(out + "/summary.json").warnings;
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].rule, "unused_material");
  EXPECT_EQ(warnings[1].rule, "behind_wall");
  for (const Warning& warning : warnings) EXPECT_EQ(warning.count, 1);
}

TEST(PercussRun, TakesSettings) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const ProcessResult result = run_percuss({"run", "--set", "time.max_steps=3", folder.write("deck.yaml", cube), "-o",
                                            out, "-s", "parts.cube.box.cells=[1, 1, 1]"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_summary(out + "/summary.json").steps, 3);
  EXPECT_EQ(read_summary(out + "/summary.json").elements, 1);
}

TEST(PercussRun, OverwritesNothingUnasked) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const std::string out = folder.path() + "/out";
  fs::create_directory(out);
  folder.write("out/notes.txt", "mine");
  const ProcessResult refused = run_percuss({"run", file, "-o", out});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(run_percuss({"run", file, "-o", out, "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out + "/notes.txt"));
  const auto written = fs::last_write_time(out + "/summary.json");
  EXPECT_EQ(run_percuss({"run", file, "-o", out}).exit_code, 2);
  EXPECT_EQ(fs::last_write_time(out + "/summary.json"), written);
  EXPECT_EQ(run_percuss({"run", file, "-o", file}).exit_code, 2);
}

TEST(PercussRun, ExitsWithThreeWhenTheRunFails) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  // No run keeps its energy to this.
  const ProcessResult result =
      run_percuss({"run", folder.write("deck.yaml", cube), "-o", out, "--set", "audit.max_energy_error=1e-30"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("audit.max_energy_error"));
  EXPECT_EQ(read_summary(out + "/summary.json").status, "failed");
}

TEST(PercussRun, ExitsWithFourWhenTheSystemFails) {
  const TemporaryFolder folder;
  const ProcessResult result = run_percuss({"run", folder.write("deck.yaml", cube), "-o", "/proc/percuss/out"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("/proc/percuss/out"));
}

TEST(PercussRun, EndsCleanlyWhenItIsInterrupted) {
  for (const int signal_number : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    const std::string out = folder.path() + "/out";
    const std::string file = folder.write("deck.yaml", cube);
    const ProcessResult result =
        interrupt_percuss({"run", file, "-o", out, "--set", "time.end=1e9", "--set", "output={history: {every: 1}}"},
                          out + "/history.csv", signal_number);
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_EQ(read_summary(out + "/summary.json").status, "interrupted");
    EXPECT_THAT(result.err, HasSubstr("to continue: percuss run " + file +
                                      " --set time.end=1e9 --set 'output={history: {every: 1}}' --restart " + out +
                                      "/checkpoint.h5"));
    EXPECT_THAT(run_percuss({"info", out}).out, HasSubstr("checkpoint of a percuss run, whole and undamaged"));
  }
}

TEST(PercussRun, RefusesARestartFromWhatIsNoCheckpoint) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const ProcessResult none = run_percuss({"run", file, "--restart", folder.path() + "/none.h5"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("none.h5: error: no such file"));
  const ProcessResult empty = run_percuss({"run", file, "--restart", folder.path()});
  EXPECT_EQ(empty.exit_code, 2);
  EXPECT_THAT(empty.err, HasSubstr("checkpoint.h5: error: no such file"));
  const ProcessResult text = run_percuss({"run", file, "--restart", file});
  EXPECT_EQ(text.exit_code, 2);
  EXPECT_THAT(text.err, HasSubstr("deck.yaml: error: not a checkpoint (it is no HDF5 file): name checkpoint.h5 or its "
                                  "folder"));
  const ProcessResult cut = run_percuss({"run", file, "--restart", folder.write("cut.h5", "HDF")});
  EXPECT_EQ(cut.exit_code, 2);
  EXPECT_THAT(cut.err, HasSubstr("cut.h5: error: not a checkpoint, or not a whole one"));
}

TEST(PercussInfo, ReadsOnlyWhatItKnows) {
  const TemporaryFolder folder;
  EXPECT_THAT(run_percuss({"info", folder.write("deck.yaml", cube)}).err, HasSubstr("percuss check"));
  for (const std::string& file :
       {folder.path(), folder.path() + "/none", folder.write("a.json", "{\"a\": 1}"),
        folder.write("a.vtkhdf", "\x89HDF\r\n\x1a\n"), folder.write("a.e", "CDF\x01"), folder.write("empty", "")}) {
    const ProcessResult result = run_percuss({"info", file});
    EXPECT_EQ(result.exit_code, 2) << file << ": " << result.err;
    EXPECT_THAT(result.err, HasSubstr("error: ")) << file;
  }
}

TEST(Percuss, FailsWhenItsOutputIsLost) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", cube);
  const std::string script = folder.write("full.sh", "\"$@\" >/dev/full\n");
  EXPECT_EQ(run_percuss({"check", file}, "sh " + script).exit_code, 4);
}

}  // namespace
}  // namespace percuss
