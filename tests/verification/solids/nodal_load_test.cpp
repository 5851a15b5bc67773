// Forces and moments on nodes, and driven rotations, against exact answers.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::nodal_load_test {
namespace {

constexpr double young = 1.2e6, thickness = 0.1, length = 10, width = 1;
constexpr double rigidity = young * width * thickness * thickness * thickness / 12;

/// Time in which a load grows, ten periods of the strip, and a curve that grows to `value` in it: so slowly that 2e-4
/// of the static answer is left as a vibration.
constexpr double growth = 0.6;
std::string grow(double value) {
  return fmt::format(R"yaml({{expression: "{0} * (t / {1} - sin(2 * pi * t / {1}) / (2 * pi))"}})yaml", value, growth);
}

/// Displacement of the end of a clamped strip of `cells` shells along x without Poisson's effect, under a load on the
/// two nodes of its end: half of it on each.
Vec3 bend(int cells, const std::string& load, const std::string& more = "") {
  const HistoryTable history = run_deck(fmt::format(R"yaml(
title: cantilever
time: {{end: {}}}
parts: {{strip: {{shell_plate: {{size: [{}, {}], cells: [{}, 1]}}, thickness: {}, material: m{}}}}}
materials: {{m: {{model: elastic, density: 1e-4, youngs_modulus: {}, poissons_ratio: 0}}}}
conditions: [{{nodes: strip/x_min, fixed: [x, y, z, rx, ry, rz]}}]
loads: {{nodal: [{{nodes: strip/x_max, {}}}]}}
output: {{history: {{every: 0.1, nodes: [{{name: end, near: [{}, 0, 0]}}]}}}}
)yaml",
                                                    growth, length, width, cells, thickness, more, young, load, length))
                                   .history;
  return {history.last("end_x") - length, history.last("end_y"), history.last("end_z")};
}

}  // namespace

TEST(NodalLoad, MomentAtTheEndOfACantileverGivesMLOverEI) {
  // So small that the deflection is that of the linear theory, M L^2 / 2 E I.
  const double moment = 1e-3;
  const Vec3 u = bend(10, fmt::format("moment: {{y: {}}}", grow(-0.5 * moment)));
  const double exact = moment * length * length / (2 * rigidity);
  fmt::print("cantilever under a moment: {:.6f} of M L^2 / 2 E I\n", u[2] / exact);
  EXPECT_NEAR(u[2] / exact, 1, 1e-3);
}

TEST(NodalLoad, ALargeMomentBendsACantileverIntoAQuarterOfACircle) {
  constexpr int cells = 20;
  const double angle = 0.5 * std::numbers::pi, moment = rigidity * angle / length, radius = length / angle;
  const Vec3 u = bend(cells, fmt::format("moment: {{y: {}}}", grow(-0.5 * moment)));
  fmt::print("quarter of a circle: {:.5f}, {:.5f} of the exact displacements\n",
             u[0] / (radius * std::sin(angle) - length), u[2] / (radius * (1 - std::cos(angle))));
  // The mesh is a polygon, and the strip is stretched by nothing but bending.
  EXPECT_NEAR(u[0], radius * std::sin(angle) - length, 2e-3 * length);
  EXPECT_NEAR(u[2], radius * (1 - std::cos(angle)), 2e-3 * length);
}

TEST(NodalLoad, ForceAtTheEndOfACantileverGivesPLCubedOver3EI) {
  constexpr int cells = 20;
  const double force = 1e-4;
  const Vec3 u = bend(cells, fmt::format("force: {{z: {}}}", grow(0.5 * force)));
  const double bending = force * length * length * length / (3 * rigidity),
               shear = force * length / (5.0 / 6.0 * 0.5 * young * width * thickness);
  fmt::print("cantilever under a force: {:.5f} of P L^3 / 3 E I and shear\n", u[2] / (bending + shear));
  EXPECT_NEAR(u[2] / (bending + shear), 1,
              2e-3);  // constant curvature in an element: 1 / (4 cells^2) of the deflection
}

