// Shells in motion: free spin, the lowest frequency of a plate, an elastic strip that is stretched, energy of a plastic
// impact.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/src/step/scene.hpp"
#include "tests/verification/support/mapped_shell.hpp"
#include "tests/verification/support/run_deck.hpp"

namespace percuss::test::shell_motion_test {

TEST(ShellMotion, WarpedPlateInFreeSpinKeepsItsMomentumAndItsEnergyForAHundredTurns) {
  auto mesh = make_mapped_shell({4, 4}, [](double u, double v) {
    return Vec3{u - 0.5, v - 0.5, 0.3 * (u - 0.5) * (v - 0.5) + 0.05 * std::sin(5 * u)};
  });
  const TemporaryFile file(testing_mesh::write_exodus(mesh, "spinning_plate.exo"));
  const double w = 200;
  const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: {}}}
parts: {{plate: {{exodus: {{file: {}}}, thickness: 0.06, material: steel}}}}
materials: {{steel: {{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}}}
initial: [{{part: plate, angular_velocity: [{}, 30, {}]}}]
output: {{history: {{every: 1e-3}}}}
audit: {{max_energy_error: 1e-3, max_momentum_error: 1e-10}}
)yaml",
                                           100 * 2 * std::numbers::pi / w, file.path(), 0.1 * w, w));
  fmt::print("angular momentum {:.1e}, energy {:.1e}\n", run.summary.momentum.angular_error, run.summary.energy.error);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-11);
  // The plate, whose centre lines are not stretched at the start, breathes; that does not grow or fade.
  const double turn = 2 * std::numbers::pi / w;
  const double first = run.history.mean(0, 20 * turn, "kinetic"),
               last = run.history.mean(80 * turn, 100 * turn, "kinetic");
  EXPECT_NEAR(last / first, 1, 1e-3);
  EXPECT_NEAR(run.history.smallest("kinetic") / run.history.largest("kinetic"), 1, 3e-3);
}

