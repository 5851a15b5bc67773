// Gravity, held directions and prescribed motions over steps.

#include <gtest/gtest.h>

#include <cmath>

#include "src/step/audit/audit.hpp"
#include "tests/src/step/scene.hpp"

namespace percuss::test {
namespace {

const std::string bar_text = R"(
time: {end: 1}
parts: {bar: {box: {size: [1, 0.2, 0.2], cells: [10, 2, 2]}, material: steel}}
)" + steel_text;

constexpr double bar_mass = 7850 * 0.04;

}  // namespace

TEST(Gravity, EveryNodeOfEveryFreeShapeAcceleratesAtExactlyG) {
  Scene scene(R"(
time: {end: 1}
parts:
  a: {box: {size: [1, 2, 3], cells: [3, 2, 5]}, material: steel}
  b: {cylinder: {radius: 1, length: 2, cells: [5, 4]}, at: [0, 10, 0], material: steel}
  c: {tube: {inner_radius: 0.5, outer_radius: 0.8, length: 1, cells: [2, 12, 3]}, at: [0, 0, 10], material: steel}
  d: {sphere: {radius: 0.7, cells: 5}, at: [-10, 0, 0], material: steel}
loads: {gravity: [1, -2, -9.81]}
)" + steel_text);
  scene.run(50);
  const auto v = to_host(scene.state.v);
  const auto x = to_host(scene.state.x);
  const double g[3] = {1, -2, -9.81};
  // v is at n-1/2; positions under constant acceleration are exact with central differences. Round-off of x (10 m)
  // strains the elements by 1e-16, which brings accelerations of E / (rho h) 1e-16 = 1e-8 m/s^2: 1e-12 m/s here.
  const double t = scene.state.time, t_half = t - 0.5 * scene.state.dt;
  for (std::size_t n = 0; n < v.extent(0); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(v(n, k), g[k] * t_half, 1e-12) << "node " << n;
      EXPECT_NEAR(x(n, k) - scene.chunked.mesh.nodes[n][k], 0.5 * g[k] * t * t, 1e-14);
    }
  }
}

TEST(Gravity, IsBookedAsPotentialAndAsImpulse) {
  Scene scene(
      bar_text +
      "loads: {gravity: [1, -2, -9.81]}\ninitial: [{part: bar, velocity: [3, 0, 4], angular_velocity: [5, 6, 7]}]\n");
  Audit audit(scene.model);
  scene.stepper.start(scene.state);
  audit(scene.state);
  for (int i = 0; i < 200; ++i) scene.stepper.advance(scene.state);
  const AuditResult result = audit(scene.state);
  const double t = scene.state.time;
  EXPECT_NEAR(result.energy.external, bar_mass * (0.5 * t * t * (1 + 4 + 9.81 * 9.81) + t * (3 * 1 - 9.81 * 4)), 1e-9);
  EXPECT_LT(result.momentum.linear_error, 1e-13);
  EXPECT_LT(result.momentum.angular_error, 1e-13);
  EXPECT_LT(std::abs(result.energy.error), 1e-6);
}

TEST(Fixed, NodesStayWhereTheyAreInTheirDirectionsOnly) {
  Scene scene(bar_text +
              "conditions: [{nodes: bar/x_min, fixed: [x, y]}]\ninitial: [{part: bar, velocity: [10, 20, 30]}]\n");
  scene.run(100);
  const auto x = to_host(scene.state.x);
  const auto v = to_host(scene.state.v);
  for (const int node : scene.chunked.mesh.node_sets.at("bar/x_min")) {
    const auto n = static_cast<std::size_t>(node);
    EXPECT_EQ(x(n, 0), scene.chunked.mesh.nodes[n][0]);
    EXPECT_EQ(x(n, 1), scene.chunked.mesh.nodes[n][1]);
    EXPECT_EQ(v(n, 0), 0);
    EXPECT_EQ(v(n, 1), 0);
    EXPECT_GT(std::abs(x(n, 2) - scene.chunked.mesh.nodes[n][2]), 1e-5);
  }
}

TEST(PrescribedVelocity, IsTakenAtTheMiddleOfTheStepSoThatLinearCurvesIntegrateExactly) {
  Scene scene(bar_text + R"deck(conditions: [{nodes: bar/x_min, velocity: {x: {expression: "4000 * t + 1"}}}])deck" +
              "\n");
  scene.run(60);
  const auto x = to_host(scene.state.x);
  const auto v = to_host(scene.state.v);
  const double t = scene.state.time;
  for (const int node : scene.chunked.mesh.node_sets.at("bar/x_min")) {
    const auto n = static_cast<std::size_t>(node);
    EXPECT_DOUBLE_EQ(v(n, 0), 4000 * (t - 0.5 * scene.state.dt) + 1);
    EXPECT_NEAR(x(n, 0), 2000 * t * t + t, 1e-15);  // 60 additions of about 1e-5 m
  }
}

