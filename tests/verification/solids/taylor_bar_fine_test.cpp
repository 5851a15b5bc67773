// The Taylor bar on finer meshes, with the kinds of elements that are meant for it.

#include <gtest/gtest.h>

#include "tests/verification/support/taylor_bar.hpp"

namespace percuss::test::taylor_bar_fine_test {

TEST(TaylorBarFine, AssumedStrainOn3840Elements) {
  const TaylorShape shape = run_taylor_bar(4, TaylorFoot::held);
  EXPECT_NEAR(shape.length, taylor_length, 0.0022 * taylor_length);
  EXPECT_NEAR(shape.mean_foot(), taylor_radius, 0.003 * taylor_radius);
  EXPECT_NEAR(shape.foot_on_axes, taylor_radius, 0.003 * taylor_radius);
  EXPECT_LT(shape.largest_foot - shape.smallest_foot, 0.0015 * taylor_radius);
  EXPECT_LT(shape.hourglass, 2e-3);
  EXPECT_LT(shape.energy_error, 1e-4);
}

TEST(TaylorBarFine, FullIntegrationOn3840Elements) {
  const TaylorShape shape = run_taylor_bar(4, TaylorFoot::held, "{integration: full}");
  EXPECT_NEAR(shape.length, taylor_length, 0.003 * taylor_length);
  EXPECT_NEAR(shape.mean_foot(), taylor_radius, 0.006 * taylor_radius);
  EXPECT_LT(shape.energy_error, 1e-4);
}

}  // namespace percuss::test::taylor_bar_fine_test
