// Rigid bodies in contact, with one another, with walls and with bodies that deform, under every enforcement.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::rigid_contact_test {
namespace {

const std::string materials = R"(
materials:
  steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3}
  soft: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}
)";

class RigidContact : public testing::TestWithParam<const char*> {};

/// A cube whose corner goes ahead along x and meets the face of a block at rest, off the centres of both.
std::string describe_corner_impact(const std::string& enforcement) {
  return fmt::format(R"(
time: {{end: 4.0e-4, max_step: 1.0e-6}}
parts:
  cube: {{box: {{size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}}, material: steel, rotate: [{{axis: z, angle: -45}}, {{axis: y, angle: 35.264389682754654}}], at: [-0.1742, 0, 0], rigid: true}}
  block: {{box: {{size: [0.2, 0.3, 0.3], cells: [2, 3, 3]}}, at: [0, -0.12, -0.13], material: steel, rigid: true}}
initial: [{{part: cube, velocity: [10, 0, 0]}}]
contact: {{surfaces: all, enforcement: {}, edges: false}}
output: {{history: {{every: 0}}}}
)",
                     enforcement) +
         materials;
}

}  // namespace

// The impulse at one point between two bodies, P = v / (n . (W_1 + W_2) n), W = 1/M + [r]^T I^-1 [r]: enforcement
// leaves no closing velocity, the springs of penalty give all of it back, and no friction acts. The tip hits the face
// at y = z = 0.
TEST_P(RigidContact, OfACornerWithAFaceGivesTheImpulseOfRigidBodies) {
  const Outcome run = run_deck(describe_corner_impact(GetParam()));
  const double cube = 8000 * 1e-3, block = 8000 * 0.2 * 0.3 * 0.3;
  const double iy = block * (0.04 + 0.09) / 12, iz = iy;
  const double y = -0.03, z = -0.02;  // of the point from the centre of the block (0.1, 0.03, 0.02)
  const double inverse =
      1 / cube + 1 / block + z * z / iy + y * y / iz;  // the tip's line goes through the cube's centre
  const bool springs_back = std::string(GetParam()) == "penalty";
  const double impulse = (springs_back ? 20 : 10) / inverse;
  EXPECT_NEAR(run.history.last("body_vx:block"), impulse / block, 2e-3 * impulse / block) << run.summary.steps;
  EXPECT_NEAR(run.history.last("body_vx:cube"), 10 - impulse / cube, 2e-3 * 10);
  EXPECT_NEAR(run.history.last("body_wz:block"), -y * impulse / iz, 2e-3 * impulse / iz * 0.03);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
}

TEST_P(RigidContact, WithAWallStopsAFallingBlock) {
  const Outcome run = run_deck(fmt::format(R"(
time: {{end: 0.02, max_step: 1.0e-5}}
parts: {{block: {{box: {{size: [0.3, 0.2, 0.1], cells: [3, 2, 2]}}, at: [0, 0, 0.005], material: steel, rigid: true}}}}
initial: [{{part: block, velocity: [0, 0, -1]}}]
loads: {{gravity: [0, 0, -9.81]}}
walls: [{{normal: z}}]
contact: {{surfaces: none, enforcement: {}}}
output: {{history: {{every: 0}}}}
)",
                                           GetParam()) +
                               materials);
  if (std::string(GetParam()) != "penalty") {
    EXPECT_NEAR(run.history.last("body_z:block"), 0.05, 1e-6);
    EXPECT_NEAR(run.history.last("body_vz:block"), 0, 1e-3);
  }
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-9);
}

TEST_P(RigidContact, WithAnElasticBlockClosesTheEnergy) {
  const Outcome run = run_deck(fmt::format(R"(
time: {{end: 1.0e-3}}
parts:
  ball: {{sphere: {{radius: 0.05, cells: 8}}, at: [0.02, 0.01, 0.0502], material: steel, rigid: true}}
  block: {{box: {{size: [0.3, 0.3, 0.1], cells: [12, 12, 4]}}, at: [-0.15, -0.15, -0.1], material: soft}}
initial: [{{part: ball, velocity: [2, 0, -10], angular_velocity: [20, 30, 100]}}]
contact: {{surfaces: all, friction: 0.3, enforcement: {}}}
output: {{history: {{every: 1.0e-5}}}}
)",
                                           GetParam()) +
                               materials);
  EXPECT_GT(run.history.largest("contacts"), 0);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-12);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-12);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);  // as deformable bodies in contact
}

INSTANTIATE_TEST_SUITE_P(Of, RigidContact, testing::Values("kinematic", "lagrange", "penalty"),
                         [](const auto& parameter) { return std::string(parameter.param); });

