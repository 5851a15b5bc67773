// The step is bounded by the motion of bodies that approach each other, where they fly faster than their waves.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "src/step/audit/audit.hpp"
#include "src/step/run/run.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// Two blocks with elements of 0.5 and 0.25, 0.01 apart along x.
std::string make_blocks(const std::string& velocities, const std::string& contact) {
  return R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}
  b: {box: {size: [1, 1, 1], cells: [4, 4, 4]}, at: [1.01, 0, 0], material: steel}
initial: )" +
         velocities + "\ncontact: " + contact + "\n" + steel_text;
}

/// Three pieces of a part and a block of another, all far apart, that meet at 4e5 m/s: 70 times the speed of waves.
const std::string pieces = R"(
time: {end: 2e-5}
parts:
  pieces: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, array: {count: [3, 1, 1], pitch: [2, 1, 1]}, material: steel}
  block: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [7, 0.1, 0.2], material: steel}
initial: [{part: pieces, velocity: [4e5, 0, 0]}]
contact: {surfaces: all}
)" + steel_text;

/// A block with elements of 0.5, 0.01 before a wall at x = 1.01.
std::string make_block_before_wall(const std::string& velocity, const std::string& wall) {
  return R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}
initial: [{part: a, velocity: )" +
         velocity + "}]\nwalls: [{" + wall + "}]\n" + steel_text;
}

double find_first_step(const std::string& deck) {
  Scene scene(deck, Communicator(MPI_COMM_SELF));
  scene.stepper.start(scene.state);
  return scene.state.next_dt;
}

double find_element_step(const std::string& deck) {
  Scene scene(deck, Communicator(MPI_COMM_SELF));
  scene.stepper.start(scene.state);
  return scene.deck.time.step_scale * scene.state.bound.step;
}

}  // namespace

TEST(Approach, TheFirstStepClosesTheGapAndHalfOfTheSmallerFace) {
  // 0.01 at 4e5 along x; then 0.5 * 0.25 at |(4e5, -3e5)| = 5e5.
  const std::string deck =
      make_blocks("[{part: a, velocity: [4e5, 0, 0]}, {part: b, velocity: [0, 3e5, 0]}]", "{surfaces: all}");
  EXPECT_NEAR(find_first_step(deck), 2.5e-8 + 2.5e-7, 1e-14 * 2.75e-7 + 1e-16);
  Scene scene(deck);
  scene.stepper.start(scene.state);
  const Approach* const found = scene.stepper.find_limiting_approach(scene.state);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(describe_approach(*found, scene.chunked.mesh), "the approach of parts 'a' and 'b' at 5e+05");
}

TEST(Approach, BodiesThatCannotMeetDoNotBoundTheStep) {
  const std::string apart = make_blocks("[{part: a, velocity: [-4e5, 0, 0]}]", "{surfaces: all}"),
                    beside = make_blocks("[{part: a, velocity: [0, 4e5, 0]}]", "{surfaces: all}"),
                    together = make_blocks("[{velocity: [4e5, 0, 0]}]", "{surfaces: all}"),
                    untouched = make_blocks("[{part: a, velocity: [4e5, 0, 0]}]", "{surfaces: [{a: a, b: a}]}"),
                    slow = make_blocks("[{part: a, velocity: [100, 0, 0]}]", "{surfaces: all}");
  for (const std::string& deck : {apart, beside, together, untouched, slow})
    EXPECT_EQ(find_first_step(deck), find_element_step(deck)) << deck;
}

TEST(Approach, BodiesMeetInStepsOfHalfAFaceAndTheBalanceHolds) {
  constexpr double speed = 4e5, gap = 2, half_face = 0.25;
  Scene scene(pieces, Communicator(MPI_COMM_SELF));
  scene.stepper.start(scene.state);
  Audit audit(scene.model);
  audit(scene.state);
  // From 5 to 7 nothing is in the way of the first piece. (The step is shorter, so that the end is hit.)
  EXPECT_NEAR(scene.contact.approach().step, (gap + half_face) / speed, 1e-12 * (gap + half_face) / speed);
  EXPECT_LE(scene.state.next_dt, scene.contact.approach().step);
  int limited = 0;
  double met = 0;  // where the first piece would be without contact as it first meets the block, from 5 on
  while (scene.state.time < 2e-5 * (1 - 1e-12)) {
    const bool was_limited = scene.stepper.find_limiting_approach(scene.state) != nullptr;
    scene.stepper.advance(scene.state);
    limited += was_limited ? 1 : 0;
    EXPECT_LT(scene.state.bound.failed_element, 0);
    const AuditResult balance = audit(scene.state);
    EXPECT_LT(std::abs(balance.energy.error), 1e-2) << "step " << scene.state.step;
    EXPECT_LT(balance.momentum.linear_error, 1e-13) << "step " << scene.state.step;
    if (met == 0 && scene.stepper.contact_report().interactions > 0) met = speed * scene.state.time;
  }
  EXPECT_GE(limited, 2);  // then the viscosity of the shock bounds the step of elements
  EXPECT_GE(met, gap);
  EXPECT_LE(met, (gap + half_face) * (1 + 1e-12));
}

