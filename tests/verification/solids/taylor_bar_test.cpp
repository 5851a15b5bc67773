// The Taylor bar on coarse meshes: it converges, length and radius from one side.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/verification/support/taylor_bar.hpp"

namespace percuss::test::taylor_bar_test {

TEST(TaylorBar, ConvergesMonotonically) {
  const TaylorShape coarse = run_taylor_bar(2, TaylorFoot::held), fine = run_taylor_bar(3, TaylorFoot::held);
  EXPECT_LT(std::abs(fine.length - taylor_length), std::abs(coarse.length - taylor_length));
  EXPECT_LT(std::abs(fine.mean_foot() - taylor_radius), std::abs(coarse.mean_foot() - taylor_radius));
  EXPECT_LT(fine.largest_foot - fine.smallest_foot, coarse.largest_foot - coarse.smallest_foot);
  // Errors fall with h^1.3: at n = 3 they are about 1.5 times those that n = 4 is held to.
  EXPECT_NEAR(fine.length, taylor_length, 0.0035 * taylor_length);
  EXPECT_NEAR(fine.mean_foot(), taylor_radius, 0.0045 * taylor_radius);
  EXPECT_LT(fine.hourglass, 2e-3);
  EXPECT_LT(fine.energy_error, 1e-4);
}

TEST(TaylorBar, FullIntegrationConvergesToTheSameShape) {
  const TaylorShape shape = run_taylor_bar(2, TaylorFoot::held, "{integration: full}");
  EXPECT_NEAR(shape.length, taylor_length, 0.007 * taylor_length);
  EXPECT_NEAR(shape.mean_foot(), taylor_radius, 0.015 * taylor_radius);
  EXPECT_EQ(shape.hourglass, 0);
}

TEST(TaylorBar, OnAWallThatItMayLeaveHasTheSameLengthAndALiftedRim) {
  const TaylorShape held = run_taylor_bar(2, TaylorFoot::held), free = run_taylor_bar(2, TaylorFoot::on_wall);
  // Only the rim of the foot curls up (0.2 mm) and outwards; the rest cannot tell the two apart until the rebound.
  EXPECT_NEAR(free.length, held.length, 2e-3 * held.length);
  EXPECT_NEAR(free.foot_on_axes, held.foot_on_axes, 0.02 * held.foot_on_axes);
  EXPECT_NEAR(free.foot_on_diagonal, held.foot_on_diagonal, 0.02 * held.foot_on_diagonal);
  EXPECT_GT(free.foot_on_axes, held.foot_on_axes);
}

}  // namespace percuss::test::taylor_bar_test
