// How many threads a run takes by itself.

#include "src/app/process/compute_session.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "src/deck/reading/read_deck.hpp"

namespace percuss {
namespace {

TEST(Threads, HaveAThousandElementsEachOrOneThread) {
  EXPECT_EQ(choose_thread_count(0, 1, 64), 1);
  EXPECT_EQ(choose_thread_count(1000, 1, 64), 1);
  EXPECT_EQ(choose_thread_count(3000, 1, 64), 3);  // as many as on four cores
  EXPECT_EQ(choose_thread_count(3001, 1, 64), 4);
  EXPECT_EQ(choose_thread_count(1e6, 1, 64), 64);
  EXPECT_EQ(choose_thread_count(1e6, 1000, 64), 1);
  EXPECT_EQ(choose_thread_count(1e12, 1, 0), 1);
}

TEST(Threads, CountElementsOfGeneratedPartsAndExpectThoseOfFiles) {
  const std::string file = testing::TempDir() + "compute_session_mesh.k";
  std::ofstream(file) << std::string(50000, 'x');
  const Deck deck = parse_deck(R"(
time: {end: 1}
parts:
  box: {box: {size: [1, 1, 1], cells: [10, 20, 3]}, material: steel}
  one: {mesh: {file: )" + file + R"(}, material: steel}
  same: {mesh: {file: )" + file + R"(}, material: steel}
materials: {steel: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
)",
                               "deck.yaml", {});
  EXPECT_EQ(estimate_elements(deck), 600 + 500);
  std::filesystem::remove(file);
  EXPECT_EQ(estimate_elements(deck), 600);
}

}  // namespace
}  // namespace percuss
