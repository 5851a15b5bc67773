// A distorted mesh of a fluid falls like a body: forces of weight and inertia at the centroids cancel.

#include <gtest/gtest.h>

#include "tests/verification/fluids/tank.hpp"
#include "tests/verification/support/random_mesh.hpp"

namespace percuss::test::free_fall_test {

TEST(FreeFall, OfADistortedFluidDoesNotDistortIt) {
  const RandomMesh mesh = make_random_mesh(4, 0.2, 3);
  const TemporaryFile file(testing_mesh::write_exodus(mesh.written, "falling_fluid.exo"));
  const Outcome run = run_deck(fmt::format(R"(
title: a block of fluid falls
time: {{end: 1}}
parts: {{w: {{exodus: {{file: {}}}, material: water}}}}
materials: {{water: {{model: fluid, density: 1000, equation_of_state: {{kind: linear, bulk_modulus: 4.0e+6}}}}}}
loads: {{gravity: [0, 0, -9.81]}}
output: {{history: {{every: 0.01, nodes: [{{name: corner, near: [-0.5, -0.5, -0.5]}}, {{name: middle, near: [0, 0, 0]}}, {{name: side, near: [0.5, 0, 0]}}]}}}}
)",
                                           file.path()));
  const double exact = -0.5 * gravity;
  for (const char* const node : {"corner", "middle", "side"}) {
    const auto& z = run.history[fmt::format("{}_z", node)];
    const double fallen = z.back() - z.front();
    fmt::print("{}: {:.3g} m off\n", node, fallen - exact);
    EXPECT_NEAR(fallen, exact, 1e-9);
  }
  EXPECT_LT(std::abs(run.summary.energy.error), 1e-6);
  EXPECT_LT(run.summary.momentum.angular_error, 1e-6);
}

}  // namespace percuss::test::free_fall_test
