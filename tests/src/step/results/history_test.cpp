// History points and the rows of history.csv.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "src/error.hpp"
#include "src/step/results/history.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/scene.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

std::string make_history_text(const std::string& output) {
  return R"(time: {end: 1e-4}
parts:
  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}
  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [1, 0, 0], material: steel}
output:
  history: {every: 1e-5, )" +
         output + "}\ninitial: [{part: b, velocity: [0, 0, 3]}]\n" + steel_text;
}

std::vector<FollowedPoint> find_points(const std::string& output) {
  const Scene scene(make_history_text(output));
  return find_history_points(scene.deck, scene.chunked);
}

std::string take_points_error(const std::string& output) {
  try {
    find_points(output);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(HistoryPoints, AreTheNearestNodeOrElementOfTheSearchedPart) {
  const Scene scene(
      make_history_text("nodes: [{name: n, near: [0.9, 0.1, 0]}, {name: m, near: [0.9, 0.1, 0], part: b}], "
                        "elements: [{name: e, near: [1.1, 0.9, 0.9]}, {name: f, near: [5, 5, 5], part: a}]"));
  const Mesh& mesh = scene.chunked.mesh;
  const std::vector<FollowedPoint> points = find_history_points(scene.deck, scene.chunked);
  ASSERT_EQ(points.size(), 4u);
  const auto part_of_node = [&](int node) {
    const auto& set = mesh.node_sets.at("a");
    return std::find(set.begin(), set.end(), node) != set.end() ? "a" : "b";
  };
  // The parts' nodes coincide at x = 1: the lowest index wins, or the part that was requested.
  EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(points[0].index)], (Vec3{1, 0, 0}));
  EXPECT_STREQ(part_of_node(points[0].index), "a");
  EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(points[1].index)], (Vec3{1, 0, 0}));
  EXPECT_STREQ(part_of_node(points[1].index), "b");
  EXPECT_TRUE(points[2].is_element);
  EXPECT_EQ(mesh.part_of(static_cast<std::size_t>(points[2].index)), 1);
  EXPECT_EQ(mesh.part_of(static_cast<std::size_t>(points[3].index)), 0);
}

TEST(HistoryPoints, AreFoundByTheUsersId) {
  const Scene scene(make_history_text("nodes: [{name: n, id: 20}], elements: [{name: e, id: 9}]"));
  const std::vector<FollowedPoint> points = find_history_points(scene.deck, scene.chunked);
  EXPECT_EQ(scene.chunked.mesh.node_ids[static_cast<std::size_t>(points[0].index)], 20);
  EXPECT_EQ(scene.chunked.mesh.element_ids[static_cast<std::size_t>(points[1].index)], 9);
}

TEST(HistoryPoints, WithAnUnknownIdAreRefusedAtTheirPlace) {
  EXPECT_THAT(take_points_error("nodes: [{name: n, id: 99}]"), HasSubstr("deck.yaml:6:"));
  EXPECT_THAT(take_points_error("nodes: [{name: n, id: 99}]"), HasSubstr("no node has the id 99 (history point 'n')"));
  EXPECT_THAT(take_points_error("elements: [{name: e, id: 99}]"), HasSubstr("no element has the id 99"));
}

TEST(History, HasARowAtTheStartAtEveryDueTimeAndAtTheEnd) {
  const Outcome run = run_deck(make_history_text("nodes: [{name: n, near: [2, 1, 1]}]"), {"time.max_step=3e-6"});
  ASSERT_EQ(run.history.rows(), 11u);
  const std::vector<double>& time = run.history["time"];
  EXPECT_EQ(time[0], 0);
  EXPECT_DOUBLE_EQ(time[10], 1e-4);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_GE(time[i], 1e-5 * static_cast<double>(i) * (1 - 1e-12));
    EXPECT_LT(time[i], 1e-5 * static_cast<double>(i) + 3e-6);
    EXPECT_NEAR(run.history["n_z"][i], 1 + 3 * time[i], 1e-14);  // 34 additions to 1
    EXPECT_EQ(run.history["n_vz"][i], 3);
    EXPECT_NEAR(run.history["momentum_z"][i], 3 * 7850, 1e-9);
  }
}

/// columns.json names the heading of history.csv, column by column, with its unit.
TEST(HistoryColumns, AreDescribedForPrograms) {
  const TemporaryFolder folder;
  const std::string text =
      "units: mm, kg, ms\n" + make_history_text("nodes: [{name: n, near: [0, 0, 0]}], parts: [b]") +
      "walls: [{name: ram, normal: z, point: [0, 0, -9], speed: 1}, {normal: x, point: [-9, 0, 0], mass: 1}]\n";
  const Scene scene(text);
  History(folder.path(), {scene.deck, scene.chunked, scene.stepper}).close();
  std::ifstream history(folder.path() + "/history.csv"), file(folder.path() + "/columns.json");
  std::string heading;
  std::getline(history, heading);
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["units"], "mm, kg, ms");
  std::string joined;
  for (const auto& column : json["columns"]) {
    if (!joined.empty()) joined += ',';
    joined += column["name"].get<std::string>();
    EXPECT_FALSE(column["meaning"].get<std::string>().empty());
  }
  EXPECT_EQ(joined, heading);
  const auto of = [&](const std::string& name) {
    const auto found = std::find_if(json["columns"].begin(), json["columns"].end(),
                                    [&](const auto& column) { return column["name"] == name; });
    return std::pair{(*found)["unit"].get<std::string>(), (*found)["dimension"].get<std::string>()};
  };
  EXPECT_EQ(of("kinetic"), (std::pair<std::string, std::string>{"J", "mass length^2 time^-2"}));
  EXPECT_EQ(of("step"), (std::pair<std::string, std::string>{"", "1"}));
  EXPECT_EQ(of("n_vx"), (std::pair<std::string, std::string>{"mm/ms", "length time^-1"}));
  EXPECT_EQ(of("mass:b"), (std::pair<std::string, std::string>{"kg", "mass"}));
  EXPECT_EQ(of("wall_displacement:ram"), (std::pair<std::string, std::string>{"mm", "length"}));
  EXPECT_EQ(of("wall_speed:walls.1"), (std::pair<std::string, std::string>{"mm/ms", "length time^-1"}));
  EXPECT_EQ(of("momentum_x:b").second, "mass length time^-1");
}

}  // namespace percuss::test
