// The finite-element side of a run on many ranks: every rank also holds the whole scene alone, and compares its share
// of the one with the other, bit by bit.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "comm/agreement.hpp"
#include "src/error.hpp"
#include "src/step/audit/audit.hpp"
#include "src/step/model/element_blocks.hpp"
#include "src/step/model/whole_mesh.hpp"
#include "src/step/results/history.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/two_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::HasSubstr;

// Two materials, pressure on faces that meet at edges, gravity, held and driven nodes, spin: what has a sum.
const std::string text = R"yaml(
time: {end: 1}
parts:
  tough: {box: {size: [1.3, 1.1, 0.9], cells: [13, 11, 9]}, material: copper}
  ball: {sphere: {radius: 0.5, cells: 8}, at: [3, 0, 0], material: steel}
materials:
  copper: {model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 100e6, hardening_modulus: 1e9}
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
loads:
  gravity: [1, 2, -9.81]
  pressure: [{faces: ball, value: 3e8}, {faces: tough/x_max, value: {expression: "4e8 * cos(1e4 * t)"}}, {faces: tough, value: 1e6}]
initial: [{part: ball, velocity: [3, 100, 7], angular_velocity: [30, 20, 10]}]
conditions:
  - {nodes: tough/x_min, fixed: [x, y, z]}
  - {nodes: {name: tough/z_max, inside: [[0.05, 0, 0], [2, 2, 2]]}, velocity: {y: {table: [[0, 0], [1e-4, 50]]}}}
output:
  history:
    every: 0
    nodes: [{name: n, near: [0.7, 0.5, 0.4]}, {name: m, near: [3, 0, 0.5]}, {name: o, id: 7}]
    elements: [{name: e, near: [1.25, 0.5, 0.4]}, {name: f, near: [3, 0.5, 0]}, {name: g, id: 11}]
)yaml";

std::string read_file(const std::string& path) {
  std::ostringstream all;
  all << std::ifstream(path).rdbuf();
  return all.str();
}

/// History of ten steps.
std::string write_history(Scene& scene) {
  const TemporaryFolder folder;
  {
    History history(folder.path(), {scene.deck, scene.chunked, scene.stepper});
    Audit audit(scene.model);
    scene.stepper.start(scene.state);
    for (int i = 0; i < 10; ++i) {
      history.write(scene.model, {scene.state, audit(scene.state), scene.stepper.contact_report(), Vec3{},
                                  scene.contact.sum_pair_work(), scene.stepper});
      scene.stepper.advance(scene.state);
    }
    history.flush();
  }
  return scene.model.ranks.rank() == 0 ? read_file(folder.path() + "/history.csv") : "";
}

/// A table with a heading, column by column.
std::map<std::string, std::vector<double>> read_columns(const std::string& path) {
  std::istringstream file(read_file(path));
  std::string line, cell;
  std::getline(file, line);
  std::vector<std::string> names;
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(file, line)) {
    std::size_t column = 0;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) {
      columns[names.at(column++)].push_back(std::stod(cell));
    }
  }
  return columns;
}

std::string take_error(const std::string& from, const Communicator& ranks) {
  try {
    const Scene scene(from, ranks);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

Communicator self() { return Communicator(MPI_COMM_SELF); }

}  // namespace

TEST(ModelOnRanks, HasTheMassesAndMotionsOfOneRank) {
  const TwoScenes scenes(text);
  const Model &together = scenes.together.model, &alone = scenes.alone.model;
  EXPECT_EQ(together.total_mass, alone.total_mass);
  EXPECT_EQ(together.mass_center, alone.mass_center);
  expect_same_rows(scenes, together.inverse_mass, alone.inverse_mass, "inverse mass");
  expect_same_rows(scenes, together.start_velocity, alone.start_velocity, "velocity");
  const auto mine = to_host(together.mass), whole = to_host(alone.mass);
  const auto& numbers = scenes.together.chunked.mesh.node_numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) ASSERT_EQ(mine(n), whole(static_cast<std::size_t>(numbers[n])));
}

TEST(ModelOnRanks, SumsEveryNodeOverAsManySlotsAsOneRank) {
  const TwoScenes scenes(text);
  const auto mine = to_host(scenes.together.model.nodes_to_slots.first);
  const auto whole = to_host(scenes.alone.model.nodes_to_slots.first);
  const auto& numbers = scenes.together.chunked.mesh.node_numbers;
  for (std::size_t n = 0; n < numbers.size(); ++n) {
    const auto w = static_cast<std::size_t>(numbers[n]);
    EXPECT_EQ(mine(n + 1) - mine(n), whole(w + 1) - whole(w));
  }
}