TEST(PrescribedDisplacement, LandsOnItsCurveAtEveryStep) {
  Scene scene(bar_text +
              R"deck(conditions: [{nodes: bar/x_max, displacement: {y: {expression: "1e-3 * sin(3e4 * t)"}}}])deck" +
              "\n");
  scene.stepper.start(scene.state);
  for (int i = 0; i < 60; ++i) {
    scene.stepper.advance(scene.state);
    const auto x = to_host(scene.state.x);
    for (const int node : scene.chunked.mesh.node_sets.at("bar/x_max")) {
      const auto n = static_cast<std::size_t>(node);
      // start + u, to the last bits of coordinates of up to 0.2 m
      EXPECT_NEAR(x(n, 1), scene.chunked.mesh.nodes[n][1] + 1e-3 * std::sin(3e4 * scene.state.time), 1e-16);
    }
  }
}

TEST(Turn, KeepsEachNodeAtItsDistanceFromTheAxisAndFollowsItsAngle) {
  Scene scene(bar_text +
              R"deck(conditions: [{nodes: bar, turn: {axis: y, through: [0.3, 7, -0.2], angular_velocity: )deck" +
              "{expression: \"3e7 * t\"}}}]\n");
  scene.stepper.start(scene.state);
  for (int i = 0; i < 200; ++i) scene.stepper.advance(scene.state);
  const auto x = to_host(scene.state.x);
  const double t = scene.state.time, angle = 1.5e7 * t * t, c = std::cos(angle), s = std::sin(angle);
  ASSERT_GT(angle, 0.1);
  for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n) {
    const Vec3 start = scene.chunked.mesh.nodes[n];
    const double from_z = start[2] + 0.2, from_x = start[0] - 0.3;  // a turn about y takes z to x
    EXPECT_NEAR(x(n, 2), -0.2 + c * from_z - s * from_x, 1e-12);
    EXPECT_NEAR(x(n, 0), 0.3 + s * from_z + c * from_x, 1e-12);
    EXPECT_NEAR(x(n, 1), start[1], 1e-12);
  }
}

TEST(PrescribedMotion, WorkAndImpulseAreBooked) {
  // Both ends are driven against each other; a third condition drags the middle sideways.
  Scene scene(bar_text + R"deck(conditions:
  - {nodes: bar/x_min, velocity: {x: {expression: "20 * sin(2e4 * t)"}}}
  - {nodes: bar/x_max, displacement: {x: {expression: "-5e-4 * (1 - cos(2e4 * t))"}}}
  - {nodes: {name: bar, inside: [[0.45, -1, -1], [0.55, 1, 1]]}, velocity: {z: {table: [[0, 0], [1e-4, 15]]}}}
)deck");
  Audit audit(scene.model);
  scene.stepper.start(scene.state);
  audit(scene.state);
  for (int i = 0; i < 300; ++i) {
    scene.stepper.advance(scene.state);
    const AuditResult result = audit(scene.state);
    // The elements' energy comes from their own stresses and strain increments; it differs from the nodes' work by the
    // second-order error of the midpoint rule, (omega dt)^2 / 12 = 2e-3 of the part of the energy that is stored.
    EXPECT_LT(std::abs(result.energy.error), 1e-3);
    EXPECT_LT(result.momentum.linear_error, 1e-13);
    EXPECT_LT(result.momentum.angular_error, 1e-13);
  }
  EXPECT_GT(audit(scene.state).energy.external, 0.1 * audit(scene.state).energy.kinetic);
}

TEST(PrescribedVelocity, StartsAtTheCurvesFirstValue) {
  Scene scene(bar_text +
              "conditions: [{nodes: bar/x_min, velocity: {x: 25}}, {nodes: bar/x_max, displacement: {x: 0}}]\ninitial: "
              "[{part: bar, velocity: [7, 0, 0]}]\n");
  scene.stepper.start(scene.state);
  const auto v = to_host(scene.state.v);
  for (std::size_t n = 0; n < v.extent(0); ++n) {
    const double x = scene.chunked.mesh.nodes[n][0];
    EXPECT_EQ(v(n, 0), x == 0 ? 25 : x == 1 ? 0 : 7);
  }
}

TEST(PrescribedVelocity, KineticEnergyOfADrivenEndIsThatOfItsSpeedWhateverTheForce) {
  // A column pressed to half its length: the force on its driven end would change its velocity by far more than it has,
  // if nothing held it.
  Scene scene(R"(
time: {end: 1}
parts: {bar: {box: {size: [4, 1, 1], cells: [4, 1, 1]}, material: steel}}
conditions: [{nodes: bar/x_max, velocity: {x: -200}}, {nodes: bar/x_min, fixed: [x]}, {nodes: bar, fixed: [y, z]}]
initial: [{part: bar, velocity: [-100, 0, 0]}]
)" + steel_text);
  Audit audit(scene.model);
  scene.stepper.start(scene.state);
  audit(scene.state);
  while (scene.state.time < 1e-2) {
    scene.stepper.advance(scene.state);
    const AuditResult result = audit(scene.state);
    const auto v = to_host(scene.state.v);
    const auto mass = to_host(scene.model.mass);
    double end = 0;
    for (const int node : scene.chunked.mesh.node_sets.at("bar/x_max")) {
      const auto n = static_cast<std::size_t>(node);
      end += 0.5 * mass(n) * v(n, 0) * v(n, 0);
    }
    // The free planes between contribute their own, which central differences may take below zero at times, but not by
    // more than the planes have.
    EXPECT_GT(result.energy.kinetic, 0.5 * end);
    EXPECT_LT(std::abs(result.energy.error), 1e-3);
  }
}

}  // namespace percuss::test
