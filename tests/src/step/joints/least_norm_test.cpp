#include "src/step/joints/least_norm.hpp"

#include <gtest/gtest.h>

namespace percuss {
namespace {

TEST(LeastNorm, SolvesASystemOfFullRank) {
  LeastNormSolver solver;
  solver.factorise({4, 1, 0, 1, 3, 1, 0, 1, 2}, 3);
  EXPECT_EQ(solver.rank(), 3);
  const std::vector<double> x = solver.solve({6, 10, 8});  // of 1, 2, 3
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(x[i], static_cast<double>(i) + 1, 1e-14);
}

// Rows that say the same carry the same: of x + y = 2 the solution of least norm is 1, 1.
TEST(LeastNorm, DividesAmongRowsThatSayTheSame) {
  LeastNormSolver solver;
  solver.factorise({3, 3, 0, 3, 3, 0, 0, 0, 5}, 3);
  EXPECT_EQ(solver.rank(), 2);
  const std::vector<double> x = solver.solve({6, 6, 5});
  for (const double value : x) EXPECT_NEAR(value, 1, 1e-14);
}

// A = G G^T of G = (1 0; 0 1; 1 1): x in the range of A has x3 = x1 + x2 once rows are scaled, 1 / (1, 1, sqrt 2).
TEST(LeastNorm, OfThreeRowsInAPlaneIsInTheRange) {
  LeastNormSolver solver;
  solver.factorise({1, 0, 1, 0, 1, 1, 1, 1, 2}, 3);
  EXPECT_EQ(solver.rank(), 2);
  const std::vector<double> x = solver.solve({1, 2, 3});
  EXPECT_NEAR(x[0] + x[2], 1, 1e-13);  // A x = b
  EXPECT_NEAR(x[1] + x[2], 2, 1e-13);
  // The kernel is (1, 1, -1); the norm is x1^2 + x2^2 + 2 x3^2: its derivative along the kernel is zero.
  EXPECT_NEAR(x[0] + x[1] - 2 * x[2], 0, 1e-13);
}

TEST(LeastNorm, LeavesRowsOfZerosAtRest) {
  LeastNormSolver solver;
  solver.factorise({0, 0, 0, 2}, 2);
  EXPECT_EQ(solver.rank(), 1);
  const std::vector<double> x = solver.solve({0, 4});
  EXPECT_EQ(x[0], 0);
  EXPECT_NEAR(x[1], 2, 1e-15);
}

}  // namespace
}  // namespace percuss
