// Failed layers in the element: what they leave of its forces, its work and its section.

#include "kernels/shell/layer_lives.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::layer_lives_test {

namespace {

constexpr int points = 5;

/// A shell whose layers have the given shares of their stress and of the work of the step.
struct FailingTestShell {
  TestShell<ElasticLayer> shell;
  std::vector<double> rows;

  FailingTestShell(const ShellCorners& x, double thickness, const std::vector<double>& force_share,
                   const std::vector<double>& work_share)
      : shell({find_plane_elasticity(3, 0.3)}, points, x, thickness, 2), rows(LayerLives::count_rows(points)) {
    for (std::size_t p = 0; p < points; ++p) {
      const std::size_t first = LayerLives::layers + p * LayerLives::layer_size;
      rows[first + LayerLives::force_share] = force_share[p];
      rows[first + LayerLives::work_share] = work_share[p];
    }
  }

  ShellResult<double> advance(const ShellCorners& x, const ShellCorners& v, const ShellCorners& w, double dt) {
    Vec f[4], m[4];
    const Vec spins[4] = {w[0], w[1], w[2], w[3]};
    const auto result =
        advance_shell4(shell.par, CornerMotion<double>{find_differences(x), find_differences(v), spins, dt},
                       {shell.state, shell.layers.data()}, {f, m}, FailingLayers<double>{rows.data()});
    for (std::size_t i = 0; i < 4; ++i) {
      shell.force[i] = f[i];
      shell.moment[i] = m[i];
    }
    return result;
  }
};

std::vector<double> all(double share) { return std::vector<double>(points, share); }

}  // namespace

TEST(LayerLives, OfWholeLayersNoBitChanges) {
  Random random(5);
  const ShellCorners x = make_quad(random, 1, 0.7, 0.2, 0.1), v = random_field(random, 1), w = random_field(random, 1);
  TestShell<ElasticLayer> whole({find_plane_elasticity(3, 0.3)}, points, x, 0.1, 2);
  FailingTestShell failing(x, 0.1, all(1), all(1));
  const auto a = whole.advance(move(x, v, 1e-2), v, w, 1e-2), b = failing.advance(move(x, v, 1e-2), v, w, 1e-2);
  EXPECT_EQ(a.work.internal, b.work.internal);
  EXPECT_EQ(a.work.hourglass, b.work.hourglass);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(norm(whole.force[i] - failing.shell.force[i]), 0);
    EXPECT_EQ(norm(whole.moment[i] - failing.shell.moment[i]), 0);
  }
}

TEST(LayerLives, ACommonShareIsThatOfAllForcesAndOfTheWork) {
  Random random(6);
  const ShellCorners x = make_quad(random, 1, 0.7, 0.2, 0.1), v = random_field(random, 1), w = random_field(random, 1);
  TestShell<ElasticLayer> whole({find_plane_elasticity(3, 0.3)}, points, x, 0.1, 2);
  FailingTestShell failing(x, 0.1, all(0.25), all(0.375));
  const auto a = whole.advance(move(x, v, 1e-2), v, w, 1e-2), b = failing.advance(move(x, v, 1e-2), v, w, 1e-2);
  EXPECT_NEAR(b.work.internal, 0.375 * a.work.internal, 1e-14 * std::abs(a.work.internal));
  EXPECT_NEAR(b.work.hourglass, 0.375 * a.work.hourglass, 1e-14 * std::abs(a.work.hourglass));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(norm(0.25 * whole.force[i] - failing.shell.force[i]), 0, 1e-14 * largest_norm(whole.force));
    EXPECT_NEAR(norm(0.25 * whole.moment[i] - failing.shell.moment[i]), 0, 1e-14 * largest_norm(whole.moment));
  }
}

TEST(LayerLives, WithoutItsOuterLayersASectionHasTheMomentOfTheOthers) {
  const ShellCorners x{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}}, still{};
  const ShellCorners w{Vec{0, -1, 0}, Vec{0, 1, 0}, Vec{0, 1, 0}, Vec{0, -1, 0}};  // curvature 2 along x
  constexpr double dt = 1e-3, thickness = 0.1;
  const std::vector<double> left{0, 1, 1, 1, 0};
  FailingTestShell failing(x, thickness, left, left);
  failing.advance(x, still, w, dt);
  const ThicknessPoints rule = find_thickness_points(points);
  double section = 0;  // sum of w z^2
  for (int p = 1; p < 4; ++p) section += rule.weight[p] * rule.place[p] * rule.place[p] * thickness * thickness / 4;
  const double moment = 3 / (1 - 0.09) * thickness * section * 2 * dt;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::abs(failing.shell.moment[i].y), moment / 2, 1e-14 * moment);
    EXPECT_NEAR(norm(failing.shell.force[i]), 0, 1e-16);
  }
}

TEST(LayerLives, StrainsSumUpOfStretchAndCurvature) {
  const ShellCorners x{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}};
  const ShellCorners v{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 0, 0}, Vec{0, 0, 0}};
  const ShellCorners w{Vec{0, -1, 0}, Vec{0, 1, 0}, Vec{0, 1, 0}, Vec{0, -1, 0}};
  FailingTestShell failing(x, 0.1, all(1), all(1));
  failing.advance(move(x, v, 1e-2), v, w, 1e-2);
  EXPECT_NEAR(failing.rows[LayerLives::membrane], 1e-2 / 1.005, 1e-16);  // on the edge of the middle of the step
  EXPECT_NEAR(failing.rows[LayerLives::bending], 1e-2 * 0.05 * 2 / 1.005, 1e-16);
  for (const int k : {LayerLives::membrane + 1, LayerLives::membrane + 2, LayerLives::bending + 1})
    EXPECT_NEAR(failing.rows[static_cast<std::size_t>(k)], 0, 1e-17);
}

}  // namespace percuss::test::layer_lives_test
