#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "kernels/contact/enforcement/row_solution.hpp"

namespace percuss::test::convergence_test {
namespace {

/// Gaps of 1000 rows of which the deepest is 1e-3 deep.
PredictedGaps make_gaps() {
  PredictedGaps gaps;
  gaps.deepest = 1e-3;
  gaps.smallest_size = 0.1;
  gaps.rows = 1000;
  return gaps;
}

TEST(EnergyUnit, SumsDoNotDependOnTheOrderAndLoseLessThanAUnitATerm) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> terms(1000);
  for (double& term : terms) term = uniform(random) * std::pow(10, -3 * (1 + uniform(random)));
  const EnergyUnit unit = EnergyUnit::of_largest(1);
  const auto sum = [&] {
    std::int64_t total = 0;
    for (const double term : terms) total += unit.count(term);
    return total;
  };
  const std::int64_t forwards = sum();
  std::reverse(terms.begin(), terms.end());
  EXPECT_EQ(sum(), forwards);
  double exact = 0;
  for (const double term : terms) exact += term;
  EXPECT_NEAR(static_cast<double>(forwards) / unit.per_unit, exact, 1000 / unit.per_unit);
}

TEST(EnergyUnit, WhatIsTooLargeOrNoNumberCountsAsMostAndNothingCountsWithoutMagnitude) {
  const EnergyUnit unit = EnergyUnit::of_largest(2);
  const auto most = static_cast<std::int64_t>(EnergyUnit::most);
  EXPECT_EQ(unit.count(1e30), most);
  EXPECT_EQ(unit.count(-1e30), -most);
  EXPECT_EQ(unit.count(std::numeric_limits<double>::infinity()), most);
  EXPECT_EQ(unit.count(std::numeric_limits<double>::quiet_NaN()), most);
  for (const double nothing : {0.0, 1e-320}) {
    EXPECT_FALSE(EnergyUnit::of_largest(nothing).is_known());
    EXPECT_EQ(EnergyUnit::of_largest(nothing).count(1.0), 0);
  }
}

TEST(EnergyUnit, OfAPackIsTheSumOfItsLanes) {
  const EnergyUnit unit = EnergyUnit::of_largest(1);
  const double terms[] = {0.3, -1e-7, 1e30, -1e30, std::numeric_limits<double>::quiet_NaN(), -0.0, 1e-300, 7.0 / 9};
  constexpr int lanes = RowPack::lanes;
  for (int shift = 0; shift < 8; ++shift) {
    alignas(64) double values[lanes];
    std::int64_t total = 0;
    for (int lane = 0; lane < lanes; ++lane) {
      values[lane] = terms[(lane + shift) % 8];
      total += unit.count(values[lane]);
    }
    EXPECT_EQ(unit.count(load_pack(values)), total) << shift;
  }
}

TEST(EnergyUnit, OfThePassBeforeSeesTermsOfAnyMagnitudeAndTheirGrowth) {
  for (const double largest : {1e-290, 1e-60, 1e-12, 1.0, 1e40}) {
    const EnergyUnit unit = EnergyUnit::after(largest);
    ASSERT_TRUE(unit.is_known()) << largest;
    EXPECT_GT(unit.count(1e-8 * largest), 0) << largest;
    EXPECT_LT(unit.count(-1e-8 * largest), 0) << largest;
    EXPECT_GT(unit.count(255 * largest), unit.count(254 * largest)) << largest;
  }
  EXPECT_FALSE(EnergyUnit::after(0).is_known());
}

TEST(Convergence, IsReachedWhenNoChangeExceedsTheTolerance) {
  const Convergence convergence(1e-3, make_gaps());
  PassSums sums;
  sums.change = 1e-6;
  EXPECT_TRUE(convergence.is_reached(sums));
  sums.change = 1.001e-6;
  EXPECT_FALSE(convergence.is_reached(sums));
}

TEST(Convergence, OfOneRowMayBeTenTolerancesWhereTheWorkOfAllChangesIsSmall) {
  const Convergence convergence(1e-3, make_gaps());
  PassSums sums;
  sums.change = 1e-5;
  sums.work = 10000000;
  sums.changed_work = 2000;  // 0.2 tolerances
  EXPECT_TRUE(convergence.is_reached(sums));
  sums.changed_work = 2001;
  EXPECT_FALSE(convergence.is_reached(sums));
  sums.changed_work = 2000;
  sums.change = 1.001e-5;
  EXPECT_FALSE(convergence.is_reached(sums));
  sums.change = 2e-6;
  sums.work = sums.changed_work = 0;  // the unit is not known yet
  EXPECT_FALSE(convergence.is_reached(sums));
}

// The largest row and 999 others change by 9 tolerances of their impulses: the changes do 45 times the work that is
// enough. Works must show it, or not be asked.
TEST(Convergence, IsNotReachedByWorkThatRoundingHides) {
  for (const double tolerance : {1e-3, 1e-5, 1e-6, 9e-7, 1e-8, 1e-10, 1e-12}) {
    PassSums sums;
    sums.change = 9 * tolerance * make_gaps().deepest;
    const double largest = 0.37;
    const EnergyUnit unit = EnergyUnit::after(largest);
    for (int row = 0; row < 1000; ++row) {
      const double work = largest / (1 + row % 7);
      sums.work += unit.count(work);
      sums.changed_work += unit.count(9 * tolerance * work);
    }
    EXPECT_FALSE(Convergence(tolerance, make_gaps()).is_reached(sums)) << tolerance;
    sums.change = tolerance * make_gaps().deepest;
    EXPECT_TRUE(Convergence(tolerance, make_gaps()).is_reached(sums)) << tolerance;
  }
}

TEST(Convergence, OfRigidBodiesIsReachedWhenNoChangeExceedsAThousandthOfTheTolerance) {
  PredictedGaps gaps = make_gaps();
  gaps.rigid = 1;
  const Convergence convergence(1e-3, gaps);
  PassSums sums;
  sums.work = 1000000;
  sums.change = 1e-9;
  EXPECT_TRUE(convergence.is_reached(sums));
  sums.change = 1.001e-9;
  EXPECT_FALSE(convergence.is_reached(sums));
}

TEST(Convergence, OfTiesIsReachedByTheirOwnTolerance) {
  PredictedGaps gaps = make_gaps();
  gaps.farthest_tied = 1e-2;
  const Convergence convergence(1e-3, gaps);
  PassSums sums;
  sums.tie_change = 1e-8;
  EXPECT_TRUE(convergence.is_reached(sums));
  sums.tie_change = 1.001e-8;
  EXPECT_FALSE(convergence.is_reached(sums));
}

TEST(Convergence, OfWhatIsMetIsReachedByAShareOfTheSize) {
  PredictedGaps gaps = make_gaps();
  gaps.deepest = 0;
  const Convergence convergence(1e-3, gaps);
  PassSums sums;
  sums.change = 0.99e-15;
  EXPECT_TRUE(convergence.is_reached(sums));
  sums.change = 1.01e-15;
  EXPECT_FALSE(convergence.is_reached(sums));
}

}  // namespace
}  // namespace percuss::test::convergence_test