TEST(ModelOnRanks, OwnsEveryNodeOnceAndComputesEveryChunkOnce) {
  const Scene scene(text);
  const Model& model = scene.model;
  const auto first = to_host(model.owned_nodes.first), end = to_host(model.owned_nodes.end);
  const auto numbers = to_host(model.node_numbers);
  std::int64_t sums[3] = {0, 0, 0};  // nodes, their numbers, chunks
  for (std::size_t c = 0; c < first.extent(0); ++c) {
    for (int n = first(c); n < end(c); ++n) {
      ++sums[0];
      sums[1] += numbers(static_cast<std::size_t>(n));
    }
  }
  const auto count = [&](const auto&... block) {
    return (0 + ... + static_cast<std::int64_t>(block.chunks.extent(0)));
  };
  sums[2] = std::apply(count, model.others->hexahedra) + std::apply(count, model.sending->hexahedra);
  EXPECT_EQ(sums[2], model.chunks.count);
  MPI_Allreduce(MPI_IN_PLACE, sums, 3, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  const std::int64_t nodes = scene.chunked.numbering.node_count();
  EXPECT_EQ(sums[0], nodes);
  EXPECT_EQ(sums[1], nodes * (nodes - 1) / 2);
  EXPECT_EQ(sums[2], scene.chunked.numbering.chunk_count());
}

TEST(ModelOnRanks, RefusesContradictingConditionsWithTheWordsOfOneRank) {
  const auto end = text.find("output:");
  const std::string conditions = text.substr(0, end) + "  - {nodes: tough/z_max, velocity: {y: 1}}\n" +
                                 "  - {nodes: tough/y_max, velocity: {y: 1}}\n" + text.substr(end);
  const std::string alone = take_error(conditions, self());
  EXPECT_THAT(alone, HasSubstr("is held in direction y by two conditions"));
  EXPECT_EQ(take_error(conditions, Communicator::world()), alone);
}

TEST(StepOnRanks, HasTheBitsOfOneRank) {
  TwoScenes scenes(text);
  scenes.run(25);
  const State &together = scenes.together.state, &alone = scenes.alone.state;
  expect_same_rows(scenes, together.x, alone.x, "position");
  expect_same_rows(scenes, together.v, alone.v, "velocity");
  expect_same_rows(scenes, together.force, alone.force, "force");
  EXPECT_EQ(together.next_dt, alone.next_dt);
  EXPECT_EQ(together.bound.element, alone.bound.element);
  EXPECT_EQ(together.bound.element_id, alone.bound.element_id);
  EXPECT_EQ(hash_state(scenes.together.model, together), hash_state(scenes.alone.model, alone));
}

TEST(StepOnRanks, HashSeesTheLastBitOfOneNodeOfOneRank) {
  Scene scene(text);
  scene.run(2);
  const auto before = hash_state(scene.model, scene.state);
  const auto first = to_host(scene.model.owned_nodes.first);
  if (scene.model.ranks.rank() == scene.model.ranks.size() - 1 && first.extent(0) > 0) {
    const auto x = Kokkos::create_mirror_view(scene.state.x);
    Kokkos::deep_copy(x, scene.state.x);
    x(first(0), 1) = std::nextafter(x(first(0), 1), 9.0);
    Kokkos::deep_copy(scene.state.x, x);
  }
  EXPECT_NE(hash_state(scene.model, scene.state), before);
}

TEST(StepOnRanks, StopsWhereAnyRankWantsTo) {
  Scene scene(text);
  scene.run(1);
  EXPECT_FALSE(scene.stepper.is_stop_agreed());
  scene.stepper.advance(scene.state, {scene.model.ranks.rank() == scene.model.ranks.size() - 1});
  EXPECT_TRUE(scene.stepper.is_stop_agreed());
}

std::vector<double> list_numbers(const AuditResult& audit) {
  const EnergySummary& e = audit.energy;
  const MomentumSummary& m = audit.momentum;
  std::vector<double> numbers{e.initial,  e.kinetic, e.contact,      e.friction,     e.damping,
                              e.external, e.error,   m.linear_error, m.angular_error};
  numbers.insert(numbers.end(), e.work.begin(), e.work.end());
  numbers.insert(numbers.end(), m.linear, m.linear + 3);
  numbers.insert(numbers.end(), m.angular, m.angular + 3);
  return numbers;
}

TEST(AuditOnRanks, HasTheBitsOfOneRank) {
  TwoScenes scenes(text);
  Audit together(scenes.together.model), alone(scenes.alone.model);
  scenes.run(0);
  for (int i = 0; i < 6; ++i) {
    const AuditResult a = together(scenes.together.state), b = alone(scenes.alone.state);
    EXPECT_EQ(list_numbers(a), list_numbers(b)) << "step " << i;
    EXPECT_LT(std::abs(a.energy.error), 0.1);
    scenes.together.stepper.advance(scenes.together.state);
    scenes.alone.stepper.advance(scenes.alone.state);
  }
}

TEST(HistoryOnRanks, FollowsThePointsOfOneRank) {
  const TwoScenes scenes(text);
  const auto together = find_history_points(scenes.together.deck, scenes.together.chunked);
  const auto alone = find_history_points(scenes.alone.deck, scenes.alone.chunked);
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(together[i].number, alone[i].number) << alone[i].name;
    int holders = together[i].index >= 0 ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &holders, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(holders, 1) << alone[i].name;
  }
}

