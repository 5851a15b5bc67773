// Rigid walls that are cylinders and spheres: against exact answers.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/contact/geometry/wall_geometry.hpp"
#include "tests/src/step/two_scenes.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::round_wall_test {
namespace {

/// A soft cube of one element and 1 mm with its bottom's middle at a point.
std::string write_cube(double x, double y, double z, const std::string& rest) {
  return fmt::format(R"yaml(
title: a small cube and a wall
parts: {{cube: {{box: {{size: [1e-3, 1e-3, 1e-3], cells: [1, 1, 1]}}, at: [{:.17g}, {:.17g}, {:.17g}], material: rubber}}}}
materials: {{rubber: {{model: elastic, density: 1000, youngs_modulus: 1e5, poissons_ratio: 0.3}}}}
{}
)yaml",
                     x - 5e-4, y - 5e-4, z, rest);
}

constexpr double cube_mass = 1e-6, pull = 10;

/// Distance of the nodes from an axis along y through (0, 0), at least.
double find_least_distance(const Scene& scene) {
  double least = INFINITY;
  for (std::size_t n = 0; n < scene.chunked.mesh.nodes.size(); ++n)
    least = std::min(least, std::hypot(scene.state.x(n, 0), scene.state.x(n, 2)));
  return least;
}

Communicator alone() { return Communicator(MPI_COMM_SELF); }

}  // namespace

// Whatever the place and the speed, a push along the normal brings the node to the surface.
TEST(RoundGap, IsTheWayAlongTheNormalToTheSurface) {
  ContactWall wall;
  wall.point = {0.1, -0.2, 0.3};
  wall.radius = 0.5;
  wall.speed = 3;
  wall.direction = normalize(Point3{1, 2, -2});
  wall.along = normalize(Point3{2, -1, 1});
  for (const WallShape shape : {WallShape::cylinder, WallShape::sphere}) {
    wall.shape = shape;
    const Point3 x{0.4, 0.6, 0.5}, v{-20, -100, 10};
    const double dt = 5e-3, offset = 0.05;
    const WallGap gap = find_round_gap(wall, x, v, dt, offset);
    EXPECT_NEAR(gap.start, find_wall_height(wall, x) - offset, 1e-15);
    EXPECT_LT(gap.end, 0);
    ContactWall moved = wall;
    moved.point = wall.point + dt * wall.speed * wall.direction;
    const Point3 pushed = x + dt * v - gap.end * gap.normal;
    EXPECT_NEAR(find_wall_height(moved, pushed), offset, 1e-14);
    EXPECT_NEAR(dot(gap.gradient, gap.normal), 1, 1e-14);
    // The gradient is that of the gap by the place at n+1.
    for (const Point3& way : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
      const double h = 1e-6;
      const double more = find_round_gap(wall, x, v + (h / dt) * way, dt, offset).end,
                   less = find_round_gap(wall, x, v - (h / dt) * way, dt, offset).end;
      EXPECT_NEAR((more - less) / (2 * h), dot(gap.gradient, way), 1e-7);
    }
  }
}

TEST(RoundWall, StopsNodesAtItsSurface) {
  for (const char* shape : {"cylinder: {axis: y, radius: 0.02}", "sphere: {radius: 0.02}"}) {
    Scene scene(write_cube(0, 0, 0.0201,
                           fmt::format("time: {{end: 1, max_step: 2e-5}}\nwalls: [{{{}}}]\n"
                                       "initial: [{{velocity: [0, 0, -1]}}]",
                                       shape)),
                alone());
    scene.run(0);
    for (int i = 0; i < 100; ++i) {
      scene.stepper.advance(scene.state);
      // The bottom's corners are off the axis: a sphere lets them lower than a cylinder.
      const double least = find_least_distance(scene), corner = std::sqrt(4e-4 - 2.5e-7);
      ASSERT_GT(least, (shape[0] == 'c' ? 0.02 : corner) * (1 - 1e-3)) << shape << i;
    }
    EXPECT_GT(scene.state.v(0, 2), 0) << shape;  // it has bounced
  }
}

