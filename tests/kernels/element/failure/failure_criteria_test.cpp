#include "kernels/element/failure_criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss {
namespace {

using Tensor = Symmetric3<double>;

/// diag(1, 2, 3) times `scale`, its axes turned by the angles about z and then about x.
Tensor turn(const Tensor& diagonal, double about_z, double about_x) {
  const double c = std::cos(about_z), s = std::sin(about_z), d = std::cos(about_x), t = std::sin(about_x);
  const double r[3][3] = {{c, -s, 0}, {d * s, d * c, -t}, {t * s, t * c, d}};
  const double e[3] = {diagonal.xx, diagonal.yy, diagonal.zz};
  const auto entry = [&](int i, int j) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += r[i][k] * e[k] * r[j][k];
    return sum;
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

ElementLoad stretch_to(double plastic_strain, const Tensor& stress) {
  ElementLoad load;
  load.stress = stress;
  load.stretch = {1, 1, 1, 0, 0, 0};
  load.plastic_strain = plastic_strain;
  return load;
}

/// What a load holds of which nothing was read. The compiler refuses the constant if any of it is not set.
constexpr double sum_unread_load() {
  ElementLoad load;
  const auto sum = [](const Tensor& a) { return a.xx + a.yy + a.zz + a.xy + a.yz + a.zx; };
  return sum(load.stress) + sum(load.stretch) + load.plastic_strain + load.homologous;
}

}  // namespace

TEST(ElementLoad, IsZeroWhereNothingIsRead) {
  constexpr double sum = sum_unread_load();
  EXPECT_EQ(sum, 0);
}

TEST(LargestEigenvalue, IsThatOfATurnedDiagonal) {
  for (const Tensor& diagonal : {Tensor{3, -2, 1, 0, 0, 0}, Tensor{-5, -5, 2, 0, 0, 0}, Tensor{4, 4, -1, 0, 0, 0},
                                 Tensor{-7, -8, -9, 0, 0, 0}}) {
    const double largest = std::max({diagonal.xx, diagonal.yy, diagonal.zz});
    for (double angle = 0; angle < 3; angle += 0.37) {
      const Tensor turned = turn(diagonal, angle, 2 * angle);
      EXPECT_NEAR(find_largest_eigenvalue(turned), largest, 1e-7);  // double roots: the square root of round-off
      EXPECT_TRUE(reaches(turned, largest - 1e-6));
      EXPECT_FALSE(reaches(turned, largest + 1e-6));
    }
  }
}

TEST(LargestEigenvalue, OfASphereIsItsMean) { EXPECT_EQ(find_largest_eigenvalue({2, 2, 2, 0, 0, 0}), 2); }

TEST(FailureStrain, IsJohnsonAndCooks) {
  const JohnsonCookDamage d{0.05, 3.44, -2.12, 0.002, 0.61, 1};  // 4340 steel of the paper
  // Uniaxial tension: mean over von Mises is 1/3.
  ElementLoad load = stretch_to(0, {600, 0, 0, 0, 0, 0});
  EXPECT_NEAR(find_failure_strain(d, load, 1), 0.05 + 3.44 * std::exp(-2.12 / 3), 1e-14);
  EXPECT_NEAR(find_failure_strain(d, load, 0.01), 0.05 + 3.44 * std::exp(-2.12 / 3), 1e-14);
  load.homologous = 0.5;
  EXPECT_NEAR(find_failure_strain(d, load, 1000),
              (0.05 + 3.44 * std::exp(-2.12 / 3)) * (1 + 0.002 * std::log(1000)) * (1 + 0.61 * 0.5), 1e-14);
  // Pure shear, and a mean stress far above von Mises'.
  EXPECT_NEAR(find_failure_strain(d, stretch_to(0, {0, 0, 0, 300, 0, 0}), 1), 3.49, 1e-14);
  EXPECT_NEAR(find_failure_strain(d, stretch_to(0, {901, 900, 900, 0, 0, 0}), 1), 0.05 + 3.44 * std::exp(-2.12 * 1.5),
              1e-14);
}

TEST(Failure, ARateThatLeavesNoFailureStrainFailsAtOnce) {
  FailureLimits limits;
  limits.johnson_cook = {0.1, 0, 0, -0.1, 0, 1};  // 1 - 0.1 ln(rate) is 0 at a rate of e^10
  FailureHistory slow, fast;
  EXPECT_FALSE(fails(limits, stretch_to(1e-4, {}), 1e-3, slow));
  EXPECT_TRUE(fails(limits, stretch_to(1e-4, {}), 1e-9, fast));
}

TEST(Failure, DamageAddsUpOverUnlikeSteps) {
  FailureLimits limits;
  limits.johnson_cook = {0.1, 0, 0, 0, 0, 1};
  FailureHistory history;
  EXPECT_FALSE(fails(limits, stretch_to(0.04, {}), 1e-3, history));
  EXPECT_NEAR(history.damage, 0.4, 1e-15);
  EXPECT_FALSE(fails(limits, stretch_to(0.04, {}), 1e-3, history));
  EXPECT_NEAR(history.damage, 0.4, 1e-15);
  EXPECT_FALSE(fails(limits, stretch_to(0.0999, {}), 1e-3, history));
  EXPECT_TRUE(fails(limits, stretch_to(0.1001, {}), 1e-3, history));
}

TEST(Failure, EachLimitIsMetAtItsValue) {
  struct Case {
    double FailureLimits::*limit;
    double value;
    ElementLoad below, above;
    bool reads_stress, reads_stretch;
  };
  ElementLoad long_load = stretch_to(0, {}), longer = long_load;
  long_load.stretch = turn({std::exp(0.2) * 0.999, 1, 1, 0, 0, 0}, 0.3, 0.4);
  longer.stretch = turn({std::exp(0.2) * 1.001, 1, 1, 0, 0, 0}, 0.3, 0.4);
  const Case cases[] = {
      {&FailureLimits::plastic_strain, 0.3, stretch_to(0.2999, {}), stretch_to(0.3, {}), false, false},
      {&FailureLimits::principal_stress, 5, stretch_to(0, {4.99, -9, 1, 0, 0, 0}), stretch_to(0, {0, 0, 0, 5, 0, 0}),
       true, false},
      {&FailureLimits::tension, 2, stretch_to(0, {3, 2.9, 0, 0, 0, 0}), stretch_to(0, {3, 3, 0, 0, 0, 0}), true, false},
      {&FailureLimits::principal_strain, 0.2, long_load, longer, false, true},
  };
  for (const Case& c : cases) {
    FailureLimits limits;
    FailureHistory history;
    EXPECT_FALSE(fails(limits, c.above, 1, history));
    limits.*c.limit = c.value;
    EXPECT_FALSE(fails(limits, c.below, 1, history));
    EXPECT_TRUE(fails(limits, c.above, 1, history));
    EXPECT_EQ(limits.reads_stress(), c.reads_stress);
    EXPECT_EQ(limits.reads_stretch(), c.reads_stretch);
  }
  FailureLimits damaged;
  damaged.johnson_cook.d1 = 0.1;
  EXPECT_TRUE(damaged.reads_stress());
}

TEST(Failure, ThinningIsTheStrainAcrossALayer) {
  constexpr double young = 200e9, poisson = 0.3, compressibility = (1 - 2 * poisson) / young;
  const double sxx = 3e8, syy = -1e8;
  const Symmetric3<double> elastic{(sxx - poisson * syy) / young, (syy - poisson * sxx) / young, 0, 0, 0, 0};
  const double across = -poisson / young * (sxx + syy);  // Hooke's law in plane stress
  EXPECT_NEAR(find_thinning(elastic, sxx + syy, compressibility), -across, 1e-16);
  // plastic flow along x keeps the volume: half of it across
  const Symmetric3<double> flown{elastic.xx + 0.2, elastic.yy - 0.1, 0, 0, 0, 0};
  EXPECT_NEAR(find_thinning(flown, sxx + syy, compressibility), 0.1 - across, 1e-15);
}

TEST(Failure, TimeAtYieldCountsTheStepsThatFlow) {
  FailureLimits limits;
  limits.yield_time = 2.5;
  FailureHistory history;
  EXPECT_FALSE(fails(limits, stretch_to(0.1, {}), 1, history));
  EXPECT_FALSE(fails(limits, stretch_to(0.1, {}), 5, history));
  EXPECT_FALSE(fails(limits, stretch_to(0.2, {}), 1, history));
  EXPECT_TRUE(fails(limits, stretch_to(0.3, {}), 1, history));
}

TEST(LifeShares, FallInEqualParts) {
  EXPECT_EQ(find_life_shares(ElementLives::whole, 4).force, 1);
  EXPECT_EQ(find_life_shares(4, 4).force, 0.75);
  EXPECT_EQ(find_life_shares(4, 4).work, 0.875);
  EXPECT_EQ(find_life_shares(1, 4).now, 0.25);
  EXPECT_EQ(find_life_shares(1, 4).force, 0);
  EXPECT_LT(find_life_shares(0, 4).force, 0);
}

// Damage is a share of the failure strain up to 1, then grows by the strain over what the evolution asks.
TEST(DamageEvolution, BeginsWithinAStepAndEndsAtTwo) {
  FailureLimits limits;
  limits.johnson_cook.d1 = 0.1;
  limits.evolution.by_strain = 5;
  FailureHistory history;
  const Tensor tension{300, 0, 0, 0, 0, 0};
  EXPECT_FALSE(fails(limits, stretch_to(0.08, tension), 1, history));
  EXPECT_DOUBLE_EQ(history.damage, 0.8);
  EXPECT_FALSE(fails(limits, stretch_to(0.16, tension), 1, history));
  EXPECT_DOUBLE_EQ(history.damage, 1 + 5 * 0.06);
  EXPECT_DOUBLE_EQ(find_share_of_damage(history.damage), 0.7);
  EXPECT_FALSE(fails(limits, stretch_to(0.16, tension), 1, history));
  EXPECT_TRUE(fails(limits, stretch_to(0.3, tension), 1, history));
  EXPECT_DOUBLE_EQ(history.damage, 2);
}

// By an energy the rest of the force does twice G over the size, whatever the stress is.
TEST(DamageEvolution, SpendsItsEnergyWhileTheMaterialHardens) {
  FailureLimits limits;
  limits.plastic_strain = 0.02;
  const double size = 2, energy = 15;
  limits.evolution.by_work = 0.5 * size / energy;
  FailureHistory history;
  double spent = 0;
  const int steps = 200000;
  for (int i = 1; i <= steps && history.damage < 2; ++i) {
    const double strain = 0.3 * i / steps, stress = 300 + 500 * strain, before = find_share_of_damage(history.damage);
    fails(limits, stretch_to(strain, {stress, 0, 0, 0, 0, 0}), 1, history);
    if (history.damage >= 1)
      spent += 0.5 * (before + find_share_of_damage(history.damage)) * stress * size * 0.3 / steps;
  }
  EXPECT_GE(history.damage, 2);
  EXPECT_NEAR(spent, energy, 1e-4 * energy);
}

TEST(Triaxiality, IsThatOfTheMeanByVonMisesStress) {
  const MaterialTable table{2, {0, 1.0 / 3}, {0.6, 0.3}};
  FailureLimits limits;
  limits.triaxiality = &table;
  limits.strain_factor = 0.5;
  const auto find = [&](const Tensor& stress) { return find_failure_strain(limits, stretch_to(0.1, stress), 1); };
  EXPECT_NEAR(find({200, 0, 0, 0, 0, 0}), 0.15, 1e-12);
  EXPECT_NEAR(find({0, 0, 0, 50, 0, 0}), 0.3, 1e-12);
  EXPECT_NEAR(find({-100, -100, -100, 0, 0, 0}), 0.3, 1e-12);
  limits.johnson_cook.d1 = 0.12;
  EXPECT_NEAR(find({200, 0, 0, 0, 0, 0}), 0.12, 1e-12);  // the smaller of both
}

}  // namespace percuss
