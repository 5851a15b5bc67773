// summary.json: its keys, their order, and that it reads back.

#include "src/output/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "src/error.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/output/sample_run.hpp"

namespace percuss {
namespace {

using testing::HasSubstr;

std::string read_whole(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// "dt.min" for a key within an object, in the order of the file.
void list_keys(const nlohmann::ordered_json& object, const std::string& prefix, std::vector<std::string>& keys) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      list_keys(value, prefix + key + ".", keys);
    } else {
      keys.push_back(prefix + key);
    }
  }
}

Summary make_summary() {
  Summary summary;
  summary.status = "completed";
  summary.version = "0.1.0";
  summary.backend = "OpenMP";
  summary.threads = 2;
  summary.elements = 8400;
  summary.steps = 123456789012;
  summary.time = 0.1;
  summary.dt.min = 1.0 / 3e6;
  summary.dt.element = 17;
  summary.phases_s.contact_check = 0.25;
  summary.earlier = {2, 30, 0.5, 1.5, {}};
  summary.earlier.phases_s.halo = 0.75;
  summary.energy.error = 1e-300;
  summary.momentum.linear[1] = -0.0;
  summary.momentum.angular[2] = 5e-324;
  summary.messages.bytes = 3;
  summary.peak_bytes = 1234567890123;
  summary.state_hash = "0123456789abcdef";
  summary.warnings = {{"hourglass_energy", "too soft", "part 'a'", 0.25, 3}, {"behind_wall", "a \"wall\"", "", 0, 1}};
  return summary;
}

TEST(Summary, HasExactlyTheKeysThatItPromisesInTheirOrder) {
  const sample::TemporaryFolder folder;
  write_summary(folder.file("summary.json"), Summary{});
  std::vector<std::string> keys;
  list_keys(nlohmann::ordered_json::parse(read_whole(folder.file("summary.json"))), "", keys);
  const std::vector<std::string> promised{"status",
                                          "error",
                                          "warnings",
                                          "version",
                                          "backend",
                                          "precision",
                                          "ranks",
                                          "threads",
                                          "elements",
                                          "nodes",
                                          "contact_nodes",
                                          "contact_faces",
                                          "steps",
                                          "time",
                                          "end_time",
                                          "ended_by",
                                          "restart_changes",
                                          "sensors",
                                          "dt.min",
                                          "dt.max",
                                          "dt.last",
                                          "dt.element",
                                          "dt.spring",
                                          "dt.estimate",
                                          "dt.estimates",
                                          "dt.gain",
                                          "dt.approach",
                                          "mass.added",
                                          "mass.share",
                                          "mass.in_run",
                                          "mass.energy",
                                          "relaxation.state",
                                          "relaxation.damped_steps",
                                          "relaxation.kinetic_ratio",
                                          "relaxation.scale",
                                          "relaxation.frequency",
                                          "relaxation.energy",
                                          "relaxation.preload_error",
                                          "relaxation.contact_stored",
                                          "setup_s",
                                          "loop_s",
                                          "grind_ns",
                                          "phases_s.internal_force",
                                          "phases_s.halo",
                                          "phases_s.integrate",
                                          "phases_s.contact_rcb",
                                          "phases_s.contact_search",
                                          "phases_s.contact_check",
                                          "phases_s.contact_enforce",
                                          "phases_s.reduce",
                                          "phases_s.estimate",
                                          "phases_s.output",
                                          "earlier.runs",
                                          "earlier.steps",
                                          "earlier.setup_s",
                                          "earlier.loop_s",
                                          "earlier.phases_s.internal_force",
                                          "earlier.phases_s.halo",
                                          "earlier.phases_s.integrate",
                                          "earlier.phases_s.contact_rcb",
                                          "earlier.phases_s.contact_search",
                                          "earlier.phases_s.contact_check",
                                          "earlier.phases_s.contact_enforce",
                                          "earlier.phases_s.reduce",
                                          "earlier.phases_s.estimate",
                                          "earlier.phases_s.output",
                                          "skipped.chunk_updates",
                                          "skipped.searches",
                                          "skipped.pair_checks",
                                          "skipped.wall_looks",
                                          "skipped.enforcements",
                                          "skipped.rebalances",
                                          "energy.initial",
                                          "energy.kinetic",
                                          "energy.internal",
                                          "energy.hourglass",
                                          "energy.viscous",
                                          "energy.folding",
                                          "energy.contact",
                                          "energy.friction",
                                          "energy.damping",
                                          "energy.external",
                                          "energy.error",
                                          "energy.contact_taken",
                                          "energy.largest",
                                          "momentum.linear",
                                          "momentum.angular",
                                          "momentum.linear_error",
                                          "momentum.angular_error",
                                          "eroded.elements",
                                          "eroded.mass",
                                          "eroded.energy",
                                          "eroded.vanished_mass",
                                          "balance.elements",
                                          "balance.contact",
                                          "messages.count",
                                          "messages.bytes",
                                          "decomposition.rebalances",
                                          "decomposition.worst_imbalance",
                                          "decomposition.rounds_per_cut",
                                          "decomposition.ghost_faces",
                                          "peak_bytes",
                                          "state_hash",
                                          "deck.file",
                                          "deck.settings",
                                          "deck.values"};
  EXPECT_EQ(keys, promised);
}

