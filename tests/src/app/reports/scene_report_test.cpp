// Masses, folders, threads: the parts of the commands that can be asked alone.

#include "src/app/reports/scene_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "src/app/folder/output_folder.hpp"
#include "src/app/process/memory_check.hpp"
#include "src/app/process/placement.hpp"
#include "src/app/process/threads.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/app/percuss_process.hpp"

namespace percuss {
namespace {

Deck two_blocks() {
  return parse_deck(
      "time: {end: 1}\n"
      "materials:\n"
      "  a: {model: elastic, density: 3, youngs_modulus: 1, poissons_ratio: 0}\n"
      "  b: {model: j2_plasticity, density: 5, youngs_modulus: 1, poissons_ratio: 0, yield_stress: 1}\n"
      "parts:\n"
      "  one: {box: {size: [1, 2, 3], cells: [2, 3, 4]}, material: a}\n"
      "  two: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, array: {count: [1, 1, 4], pitch: [0, 0, 2]}, at: [5, 0, 0], "
      "material: b}\n",
      "deck.yaml");
}

TEST(SceneReport, SumsTheMassOfEachPart) {
  const Deck deck = two_blocks();
  const SceneReport scene = describe_scene(deck, load_mesh(deck, Communicator(MPI_COMM_SELF)));
  ASSERT_EQ(scene.parts.size(), 2U);
  EXPECT_NEAR(scene.parts[0].mass, 3 * 6, 1e-13);  // round-off of 24 volumes
  EXPECT_NEAR(scene.parts[1].mass, 5 * 4, 1e-13);
}

TEST(SceneReport, TellsTheMassThatTheDeckAddsAndGives) {
  const Deck deck = parse_deck(
      "time: {end: 1}\nmaterials: {a: {model: elastic, density: 2, youngs_modulus: 1, poissons_ratio: 0}}\nparts:\n"
      "  one: {box: {size: [1, 2, 3], cells: [2, 3, 4]}, material: a}\n"
      "  two: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [5, 0, 0], material: a, rigid: {mass: 300}}\n"
      "  hull: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [9, 0, 0], material: a, rigid: {body: ship, mass: 40}}\n"
      "  mast: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [9, 3, 0], material: a, rigid: {body: ship}}\n"
      "added_mass: [{nodes: one, mass: 7}]\n",
      "deck.yaml");
  SceneReport scene = describe_scene(deck, load_mesh(deck, Communicator(MPI_COMM_SELF)));
  EXPECT_NEAR(scene.total_mass, 12 + 7 + 300 + 40, 1e-12);
  scene.first_step = 1;
  EXPECT_THAT(format_scene(scene),
              testing::HasSubstr("mass 359 (18 of elements; the rest is added or given by the deck)\n"));
}

TEST(SceneReport, CountsPartsAndBodies) {
  const Deck deck = two_blocks();
  const ChunkedMesh chunked = load_mesh(deck, Communicator(MPI_COMM_SELF));
  SceneReport scene = describe_scene(deck, chunked);
  scene.first_step = 0.25;
  scene.controlling_element = describe_element(chunked, 55);
  const std::string text = format_scene(scene);
  EXPECT_THAT(text, testing::HasSubstr("56 elements, 168 nodes, 5 bodies, mass 38\n"));
  EXPECT_THAT(text, testing::HasSubstr("none (bodies pass through each other)"));
  EXPECT_THAT(text, testing::HasSubstr("x 0 to 6, y 0 to 2, z 0 to 7"));
  EXPECT_THAT(text, testing::HasSubstr("of part 'two' controls it), about 4 steps"));
}

TEST(SceneReport, CountsFramesAsARunWritesThem) {
  const std::string text =
      "time: {end: 3e-4}\nmaterials: {a: {model: elastic, density: 3, youngs_modulus: 1, poissons_ratio: 0}}\n"
      "parts: {one: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: a}}\noutput: {fields: {every: ";
  const std::pair<const char*, const char*> frames[] = {
      {"1e-5", "31"}, {"7e-6", "44"}, {"3e-4", "2"}, {"1", "2"}, {"1e-4", "4"}};
  for (const auto& [every, count] : frames) {
    const Deck deck = parse_deck(text + every + "}}\n", "deck.yaml");
    const ChunkedMesh chunked = load_mesh(deck, Communicator(MPI_COMM_SELF));
    SceneReport scene = describe_scene(deck, chunked);
    scene.first_step = 1e-6;
    EXPECT_THAT(format_scene(scene), testing::HasSubstr(fmt::format(" {} frames of fields", count))) << every;
  }
}

TEST(Placement, NamesTheNumbersWhereThreadsHaveToTakeTurns) {
  EXPECT_FALSE(describe_crowding({2, 4, 4, 0, 0, 0}, 2));
  EXPECT_THAT(describe_crowding({2, 6, 4, 0, 0, 0}, 2)->text,
              testing::HasSubstr("2 ranks with 6 threads together share the 4 cores"));
  EXPECT_THAT(describe_crowding({3, 4, 4, 1, 2, 1}, 3)->text,
              testing::HasSubstr("1 of 3 ranks is bound to fewer cores than threads: 2 threads on 1 core "));
}

TEST(OutputFolder, IsNamedAfterTheScene) {
  EXPECT_EQ(default_output_folder("inputs/brick_wall/deck.yaml"), "out/brick_wall");
  EXPECT_EQ(default_output_folder("inputs/brick_wall/../two_bars/deck.yaml"), "out/two_bars");
  EXPECT_EQ(default_output_folder("inputs/bar.yaml"), "out/bar");
  const std::string here = std::filesystem::current_path().filename().string();
  EXPECT_EQ(default_output_folder("deck.yaml"), "out/" + here);
}

TEST(OutputFolder, IsMadeAndTakenWhenItHoldsNothingButALock) {
  const TemporaryFolder folder;
  const std::string made = folder.path() + "/a/b";
  make_output_folder(made);
  EXPECT_TRUE(std::filesystem::is_directory(made));
  EXPECT_NO_THROW(make_output_folder(made));
  folder.write("a/b/run.lock", "");
  EXPECT_NO_THROW(check_folder_is_empty(made));
  folder.write("a/b/summary.json.tmp", "");
  EXPECT_ERROR(check_folder_is_empty(made), InputError, "it is not empty");
  EXPECT_ERROR(make_output_folder(folder.write("file", "")), InputError, "not a folder");
}

TEST(OutputFolder, LosesOnlyResultsAndWhatWasToReplaceThem) {
  const TemporaryFolder folder;
  for (const char* file : {"summary.json", "checkpoint.h5.tmp", "fields.xdmf.tmp", "picture.png", "run.lock"})
    folder.write(file, "");
  remove_results(folder.path());
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) left.push_back(entry.path().filename());
  EXPECT_THAT(left, testing::UnorderedElementsAre("picture.png", "run.lock"));
}

TEST(MemoryCheck, LetsPassWhatFits) {
  EXPECT_NO_THROW(check_memory(two_blocks()));
  EXPECT_GT(find_machine_memory(), 1e8);
}

TEST(MemoryCheck, RefusesAMeshThatDoesNotFitBeforeItFillsTheMemory) {
  Deck deck = two_blocks();
  std::get<BoxShape>(deck.parts[0].shape).cells = {1000, 1000, 1000};
  EXPECT_ERROR(check_memory(deck, 8e9), SystemError, "the mesh does not fit");
  EXPECT_NO_THROW(check_memory(deck, 1e12));
}

TEST(Threads, AreAtLeastOneAndAtMostTheMachines) {
  EXPECT_GE(count_available_cores(), 1);
  EXPECT_LE(count_available_cores(), 1 << 16);
}

}  // namespace
}  // namespace percuss
