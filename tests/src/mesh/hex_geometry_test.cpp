#include "src/mesh/hex_geometry.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/src/mesh/mesh_measures.hpp"

namespace percuss {
namespace {

using testing_mesh::gauss_volume;

ElementCorners make_brick_corners(double a, double b, double c) {
  return {{{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}}};
}

TEST(HexGeometry, VolumeOfABrickIsTheProductOfItsEdges) {
  EXPECT_DOUBLE_EQ(find_solid_volume(hex8_topology, make_brick_corners(2, 3, 5)), 30);
  EXPECT_DOUBLE_EQ(find_solid_volume(hex8_topology, make_brick_corners(-2, 3, 5)), -30);
}

TEST(HexGeometry, VolumeOfWarpedHexahedraIsThatOfGaussQuadrature) {
  std::mt19937 random(7);  // NOLINT: a fixed seed is wanted
  std::uniform_real_distribution<double> shift(-0.4, 0.4);
  for (int i = 0; i < 200; ++i) {
    ElementCorners x = make_brick_corners(1, 2, 1.5);
    for (Vec3& corner : x) {
      for (double& c : corner) c += shift(random);
    }
    // Round-off of two dozen products of numbers near 1.
    EXPECT_NEAR(find_solid_volume(hex8_topology, x), gauss_volume(x), 1e-14);
  }
}

TEST(HexGeometry, VolumeDoesNotDependOnTheDistanceToTheOrigin) {
  ElementCorners x = make_brick_corners(1, 1, 1);
  for (Vec3& corner : x) corner[0] += 1048576;  // 2^20: the shift itself is exact
  EXPECT_EQ(find_solid_volume(hex8_topology, x), 1);
}

TEST(HexGeometry, CornerJacobiansOfABrickAreItsVolume) {
  for (int c = 0; c < 8; ++c) {
    const CornerJacobian jacobian = find_corner_jacobian(hex8_topology, make_brick_corners(2, 3, 5), c);
    EXPECT_DOUBLE_EQ(jacobian.value, 30) << "corner " << c;
    EXPECT_DOUBLE_EQ(jacobian.edge_product, 30) << "corner " << c;
  }
}

TEST(HexGeometry, ACornerPushedThroughItsOppositeTurnsItsJacobianNegative) {
  ElementCorners x = make_brick_corners(1, 1, 1);
  x[6] = {0.2, 0.2, 0.2};
  EXPECT_LT(find_corner_jacobian(hex8_topology, x, 6).value, 0);
  EXPECT_GT(find_corner_jacobian(hex8_topology, x, 0).value, 0);
}

}  // namespace
}  // namespace percuss