// Without friction a small body that slides down from the top of a ball leaves it where the weight no longer bends its
// way: cos = 2/3 + v^2 / (3 g R).
TEST(RoundWall, IsLeftWhereABodySlidesOff) {
  for (const char* shape : {"cylinder: {axis: y, radius: 0.1}", "sphere: {radius: 0.1}"}) {
    const double radius = 0.1 + 5e-4, speed = 0.2;
    const Outcome run = run_deck(write_cube(0, 0, 0.1,
                                            fmt::format(R"yaml(
time: {{end: 0.3}}
elements: {{hourglass: viscous}}
loads: {{gravity: [0, 0, {}]}}
initial: [{{velocity: [{}, 0, 0]}}]
walls: [{{name: ball, {}}}]
output: {{history: {{every: 1e-3, forces: [{{name: push, wall: ball}}]}}}}
)yaml",
                                                        -pull, speed, shape)));
    const HistoryTable& h = run.history;
    // The fall of the mass centre follows from the momentum; the last row with a force is where the body left.
    double z = radius, left = NAN;
    for (std::size_t row = 1; row < h.rows(); ++row) {
      const double dt = h["time"][row] - h["time"][row - 1];
      z += 0.5 * dt * (h["momentum_z"][row] + h["momentum_z"][row - 1]) / cube_mass;
      if (std::isnan(left) && row > 20 && h["fz:push"][row] == 0) left = z;
    }
    const double exact = 2.0 / 3 + speed * speed / (3 * pull * radius);
    EXPECT_NEAR(left / radius, exact, 0.02) << shape;
    EXPECT_LT(std::abs(h.last("contact")), 1e-3 * cube_mass * pull * radius) << shape;
    EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  }
}

// Seen from the wall nothing differs, friction included.
TEST(RoundWall, AtConstantSpeedActsAsAWallAtRestOnABodyThatIsSlowerByThat) {
  for (const char* shape : {"cylinder: {axis: [0, 1, 0.1], radius: 0.02}", "sphere: {radius: 0.02}"}) {
    const auto write = [&](double u, const std::string& motion) {
      return write_cube(0.004, 0.002, 0.0203,
                        fmt::format("time: {{end: 1, max_step: 2e-5}}\nwalls: [{{friction: 0.3, {}{}}}]\n"
                                    "initial: [{{velocity: [{:.17g}, {:.17g}, {:.17g}]}}]",
                                    shape, motion, -0.3 + u, 0.1 + 2 * u, -1 - 2 * u));
    };
    Scene moving(write(0.25, ", direction: [1, 2, -2], speed: 0.75"), alone()), resting(write(0, ""), alone());
    moving.run(150);
    resting.run(150);
    ASSERT_EQ(moving.state.time, resting.state.time);
    const double way = 0.25 * moving.state.time;
    const double by[3] = {way, 2 * way, -2 * way};
    for (std::size_t n = 0; n < 8; ++n)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(moving.state.x(n, k) - by[k], resting.state.x(n, k), 1e-10) << shape << n;
    EXPECT_GT(resting.state.v(0, 2), 0.1) << shape;  // it has bounced
    EXPECT_NEAR(moving.contact.list_wall_motions()[0], 3 * way, 1e-15);
  }
}

