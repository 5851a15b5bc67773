#include "kernels/contact/geometry/swept_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace percuss::test::swept_root_test {
namespace {

// Bisection ends at neighbouring doubles; the cubic itself is exact to a few units of round-off.
constexpr double root_tolerance = 1e-14;

FacePoints make_square(double z) { return {{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}}; }
FacePoints translate(const Point3& d) { return {{d, d, d, d}}; }

TEST(SweptRoot, FallingRootsOfAProductOfLinearFactorsAreItsFallingZeros) {
  // f = -(tau - 1/4)(tau - 1/2)(tau - 3/4): falls at 1/4, rises at 1/2, falls at 3/4.
  const Cubic f{{0.25 * 0.5 * 0.75, -(0.25 * 0.5 + 0.25 * 0.75 + 0.5 * 0.75), 1.5, -1}};
  double root[2] = {0, 0};
  ASSERT_EQ(find_falling_roots(f, root), 2);
  EXPECT_NEAR(root[0], 0.25, root_tolerance);
  EXPECT_NEAR(root[1], 0.75, root_tolerance);
}

TEST(SweptRoot, IsTheFirstNumberBehindTheZeroWhateverTheCubic) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    // From lines to strongly bent; every fourth falls late, next to where it turns, or very fast.
    const double bend = std::pow(10, -8 * (1 + uniform(random)));
    Cubic f{{uniform(random), uniform(random), bend * uniform(random), bend * uniform(random)}};
    if (i % 4 == 1) f = {{1e-3 * uniform(random), 0, -1, uniform(random)}};
    if (i % 4 == 2) f.c[1] *= 1e6;
    double root[2] = {0, 0};
    const int count = find_falling_roots(f, root);
    for (int k = 0; k < count; ++k) {
      EXPECT_GT(root[k], 0);
      EXPECT_LE(root[k], 1);
      EXPECT_LT(evaluate(f, root[k]), 0) << i;
      const double before = std::min(std::nextafter(root[k], 0.0), root[k] - std::ldexp(1, -60));
      EXPECT_GE(evaluate(f, before), 0) << i;
      ++found;
    }
  }
  EXPECT_GT(found, 5000);
}

TEST(SweptRoot, ARisingZeroIsNoHit) {
  double root[2] = {0, 0};
  EXPECT_EQ(find_falling_roots({{-0.5, 1, 0, 0}}, root), 0);
}

TEST(SweptRoot, ATouchingDoubleRootIsNoHit) {
  // (tau - 1/2)^2 stays on its side.
  double root[2] = {0, 0};
  EXPECT_EQ(find_falling_roots({{0.25, -1, 1, 0}}, root), 0);
}

TEST(SweptRoot, AStartInThePlaneCountsAsAHitAtTheStart) {
  double root[2] = {0, 0};
  ASSERT_EQ(find_falling_roots({{0, -1, 0, 0}}, root), 1);
  EXPECT_NEAR(root[0], 0, root_tolerance);
}

TEST(SweptRoot, AFaceThatComesUpIsHitWhenItArrives) {
  // The node is the origin, the face rises from -3 to 5: it arrives at 3/8.
  const SweptHit hit = sweep_face(make_square(-3), translate({0, 0, 8}), 1e-3);
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.tau, 0.375, root_tolerance);
  for (const double w : hit.weight) EXPECT_NEAR(w, 0.25, root_tolerance);
}

TEST(SweptRoot, NoSpeedIsTooHighForAThinFace) {
  for (const double speed : {1e1, 1e4, 1e8}) {
    const SweptHit hit = sweep_face(make_square(-1), translate({0, 0, speed}), 1e-3);
    ASSERT_TRUE(hit.hit) << speed;
    EXPECT_NEAR(hit.tau * speed, 1, 1e-7) << speed;  // round-off of the position, speed times 1e-16
  }
}

TEST(SweptRoot, AFaceThatPassesBesideTheNodeIsMissed) {
  EXPECT_FALSE(sweep_face(make_square(-1), translate({0, 2.5, 2}), 1e-3).hit);  // 0.25 beside the edge at z = 0
  EXPECT_TRUE(sweep_face(make_square(-1), translate({0, 2.0, 2}), 1e-3).hit);   // on the edge
}

TEST(SweptRoot, GoingThroughFromBehindIsNoHit) {
  EXPECT_FALSE(sweep_face(make_square(1), translate({0, 0, -2}), 1e-3).hit);
}

TEST(SweptRoot, AFaceThatTurnsIsHitAtTheRootOfItsQuadratic) {
  // The two sides y = -1 and y = 1 start at z = -2 and z = 0 and end at 6 and -2: the plane at y = 0 is at
  // z = -1 + 3 tau, so the node at the origin is passed at 1/3.
  const FacePoints start{{{-1, -1, -2}, {1, -1, -2}, {1, 1, 0}, {-1, 1, 0}}};
  const FacePoints moves{{{0, 0, 8}, {0, 0, 8}, {0, 0, -2}, {0, 0, -2}}};
  const SweptHit hit = sweep_face(start, moves, 1e-3);
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.tau, 1.0 / 3, 1e-14);
}

TEST(SweptRoot, OfAllTrianglesOfAWarpedFaceTheFirstToArriveIsHit) {
  // Corners 0 and 2 high, 1 and 3 low: the triangle of corners 1, 2 and the middle is the plane z = height y.
  const double height = 0.1;
  FacePoints start{{{-1, -1, height}, {1, -1, -height}, {1, 1, height}, {-1, 1, -height}}};
  for (Point3& corner : start.corner) corner = corner - Point3{0.8, 0.2, 1};
  const SweptHit hit = sweep_face(start, translate({0, 0, 2}), 1e-3);
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.tau, (1 - height * 0.2) / 2, 1e-14);
}

TEST(SweptRoot, TwoFacesWithACommonEdgeLeaveNoCrack) {
  // Nodes on the common edge x = 0, at places that are no round numbers: each is caught by at least one face.
  for (int i = 0; i < 1000; ++i) {
    const double y = -1 + 2 * (i + 0.5) / 1000, z = -1 - 0.3 * std::sin(7.0 * i);
    const FacePoints left{{{-1, -1 - y, z}, {0, -1 - y, z}, {0, 1 - y, z}, {-1, 1 - y, z}}};
    const FacePoints right{{{0, -1 - y, z}, {1, -1 - y, z}, {1, 1 - y, z}, {0, 1 - y, z}}};
    EXPECT_TRUE(sweep_face(left, translate({0, 0, 3}), 1e-12).hit ||
                sweep_face(right, translate({0, 0, 3}), 1e-12).hit);
  }
}

}  // namespace
}  // namespace percuss::test::swept_root_test
