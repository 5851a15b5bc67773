// Accelerometers: a body that spins, free flight, gravity, axes, any ranks, restart.

#include "src/step/forces/accelerometers.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "src/error.hpp"
#include "src/step/run/run.hpp"
#include "tests/expect_error.hpp"
#include "tests/src/step/forces/force_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test {
namespace {

/// A cube about the origin with the edge 2, whose node "rim" is at (1, 0, 0), "hub" at the origin and "side" at
/// (1, 1, 0). keys: of the part.
std::string make_cube(const std::string& keys, const std::string& motion, const std::string& more) {
  return fmt::format(R"(
time: {{end: 1000}}
parts: {{cube: {{box: {{size: [2, 2, 2], cells: [2, 2, 2]}}, at: [-1, -1, -1], material: m{}}}}}
materials: {{m: {{model: elastic, density: 1, youngs_modulus: 100, poissons_ratio: 0.25}}}}
initial: [{{part: cube, {}}}]
output:
  history:
    every: 0.05
    nodes: [{{name: rim, near: [1, 0, 0]}}, {{name: hub, near: [0, 0, 0]}}, {{name: side, near: [1, 1, 0]}}]
    accelerometers:
      - {{name: a, nodes: [rim, hub, side]}}
      - {{name: b, nodes: [rim, side, hub], gravity: remove}}
{})",
                     keys, motion, more);
}

Vec3 find_local(const std::map<std::string, double>& values, const std::string& kind, const std::string& name) {
  return {values.at(kind + "x:" + name), values.at(kind + "y:" + name), values.at(kind + "z:" + name)};
}

/// A step of this length.
void advance_by(Scene& scene, double dt) {
  scene.state.next_dt = dt;
  scene.stepper.advance(scene.state);
}

}  // namespace

TEST(Accelerometers, AxesFollowThreePlaces) {
  const FoundAxes found = find_local_axes({1, 2, 3}, {1, 2, 8}, {3, 2, 4});
  ASSERT_TRUE(found.is_given);
  EXPECT_EQ(found.axes[0], (Vec3{0, 0, 1}));
  EXPECT_EQ(found.axes[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(found.axes[2], (Vec3{0, 1, 0}));
  EXPECT_FALSE(find_local_axes({1, 2, 3}, {1, 2, 8}, {1, 2, 4}).is_given);
  EXPECT_FALSE(find_local_axes({1, 2, 3}, {1, 2, 3}, {1, 5, 4}).is_given);
}

TEST(Accelerometers, OfABodyThatSpinsHaveItsCentripetalAcceleration) {
  // A rigid cube turns by t = asin(w dt) in a step, so that each half of a step changes the velocity of the rim at r =
  // 1 by (1 - cos t) / dt towards the hub and by nothing across, whatever the lengths of the steps.
  Scene scene(make_cube(", rigid: true", "velocity: [3, -2, 1], angular_velocity: [0, 0, 2]", ""));
  scene.stepper.start(scene.state);
  EXPECT_EQ(find_local(take_row(scene), "local_a", "a"), (Vec3{0, 0, 0}));
  const double w = 2;
  double half_before = 0, middle_before = 0, change = 0;
  for (int row = 0; row < 40; ++row) {
    double expected = 0;
    for (int i = 0; i < 7; ++i) {
      const double dt = 0.004 * (1 + (row * 7 + i) % 5), half = (1 - std::cos(std::asin(w * dt))) / dt;
      advance_by(scene, dt);
      expected += half_before + half;
      half_before = half;
    }
    change += expected;
    const double middle = scene.state.time - 0.5 * scene.state.dt,
                 interval = middle - std::exchange(middle_before, middle);
    const std::map<std::string, double> values = take_row(scene);
    const Vec3 a = find_local(values, "local_a", "a"), dv = find_local(values, "local_dv", "a");
    expect_near(a, {expected / interval, 0, 0}, 1e-11);
    EXPECT_NEAR(a[0], w * w, 1e-3 * w * w);  // the mean of the continuous motion
    expect_near(dv, {change, 0, 0}, 1e-11);
    expect_near(find_local(values, "local_a", "b"), {0, expected / interval, 0}, 1e-11);  // its y goes to the hub
  }
  EXPECT_GT(w * scene.state.time, 2 * 3.14);  // more than a turn
}

TEST(Accelerometers, OfASkewSpinAreConstantInTheBody) {
  // About w (1, 2, 2) / 3 the rim is at r with the part (8, -2, -2) / 9 across the axis.
  Scene scene(make_cube(", rigid: true", "angular_velocity: [1, 2, 2]", ""));
  scene.stepper.start(scene.state);
  const double w = 3, dt = 0.01, toward = 2 * (1 - std::cos(std::asin(w * dt))) / (dt * dt);
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 50; ++i) advance_by(scene, dt);
    // Along -x, y and -z of time 0.
    const Vec3 expected{toward * 8 / 9, toward * 2 / 9, -toward * 2 / 9};
    expect_near(find_local(take_row(scene), "local_a", "a"), expected, 1e-10);
  }
}

