// The Taylor bar on the finest mesh that runs in about a minute.

#include <gtest/gtest.h>

#include "tests/verification/taylor_bar.hpp"

namespace percuss::test {

TEST(TaylorBar, OnAFineMeshIsWithinTheSpreadOfGoodCodes) {
  const TaylorShape shape = run_taylor_bar(16, TaylorFoot::held);
  EXPECT_NEAR(shape.length, taylor_length, 0.005 * taylor_length);
  EXPECT_NEAR(shape.foot_on_axes, taylor_radius, 0.015 * taylor_radius);
  EXPECT_NEAR(shape.foot_on_diagonal, taylor_radius, 0.015 * taylor_radius);
}

}  // namespace percuss::test
