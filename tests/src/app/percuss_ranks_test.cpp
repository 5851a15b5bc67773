// The executable under mpirun: what is said once, and what does not depend on the ranks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "src/output/summary.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Without contact: two blocks that fly and deform.
const char* const flying_blocks = R"yaml(title: Two blocks fly
time: {end: 0.5, max_steps: 20}
parts:
  one: {box: {size: [1, 1, 1], cells: [8, 8, 8]}, material: soft}
  two: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [0, 0, 3], material: soft}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: one, velocity: [0, 0, 0.1], angular_velocity: [0, 0, 1]}]
output: {history: {every: 0}}
)yaml";

TEST(PercussOnRanks, RunsAndReportsOnce) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const ProcessResult result = run_percuss({"run", folder.write("deck.yaml", flying_blocks), "-o", out}, launch_on(3));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(count(result.err, "completed: t ="), 1) << result.err;
  const Summary summary = read_summary(out + "/summary.json");
  EXPECT_EQ(summary.ranks, 3);
  EXPECT_EQ(summary.elements, 576);
  EXPECT_GT(summary.messages.count, 0);
  EXPECT_GE(summary.balance.elements, 1);
}

TEST(PercussOnRanks, ChecksAndPrintsOnceWhatOneRankPrints) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", flying_blocks);
  const ProcessResult alone = run_percuss({"check", file});
  const ProcessResult result = run_percuss({"check", file}, launch_on(3));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, alone.out);
}

TEST(PercussOnRanks, TellsOfWrongInputOnce) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("deck.yaml", std::string(flying_blocks) +
                                    "conditions: [{nodes: {name: one, inside: [[8, 8, 8], [9, 9, 9]]}, fixed: x}]\n");
  const ProcessResult result = run_percuss({"run", file, "-o", folder.path() + "/out"}, launch_on(2));
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(count(result.err, "'one' has no nodes inside the box"), 1) << result.err;
  EXPECT_EQ(run_percuss({"run", "--nonsense"}, launch_on(2)).exit_code, 2);
}

TEST(PercussOnRanks, TellsOfAFailedRunOnceAndWritesItsSummary) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out";
  const ProcessResult result = run_percuss(
      {"run", folder.write("deck.yaml", flying_blocks), "-o", out, "--set", "audit={max_energy_error: 1e-30}"},
      launch_on(2));
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_EQ(count(result.err, "audit.max_energy_error ="), 1) << result.err;
  EXPECT_EQ(read_summary(out + "/summary.json").status, "failed");
}

TEST(PercussOnRanks, TellsOfAFailedSystemOnce) {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_percuss({"run", folder.write("deck.yaml", flying_blocks), "-o", "/proc/percuss/out"}, launch_on(2));
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_EQ(count(result.err, "folder /proc/percuss/out cannot be created"), 1) << result.err;
}

TEST(PercussOnRanks, SaysThatRanksHaveNoElements) {
  const TemporaryFolder folder;
  const ProcessResult result =
      run_percuss({"run", folder.write("deck.yaml", flying_blocks), "-o", folder.path() + "/out", "--set",
                   "parts.one.box.cells=[1, 1, 1]", "--set", "parts.two.box.cells=[1, 1, 1]"},
                  launch_on(3));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(count(result.err, "warning: 1 of 3 ranks have no elements (the mesh has 2 chunks"), 1) << result.err;
}

TEST(PercussOnRanks, HelpsOnce) {
  const ProcessResult result = run_percuss({"--help"}, launch_on(2));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(count(result.out, "Exit codes:"), 1);
}