TEST(Summary, ReadsBackToTheSameValues) {
  const sample::TemporaryFolder folder;
  const std::string path = folder.file("summary.json");
  write_summary(path, make_summary());
  const Summary read = read_summary(path);
  EXPECT_EQ(read.status, "completed");
  EXPECT_EQ(read.threads, 2);
  EXPECT_EQ(read.steps, 123456789012);
  EXPECT_EQ(read.time, 0.1);
  EXPECT_EQ(read.dt.min, 1.0 / 3e6);
  EXPECT_EQ(read.dt.element, 17);
  EXPECT_EQ(read.phases_s.contact_check, 0.25);
  EXPECT_EQ(read.earlier.steps, 30);
  EXPECT_EQ(read.earlier.phases_s.halo, 0.75);
  EXPECT_EQ(read_earlier(write_earlier(read.earlier), "checkpoint").loop_s, 1.5);
  EXPECT_ERROR(read_earlier("[]", "checkpoint"), InputError, "is not JSON");
  EXPECT_EQ(read.energy.error, 1e-300);
  EXPECT_TRUE(std::signbit(read.momentum.linear[1]));
  EXPECT_EQ(read.momentum.angular[2], 5e-324);
  EXPECT_EQ(read.peak_bytes, 1234567890123);
  EXPECT_EQ(read.state_hash, "0123456789abcdef");
  ASSERT_EQ(read.warnings.size(), 2U);
  EXPECT_EQ(format_warning(read.warnings[0]),
            "part 'a': warning: too soft [hourglass_energy] (first at t = 0.25, 3 times)");
  const std::string text = read_whole(path);
  write_summary(path, read);  // every other member as well
  EXPECT_EQ(read_whole(path), text);
}

TEST(Summary, WritesWhatIsNotFiniteAsNullAndReadsItAsNan) {
  const sample::TemporaryFolder folder;
  Summary summary = make_summary();
  summary.energy.kinetic = NAN;
  write_summary(folder.file("summary.json"), summary);
  EXPECT_THAT(read_whole(folder.file("summary.json")), HasSubstr("\"kinetic\": null"));
  EXPECT_TRUE(std::isnan(read_summary(folder.file("summary.json")).energy.kinetic));
}

void expect_refusal(const std::string& text, const std::string& message) {
  const sample::TemporaryFolder folder;
  const std::string path = folder.file("summary.json");
  std::ofstream(path) << text;
  try {
    read_summary(path);
    ADD_FAILURE() << "took for a summary: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path + message));
  }
}

TEST(Summary, KeepsTheValuesOfTheDeckAndReadsSummariesThatHaveNone) {
  const sample::TemporaryFolder folder;
  const std::string path = folder.file("summary.json");
  Summary summary = make_summary();
  summary.deck = {"deck.yaml", "{\"time\":{\"end\":0.1},\"walls\":[1,null,\"x\"]}", {"time.end=0.1"}};
  write_summary(path, summary);
  const Summary read = read_summary(path);
  EXPECT_EQ(read.deck.file, summary.deck.file);
  EXPECT_EQ(read.deck.values, summary.deck.values);
  EXPECT_EQ(read.deck.settings, summary.deck.settings);
  auto json = nlohmann::ordered_json::parse(read_whole(path));
  json["deck"]["values"] = 3;
  expect_refusal(json.dump(), ": error: 'deck.values' is not an object");
  json.erase("deck");
  std::ofstream(path) << json.dump();
  EXPECT_EQ(read_summary(path).deck.values, "");
}

TEST(Summary, IsWrittenEvenIfTheErrorTextIsNotUtf8) {
  const sample::TemporaryFolder folder;
  Summary summary = make_summary();
  summary.error = "cannot read '\xff\xfe.exo'";
  write_summary(folder.file("summary.json"), summary);
  EXPECT_THAT(read_summary(folder.file("summary.json")).error, HasSubstr(".exo"));
}

TEST(Summary, KeepsTheOldFileWhenTheNewOneCannotBeWritten) {
  const sample::TemporaryFolder folder;
  const std::string path = folder.file("summary.json");
  write_summary(path, make_summary());
  std::filesystem::create_directory(path + ".tmp");  // where the new one would be prepared
  EXPECT_ERROR(write_summary(path, Summary{}), SystemError, "cannot write");
  EXPECT_EQ(read_summary(path).status, "completed");
}

TEST(Summary, RefusesWhatIsNotASummaryWithItsPlace) {
  expect_refusal("", ":1:1: error: this is not JSON");
  expect_refusal("{\n  \"status\": completed\n}\n", ":2:13: error: this is not JSON");
  expect_refusal("[1, 2]", ":1:1: error: this is not a JSON object");
  expect_refusal("{}", ": error: 'status' is missing");
}

TEST(Summary, NamesTheKeyThatHasAWrongType) {
  const sample::TemporaryFolder folder;
  const std::string path = folder.file("summary.json");
  write_summary(path, make_summary());
  auto json = nlohmann::ordered_json::parse(read_whole(path));
  json["warnings"][1]["count"] = "many";
  expect_refusal(json.dump(), ": error: 'warnings' is not a list of warnings");
  json.erase("warnings");  // of a percuss that listed none
  json["momentum"]["linear"] = {1, 2};
  expect_refusal(json.dump(), ": error: 'momentum.linear' is not a list of three numbers");
  json["dt"]["element"] = 1.5;
  expect_refusal(json.dump(), ": error: 'dt.element' is not a whole number");
}

TEST(Summary, TellsWhyAFileCannotBeRead) {
  EXPECT_ERROR(read_summary("/dev/null/summary.json"), SystemError, "Not a directory");
  EXPECT_ERROR(read_summary("/"), SystemError, "Is a directory");
}

}  // namespace
}  // namespace percuss
