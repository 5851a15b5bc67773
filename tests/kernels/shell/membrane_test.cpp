// Membranes as pure functions: their rates and transpose, the warp that tension resists, the bound of their step.

#include <gtest/gtest.h>

#include "tests/kernels/shell/exact_step.hpp"

namespace percuss::test::membrane_test {
namespace {

constexpr double young = 3, poisson = 0.25, thickness = 0.02;

TestShell<ElasticLayer> make_membrane(const ShellCorners& x) {
  TestShell<ElasticLayer> shell({find_plane_elasticity(young, poisson)}, 1, x, thickness, 1);
  shell.par.is_membrane = true;
  return shell;
}

/// Mean of Green's strain xx, yy, 2 xy of the bilinear surface against its place at the start, by 4 x 4 Gauss points.
double find_mean_energy(const ShellCorners& start, const ShellCorners& x, double stress) {
  const double place[4] = {-0.861136311594053, -0.339981043584856, 0.339981043584856, 0.861136311594053};
  const double weight[4] = {0.347854845137454, 0.652145154862546, 0.652145154862546, 0.347854845137454};
  const double xi_sign[4] = {-1, 1, 1, -1}, eta_sign[4] = {-1, -1, 1, 1};
  const auto tangents = [&](const ShellCorners& of, double xi, double eta, Vec& a, Vec& b) {
    a = b = Vec{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      a = a + (0.25 * xi_sign[i] * (1 + eta * eta_sign[i])) * of[i];
      b = b + (0.25 * eta_sign[i] * (1 + xi * xi_sign[i])) * of[i];
    }
  };
  double energy = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Vec a0, b0, a, b;
      tangents(start, place[i], place[j], a0, b0);
      tangents(x, place[i], place[j], a, b);
      // A square of the edges 2: the tangents at the start are unit vectors at right angles.
      energy += weight[i] * weight[j] * thickness * stress * 0.5 * (dot(a, a) - dot(a0, a0) + dot(b, b) - dot(b0, b0));
    }
  return energy;
}

}  // namespace

TEST(Membrane, ForcesAreTheTransposeOfRatesAndBalance) {
  Random random(51);
  for (int trial = 0; trial < 200; ++trial) {
    ShellCorners x = make_quad(random, 1.5, 1, 0.2, trial % 2 == 0 ? 0.3 : 0);
    if (trial % 3 == 0) x[3] = x[2];
    ShellCorners v = random_field(random, 1);
    if (trial % 3 == 0) v[3] = v[2];
    const auto shapes = find_shapes(x);
    const auto g = find_shell_geometry(find_differences(x), shapes);
    const auto rate = find_membrane_rates(g, turn(g.frame, find_differences(v)), shapes).shell;
    ShellRates<double> on{};
    for (double& value : on.membrane) value = random();
    if (trial % 3 != 0)
      for (double& value : on.membrane_hourglass) value = random();
    Vec f[4], m[4];
    find_membrane_forces(g, on, CornerLoads<double>{f, m});
    double power = 0, expected = 0;
    Vec sum{0, 0, 0}, moment{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      power += dot(f[i], v[i]);
      sum = sum + f[i];
      moment = moment + cross(x[i], f[i]);
      EXPECT_EQ(norm(m[i]), 0);
    }
    for (int k = 0; k < 3; ++k) expected += on.membrane[k] * rate.membrane[k];
    for (int k = 0; k < 2; ++k) expected += on.membrane_hourglass[k] * rate.membrane_hourglass[k];
    EXPECT_NEAR(power, expected, 1e-12);
    EXPECT_LT(norm(sum), 1e-13);
    EXPECT_LT(norm(moment), 1e-13);
  }
}

TEST(Membrane, RigidMotionHasNoRates) {
  Random random(52);
  for (int trial = 0; trial < 50; ++trial) {
    const ShellCorners x = make_quad(random, 1.5, 1, 0.2, 0.3);
    const Vec spin = random_vector(random, 1), along = random_vector(random, 1);
    ShellCorners v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = along + cross(spin, x[i]);
    const auto g = find_shell_geometry(find_differences(x));
    const auto rate = find_membrane_rates(g, turn(g.frame, find_differences(v)), Quadrilaterals{});
    EXPECT_NEAR(rate.warp, 0, 1e-14);
    for (const double value : rate.shell.membrane) EXPECT_NEAR(value, 0, 1e-14);
    for (const double value : rate.shell.membrane_hourglass) EXPECT_NEAR(value, 0, 1e-14);
  }
}

