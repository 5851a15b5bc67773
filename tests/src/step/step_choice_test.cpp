// How long the next step is, and where a run ends.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "src/step/run/run.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

std::string make_text(const std::string& time) {
  return "time: {" + time + "}\nparts: {a: {box: {size: [1, 1, 1], cells: [3, 3, 3]}, material: steel}}\n" +
         "initial: [{part: a, angular_velocity: [1, 2, 3]}]\n" + steel_text;
}

Summary run_text(const std::string& time) { return run_scene(parse_deck(make_text(time), "deck.yaml"), {}).summary; }

}  // namespace

TEST(StepChoice, EndTimesAreHitExactlyWithoutATinyLastStep) {
  Scene scene(make_text("end: 1"));
  scene.stepper.start(scene.state);
  const double first = scene.state.next_dt;
  for (const double steps : {0.3, 1.0, 1.5, 2.0, 2.0001, 7.3, 19.99, 100.001}) {
    const Summary summary = run_text(fmt::format("end: {}", steps * first));
    EXPECT_DOUBLE_EQ(summary.time, steps * first) << steps << " steps";
    EXPECT_EQ(summary.status, "completed");
    EXPECT_GE(summary.dt.min, 0.49 * std::min(steps, 1.0) * first) << steps << " steps";
    EXPECT_LE(summary.dt.max, 1.01 * first);
  }
}

/// One row of nodes is struck: the energy is in waves as short as the elements, of which (omega dt)^2 / 4, most of it,
/// changes with the step.
std::string make_struck_bar(const std::string& end) {
  return "time: {end: " + end + R"(}
parts: {a: {box: {size: [1, 0.1, 0.1], cells: [10, 1, 1]}, material: steel}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{nodes: a/x_min, velocity: [1, 0, 0]}]
)" + steel_text;
}

TEST(StepChoice, LandingOnTheEndKeepsTheEnergyOfTheShortestWaves) {
  // 128 steps are shortened by 1 in 128 to 2 in 129, once.
  for (const char* end : {"2e-4", "4.3e-4", "1e-3", "4.9e-3"}) {
    const Summary summary = run_scene(parse_deck(make_struck_bar(end), "deck.yaml"), {}).summary;
    EXPECT_LT(std::abs(summary.energy.error), 3e-3) << end;
  }
}

TEST(StepChoice, TheLastStepsAreEqual) {
  Scene scene(make_struck_bar("4.9e-3"));
  scene.stepper.start(scene.state);
  std::vector<double> steps;
  while (scene.state.time < 4.9e-3 * (1 - 1e-12)) {
    scene.stepper.advance(scene.state);
    steps.push_back(scene.state.dt);
  }
  ASSERT_GT(steps.size(), 300u);
  EXPECT_DOUBLE_EQ(scene.state.time, 4.9e-3);
  const double last = steps.back(), before = steps[steps.size() - 200];
  for (std::size_t i = steps.size() - 120; i < steps.size(); ++i) EXPECT_NEAR(steps[i], last, 1e-6 * last);
  EXPECT_LT(std::abs(last / before - 1), 0.02);
}

TEST(StepChoice, AStepDoesNotFollowTheBoundOfAVibration) {
  // A clamped bar at a strain of 0.4 %: steps that follow its bound up and down gain 8e-4 of the energy.
  const Summary summary = run_scene(parse_deck(R"(
time: {end: 1, max_steps: 2000}
parts: {a: {box: {size: [0.08, 0.01, 0.01], cells: [8, 1, 1]}, material: steel}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{velocity: [20, 0, 0]}]
conditions: [{nodes: a/x_min, fixed: [x, y, z]}]
)" + steel_text,
                                               "deck.yaml"),
                                    {})
                              .summary;
  EXPECT_LT(std::abs(summary.energy.error), 1e-4);
}

TEST(StepChoice, AStepIsTheScaledBoundOfTheElements) {
  Scene scene(make_text("end: 1, step_scale: 0.7"));
  scene.run(10);
  EXPECT_LE(scene.state.next_dt, 0.7 * scene.state.bound.step);
  EXPECT_GT(1.02 * scene.state.next_dt, 0.7 * scene.state.bound.step);  // it is kept while the bound hardly grows
  // a cube of edge h: 0.9 h / c_L comes from the proven bound only in one dimension; here omega^2 <= 8 (lambda tr G +
  // 2 mu g_max) / (rho V^2) with G = 2 h^4 I / ... gives h / sqrt(3 lambda + 2 mu) * sqrt(rho)
  const double lambda = 200e9 * 0.3 / (1.3 * 0.4), mu = 200e9 / 2.6, h = 1.0 / 3;
  const double elastic = h * std::sqrt(7850 / (3 * lambda + 2 * mu));
  EXPECT_LT(scene.state.bound.step, elastic);  // hourglass control and viscosity shorten it
  EXPECT_GT(scene.state.bound.step, 0.85 * elastic);
}

TEST(StepChoice, MaxStepBoundsEveryStep) {
  const Summary summary = run_text("end: 1e-3, max_step: 1e-5");
  EXPECT_EQ(summary.steps, 100);
  EXPECT_LE(summary.dt.max, 1e-5 * (1 + 1e-12));  // the last one ends on time.end, sums of times are rounded
  EXPECT_DOUBLE_EQ(summary.time, 1e-3);
}

TEST(StepChoice, MaxStepsEndsARunAsCompleted) {
  const Summary summary = run_text("end: 1, max_steps: 7");
  EXPECT_EQ(summary.steps, 7);
  EXPECT_EQ(summary.status, "completed");
  EXPECT_LT(summary.time, 1e-3);
}

TEST(StepChoice, AStepGrowsByATenthAtMost) {
  Scene scene(make_text("end: 1"));
  scene.run(1);
  const double full = scene.state.next_dt;
  scene.state.dt = scene.state.next_dt = 0.01 * full;
  scene.stepper.advance(scene.state);
  for (int i = 0; i < 100 && scene.state.next_dt < 0.99 * full; ++i) {
    EXPECT_LE(scene.state.next_dt, 1.1 * scene.state.dt * (1 + 1e-15));
    scene.stepper.advance(scene.state);
  }
  EXPECT_NEAR(scene.state.next_dt, full, 0.01 * full);  // and reaches the bound again
}

}  // namespace percuss::test
