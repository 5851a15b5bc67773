// The Taylor bar on coarse meshes: it converges, length and both radii from one side.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/verification/taylor_bar.hpp"

namespace percuss::test {

TEST(TaylorBar, ConvergesMonotonically) {
  std::vector<TaylorShape> shapes;
  for (const int across : {6, 8, 12}) shapes.push_back(run_taylor_bar(across, TaylorFoot::held));
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    const TaylorShape &coarse = shapes[i - 1], &fine = shapes[i];
    EXPECT_LT(std::abs(fine.length - taylor_length), std::abs(coarse.length - taylor_length));
    EXPECT_LT(std::abs(fine.foot_on_axes - taylor_radius), std::abs(coarse.foot_on_axes - taylor_radius));
    // the foot grows rounder
    EXPECT_LT(fine.foot_on_diagonal - fine.foot_on_axes, coarse.foot_on_diagonal - coarse.foot_on_axes);
  }
  // Errors fall with h^1.3: at 12 across they are about 1.5 times those that the fine mesh is held to.
  EXPECT_NEAR(shapes.back().length, taylor_length, 0.0075 * taylor_length);
  EXPECT_NEAR(shapes.back().foot_on_axes, taylor_radius, 0.0225 * taylor_radius);
  EXPECT_NEAR(shapes.back().foot_on_diagonal, taylor_radius, 0.015 * taylor_radius);
}

TEST(TaylorBar, OnAWallThatItMayLeaveHasTheSameLengthAndALiftedRim) {
  const TaylorShape held = run_taylor_bar(8, TaylorFoot::held), free = run_taylor_bar(8, TaylorFoot::on_wall);
  // Only the rim of the foot curls up (0.2 mm) and outwards; the rest cannot tell the two apart until the rebound.
  EXPECT_NEAR(free.length, held.length, 2e-3 * held.length);
  EXPECT_NEAR(free.foot_on_axes, held.foot_on_axes, 0.02 * held.foot_on_axes);
  EXPECT_NEAR(free.foot_on_diagonal, held.foot_on_diagonal, 0.02 * held.foot_on_diagonal);
  EXPECT_GT(free.foot_on_axes, held.foot_on_axes);
}

}  // namespace percuss::test
