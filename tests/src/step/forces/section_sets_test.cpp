// Sections by nodes and elements: against cuts by a plane, exact waves and the momentum that passes; on any ranks.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/forces/force_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

/// A bar along x of cubes with the edge 0.01, cells x 2 x 2, as a keyword file: the sets "row" of nodes at x = 0.3,
/// "layer" of the elements ahead of them and "ahead" of all elements there.
std::string write_bar(int cells) {
  const int cut = 30,
            corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const auto node = [](int i, int j, int k) { return 1 + 9 * i + 3 * j + k; };
  std::string nodes = "*NODE\n", elements = "*ELEMENT_SOLID\n", layer, ahead, row;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) nodes += fmt::format("{},{},{},{}\n", node(i, j, k), i * 0.01, j * 0.01, k * 0.01);
  for (int j = 0; j < 3; ++j) row += fmt::format("{},{},{}\n", node(cut, j, 0), node(cut, j, 1), node(cut, j, 2));
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k) {
        const int id = 1 + 4 * i + 2 * j + k;
        elements += fmt::format("{},1", id);
        for (const auto& c : corner) elements += fmt::format(",{}", node(i + c[0], j + c[1], k + c[2]));
        elements += "\n";
        if (i == cut) layer += fmt::format("{},\n", id);
        if (i >= cut) ahead += fmt::format("{},\n", id);
      }
  return "*KEYWORD\n" + nodes + "*PART\nbar\n1,\n" + elements + "*SET_NODE_LIST_TITLE\nrow\n1,\n" + row +
         "*SET_SOLID_LIST_TITLE\nlayer\n2,\n" + layer + "*SET_SOLID_LIST_TITLE\nahead\n3,\n" + ahead + "*END\n";
}

/// The bar flies into a wall: uniaxial strain by symmetry, a wave of the force rho c v A.
std::string make_bar(const std::string& mesh, const std::string& history = "") {
  return fmt::format(R"(
time: {{end: 1}}
parts: {{bar: {{mesh: {{file: {}}}, material: m}}}}
materials: {{m: {{model: elastic, density: 4, youngs_modulus: 100, poissons_ratio: 0}}}}
initial: [{{part: bar, velocity: [-0.01, 0, 0]}}]
walls: [{{name: stop, point: [0, 0, 0], normal: x}}]
output:
  history:
{}    forces:
      - {{name: layer, section: {{nodes: bar/row, elements: bar/layer}}}}
      - {{name: ahead, section: {{nodes: row, elements: [bar/ahead]}}, about: [0, 0, 0]}}
      - {{name: plane, section: {{point: [0.301, 0, 0], normal: x}}, about: [0, 0, 0]}}
      - {{name: whole, section: {{nodes: row, elements: bar}}}}
)",
                     mesh, history);
}

/// Writes the mesh for all ranks.
class BarFile {
 public:
  explicit BarFile(int cells) : path_(folder_.path() + "/bar.k") {
    if (Communicator::world().rank() == 0) std::ofstream(path_) << write_bar(cells);
    Communicator::world().barrier();
  }
  const std::string& path() const { return path_; }
  const std::string& folder() const { return folder_.path(); }

 private:
  SharedFolder folder_;
  std::string path_;
};

}  // namespace