// A block on a spring slides over a plate, on nine nodes where three would hold it: a swing with dry friction about
// mu m g / k. (Extrapolation along impulses that change no velocity once gave no numbers in step 154.)
TEST(RigidBlockOnAPlate, SwingsOnASpringWithFrictionUnderLagrange) {
  const Outcome run = run_deck(R"(
time: {end: 2, max_step: 5.0e-4, max_steps: 160}
parts:
  block: {box: {size: [0.2, 0.2, 0.1], cells: [2, 2, 1]}, material: soft, rigid: {mass: 1}}
  anchor: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [1, 0.05, 0], material: soft, rigid: true}
  plate: {box: {size: [2, 1, 0.1], cells: [9, 5, 1]}, at: [-1, -0.4, -0.1], material: soft, rigid: true}
springs:
  pull: {between: [{near: [0.2, 0.1, 0], part: block}, {near: [1, 0.1, 0], part: anchor}], stiffness: 100, rest_length: 0.6}
conditions: [{nodes: anchor, fixed: [x, y, z]}, {nodes: plate, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: [[block, plate]], friction: 0.3, enforcement: lagrange}
output: {history: {every: 0}}
)" + materials);
  const double middle = 0.3 * 9.81 / 100, swing = (0.2 - middle) * (1 - std::cos(10 * 0.08));
  EXPECT_NEAR(run.history.last("body_x:block"), 0.1 + swing, 1e-3 * swing);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-7);
}

// A chain of masses and springs with the end mass that a rigid block adds: the bar is one element wide, without lateral
// contraction, so that it is that chain exactly, up to the square of the strain (1e-7).
TEST(RigidEndMass, MovesWithItsBarAsALumpedChain) {
  const Outcome run = run_deck(R"(
time: {end: 1.0e-3, step_scale: 0.1}
parts:
  bar: {box: {size: [1, 0.1, 0.1], cells: [10, 1, 1]}, material: steel}
  mass: {box: {size: [0.2, 0.1, 0.1], cells: [2, 1, 1]}, at: [1, 0, 0], material: steel, rigid: true}
join: true
materials: {steel: {model: elastic, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{part: mass, velocity: [1.0e-3, 0, 0]}]
output: {history: {every: 1.0e-6}}
)");
  constexpr int cells = 10;
  const double area = 0.01, h = 0.1, stiffness = 200e9 * area / h, m = 8000 * area * h;
  double x[cells + 1] = {}, v[cells + 1] = {}, mass[cells + 1];
  for (int i = 0; i <= cells; ++i) mass[i] = i == 0 ? 0.5 * m : (i < cells ? m : 0.5 * m + 8000 * area * 0.2);
  v[cells] = 1e-3;
  const int steps = 100000;
  const double dt = 1e-3 / steps;
  double farthest = 0, largest = 0;
  for (int n = 0; n < steps; ++n) {
    double f[cells + 1] = {};
    for (int i = 0; i < cells; ++i) {
      const double pull = stiffness * (x[i + 1] - x[i]);
      f[i] += pull;
      f[i + 1] -= pull;
    }
    for (int i = 0; i <= cells; ++i) {
      v[i] += (n == 0 ? 0.5 : 1) * dt * f[i] / mass[i];
      x[i] += dt * v[i];
    }
    if ((n + 1) % 1000 != 0) continue;
    const double time = (n + 1) * dt, moved = run.history.at(time, "body_x:mass") - run.history["body_x:mass"].front();
    farthest = std::max(farthest, std::abs(moved - x[cells]));
    largest = std::max(largest, std::abs(x[cells]));
  }
  EXPECT_LT(farthest, 1e-3 * largest);  // the square of the step, at a tenth of the stable one
  EXPECT_LT(run.summary.momentum.linear_error, 1e-13);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-4);  // as of a bar without rigid parts at this step
}

// A press that is driven from rest and lies on the block from the start: its work is that of the block from the first
// step on, whatever it weighs.
TEST(RigidContact, APressThatStartsFlushDoesTheWorkOfWhatItPresses) {
  for (const char* const mass : {"1.0e-3", "1.0e5"}) {
    for (const char* const motion : {"displacement: {z: {expression: -0.1 * t^3}}",
                                     "velocity: {z: {expression: -0.3 * t^2}}", "velocity: {z: -0.01}"}) {
      const Outcome run = run_deck(fmt::format(R"(
time: {{end: 0.1}}
parts:
  block: {{box: {{size: [1, 1, 1], cells: [4, 4, 4]}}, material: soft}}
  press: {{box: {{size: [2, 2, 0.2], cells: [1, 1, 1]}}, at: [-0.5, -0.5, 1], material: soft, rigid: {{mass: {}, fixed: [x, y, rx, ry, rz]}}}}
materials: {{soft: {{model: elastic, density: 1000, youngs_modulus: 1.0e7, poissons_ratio: 0}}}}
conditions: [{{nodes: block/z_min, fixed: [z]}}, {{body: press, {}}}]
contact: {{surfaces: all}}
output: {{history: {{every: 0, forces: [{{name: held, support: block/z_min}}, {{name: press, support: press}}]}}}}
)",
                                               mass, motion));
      double worst = 0;
      for (std::size_t i = 1; i < run.history.rows(); ++i)
        worst = std::max(worst, std::abs(run.history["energy_error"][i]));
      EXPECT_LT(worst, 1e-3) << mass << ", " << motion;
      EXPECT_LT(std::abs(run.summary.energy.contact), 1e-2 * run.summary.energy.external) << mass << ", " << motion;
    }
  }
}

}  // namespace percuss::test::rigid_contact_test
