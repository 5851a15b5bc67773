#include "kernels/element/hex8/modes.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::modes_test {

namespace {

/// Volume of the trilinear hexahedron by 2x2x2 Gauss points, which is exact for it: independent of the modal form.
double integrate_volume(const Corners& c) {
  const double g = 1 / std::sqrt(3.0);
  double volume = 0;
  for (int p = 0; p < 8; ++p) {
    const double xi = g * corner_xi[p], eta = g * corner_eta[p], zeta = g * corner_zeta[p];
    Matrix3<double> j{};
    for (int i = 0; i < 8; ++i) {
      const double sx = 1 + corner_xi[i] * xi, sy = 1 + corner_eta[i] * eta, sz = 1 + corner_zeta[i] * zeta;
      const Vector3<double> dn{corner_xi[i] * sy * sz / 8, corner_eta[i] * sx * sz / 8, corner_zeta[i] * sx * sy / 8};
      j.row[0] = j.row[0] + c.x[i] * dn;
      j.row[1] = j.row[1] + c.y[i] * dn;
      j.row[2] = j.row[2] + c.z[i] * dn;
    }
    volume += determinant(j);
  }
  return volume;
}

}  // namespace

TEST(Modes, TransformAndItsTransposeGiveEightTimesTheIdentity) {
  Random random(1);
  double u[8], original[8];
  for (int i = 0; i < 8; ++i) original[i] = u[i] = random();
  to_modes(u);
  to_corners(u);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(u[i], 8 * original[i], 1e-14);
}

TEST(Modes, EachModeIsItsSumOverTheCorners) {
  for (int corner = 0; corner < 8; ++corner) {
    double u[8] = {};
    u[corner] = 1;
    to_modes(u);
    const int x = corner_xi[corner], y = corner_eta[corner], z = corner_zeta[corner];
    const double expected[8] = {1.0, 1.0 * x, 1.0 * y, 1.0 * z, 1.0 * y * z, 1.0 * z * x, 1.0 * x * y, 1.0 * x * y * z};
    for (int m = 0; m < 8; ++m) EXPECT_EQ(u[m], expected[m]) << "corner " << corner << " mode " << m;
  }
}

TEST(Modes, VolumeEqualsTheGaussIntegralOfDistortedElements) {
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Corners c = make_element(random, 1.0, 0.7, 1.9, 0.2);
    EXPECT_NEAR(find_volume_gradient(find_modes(c)).volume, integrate_volume(c), 1e-14);
  }
}

TEST(Modes, VolumeGradientIsTheDerivativeOfTheVolume) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const Corners c = make_element(random, 1.0, 1.3, 0.8, 0.25);
    const VolumeGradient<double> b = find_volume_gradient(find_modes(c));
    double bx[8] = {0, b[1].x, b[2].x, b[3].x, b[4].x, b[5].x, b[6].x, 0};
    to_corners(bx);
    for (int i = 0; i < 8; ++i) {
      // The volume is linear in each coordinate, so a central difference is exact but for round-off.
      Corners up = c, down = c;
      up.x[i] += 0.5;
      down.x[i] -= 0.5;
      EXPECT_NEAR(bx[i] / 64, integrate_volume(up) - integrate_volume(down), 1e-13);
    }
  }
}

TEST(Modes, LinearFieldGivesItsOwnGradientInADistortedElement) {
  Random random(4);
  for (int k = 0; k < 50; ++k) {
    const Corners c = make_element(random, 1.0, 0.5, 2.0, 0.2);
    const Matrix3<double> g = random_matrix(random, 3.0);
    const VolumeGradient<double> b = find_volume_gradient(find_modes(c));
    const Matrix3<double> l = find_velocity_gradient(find_modes(apply(g, c)), b);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(l.row[i].x, g.row[i].x, 1e-13);
      EXPECT_NEAR(l.row[i].y, g.row[i].y, 1e-13);
      EXPECT_NEAR(l.row[i].z, g.row[i].z, 1e-13);
    }
  }
}

TEST(Modes, UniformVelocityGivesExactlyNoGradient) {
  Random random(5);
  const Corners c = make_element(random, 1.0, 1.0, 1.0, 0.3);
  Corners v{};
  for (int i = 0; i < 8; ++i) v.x[i] = v.y[i] = v.z[i] = 0.1;
  const Matrix3<double> l = find_velocity_gradient(find_modes(v), find_volume_gradient(find_modes(c)));
  for (const auto& row : l.row) {
    EXPECT_EQ(row.x, 0);
    EXPECT_EQ(row.y, 0);
    EXPECT_EQ(row.z, 0);
  }
}

}  // namespace percuss::test::modes_test
