// Joints that slide, cross or hold: exact motions of bodies on each kind.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::joint_kinds_test {
namespace {

constexpr const char* of_steel =
    "materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n";

/// A rod of 1 m along x from the origin, of 2 kg, with these joints.
Outcome run_rod(double end, const std::string& joints, const std::string& more) {
  return run_deck(fmt::format(
      "time: {{end: {}, max_step: 1.0e-3}}\nparts: {{rod: {{box: {{size: [1, 0.02, 0.02], cells: [4, 2, 2]}}, at: [0, "
      "-0.01, -0.01], material: steel, rigid: {{mass: 2, inertia: [0.1, 0.3, 0.3, 0, 0, 0]}}}}}}\n{}joints: "
      "{}\n{}output: {{history: {{every: 0.01}}}}\n",
      end, of_steel, joints, more));
}

double find_angle(const HistoryTable& history, const std::string& body, std::size_t row, const double (&axis)[3]) {
  const auto q = [&](const char* which) { return history[fmt::format("body_{}:{}", which, body)][row]; };
  return 2 * std::atan2(q("q1") * axis[0] + q("q2") * axis[1] + q("q3") * axis[2], q("q0"));
}

}  // namespace

// On a rail at 45 degrees: half of g t^2 sin 45 degrees along it, and the rail carries m g cos 45 degrees across it.
TEST(SlidingJoint, TranslationalSlidesDownItsRail) {
  const double end = 0.5, way = 0.5 * 9.81 * std::sqrt(0.5) * end * end;
  const Outcome run =
      run_rod(end, "{rail: {kind: translational, bodies: [rod], at: [0.3, 0.1, 0.2], axis: [1, 0, -1]}}",
              "loads: {gravity: [0, 0, -9.81]}\n");
  EXPECT_NEAR(run.history.last("body_x:rod"), 0.5 + way * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(run.history.last("body_z:rod"), -way * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(run.history.last("body_y:rod"), 0, 1e-12);
  EXPECT_NEAR(run.history.last("body_q0:rod"), 1, 1e-15);
  const double fx = run.history.last("joint_fx:rail"), fz = run.history.last("joint_fz:rail");
  EXPECT_NEAR(fx, 2 * 9.81 * 0.5, 1e-6);
  EXPECT_NEAR(fz, 2 * 9.81 * 0.5, 1e-6);
}

// It slides as on the rail, and turns about the axis as it began.
TEST(SlidingJoint, CylindricalTurnsAboutItsAxisToo) {
  const double end = 0.5, rate = 7;
  const Outcome run = run_rod(end, "{sleeve: {kind: cylindrical, bodies: [rod], at: [0.2, 0, 0], axis: x}}",
                              "loads: {gravity: [4, 0, -9.81]}\ninitial: [{part: rod, angular_velocity: [7, 0, 0], "
                              "center: [0, 0, 0]}]\n");
  EXPECT_NEAR(run.history.last("body_x:rod"), 0.5 + 0.5 * 4 * end * end, 1e-9);
  EXPECT_NEAR(run.history.last("body_z:rod"), 0, 1e-12);
  const std::size_t last = run.history.rows() - 1;
  EXPECT_NEAR(find_angle(run.history, "rod", last, {1, 0, 0}), rate * end, 1e-5);  // of second order in a step's turn
  EXPECT_NEAR(run.history.last("joint_fz:sleeve"), 2 * 9.81, 1e-6);
  // the weight acts at 0.5 + way, 0.3 + way from the joint's point
  EXPECT_NEAR(run.history.last("joint_my:sleeve"), -2 * 9.81 * (0.3 + 0.5 * 4 * end * end), 2e-2);
}

// A force along a screw moves its mass and turns its inertia: a = F / (m + I / p^2), w = v / p, p the way over the
// angle. It turns several times; a negative lead turns the other way.
TEST(SlidingJoint, ScrewTurnsAsItSlides) {
  const double end = 3, inertia = 0.1;
  for (const double lead : {0.5, -0.5}) {
    const double p = lead / (2 * std::numbers::pi), a = 4 * 2 / (2 + inertia / (p * p));
    const Outcome run =
        run_rod(end, fmt::format("{{screw: {{kind: screw, bodies: [rod], at: [0.2, 0, 0], axis: x, lead: {}}}}}", lead),
                "loads: {gravity: [4, 0, 0]}\n");
    // of second order in a step's turn, at most 0.017: a quarter of the step has a sixteenth of the error
    EXPECT_NEAR(run.history.last("body_x:rod"), 0.5 + 0.5 * a * end * end, 1e-5);
    const std::size_t last = run.history.rows() - 1;
    const double angle = find_angle(run.history, "rod", last, {1, 0, 0});
    EXPECT_NEAR(std::remainder(angle - 0.5 * a * end * end / p, 2 * std::numbers::pi), 0, 1e-4);
    EXPECT_NEAR(run.history.last("joint_fx:screw"), 2 * (a - 4), 1e-5);
  }
}

TEST(SlidingJoint, PlanarFallsInItsPlane) {
  const double end = 0.5, rate = 3;
  const Outcome run = run_rod(end, "{table: {kind: planar, bodies: [rod], at: [0.1, 0, 0], axis: z}}",
                              "loads: {gravity: [1, 2, -10]}\ninitial: [{part: rod, angular_velocity: [0, 0, 3], "
                              "center: [0.5, 0, 0]}]\n");
  EXPECT_NEAR(run.history.last("body_x:rod"), 0.5 + 0.5 * end * end, 1e-9);
  EXPECT_NEAR(run.history.last("body_y:rod"), end * end, 1e-9);
  EXPECT_NEAR(run.history.last("body_z:rod"), 0, 1e-12);
  EXPECT_NEAR(find_angle(run.history, "rod", run.history.rows() - 1, {0, 0, 1}), rate * end, 1e-5);
  EXPECT_NEAR(run.history.last("joint_fz:table"), 20, 1e-6);
}

// A sleeve on a rod that spins freely: r'' = r w^2 with (I + m r^2) w constant, m the reduced mass.
TEST(SlidingJoint, SleeveRunsOutOnASpinningRod) {
  const double end = 0.4, mass = 2.0 * 1.0 / 3.0, inertia = 0.3 + 0.01, first = 0.1, rate = 5;
  const Outcome run = run_deck(fmt::format(
      "time: {{end: {}, max_step: 1.0e-4}}\nparts:\n  rod: {{box: {{size: [1, 0.02, 0.02], cells: [4, 2, 2]}}, at: "
      "[-0.5, -0.01, -0.01], material: steel, rigid: {{mass: 2, inertia: [0.1, 0.3, 0.3, 0, 0, 0]}}}}\n  sleeve: "
      "{{box: {{size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}}, at: [0.05, -0.05, -0.05], material: steel, rigid: {{mass: "
      "1, inertia: [0.01, 0.01, 0.01, 0, 0, 0]}}}}\n{}joints: {{slide: {{kind: translational, bodies: [rod, sleeve], "
      "at: [0, 0, 0], axis: x}}}}\ninitial: [{{part: all, angular_velocity: [0, 0, {}], center: [{}, 0, 0]}}]\noutput: "
      "{{history: {{every: 0.01}}}}\n",
      end, of_steel, rate, first / 3));
  double r = first, v = 0;
  const double spin = (inertia + mass * r * r) * rate;
  const int steps = 40000;
  const auto pull = [&](double at) { return at * std::pow(spin / (inertia + mass * at * at), 2); };
  for (int i = 0; i < steps; ++i) {
    v += 0.5 * end / steps * pull(r);
    r += end / steps * v;
    v += 0.5 * end / steps * pull(r);
  }
  const auto last = [&](const char* column) { return run.history.last(column); };
  const double x = last("body_x:sleeve") - last("body_x:rod"), y = last("body_y:sleeve") - last("body_y:rod");
  EXPECT_GT(r, 3 * first);
  EXPECT_NEAR(std::hypot(x, y), r, 1e-5);
  EXPECT_NEAR(std::atan2(y, x), find_angle(run.history, "rod", run.history.rows() - 1, {0, 0, 1}), 1e-12);
  for (const char* q : {"q0", "q1", "q2", "q3"})
    EXPECT_NEAR(last(fmt::format("body_{}:rod", q).c_str()), last(fmt::format("body_{}:sleeve", q).c_str()), 1e-12);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::max(run.history.largest("energy_error"), -run.history.smallest("energy_error")), 1e-6);
}

// Two shafts at 30 degrees: tan of the second angle is that of the first times cos 30 degrees, at all times.
TEST(UniversalJoint, TurnsTheSecondShaftUnevenly) {
  const double bend = std::numbers::pi / 6, c = std::cos(bend), s = std::sin(bend);
  const Outcome run = run_deck(fmt::format(
      "time: {{end: 1, max_step: 1.0e-3}}\nparts:\n  a: {{box: {{size: [1, 0.02, 0.02], cells: [4, 2, 2]}}, at: [-1, "
      "-0.01, -0.01], material: steel, rigid: true}}\n  b: {{box: {{size: [1, 0.04, 0.02], cells: [4, 2, 2]}}, at: [0, "
      "-0.02, -0.01], material: steel, rigid: true}}\n{}joints:\n  one: {{kind: revolute, bodies: [a], at: [-0.5, 0, "
      "0], axis: x}}\n  two: {{kind: revolute, bodies: [b], at: [0, 0, 0], axis: [{}, {}, 0]}}\n  cross: {{kind: "
      "universal, bodies: [a, b], at: [0, 0, 0], axis: z, second_axis: [{}, {}, 0]}}\ninitial: [{{part: a, "
      "angular_velocity: [15, 0, 0], center: [0, 0, 0]}}, {{part: b, angular_velocity: [{}, {}, 0], center: [0, 0, "
      "0]}}]\noutput: {{history: {{every: 0.01}}}}\n",
      of_steel, c, s, -s, c, 15 * c * c, 15 * c * s));
  double turned = 0;
  for (std::size_t row = 0; row < run.history.rows(); ++row) {
    const double first = find_angle(run.history, "a", row, {1, 0, 0});
    const double second = find_angle(run.history, "b", row, {c, s, 0});
    EXPECT_NEAR(std::cos(first) * std::sin(second), c * std::sin(first) * std::cos(second), 1e-11) << row;
    turned = std::max(turned, std::abs(std::sin(first) * std::cos(second) - std::cos(first) * std::sin(second)));
  }
  EXPECT_GT(turned, 0.07);  // (1 - c) / (1 + c): the shafts are out of step in between
  EXPECT_LT(std::max(run.history.largest("energy_error"), -run.history.smallest("energy_error")), 1e-3);
}

// A rod held by one end carries its weight with a force and a moment there.
TEST(FixedJoint, HoldsARodByItsEnd) {
  const Outcome run =
      run_rod(0.1, "{clamp: {kind: fixed, bodies: [rod], at: [0, 0, 0]}}", "loads: {gravity: [0, 0, -10]}\n");
  EXPECT_NEAR(run.history.last("body_z:rod"), 0, 1e-13);
  EXPECT_NEAR(run.history.last("joint_fz:clamp"), 20, 1e-9);
  EXPECT_NEAR(run.history.last("joint_my:clamp"), -20 * 0.5, 1e-9);
}

}  // namespace percuss::test::joint_kinds_test