TEST(ShellMotion, SimplySupportedPlateSwingsAtTheFrequencyOfKirchhoff) {
  constexpr double edge = 1, thickness = 0.01, young = 200e9, poisson = 0.3, density = 7850;
  const double rigidity = young * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
  const double pi = std::numbers::pi;
  const double exact = 2 * pi * pi / (edge * edge) * std::sqrt(rigidity / (density * thickness));
  Scene scene(std::string(R"yaml(
time: {end: 1}
parts: {plate: {shell_plate: {size: [1, 1], cells: [16, 16]}, thickness: 0.01, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: plate/x_min, fixed: [z, rx]}
  - {nodes: plate/x_max, fixed: [z, rx]}
  - {nodes: plate/y_min, fixed: [z, ry]}
  - {nodes: plate/y_max, fixed: [z, ry]}
)yaml"));
  const auto start = to_host(scene.model.start);
  std::size_t middle = 0;
  for (std::size_t n = 0; n < start.extent(0); ++n) {
    // The first mode, so slow that nothing stretches.
    const double x = pi * start(n, 0) / edge, y = pi * start(n, 1) / edge, speed = 1e-4;
    scene.state.v(n, 2) = speed * std::sin(x) * std::sin(y);
    scene.state.w(n, 0) = speed * pi / edge * std::sin(x) * std::cos(y);
    scene.state.w(n, 1) = -speed * pi / edge * std::cos(x) * std::sin(y);
    if (start(n, 0) == 0.5 && start(n, 1) == 0.5) middle = n;
  }
  scene.stepper.start(scene.state);
  double before = 0, time = 0;
  int halves = 0;
  while (halves < 4) {
    scene.stepper.advance(scene.state);
    const double now = scene.state.x(middle, 2);
    if (before * now < 0) {
      ++halves;
      time = scene.state.time - scene.state.dt * now / (now - before);
    }
    before = now;
  }
  const double share = halves * pi / time / exact;
  fmt::print("lowest frequency of the plate, 16 x 16: {:.4f} of Kirchhoff's\n", share);
  EXPECT_NEAR(share, 1, 0.01);
}

TEST(ShellMotion, PulledStripThinsAndCarriesTheStressOfHooke) {
  // Quasi-static: the end is pulled over fifty traversals of the strip by waves.
  const Outcome run = run_deck(R"yaml(
time: {end: 0.02}
parts: {strip: {shell_plate: {size: [1, 0.2], cells: [20, 4]}, thickness: 0.01, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: strip/x_min, symmetry: x}
  - {nodes: strip/y_min, symmetry: y}
  - {nodes: strip/x_max, displacement: {x: {expression: "1e-3 * (t/0.02 - sin(2*pi*t/0.02)/(2*pi))"}}}
output: {history: {every: 1e-4, elements: [{name: e, near: [0.5, 0.1, 0]}]}}
)yaml");
  EXPECT_NEAR(run.history.last("e_stress_xx") / (200e9 * 1e-3), 1, 5e-3);  // true stress on a strip that waves a little
  EXPECT_LT(std::abs(run.history.last("e_stress_yy")), 5e-3 * 200e6);
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-9);
}

TEST(ShellMotion, BooksCloseWhereAClampedPlateYieldsAndAnEdgeIsTurned) {
  const Outcome run = run_deck(R"yaml(
time: {end: 4.0e-3}
parts: {plate: {shell_plate: {size: [1, 0.6], cells: [16, 10]}, thickness: 0.01, material: alloy}}
materials: {alloy: {model: j2_plasticity, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.33, yield_stress: 100e6, hardening_modulus: 500e6}}
initial: [{nodes: {name: plate, inside: [[0.2, 0.1, -1], [0.8, 0.5, 1]]}, velocity: [0, 0, 60]}]
loads: {gravity: [0, 0, -9.81], pressure: [{faces: plate/bottom, value: {table: [[0, 0], [1e-3, 3e5], [1, 3e5]]}}]}
conditions:
  - {nodes: plate/x_min, fixed: [x, y, z, rx, ry, rz]}
  - {nodes: plate/x_max, fixed: [x, y, z]}
  - {nodes: plate/x_max, velocity: {ry: {expression: "40 * sin(500 * t)"}}}
output: {history: {every: 1e-5}}
)yaml");
  fmt::print("energy {:.1e}, angular momentum {:.1e}, hourglass energy {:.1e} of the internal\n",
             run.summary.energy.error, run.summary.momentum.angular_error,
             run.summary.energy.hourglass() / run.summary.energy.internal());
  EXPECT_LT(run.history.largest("energy_error"), 2e-3);
  EXPECT_GT(run.history.smallest("energy_error"), -2e-3);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-10);
  EXPECT_LT(run.summary.momentum.linear_error, 1e-10);
  EXPECT_GT(run.summary.energy.internal(), 0);
}

TEST(ShellMotion, BallBouncesOffAWallAndTheBooksClose) {
  for (const char* enforcement : {"kinematic", "penalty"}) {
    const Outcome run = run_deck(fmt::format(R"yaml(
time: {{end: 1.5e-3}}
parts: {{ball: {{shell_sphere: {{radius: 0.5, cells: 4}}, thickness: 0.02, at: [0, 0, 0.501], material: alloy}}}}
materials: {{alloy: {{model: elastic, density: 2700, youngs_modulus: 70e9, poissons_ratio: 0.3}}}}
initial: [{{part: ball, velocity: [1, 0, -5]}}]
walls: [{{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.2}}]
contact: {{surfaces: none, enforcement: {}}}
output: {{history: {{every: 1e-5, nodes: [{{name: low, near: [0, 0, 0.001]}}]}}}}
)yaml",
                                             enforcement));
    EXPECT_GT(run.history.last("momentum_z"), run.history["momentum_z"].front());
    EXPECT_GT(run.history.largest("wall_force_z"), 0);
    EXPECT_LT(std::abs(run.summary.energy.error), 1e-3);
    EXPECT_LT(run.summary.momentum.angular_error, 1e-11);
    if (std::string(enforcement) == "kinematic") {
      EXPECT_GT(run.history.smallest("low_z"), -1e-6);
    }
  }
}

}  // namespace percuss::test::shell_motion_test
