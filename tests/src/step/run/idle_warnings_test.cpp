// What a run warns of at its end because nothing has happened: forces that stayed 0, bodies that met nothing.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A block 1 above a held plate, with a wall far below and a force of each kind.
std::string make_scene(double speed) {
  return fmt::format(R"(
time: {{end: 2.0e-4}}
parts:
  block: {{box: {{size: [10, 10, 10], cells: [2, 2, 2]}}, at: [0, 0, 6], material: steel}}
  plate: {{box: {{size: [10, 10, 5], cells: [2, 2, 1]}}, material: steel}}
materials: {{steel: {{model: elastic, density: 7.85e-9, youngs_modulus: 210e3, poissons_ratio: 0.3}}}}
initial: [{{part: block, velocity: [0, 0, {}]}}]
conditions: [{{nodes: plate/z_min, fixed: [x, y, z]}}]
walls: [{{name: floor, point: [0, 0, -50], normal: z}}]
contact: {{surfaces: all}}
output:
  history:
    every: 1.0e-5
    forces:
      - {{name: hit, contact: [block, plate]}}
      - {{name: floor, wall: floor}}
      - {{name: held, support: plate/z_min}}
)",
                     speed);
}

std::vector<std::string> list_texts(const Outcome& outcome, const std::string& rule) {
  std::vector<std::string> texts;
  for (const Warning& warning : outcome.summary.warnings)
    if (warning.rule == rule) texts.push_back(warning.text);
  return texts;
}

TEST(IdleWarnings, TellBodiesAndForcesThatMeetNothing) {
  const Outcome outcome = run_deck(make_scene(-10));  // 2e-3 of the gap
  const std::vector<std::string> bodies = list_texts(outcome, "unreached_body"),
                                 forces = list_texts(outcome, "idle_force");
  EXPECT_THAT(bodies, Contains(HasSubstr("starts 1 away at a speed of 10, and would arrive at about 0.1")));
  EXPECT_THAT(bodies, Contains(HasSubstr("part 'block' has flown through the whole run")));
  EXPECT_EQ(forces.size(), 3U);
  EXPECT_THAT(forces, Contains(HasSubstr("force 'hit' stayed 0 in the whole run (its surfaces never touched)")));
  EXPECT_THAT(forces, Contains(HasSubstr("force 'floor' stayed 0 in the whole run (nothing ever touched this wall)")));
}

TEST(IdleWarnings, AreNoneOfBodiesThatMeet) {
  const Outcome outcome = run_deck(make_scene(-10000));
  EXPECT_TRUE(list_texts(outcome, "unreached_body").empty());
  EXPECT_THAT(list_texts(outcome, "idle_force"),
              testing::ElementsAre(HasSubstr("force 'floor' stayed 0")));  // the plate holds the block
}

TEST(IdleWarnings, WaitForTheEndOfTheTime) {
  const Outcome outcome = run_deck(make_scene(-10000), {"time.max_steps=3"});
  EXPECT_TRUE(list_texts(outcome, "unreached_body").empty());
  EXPECT_TRUE(list_texts(outcome, "idle_force").empty());
}

}  // namespace
}  // namespace percuss::test