TEST(Membrane, TensionResistsWarpAsThatOfTheBilinearSurface) {
  // The forces on the corners of a square under equal tension are the derivative of what its tension takes to warp.
  const double stress = 0.1, warp = 0.3, step = 1e-4;
  const ShellCorners flat{Vec{-1, -1, 0}, Vec{1, -1, 0}, Vec{1, 1, 0}, Vec{-1, 1, 0}};
  ShellCorners x = flat;
  for (std::size_t i = 0; i < 4; ++i) x[i].z = warp * (i % 2 == 0 ? 1 : -1);
  TestShell<ElasticLayer> shell = make_membrane(x);
  shell.layers[0] = shell.layers[1] = stress;
  shell.advance(x, {}, {}, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    ShellCorners up = x, down = x;
    up[i].z += step;
    down[i].z -= step;
    const double slope = (find_mean_energy(flat, up, stress) - find_mean_energy(flat, down, stress)) / (2 * step);
    EXPECT_NEAR(shell.force[i].z, slope, 1e-9 * thickness);
  }
}

TEST(Membrane, WarpingStretchesByGreensMeanStrain) {
  // From flat to warped in one step: the midpoint rule integrates z dz exactly.
  const double warp = 1e-3;
  const ShellCorners flat{Vec{-1, -1, 0}, Vec{1, -1, 0}, Vec{1, 1, 0}, Vec{-1, 1, 0}};
  ShellCorners v{};
  for (std::size_t i = 0; i < 4; ++i) v[i].z = warp * (i % 2 == 0 ? 1 : -1);
  TestShell<ElasticLayer> shell = make_membrane(flat);
  shell.advance(test::move(flat, v, 1), v, {}, 1);
  const double strain = warp * warp / 6, stress = young / (1 - poisson) * strain;
  EXPECT_NEAR(shell.layers[0], stress, 1e-9 * stress);
  EXPECT_NEAR(shell.layers[1], stress, 1e-9 * stress);
  EXPECT_NEAR(shell.layers[2], 0, 1e-9 * stress);
}

TEST(Membrane, HasNoStiffnessAgainstBendingAndTurning) {
  Random random(53);
  const ShellCorners x = make_quad(random, 1.5, 1, 0.2, 0);
  TestShell<ElasticLayer> shell = make_membrane(x);
  ShellCorners v{};
  for (Vec& at : v) at.z = random();
  shell.advance(test::move(x, v, 1e-6), v, random_field(random, 1), 1e-6);
  EXPECT_LT(largest_norm(shell.force), 1e-11);
  EXPECT_EQ(largest_norm(shell.moment), 0);
}

TEST(Membrane, BoundIsBelowTheExactStepOfRandomElements) {
  Random random(54);
  for (const double stretch : {0.5, 1.0, 2.0}) {
    for (const double warp : {0.0, 0.2, 0.5}) {
      const StepShare share = compare_steps(random, 500, stretch, 0, {0.2, warp, 5, 1e-4, 0.3, true});
      EXPECT_LE(share.largest, 1 + 1e-6) << stretch << " " << warp;
      EXPECT_GT(share.least, 0.7) << stretch << " " << warp;
    }
  }
}

TEST(Membrane, BoundHoldsForConcaveAndCrossedElements) {
  Random random(55);
  for (RandomShapes shapes : {RandomShapes{0.8, 0.8, 1.01}, RandomShapes{1.3, 0.3, 3}}) {
    shapes.are_membranes = true;
    EXPECT_LE(compare_steps(random, 1000, 1, 0, shapes).largest, 1 + 1e-6);
  }
}

TEST(Membrane, BoundIsExactForTriangles) {
  Random random(56);
  for (const double stretch : {0.5, 1.0, 2.0}) {
    const StepShare share = compare_triangle_steps(random, 1000, stretch, 0, true);
    EXPECT_LE(share.largest, 1 + 1e-6) << stretch;
    EXPECT_GT(share.least, 1 - 1e-3) << stretch;  // of the power method
  }
}

}  // namespace percuss::test::membrane_test