TEST(HistoryOnRanks, IsTheFileOfOneRankByteForByte) {
  TwoScenes scenes(text);
  const std::string together = write_history(scenes.together), alone = write_history(scenes.alone);
  if (scenes.together.model.ranks.rank() == 0) {
    EXPECT_EQ(together, alone);
    EXPECT_GT(together.size(), 2000u);
  }
}

TEST(RunOnRanks, EndsEverywhereWithTheErrorOfTheRankThatHasTheElement) {
  const Deck deck = parse_deck(R"(
time: {end: 1e-3}
parts:
  other: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 9, 0], material: steel}
  bar: {box: {size: [4, 1, 1], cells: [4, 1, 1]}, material: steel}
conditions: [{nodes: bar/x_max, displacement: {x: {table: [[0, 0], [1e-9, -1.5]]}}}]
)" + steel_text,
                               "deck.yaml");
  try {
    run_scene(deck, {"", Progress::Style::quiet});
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("element 5 of part 'bar' at (2.75, 0.5, 0.5) has inverted"));
  }
}

TEST(RunOnRanks, GivesEveryRankTheSameSummary) {
  Deck deck = parse_deck(text, "deck.yaml");
  deck.time.max_steps = 8;
  const Summary summary = run_scene(deck, {"", Progress::Style::quiet}).summary;
  Scene alone(text, self());
  alone.run(8);
  EXPECT_EQ(summary.state_hash, fmt::format("{:016x}", hash_state(alone.model, alone.state)));
  EXPECT_EQ(summary.elements, alone.model.element_count);
  EXPECT_EQ(summary.nodes, alone.model.node_count);
  EXPECT_EQ(summary.ranks, Communicator::world().size());
  EXPECT_EQ(summary.messages.count > 0, summary.ranks > 1);
  EXPECT_GE(summary.balance.elements, 1);
}

// A strip on two ranks has one line of shared nodes: a message of forces to the other rank, and one of moments.
TEST(RunOnRanks, CountsForcesAndMomentsOfShells) {
  const TemporaryFolder own;
  const Communicator ranks = Communicator::world();
  const std::string folder = broadcast_text(ranks, own.path(), 0);
  const auto count = [&](const std::string& shape) {
    const std::string strip = "time: {end: 1, max_steps: 8}\nparts: {a: {" + shape +
                              ", material: m}}\nmaterials: {m: {model: elastic, density: 7800, youngs_modulus: 2e11, "
                              "poissons_ratio: 0.3}}\n";
    return run_scene(parse_deck(strip, "deck.yaml"), {folder, Progress::Style::quiet}).summary.messages;
  };
  const auto solids = count("box: {size: [64, 4, 1], cells: [64, 4, 1]}");
  const auto shells = count("shell_plate: {size: [64, 4], cells: [64, 4]}, thickness: 0.1");
  EXPECT_EQ(solids.count > 0, ranks.size() > 1);
  if (ranks.size() != 2) return;
  EXPECT_EQ(shells.count, 2 * solids.count);
  EXPECT_EQ(shells.bytes, solids.bytes);  // 2 vectors at 5 nodes in place of 1 at 10
}

TEST(RunOnRanks, TellsWhatEachRankHeldWorkedAndSent) {
  const TemporaryFolder own;
  const Communicator ranks = Communicator::world();
  const std::string folder = broadcast_text(ranks, own.path(), 0);
  Deck deck = parse_deck(text + "contact: {surfaces: all}\n", "deck.yaml");
  deck.time.max_steps = 8;
  deck.contact.reuse_search = false;
  const Summary summary = run_scene(deck, {folder, Progress::Style::quiet}).summary;
  if (ranks.rank() != 0) return;
  const auto columns = read_columns(folder + "/ranks.csv");
  ASSERT_EQ(columns.at("rank").size(), static_cast<std::size_t>(ranks.size()));
  EXPECT_EQ(columns.at("rank").back(), ranks.size() - 1);
  const auto total = [&](const char* name) {
    const auto& values = columns.at(name);
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  EXPECT_EQ(total("elements"), static_cast<double>(summary.elements));
  EXPECT_GE(total("nodes"), static_cast<double>(summary.nodes));
  EXPECT_EQ(total("contact_nodes"), static_cast<double>(summary.contact_nodes));
  EXPECT_EQ(total("contact_faces"), static_cast<double>(summary.contact_faces + summary.decomposition.ghost_faces));
  EXPECT_NEAR((total("halo_messages") + total("contact_messages")) / ranks.size(), summary.messages.count, 1e-9);
  EXPECT_NEAR((total("halo_bytes") + total("contact_bytes")) / ranks.size(), summary.messages.bytes, 1e-6);
  EXPECT_EQ(total("contact_bytes") > 0, ranks.size() > 1);
  double phases = 0;
  for (const auto& [name, values] : columns) {
    if (name.rfind("compute_", 0) == 0 && name != "compute_loop") phases += total(name.c_str());
  }
  EXPECT_GT(phases, 0);
  EXPECT_LE(phases, total("compute_loop"));
  EXPECT_EQ(summary.decomposition.rebalances > 0, ranks.size() > 1);
  EXPECT_LE(summary.balance.contact, 1.02);
}

}  // namespace percuss::test
