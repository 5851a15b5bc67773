// Coulomb friction against the motion of rigid blocks: sliding to a stop, inclines, oblique impact.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::friction_test {
namespace {

constexpr double g = 9.81;

// 16 kg, soft so that steps are long: weight strains it by 1e-4, and 1e-4 of its size is what it may differ from rigid.
// Weight and friction come all at once and make it ring; a block that nothing damps continues ringing in bending, fed
// by the slip of nodes that have little weight on them, and is not rigid. Viscous hourglass control damps bending.
const std::string block = R"(
elements: {hourglass: viscous}
materials: {soft: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
)";
constexpr double mass = 16;

/// The block on a plane that is tilted about y by turning gravity.
Outcome slide_down(double degrees, double friction, double end) {
  const double angle = degrees * std::numbers::pi / 180;
  return run_deck(fmt::format(R"(
title: incline of {} degrees, friction {}
time: {{end: {}}}
parts: {{block: {{box: {{size: [0.4, 0.4, 0.1], cells: [4, 4, 2]}}, material: soft}}}}
loads: {{gravity: [{:.17g}, 0, {:.17g}]}}
walls: [{{normal: [0, 0, 1], friction: {}}}]
output: {{history: {{every: 1e-3, nodes: [{{name: n, near: [0.2, 0.2, 0.05]}}]}}}}
)",
                              degrees, friction, end, g * std::sin(angle), -g * std::cos(angle), friction) +
                  block);
}

constexpr double shaken_speed = 0.16, shaken_rate = 31.416;  // 5.03 m/s^2 at most, beyond mu g

/// Where a rigid block that begins at rest is on a table that moves with shaken_speed sin(shaken_rate t), less where
/// that is: m dv/dt = mu m g towards the speed of the table, or that speed where it needs less.
double find_slip(double friction, double end) {
  constexpr int steps = 1000000;
  const double dt = end / steps, most = friction * g * dt;
  double v = 0, slip = 0;
  for (int i = 0; i < steps; ++i) {
    const double table = shaken_speed * std::sin(shaken_rate * (i + 0.5) * dt), missing = table - v;
    v += std::clamp(missing, -most, most);
    slip += (v - table) * dt;
  }
  return slip;
}

/// The slip that a block, its part with more keys, has at the end.
double shake(const std::string& more, const std::string& elements, const std::string& enforcement, double end) {
  const HistoryTable h = run_deck(fmt::format(R"deck(
time: {{end: {}}}
parts:
  table: {{box: {{size: [0.6, 0.3, 0.02], cells: [6, 3, 1]}}, at: [-0.3, -0.15, -0.02], material: soft, rigid: true}}
  block: {{box: {{size: [0.1, 0.1, 0.05], cells: [4, 4, 2]}}, at: [-0.05, -0.05, 0], material: soft{}}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}}}
elements: {{{}}}
contact: {{surfaces: all, friction: 0.3, enforcement: {}}}
loads: {{gravity: [0, 0, -{}]}}
conditions: [{{body: table, velocity: {{x: {{expression: "{} * sin({} * t)"}}, y: 0, z: 0, rx: 0, ry: 0, rz: 0}}}}]
output: {{history: {{every: 1e-3, motion: all}}}}
)deck",
                                              end, more, elements, enforcement, g, shaken_speed, shaken_rate))
                             .history;
  return h.last("mean_displacement_x:block") - h.last("mean_displacement_x:table");
}

}  // namespace

TEST(Friction, ASlidingBlockStopsAfterItsDistanceAndTime) {
  const Outcome run = run_deck(R"(
title: sliding block
time: {end: 1.9}
parts: {block: {box: {size: [0.4, 0.4, 0.1], cells: [4, 4, 2]}, material: soft}}
initial: [{part: block, velocity: [5, 0, 0]}]
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: [0, 0, 1], friction: 0.3}]
output: {history: {every: 1e-3, nodes: [{name: n, near: [0.2, 0.2, 0.05]}]}}
)" + block);
  const HistoryTable& h = run.history;
  EXPECT_NEAR(h.last("n_x") - 0.2, 25 / (2 * 0.3 * g), 5e-3 * 4.2474);  // 4.2474 m
  fmt::print("stops after {:.4f} m\n", h.last("n_x") - 0.2);
  // The momentum falls along a straight line; a twentieth before its end the line is still straight.
  double at_twentieth = 0;
  for (std::size_t i = 0; i < h.rows() && h["momentum_x"][i] > 0.05 * mass * 5; ++i) at_twentieth = h["time"][i];
  fmt::print("and {:.4f} s, friction {:.2f} J\n", at_twentieth / 0.95, run.summary.energy.friction);
  EXPECT_NEAR(at_twentieth / 0.95, 5 / (0.3 * g), 5e-3 * 1.6989);  // 1.6989 s
  // All but the ringing of the start, some weight times sag, goes into friction.
  EXPECT_NEAR(run.summary.energy.friction, -0.5 * mass * 25, 0.02 * 0.5 * mass * 25);
  EXPECT_NEAR(run.summary.energy.friction + run.summary.energy.contact - run.summary.energy.work[WorkKind::viscous],
              -0.5 * mass * 25, 1e-3 * 200);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(Friction, ABlockSlidesDownAnInclineAtTheRigidAcceleration) {
  const Outcome run = slide_down(30, 0.3, 1);
  const double a = g * (std::sin(std::numbers::pi / 6) - 0.3 * std::cos(std::numbers::pi / 6));
  fmt::print("acceleration {:.4f} of {:.4f} m/s^2\n", 2 * (run.history.last("n_x") - 0.2), a);
  EXPECT_NEAR(a, 2.3563, 1e-4);
  EXPECT_NEAR(run.history.last("n_x") - 0.2, 0.5 * a, 5e-3 * 0.5 * a);
  EXPECT_NEAR(run.history.last("momentum_x"), mass * a, 5e-3 * mass * a);
}