TEST(Accelerometers, OfAFreeFallHaveGravityUnlessItIsRemoved) {
  for (const char* keys : {"", ", rigid: true"}) {
    Scene scene(make_cube(keys, "velocity: [3, -2, 1]", "loads: {gravity: [1, 2, -3]}\n"));
    scene.stepper.start(scene.state);
    for (int i = 0; i < 30; ++i) advance_by(scene, 0.005 * (1 + i % 3));
    const std::map<std::string, double> values = take_row(scene);
    expect_near(find_local(values, "local_a", "a"), {-1, 2, 3}, 1e-12);  // along -x, y and -z
    expect_near(find_local(values, "local_a", "b"), {0, 0, 0}, 1e-12);
    expect_near(find_local(values, "local_dv", "b"), {0, 0, 0}, 1e-12);
  }
}

TEST(Accelerometers, OfANodeAtRestFeelItsSupport) {
  Scene scene(make_cube("", "velocity: [0, 0, 0]",
                        "loads: {gravity: [0, 0, -9]}\nconditions: [{nodes: cube, fixed: [x, y, z]}]\n"));
  scene.run(20);
  const std::map<std::string, double> values = take_row(scene);
  expect_near(find_local(values, "local_a", "a"), {0, 0, 0}, 1e-13);
  expect_near(find_local(values, "local_a", "b"), {0, 0, 9}, 1e-12);  // z of b is up
}

TEST(Accelerometers, AreTheSameBitsOnAnyRanks) {
  std::string deck = make_cube("", "velocity: [-3, 0, 0], angular_velocity: [1, 2, 2]",
                               "walls: [{point: [-1.02, 0, 0], normal: x}]\n");
  deck.replace(deck.find("cells: [2, 2, 2]"), 16, "cells: [8, 8, 8]");
  Scene together(deck), alone(deck, Communicator(MPI_COMM_SELF));
  together.run(60);
  alone.run(60);
  const std::vector<double> row = take_values(together);
  EXPECT_EQ(row, take_values(alone));
  EXPECT_GT(std::abs(row[0]), 1);
}

TEST(Accelerometers, GoOnAfterARestart) {
  const SharedFolder whole, parts;
  const auto run = [&](const std::string& time, const std::string& more, const std::string& folder,
                       const std::string& restart) {
    std::string text = make_cube("", "velocity: [-3, 0, 0], angular_velocity: [1, 2, 2]",
                                 "walls: [{point: [-1.02, 0, 0], normal: x}]\n");
    text.replace(text.find("time: {end: 1000}"), 17, "time: " + time);
    text.replace(text.find("  history:\n"), 11, more + "  history:\n");
    RunOptions options;
    options.out_dir = folder;
    options.restart = restart;
    options.goes_on_in_place = !restart.empty();
    return run_scene(parse_deck(text, "deck.yaml"), options).summary;
  };
  EXPECT_GT(run("{end: 2}", "", whole.path(), "").steps, 40);
  run("{end: 2, max_steps: 36}", "  checkpoint: {every: 0.2}\n", parts.path(), "");
  run("{end: 2}", "", parts.path(), parts.path() + "/checkpoint_previous.h5");
  if (Communicator::world().rank() != 0) return;
  EXPECT_TRUE(read_file(parts.path() + "/history.csv") == read_file(whole.path() + "/history.csv"));
}

TEST(Accelerometers, RefuseNodesOnALine) {
  std::string deck = make_cube("", "velocity: [0, 0, 0]", "");
  deck.replace(deck.find("near: [1, 1, 0]"), 15, "near: [-1, 0, 0]");
  EXPECT_ERROR(Scene{deck}, InputError, "are on a line");
}

}  // namespace percuss::test