TEST(SectionSets, CarryTheForceOfAWave) {
  const BarFile bar(120);
  Scene scene(make_bar(bar.path()));
  scene.stepper.start(scene.state);
  const double c = 5, area = 4e-4, exact = 4 * c * 0.01 * area;
  const auto run_to = [&](double time) {
    while (scene.state.time < time) scene.stepper.advance(scene.state);
  };
  run_to(0.5 / c);  // the wave has passed the section
  const double since = scene.state.time;
  take_values(scene);
  run_to(1.8 / c);
  const auto j = take_impulses(scene, since);
  const double impulse = exact * (scene.state.time - since);
  for (const char* name : {"layer", "ahead", "plane"})
    EXPECT_NEAR(j.at(std::string("fx:") + name), -impulse, 0.01 * impulse) << name;
  // Sections of the same nodes and elements have the same force; the moment of the plane's is that of an equal force.
  EXPECT_NEAR(j.at("fx:layer"), j.at("fx:ahead"), 1e-13 * impulse);
  EXPECT_NEAR(j.at("fx:plane"), j.at("fx:ahead"), 1e-13 * impulse);
  EXPECT_NEAR(j.at("my:plane"), j.at("my:ahead"), 1e-13 * impulse);
  EXPECT_NEAR(j.at("my:ahead"), -impulse * 0.01, 0.01 * 0.01 * impulse);
  // About the centre of the row an even force has none.
  EXPECT_NEAR(j.at("my:layer"), 0, 1e-12 * impulse);
  EXPECT_NEAR(j.at("mz:layer"), 0, 1e-12 * impulse);
}

TEST(SectionSets, OfAllElementsChangeTheMomentumOfTheNodes) {
  const BarFile bar(40);
  Scene scene(make_bar(bar.path()));
  scene.stepper.start(scene.state);
  const auto is_row = [](const Vec3& x) { return std::abs(x[0] - 0.3) < 1e-6; };
  const Vec3 before = sum_momentum(scene, is_row);
  while (scene.state.time < 0.1) scene.stepper.advance(scene.state);
  const auto j = take_impulses(scene, 0);
  const Vec3 after = sum_momentum(scene, is_row);
  EXPECT_GT(after[0] - before[0], 0.1 * std::abs(before[0]));  // the wave has come
  expect_near(find_vector(j, 'f', "whole"), minus(after, before), 1e-13 * std::abs(before[0]));
}

TEST(SectionSets, AreTheSameBitsOnAnyRanks) {
  const BarFile bar(36);
  const std::string deck = make_bar(bar.path());
  Scene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
  together.run(60);
  alone.run(60);
  EXPECT_EQ(take_values(together), take_values(alone));
}

TEST(SectionSets, GoOnAfterARestart) {
  const BarFile bar(32);
  const std::string whole = bar.folder() + "/whole", parts = bar.folder() + "/parts";
  if (Communicator::world().rank() == 0)
    for (const std::string& path : {whole, parts}) std::filesystem::create_directory(path);
  Communicator::world().barrier();
  const auto run = [&](const std::string& time, const std::string& more, const std::string& folder,
                       const std::string& restart) {
    std::string text = make_bar(bar.path(), "    every: 0.013\n");
    text.replace(text.find("time: {end: 1}"), 14, "time: " + time);
    text.replace(text.find("  history:\n"), 11, more + "  history:\n");
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  EXPECT_GT(run("{end: 0.1}", "", whole, "").steps, 50);
  run("{end: 0.1, max_steps: 40}", "  checkpoint: {every: 0.04}\n", parts, "");
  run("{end: 0.1}", "", parts, parts + "/checkpoint_previous.h5");
  if (Communicator::world().rank() != 0) return;
  EXPECT_TRUE(read_file(parts + "/history.csv") == read_file(whole + "/history.csv"));
}

TEST(SectionSets, RefuseSetsThatAreNone) {
  const BarFile bar(32);
  const auto make = [&](const std::string& section) {
    return make_bar(bar.path()) + "      - {name: f, section: {" + section + "}}\n";
  };
  EXPECT_NO_THROW(Scene(make("nodes: bar/row, elements: [layer, bar/ahead]")));
  EXPECT_ERROR(Scene(make("nodes: bar/raw, elements: layer")), InputError, "'bar/raw' (did you mean 'bar/row'?)");
  EXPECT_ERROR(Scene(make("nodes: bar/row, elements: bar/later")), InputError, "is called 'bar/later'");
  EXPECT_ERROR(Scene(make("nodes: bar/row, elements: bar/row")), InputError, "is called 'bar/row'");
  EXPECT_ERROR(Scene(make("nodes: {inside: [[0, 0, 0], [0.1, 1, 1]]}, elements: layer")), InputError,
               "have none of its nodes");
}

}  // namespace percuss::test
