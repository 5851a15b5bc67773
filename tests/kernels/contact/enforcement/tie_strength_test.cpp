// How much of the strength of a tie stresses use up.

#include "kernels/contact/enforcement/tie_strength.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::test::tie_strength_test {
namespace {

TEST(TieStrength, AddsTheSharesOfTensionAndShear) {
  const ConnectionStrength strength{4, 8, 2, 3};
  EXPECT_DOUBLE_EQ(find_strength_use(strength, 2, 4), 0.25 + 0.125);
  EXPECT_DOUBLE_EQ(find_strength_use(strength, 4, 0), 1);
  EXPECT_DOUBLE_EQ(find_strength_use(strength, 0, 8), 1);
  EXPECT_DOUBLE_EQ(find_strength_use({4, 8, 1, 1.5}, 3, 2), 0.75 + std::pow(0.25, 1.5));
}

TEST(TieStrength, LeavesOutPressureAndStrengthsThatAreNotGiven) {
  EXPECT_EQ(find_strength_use({4, 8, 2, 2}, -100, 0), 0);
  EXPECT_DOUBLE_EQ(find_strength_use({4, 8, 2, 2}, -100, 4), 0.25);
  EXPECT_EQ(find_strength_use({0, 8, 2, 2}, 100, 0), 0);
  EXPECT_EQ(find_strength_use({4, 0, 2, 2}, 0, 100), 0);
}

TEST(TieStrength, CountsTensionFromTheSideOfTheNode) {
  EXPECT_EQ(find_tension(-3, 1), 3);  // a push towards the face pulls a node that is outside of it back
  EXPECT_EQ(find_tension(3, 1), -3);
  EXPECT_EQ(find_tension(3, -1), 3);
  EXPECT_EQ(find_tension(-3, -1), -3);
  EXPECT_EQ(find_tension(-3, 0), 3);
  EXPECT_EQ(find_tension(3, 0), 3);
}

}  // namespace
}  // namespace percuss::test::tie_strength_test