TEST(NodalLoad, AFreeBodyGathersTheImpulsesOfItsLoads) {
  // Mass 6, 27 nodes; moments do nothing to solids.
  const Outcome run = run_deck(R"yaml(
time: {end: 2}
parts: {block: {box: {size: [1, 2, 3], cells: [2, 2, 2]}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1e4, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -1], nodal: [{nodes: block, force: {x: {expression: "3 * t"}, z: 0.25}}, {nodes: block/x_min, force: {y: 1}}]}
output: {history: {}}
)yaml");
  const double last = run.history.last("time");
  EXPECT_NEAR(last, 2, 1e-12);
  // Momentum is that of half a step before the end.
  const double half = 0.5 * run.history.last("dt");
  EXPECT_NEAR(run.history.last("momentum_y"), 9 * (last - half), 1e-10);
  EXPECT_NEAR(run.history.last("momentum_z"), (27 * 0.25 - 6) * (last - half), 1e-10);
  EXPECT_NEAR(run.history.last("momentum_x"), 27 * 1.5 * (last - half) * (last - half), 1e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
}

TEST(NodalLoad, MomentsSpinAFreePlateAndTheBooksClose) {
  const Outcome run = run_deck(R"yaml(
time: {end: 0.05}
parts:
  plate: {shell_plate: {size: [1, 1], cells: [4, 4]}, thickness: 0.05, at: [-0.5, -0.5, 0], material: steel}
  block: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [-0.5, -0.5, 5], material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
loads: {nodal: [{nodes: plate, moment: {x: 400, y: {expression: "300 * cos(100 * t)"}}, force: {z: 10}}, {nodes: block, moment: {x: 500}}]}
output: {history: {every: 1e-4}}
)yaml");
  fmt::print("energy {:.1e}, angular momentum {:.1e}\n", run.summary.energy.error, run.summary.momentum.angular_error);
  const double half = 0.5 * run.history.last("dt");
  EXPECT_NEAR(run.history.last("angular_x"), 25 * 400 * (0.05 - half), 1e-9 * 500);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.history.largest("energy_error")), 1e-3);
  EXPECT_LT(std::abs(run.history.smallest("energy_error")), 1e-3);
}

TEST(NodalLoad, ADrivenRotationBendsACantileverByItsAngle) {
  // The end is turned by an angle at a rate that starts and ends at 0, slowly: twenty periods of the strip. Free to
  // move, it bends into an arc of this angle.
  constexpr double angle = 0.1, end = 1.2;
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {0}}}
parts: {{strip: {{shell_plate: {{size: [{1}, 1], cells: [10, 1]}}, thickness: {2}, material: m}}}}
materials: {{m: {{model: elastic, density: 1e-4, youngs_modulus: {3}, poissons_ratio: 0}}}}
conditions:
  - {{nodes: strip/x_min, fixed: [x, y, z, rx, ry, rz]}}
  - {{nodes: strip/x_max, velocity: {{ry: {{expression: "{4} * (1 - cos(2 * pi * t / {0})) / {0}"}}}}}}
output: {{history: {{every: 0.01, nodes: [{{name: end, near: [{1}, 0, 0]}}]}}}}
)yaml",
                                           end, length, thickness, young, -angle));
  const double exact = length * (1 - std::cos(angle)) / angle;
  const double work = 0.5 * rigidity * angle * angle / length;
  fmt::print("turned end: deflection {:.5f}, work {:.5f} of the exact\n", run.history.last("end_z") / exact,
             run.history.last("external") / work);
  EXPECT_NEAR(run.history.last("end_z") / exact, 1, 2e-3);
  EXPECT_NEAR(run.history.last("external") / work, 1, 2e-3);
}

TEST(ShellOffset, AnEccentricPullBendsTheSectionByForceTimesDistance) {
  // The mesh is the bottom: a pull N in it acts t / 2 below the middle, M = N t / 2, and the strip bends by M / E I
  // towards its top's side; the mesh stretches by N / E A + M / E I t / 2 = 4 N / E A.
  constexpr int cells = 10;
  const double pull = 1e-3;  // straightens the strip by 5 N L^2 / 12 E I of its deflection, 4e-4
  for (const auto& [reference, side] : {std::pair{"bottom", 1.0}, std::pair{"top", -1.0}}) {
    const Vec3 u =
        bend(cells, fmt::format("force: {{x: {}}}", grow(0.5 * pull)), fmt::format(", reference: {}", reference));
    const double moment = pull * thickness / 2, deflection = moment * length * length / (2 * rigidity);
    fmt::print("mesh at the {}: deflection {:.6f}, stretch {:.6f} of the exact\n", reference,
               u[2] / (side * deflection), u[0] / (4 * pull * length / (young * width * thickness)));
    EXPECT_NEAR(u[2] / (side * deflection), 1, 2e-3);
    EXPECT_NEAR(u[0] / (4 * pull * length / (young * width * thickness)), 1, 5e-3);
  }
}

}  // namespace percuss::test::nodal_load_test