TEST(Approach, ARunAtSeventyWaveSpeedsEndsWithItsEnergy) {
  const Summary summary = run_scene(parse_deck(pieces, "deck.yaml"), {}).summary;
  EXPECT_EQ(summary.status, "completed");
  EXPECT_LT(std::abs(summary.energy.error),
            1e-2);  // from where a run tells it; without a bound a block turns inside out
  EXPECT_LT(summary.momentum.linear_error, 1e-13);
}

TEST(Approach, TheFirstStepClosesTheGapToAWallAndHalfOfAFace) {
  const std::string deck = make_block_before_wall("[4e5, 3e5, 0]", "point: [1.01, 0, 0], normal: [-1, 0, 0]");
  EXPECT_NEAR(find_first_step(deck), (0.01 + 0.25) / 4e5, 1e-12 * 0.26 / 4e5);
  Scene scene(deck);
  scene.stepper.start(scene.state);
  const Approach* const found = scene.stepper.find_limiting_approach(scene.state);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(describe_approach(*found, scene.chunked.mesh), "the approach of part 'a' and walls.0 at 4e+05");
  // Friction holds nodes along the wall too: 0.25 at 5e5.
  const std::string rough =
      make_block_before_wall("[4e5, 3e5, 0]", "point: [1.01, 0, 0], normal: [-1, 0, 0], friction: 0.1");
  EXPECT_NEAR(find_first_step(rough), 0.01 / 4e5 + 0.25 / 5e5, 1e-12 * 5e-7);
}

TEST(Approach, RoundAndMovingWallsBoundTheStepLikewise) {
  // The nearest corner is (1, 1, 0.5) at 0.5 from the middle of a sphere with a radius of 0.4.
  const std::string sphere = make_block_before_wall("[4e5, 0, 0]", "point: [1.5, 1, 0.5], sphere: {radius: 0.4}"),
                    moving =
                        make_block_before_wall("[1e5, 0, 0]", "point: [1.01, 0, 0], normal: [-1, 0, 0], speed: 3e5");
  EXPECT_NEAR(find_first_step(sphere), (0.1 + 0.25) / 4e5, 1e-12 * 0.35 / 4e5);
  EXPECT_NEAR(find_first_step(moving), (0.01 + 0.25) / 4e5, 1e-12 * 0.26 / 4e5);
}

TEST(Approach, WallsThatABodyLeavesOrPassesDoNotBoundTheStep) {
  const std::string at = "point: [1.01, 0, 0], normal: [-1, 0, 0]";
  for (const std::string& deck : {make_block_before_wall("[-4e5, 0, 0]", at), make_block_before_wall("[0, 4e5, 0]", at),
                                  make_block_before_wall("[100, 0, 0]", at)})
    EXPECT_EQ(find_first_step(deck), find_element_step(deck)) << deck;
}

TEST(Approach, ABlockAtManyWaveSpeedsMeetsAWallInStepsOfHalfAFace) {
  for (const double speed : {1e4, 6e4, 4e5}) {
    Scene scene(make_block_before_wall(fmt::format("[{}, 0, 0]", speed), "point: [1.01, 0, 0], normal: [-1, 0, 0]"));
    scene.stepper.start(scene.state);
    for (int step = 0; step < 3; ++step) {  // to the wall, and on
      scene.stepper.advance(scene.state);
      EXPECT_LT(scene.state.bound.failed_element, 0) << speed << ", step " << step;
    }
    EXPECT_GE(scene.state.time * speed, 0.25);
  }
}

TEST(Approach, TheStepAndItsReasonAreTheSameOnAnyRanks) {
  Scene together(pieces), alone(pieces, Communicator(MPI_COMM_SELF));
  for (Scene* scene : {&together, &alone}) scene->stepper.start(scene->state);
  for (int step = 0; step < 20; ++step) {
    EXPECT_EQ(together.state.next_dt, alone.state.next_dt) << "step " << step;
    EXPECT_EQ(together.contact.approach().speed, alone.contact.approach().speed) << "step " << step;
    EXPECT_EQ(together.contact.approach().part, alone.contact.approach().part) << "step " << step;
    for (Scene* scene : {&together, &alone}) scene->stepper.advance(scene->state);
  }
}

}  // namespace percuss::test