TEST(PercussPlan, TellsTheDivisionOverManyRanksAndWritesNoFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", flying_blocks);
  const ProcessResult result = run_percuss({"plan", file, "--ranks", "1,3"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, HasSubstr("Two blocks fly"));
  EXPECT_THAT(result.out, HasSubstr("576 elements in 9 chunks"));
  EXPECT_THAT(result.out, HasSubstr("elements per rank, mean        576.0   192.0\n"));
  const std::string check = run_percuss({"check", file}).out, steps = check.substr(check.find("first step "), 15);
  EXPECT_THAT(result.out, HasSubstr(steps)) << check;
  EXPECT_THAT(result.out, HasSubstr("\ncore hours "));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  EXPECT_EQ(run_percuss({"plan", file, "--ranks", "1,3"}, launch_on(2)).out, result.out);
}

/// The number that a line of a table with one column of numbers ends with.
double find_planned(const std::string& table, const std::string& label) {
  const std::size_t line = table.find("\n" + label);
  if (line == std::string::npos) return -1;
  return std::stod(table.substr(line + 1 + label.size()));
}

// One plate slides over the other, within reach of the search, and does not touch it.
TEST(PercussPlan, ForecastsWhatARunSends) {
  const TemporaryFolder folder;
  const std::string out = folder.path() + "/out", file = folder.write("deck.yaml", R"yaml(
time: {end: 100, max_steps: 150}
parts:
  lower: {box: {size: [2, 1, 0.1], cells: [20, 10, 1]}, material: soft}
  upper: {box: {size: [2, 1, 0.1], cells: [18, 9, 1]}, at: [0.03, 0.02, 0.13], material: soft}
materials: {soft: {model: elastic, density: 2, youngs_modulus: 100, poissons_ratio: 0.25}}
initial: [{part: upper, velocity: [0.05, 0, 0]}]
contact: {surfaces: all}
)yaml");
  const ProcessResult run = run_percuss({"run", file, "-o", out}, launch_on(3));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Summary summary = read_summary(out + "/summary.json");
  ASSERT_LT(summary.skipped.searches, 1);
  const std::string steps = std::to_string(1 / (1 - summary.skipped.searches));
  const ProcessResult plan =
      run_percuss({"plan", file, "--ranks", "3", "--iterations", "0", "--steps-per-search", steps});
  EXPECT_THAT(plan.out,
              HasSubstr("\ncontacts 0, those of the start, for the whole run; bodies that meet later send more"));
  for (const auto& [what, sent] : {std::pair("messages", static_cast<double>(summary.messages.count)),
                                   std::pair("bytes", static_cast<double>(summary.messages.bytes))}) {
    const double planned = find_planned(plan.out, std::string("halo ") + what + " per step, mean") +
                           find_planned(plan.out, std::string("contact ") + what + " per step, mean");
    EXPECT_NEAR(planned, sent, 0.2 * sent) << what << " with " << steps << " steps per search\n" << plan.out;
  }
}

TEST(PercussPlan, RefusesAWrongDeckWithItsPlace) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("deck.yaml", std::string(flying_blocks) + "contact: {surfaces: [[one, three]]}\n");
  for (const auto& before : {std::string(), launch_on(2)}) {
    const ProcessResult result = run_percuss({"plan", file, "--ranks", "2"}, before);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(count(result.err, file + ":9:28: error: unknown part 'three'"), 1) << result.err;
  }
}

TEST(PercussSchema, PrintsOneObjectAndNothingElse) {
  for (const std::string& before : {std::string(), launch_on(2)}) {
    const ProcessResult result = run_percuss({"schema"}, before);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, testing::StartsWith("{\n"));
    EXPECT_EQ(result.out.find("\n}\n"), result.out.size() - 3);
  }
}

TEST(PercussOnRanks, StoppedGoesOnOnOthersToTheSameBits) {
  const TemporaryFolder folder;
  const std::string file = folder.write("deck.yaml", flying_blocks), out = folder.path() + "/out",
                    whole = folder.path() + "/whole";
  const auto steps = [](int count) { return "time.max_steps=" + std::to_string(count); };
  // Long enough to be stopped on the way. SIGUSR1: mpirun leaves its ranks only a second after SIGTERM.
  const ProcessResult stopped =
      interrupt_percuss({"run", file, "-o", out, "--set", steps(1'000'000), "--set", "time.end=1e6"},
                        out + "/history.csv", SIGUSR1, launch_on(2));
  EXPECT_NE(stopped.exit_code, 0);
  const Summary first = read_summary(out + "/summary.json");
  EXPECT_EQ(first.status, "interrupted") << stopped.err;
  const int end = static_cast<int>(first.steps) + 9;
  for (const auto& [launch, arguments] :
       {std::pair(launch_on(3), std::vector<std::string>{"run", file, "--restart", out}),
        std::pair(std::string(), std::vector<std::string>{"run", file, "-o", whole})}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--set", steps(end), "--set", "time.end=1e6"});
    const ProcessResult result = run_percuss(all, launch);
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_EQ(read_summary(out + "/summary.json").state_hash, read_summary(whole + "/summary.json").state_hash);
}

}  // namespace
}  // namespace percuss
