// What a restart tells of the values of the deck that have changed since the checkpoint.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "src/deck/reading/read_deck.hpp"
#include "src/step/run/run.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

std::string make_flight(const std::string& time, const std::string& output) {
  return "title: a flight\ntime: " + time + R"(
parts: {a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.3}}
initial: [{part: a, velocity: [0, 0, 3]}]
audit: {max_energy_error: 0.1}
output: {checkpoint: {every: 10}, )" +
         output + "}\n";
}

Summary run_to_end(const std::string& deck, const std::string& folder, const std::string& restart) {
  RunOptions options;
  options.out_dir = folder;
  options.restart = restart;
  return run_scene(parse_deck(deck, "deck.yaml"), options).summary;
}

}  // namespace

TEST(RestartChanges, AreListedInTheSummary) {
  const TemporaryFolder first, same, other;
  const std::string history = "history: {every: 0, nodes: [{name: n, id: 1}]}";
  const std::string deck = make_flight("{end: 1, max_steps: 5}", history);
  EXPECT_TRUE(run_to_end(deck, first.path(), "").restart_changes.empty());
  const std::string checkpoint = first.path() + "/checkpoint.h5";
  EXPECT_TRUE(run_to_end(deck, same.path(), checkpoint).restart_changes.empty());
  std::string changed = make_flight("{end: 2.0, max_steps: 8}", "history: {every: 1e-3}");
  changed.replace(changed.find("a flight"), 8, "a long flight");
  changed.replace(changed.find("max_energy_error: 0.1"), 21, "max_energy_error: 1.0e-1");  // the same number
  const Summary summary = run_to_end(changed, other.path(), checkpoint);
  EXPECT_EQ(summary.steps, 8);
  const std::vector<std::string> expected{"output.history.every is 0.001 (0 in the checkpoint)",
                                          "time.end is 2 (1 in the checkpoint)",
                                          "time.max_steps is 8 (5 in the checkpoint)",
                                          "title is a long flight (a flight in the checkpoint)",
                                          "output.history.nodes.0.id is not given (1 in the checkpoint)",
                                          "output.history.nodes.0.name is not given (n in the checkpoint)"};
  EXPECT_EQ(summary.restart_changes, expected);
  std::ifstream file(other.path() + "/summary.json");
  EXPECT_EQ(nlohmann::json::parse(file)["restart_changes"].size(), expected.size());
}

}  // namespace percuss::test
