#include "kernels/element/failure_criteria.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::test::failure_criteria_test {
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
  EXPECT_DOUBLE_EQ(find_share(limits.evolution, history.damage), 0.7);
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
    const double strain = 0.3 * i / steps, stress = 300 + 500 * strain,
                 before = find_share(limits.evolution, history.damage);
    fails(limits, stretch_to(strain, {stress, 0, 0, 0, 0, 0}), 1, history);
    if (history.damage >= 1)
      spent += 0.5 * (before + find_share(limits.evolution, history.damage)) * stress * size * 0.3 / steps;
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

/// A single element under proportional load, in equal steps of plastic strain.
struct Path {
  FailureLimits limits;
  Tensor stress{300, 0, 0, 0, 0, 0};
  FailureHistory history;
  double strain = 0;

  /// Up to a plastic strain, in so many steps; returns whether the element has failed.
  bool go(double to, int steps) {
    const double from = strain;
    bool failed = false;
    for (int i = 1; i <= steps && !failed; ++i) {
      strain = from + (to - from) * i / steps;
      failed = fails(limits, stretch_to(strain, stress), 1, history);
    }
    return failed;
  }
  double left() const { return find_force_share(limits, history); }
  double shown() const { return find_shown_damage(limits, history); }
};

// d = (1 - exp(-a p)) / (1 - exp(-a)), which Abaqus has for exponential softening by a displacement.
TEST(DamageEvolution, FallsExponentially) {
  Path path;
  path.limits.plastic_strain = 0.02;
  path.limits.evolution.by_strain = 10;
  path.limits.evolution.exponent = 3;
  path.go(0.02, 1);
  EXPECT_EQ(path.left(), 1);
  path.go(0.045, 7);
  EXPECT_NEAR(1 - path.left(), (1 - std::exp(-0.75)) / (1 - std::exp(-3)), 1e-14);
  EXPECT_NEAR(path.shown(), 2 - path.left(), 1e-14);
  EXPECT_FALSE(path.go(0.1199, 1));
  EXPECT_TRUE(path.go(0.1201, 1));
  EXPECT_EQ(path.left(), 0);
}

TEST(DamageEvolution, FallsByATable) {
  const MaterialTable lost{3, {0, 0.25, 1}, {0, 0.6, 1}};
  Path path;
  path.limits.plastic_strain = 0.02;
  path.limits.evolution.by_strain = 10;
  path.limits.evolution.lost = &lost;
  path.go(0.02 + 0.0125, 3);
  EXPECT_NEAR(path.left(), 0.7, 1e-14);
  path.go(0.02 + 0.05, 3);
  EXPECT_NEAR(path.left(), 0.8 / 3, 1e-14);
}

// The work of the force that is left is G by area with any shape, if the progress counts the mean share.
TEST(DamageEvolution, SpendsItsEnergyAlongAnExponential) {
  const double size = 2, energy = 15, a = 6;
  Path path;
  path.limits.plastic_strain = 0.02;
  path.limits.evolution.exponent = a;
  path.limits.evolution.by_work = size / energy * (1 / a - 1 / std::expm1(a));
  path.go(0.02, 1);
  double spent = 0;
  const double step = 1e-6;
  while (path.history.damage < 2) {
    const double before = path.left();
    path.go(path.strain + step, 1);
    spent += 0.5 * (before + path.left()) * 300 * size * step;
  }
  EXPECT_NEAR(spent, energy, 1e-4 * energy);
}

// Damage (strain / failure strain)^n under a proportional load, and the share ((D - D0) / (1 - D0))^m of the force
// lost.
TEST(DamageCoupling, TakesForceFromADamageOn) {
  const MaterialTable strain{1, {0}, {0.4}};
  Path path;
  path.limits.triaxiality = &strain;
  path.limits.coupling = {nullptr, 0.16, 2, 1.5};
  path.go(0.16, 5);
  EXPECT_NEAR(path.shown(), 0.16, 1e-14);
  EXPECT_NEAR(path.left(), 1, 1e-14);
  path.go(0.3, 5);
  EXPECT_NEAR(path.shown(), std::pow(0.3 / 0.4, 2), 1e-14);
  EXPECT_NEAR(path.left(), 1 - std::pow((0.5625 - 0.16) / 0.84, 1.5), 1e-14);
  EXPECT_FALSE(path.go(0.3999, 1));
  EXPECT_LT(path.left(), 1e-3);
  EXPECT_TRUE(path.go(0.4001, 1));
}