TEST(Friction, ABlockSticksToAnInclineThatIsNotTooSteepAndDoesNotCreep) {
  // tan(30 deg) = 0.577. Weight comes all at once: while that rings, single nodes lose their grip and slip a little.
  const Outcome run = slide_down(30, 0.7, 2);
  EXPECT_NEAR(run.history.mean(0.9, 1.0, "n_x"), 0.2, 1e-3);
  // From then on nothing slips: what is left of the ringing averages out of a tenth of a second.
  EXPECT_NEAR(run.history.mean(1.9, 2.0, "n_x"), run.history.mean(0.9, 1.0, "n_x"), 1e-6);
  EXPECT_EQ(run.history.at(1.0, "friction"), run.history.last("friction"));
}

TEST(Friction, ABlockSlidesOverTheFacesOfAPlateAsOverAPlane) {
  const Outcome run = run_deck(R"(
title: block on a plate
time: {end: 0.8}
parts:
  block: {box: {size: [0.4, 0.4, 0.1], cells: [4, 4, 2]}, at: [0.1, 0.2, 0], material: soft}
  plate: {box: {size: [1.5, 0.8, 0.1], cells: [9, 5, 1]}, at: [0, 0, -0.1], material: soft}
initial: [{part: block, velocity: [2, 0, 0]}]
conditions: [{nodes: plate/z_min, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: all, friction: 0.3}
output: {history: {every: 1e-3, nodes: [{name: n, near: [0.3, 0.4, 0.05], part: block}]}}
)" + block);
  EXPECT_NEAR(run.history.last("n_x") - 0.3, 4 / (2 * 0.3 * g), 5e-3 * 0.6796);
  fmt::print("stops after {:.4f} m, {:.1e} m aside\n", run.history.last("n_x") - 0.3, run.history.last("n_y") - 0.4);
  // corners of the plate's faces must not steer it
  EXPECT_NEAR(run.history.last("n_y"), 0.4, 1e-3);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(Friction, AnObliqueImpactThatSlidesThroughoutGivesMuTimesTheNormalImpulse) {
  const Outcome run = run_deck(R"(
title: oblique impact
time: {end: 6e-4}
parts: {ball: {sphere: {radius: 0.05, cells: 6}, at: [0, 0, 0.0501], material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{part: ball, velocity: [20, 0, -2]}]
walls: [{normal: [0, 0, 1], friction: 0.1}]
output: {history: {every: 0}}
)");
  const HistoryTable& h = run.history;
  const double normal = h.last("momentum_z") - h["momentum_z"][0],
               tangential = h.last("momentum_x") - h["momentum_x"][0];
  EXPECT_GT(h.last("momentum_z"), 0.8 * -h["momentum_z"][0]);  // it came back
  EXPECT_NEAR(tangential / normal, -0.1, 1e-9);                // every push slid: mu times it, to round-off
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);        // it acts where it touches
}

// Slip of a few millimetres to both sides. An elastic block without damping is no rigid one: sliding feeds a mode that
// couples its bending with its bounce, by 1.3 a millisecond whatever the step, mesh and enforcement, and not without
// Poisson's ratio. Damped it slips as a rigid one does.
TEST(Friction, OnAShakenTableGivesTheSlipOfARigidBlock) {
  const double end = 0.2, exact = find_slip(0.3, end);
  EXPECT_GT(exact, 2e-3);
  EXPECT_NEAR(shake(", rigid: true", "", "kinematic", end), exact, 2e-3 * exact);
  EXPECT_NEAR(shake("", "stiffness_damping: 1.0e-4", "kinematic", end), exact, 1.5e-2 * exact);
  EXPECT_NEAR(shake("", "stiffness_damping: 1.0e-4", "penalty", end), exact, 3e-2 * exact);
}

}  // namespace percuss::test::friction_test
