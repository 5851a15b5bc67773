// The tridiagonal eigenvalue against its closed form, and the margin against its definition.

#include "src/step/stable_step/lanczos.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace percuss::test {

TEST(Lanczos, LargestEigenvalueOfTheDifferenceMatrixIsExact) {
  // 2 on the diagonal, -1 beside it: 2 - 2 cos(n pi / (n + 1))
  for (const int n : {1, 2, 7, 100}) {
    Tridiagonal matrix{std::vector<double>(static_cast<std::size_t>(n), 2.0),
                       std::vector<double>(static_cast<std::size_t>(n - 1), -1.0)};
    const double exact = 2 - 2 * std::cos(n * std::numbers::pi / (n + 1));
    EXPECT_NEAR(find_largest_eigenvalue(matrix), exact, 1e-14 * exact) << n;
  }
  EXPECT_EQ(find_largest_eigenvalue({}), 0);
}

TEST(Lanczos, LargestEigenvalueOfADiagonalMatrixIsItsLargestEntry) {
  EXPECT_DOUBLE_EQ(find_largest_eigenvalue({{1, 5, 3}, {0, 0}}), 5);
  EXPECT_DOUBLE_EQ(find_largest_eigenvalue({{-3, -2}, {0}}), -2);
}

TEST(Lanczos, AMarginIsThatOfTheTheorem) {
  const std::int64_t n = 30000;
  const int k = 35;
  const double eps = find_lanczos_margin(n, k);
  EXPECT_NEAR(1.648 * std::sqrt(30000.0) * std::exp(-std::sqrt(eps) * (2 * k - 1)) / lanczos_failure_chance, 1, 1e-9);
}

TEST(Lanczos, StepsAreTheLeastThatReachAMargin) {
  for (const std::int64_t n : {24, 3000, 30000000}) {
    const int k = count_lanczos_steps(n, 0.04);
    EXPECT_LE(find_lanczos_margin(n, k), 0.04);
    EXPECT_GT(find_lanczos_margin(n, k - 1), 0.04);
  }
}

}  // namespace percuss::test
