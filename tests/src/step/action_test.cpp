// What the stepper asks of an action that says nothing but what it does.

#include "src/step/model/action.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

/// Moves all nodes down by `way` in the step `at`, by their velocity.
class Kick : public Action {
 public:
  Kick(double way, long at) : way_(way), at_(at) {}

  void predict(State& /*state*/, const StepTimes& /*times*/) override { ++predicted; }
  void change_velocities(State& state, const StepTimes& times) override {
    ++changed;
    if (state.step == at_) Kokkos::deep_copy(Kokkos::subview(state.v, Kokkos::ALL, 2), -way_ / times.dt);
  }

  int predicted = 0, changed = 0;

 private:
  double way_;
  long at_;
};

/// A cube whose lowest nodes are at this height, at rest.
std::string make_cube_at(double height, const std::string& more) {
  return "time: {end: 1}\nparts: {a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel, at: [0, 0, " +
         std::to_string(height) + "]}}\n" + more + steel_text;
}

double find_lowest(const Scene& scene) {
  const auto x = to_host(scene.state.x);
  double lowest = x(0, 2);
  for (std::size_t n = 0; n < x.extent(0); ++n) lowest = std::min(lowest, x(n, 2));
  return lowest;
}

}  // namespace

TEST(Action, ChangesVelocitiesInASceneWithoutContact) {
  Scene scene(make_cube_at(0, ""));
  Kick kick(0.25, 0);
  scene.stepper.act_first(kick);
  scene.run(1);
  EXPECT_EQ(kick.predicted, 1);
  EXPECT_EQ(kick.changed, 1);
  EXPECT_NEAR(find_lowest(scene), -0.25, 1e-15);
}

// What contact leaves out by the speeds of nodes counts what it has changed, though conditions after it bound a part.
TEST(Action, OfUnknownSpeedsIsStoppedByAWall) {
  for (const char* more : {"", "conditions: [{nodes: a/z_max, fixed: [x]}]\n"}) {
    Scene scene(make_cube_at(0.125, std::string("walls: [{normal: z}]\n") + more));
    Kick kick(0.25, 3);
    scene.stepper.act_first(kick);
    scene.contact.prepare(scene.state.x, scene.state.v);
    scene.run(4);
    EXPECT_EQ(kick.changed, 4);
    EXPECT_NEAR(find_lowest(scene), 0, 1e-3) << more;
  }
}

}  // namespace percuss::test