// Where the sum over the critical strain reaches 1 within a step, the damage there counts, whatever the steps are.
TEST(DamageCoupling, TakesForceFromAPlasticStrainOn) {
  const MaterialTable strain{2, {0, 1.0 / 3}, {0.8, 0.4}}, critical{2, {0, 1.0 / 3}, {0.6, 0.1}};
  for (const int steps : {1, 7, 100}) {
    Path path;
    path.limits.triaxiality = &strain;
    path.limits.coupling = {&critical, -1, 2, 2};
    EXPECT_EQ(path.left(), 1);
    path.go(0.3, steps);
    const double start = std::pow(0.1 / 0.4, 2), damage = std::pow(0.3 / 0.4, 2);
    EXPECT_NEAR(path.left(), 1 - std::pow((damage - start) / (1 - start), 2), 1e-14) << steps;
    EXPECT_NEAR(path.shown(), damage, 1e-14);
  }
}

// Two stress states: half of the critical strain in tension, the rest in shear; damage adds up likewise.
TEST(DamageCoupling, AddsUpOverStressStates) {
  const MaterialTable strain{2, {0, 1.0 / 3}, {0.8, 0.4}}, critical{2, {0, 1.0 / 3}, {0.6, 0.2}};
  Path path;
  path.limits.triaxiality = &strain;
  path.limits.coupling = {&critical, -1, 1, 1};
  path.go(0.1, 10);  // half of 0.2; a quarter of 0.4
  EXPECT_EQ(path.left(), 1);
  path.stress = {0, 0, 0, 150, 0, 0};
  path.go(0.1 + 0.3, 10);  // half of 0.6, then 0.3 / 0.8 of the damage
  EXPECT_NEAR(path.left(), 1, 1e-12);
  path.go(0.5, 10);
  const double start = 0.25 + 0.375;
  EXPECT_NEAR(path.left(), 1 - 0.125 / (1 - start), 1e-12);
}

TEST(ShearDamage, HasTheRatioOfStresses) {
  EXPECT_NEAR(find_shear_ratio({0, 0, 0, 50, 0, 0}, 0.3), std::sqrt(3.0), 1e-7);
  EXPECT_NEAR(find_shear_ratio({300, 0, 0, 0, 0, 0}, 0.3), 2 * (1 - 0.1), 1e-7);
  EXPECT_NEAR(find_shear_ratio({-300, 0, 0, 0, 0, 0}, 0.3), 2 * (1 + 0.1), 1e-7);
}

// Each criterion has a sum of its own: the first that is 1 begins the evolution.
TEST(ShearDamage, AddsUpBesideThatOfTheMeanStress) {
  const MaterialTable by_mean{1, {0}, {0.4}}, by_shear{2, {1.8, 2}, {0.1, 0.2}}, at_rates{2, {0, 2}, {1, 2}};
  Path path;
  path.limits.triaxiality = &by_mean;
  path.limits.shear.strain = &by_shear;
  path.limits.evolution.by_strain = 5;
  path.go(0.1, 4);
  EXPECT_NEAR(path.history.damage, 0.25, 1e-14);
  EXPECT_NEAR(path.shown(), 0.5, 1e-7);
  path.stress = {0, 0, 0, 150, 0, 0};  // a ratio of 1.73
  path.go(0.15 + 0.08, 3);
  EXPECT_NEAR(path.left(), 1 - 5 * 0.08, 1e-7);
  FailureHistory none;
  path.limits.rate_factor = &at_rates;
  path.limits.strain_factor = 0.5;
  fails(path.limits, stretch_to(0.05, path.stress), 0.05, none);  // a rate of 1: 1.5 times as much
  EXPECT_NEAR(none.second, 0.05 / (0.5 * 1.5 * 0.1), 1e-7);
  EXPECT_NEAR(none.damage, 0.05 / (0.5 * 1.5 * 0.4), 1e-14);
}

}  // namespace percuss::test::failure_criteria_test
