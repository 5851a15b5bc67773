// The step bound against the largest eigenvalue of random elements.

#include "tests/kernels/shell/exact_step.hpp"

#include <gtest/gtest.h>

namespace percuss::test::shell_step_test {

namespace {

/// Stiffness by differences.
constexpr double round_off = 1e-6;

}  // namespace

TEST(ShellStep, BoundIsBelowTheExactStepOfRandomTriangles) {
  Random random(25);
  // A stretched triangle is thinner and pays for rotary inertia that its section no longer has: the bound falls with
  // it.
  const double least[][2] = {{1, 0.6}, {0.5, 0.6}, {2, 0.45}, {4, 0.22}};
  for (const auto& [stretch, enough] : least) {
    const StepShare share = compare_triangle_steps(random, 4000, stretch);
    EXPECT_LE(share.largest, 1 + round_off) << stretch;
    EXPECT_GT(share.least, enough) << stretch;
  }
}

TEST(ShellStep, BoundHoldsForTrianglesWhoseSectionIsOffTheMesh) {
  Random random(26);
  for (const double offset : {1.0, -1.0, 4.0, 30.0}) {
    const StepShare share = compare_triangle_steps(random, 500, 1, offset);
    EXPECT_LE(share.largest, 1 + round_off) << offset;
    EXPECT_GT(share.least, 0.6) << offset;
  }
}

TEST(ShellStep, BoundIsBelowTheExactStepOfRandomElements) {
  Random random(21);
  const StepShare share = compare_steps(random, 3000, 1);
  EXPECT_LE(share.largest, 1 + round_off);
  EXPECT_GT(share.least, 0.75);
}

TEST(ShellStep, BoundHoldsForThickAndForLongElements) {
  Random random(27);
  for (const RandomShapes& shapes : {RandomShapes{0.2, 0.2, 5, 0.1, 2}, RandomShapes{0.2, 0.2, 20, 1e-3, 0.5}}) {
    const StepShare share = compare_steps(random, 1000, 1, 0, shapes);
    EXPECT_LE(share.largest, 1 + round_off) << shapes.longest;
    EXPECT_GT(share.least, 0.65) << shapes.longest;
  }
}

TEST(ShellStep, BoundHoldsForElementsThatWereStretched) {
  Random random(22);
  for (const double stretch : {0.5, 2.0, 4.0}) {
    const StepShare share = compare_steps(random, 500, stretch);
    EXPECT_LE(share.largest, 1 + round_off) << stretch;
    EXPECT_GT(share.least, 0.65) << stretch;
  }
}

TEST(ShellStep, BoundHoldsForStronglyWarpedElements) {
  Random random(24);
  // Corners out of the plane by up to as much as half the shorter edge, which turns their normals by up to 70 degrees.
  const StepShare share = compare_steps(random, 1000, 1, 0, {0.2, 0.5});
  EXPECT_LE(share.largest, 1 + round_off);
  EXPECT_GT(share.least, 0.7);
}

TEST(ShellStep, BoundHoldsForConcaveAndCrossedElements) {
  // Corners of squares moved by up to 0.8 of an edge; of oblongs by 1.3, so that edges cross. Flat ones and warped
  // ones.
  Random random(28);
  for (const RandomShapes& shapes : {RandomShapes{0.8, 0.8, 1.01}, RandomShapes{1.3, 0.3, 3}}) {
    const StepShare share = compare_steps(random, 2000, 1, 0, shapes);
    EXPECT_GT(share.concave, 150) << shapes.distortion;
    EXPECT_LE(share.largest, 1 + round_off) << shapes.distortion;
    EXPECT_GT(share.least, 0.3) << shapes.distortion;
  }
}

TEST(ShellStep, BoundHoldsForSectionsOffTheMesh) {
  Random random(23);
  for (const double offset : {1.0, -1.0, 4.0, 30.0}) {
    const StepShare share = compare_steps(random, 500, 1, offset);
    EXPECT_LE(share.largest, 1 + round_off) << offset;
    EXPECT_GT(share.least, 0.4) << offset;
  }
  EXPECT_LE(compare_steps(random, 300, 2, 1).largest, 1 + round_off);
}

}  // namespace percuss::test::shell_step_test