// The wall's force is all that changes the momentum, and the work of a wall at constant speed is its way by its force.
TEST(RoundWall, GivesTheMomentumAndTheWorkOfItsForce) {
  const Outcome run = run_deck(write_cube(0.004, 0, 0.0203, R"yaml(
time: {end: 4e-3}
walls: [{name: pole, cylinder: {axis: y, radius: 0.02}, friction: 0.4, direction: [0.6, 0, 0.8], speed: 1.5}]
initial: [{velocity: [0.2, 0.5, -1]}]
output: {history: {every: 1e-4, forces: [{name: push, wall: pole}]}}
)yaml"));
  const HistoryTable& h = run.history;
  double impulse[3] = {0, 0, 0}, work = 0;
  for (std::size_t row = 1; row < h.rows(); ++row) {
    const double dt = h["time"][row] - h["time"][row - 1];
    for (int k = 0; k < 3; ++k) impulse[k] += dt * h[fmt::format("f{}:push", "xyz"[k])][row];
    work += dt * 1.5 * (0.6 * h["fx:push"][row] + 0.8 * h["fz:push"][row]);
  }
  for (int k = 0; k < 3; ++k) {
    const std::string name = fmt::format("momentum_{}", "xyz"[k]);
    EXPECT_NEAR(h.last(name) - h[name][0], impulse[k], 1e-9 * cube_mass) << k;
    EXPECT_NE(impulse[k], 0);
  }
  EXPECT_NEAR(h.last("external"), work, 1e-9 * cube_mass);
  EXPECT_LT(h.last("friction"), 0);
  EXPECT_LT(std::abs(run.summary.energy.error), 5e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
}

// A cylinder that is drawn along its axis takes a body along by friction: v = mu N t / m, until both are as fast.
TEST(RoundWall, TakesABodyAlongByFriction) {
  const double speed = 0.05, friction = 0.3;
  const Outcome run = run_deck(write_cube(0, 0, 0.5,
                                          fmt::format(R"yaml(
time: {{end: 0.03}}
loads: {{gravity: [0, 0, {}]}}
walls: [{{cylinder: {{axis: y, radius: 0.5}}, friction: {}, direction: y, speed: {}}}]
output: {{history: {{every: 1e-3}}}}
)yaml",
                                                      -pull, friction, speed)));
  const HistoryTable& h = run.history;
  EXPECT_NEAR(h.at(0.008, "momentum_y") / cube_mass, friction * pull * 0.008, 0.03 * speed);
  EXPECT_NEAR(h.last("momentum_y") / cube_mass, speed, 0.02 * speed);
  EXPECT_NEAR(h.last("momentum_x") / cube_mass, 0, 1e-9);
}

TEST(RoundWall, EndsWithItsLength) {
  const auto find_height = [](const char* length) {
    Scene scene(write_cube(0, 0.05, 0.0201,
                           fmt::format("time: {{end: 1, max_step: 2e-5}}\n"
                                       "walls: [{{cylinder: {{axis: y, radius: 0.02{}}}}}]\n"
                                       "initial: [{{velocity: [0, 0, -1]}}]",
                                       length)),
                alone());
    scene.run(1500);
    return scene.state.x(0, 2);
  };
  EXPECT_GT(find_height(""), 0.02);
  EXPECT_GT(find_height(", length: 0.06"), 0.02);
  EXPECT_LT(find_height(", length: 0.04"), -5e-3);  // beside it
}

TEST(RoundWall, KeepsShellsAtHalfTheirThickness) {
  const auto find_lowest = [](const char* thickness) {
    const std::string deck = fmt::format(R"yaml(
time: {{end: 1}}
parts: {{plate: {{shell_plate: {{size: [0.04, 0.04], cells: [4, 4]}}, thickness: 0.004, at: [-0.02, -0.02, 0.20205], material: steel}}}}
initial: [{{velocity: [0, 0, -10]}}]
walls: [{{sphere: {{radius: 0.2}}{}}}]
)yaml",
                                         thickness) +
                             steel_text;
    Scene scene(deck, alone());
    scene.run(0);
    double lowest = INFINITY;
    for (int i = 0; i < 40; ++i) {
      scene.stepper.advance(scene.state);
      lowest = std::min(lowest, std::hypot(scene.state.x(12, 0), scene.state.x(12, 1), scene.state.x(12, 2)));
    }
    return lowest;
  };
  EXPECT_NEAR(find_lowest(", thickness: included"), 0.202, 1e-8);
  EXPECT_LT(find_lowest(""), 0.2019);
}

}  // namespace percuss::test::round_wall_test
