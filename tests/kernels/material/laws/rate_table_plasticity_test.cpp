// Curves for several rates: values on and between them, and the return to them.

#include "kernels/material/laws/rate_table_plasticity.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::rate_table_plasticity_test {
namespace {

RateTablePlasticity make_sample() {
  using Rows = std::vector<std::array<double, 2>>;
  RateTablePlasticity law{20e9, 0.3, {}, true};
  law.hardening.add_curve(0.1, Rows{{0, 150e6}, {0.02, 220e6}, {0.06, 250e6}});
  law.hardening.add_curve(2, Rows{{0, 200e6}, {0.05, 300e6}});
  return law;
}

[[maybe_unused]] const bool has_samples = provide_sample<RateTablePlasticity>(make_sample());

using Rows = std::vector<std::array<double, 2>>;
constexpr double young = 200e9, poisson = 0.3, density = 7850;

/// Three curves whose rows are at other strains.
RateCurves make_curves() {
  RateCurves curves;
  curves.add_curve(0.01, Rows{{0, 300}, {0.1, 400}, {0.3, 440}});
  curves.add_curve(1, Rows{{0, 360}, {0.2, 500}});
  curves.add_curve(100, Rows{{0.05, 600}});
  return curves;
}

TEST(RateCurves, ValuesOnTheCurvesAreTheirRows) {
  const RateCurves curves = make_curves();
  for (const bool logarithmic : {false, true}) {
    EXPECT_EQ(curves.find(0.05, 0.01, logarithmic).y, 350);
    EXPECT_EQ(curves.find(0.2, 0.01, logarithmic).y, 420);
    EXPECT_EQ(curves.find(0.1, 1.0, logarithmic).y, 430);
    EXPECT_EQ(curves.find(0.3, 1.0, logarithmic).y, 500);
    EXPECT_EQ(curves.find(0.0, 100.0, logarithmic).y, 600);
  }
}

TEST(RateCurves, ValuesBetweenTheCurvesAreStraightOverTheRateOrItsLogarithm) {
  const RateCurves curves = make_curves();
  // 0.505 is half way from 0.01 to 1, 0.1 by logarithms: 350 and 395 at p = 0.05
  EXPECT_NEAR(curves.find(0.05, 0.505, false).y, 372.5, 1e-10);
  EXPECT_NEAR(curves.find(0.05, 0.1, true).y, 372.5, 1e-10);
  // of 395 and 600 a quarter
  EXPECT_NEAR(curves.find(0.05, 1 + 99 * 0.25, false).y, 446.25, 1e-10);
  EXPECT_NEAR(curves.find(0.05, std::sqrt(10.0), true).y, 446.25, 1e-10);
  EXPECT_NEAR(curves.find(0.05, 0.505, false).slope, (1000 + 700) / 2.0, 1e-9);
  EXPECT_NEAR(curves.find(0.05, 0.505, false).rate_slope, 45 / 0.99, 1e-10);
  EXPECT_NEAR(curves.find(0.05, 0.1, true).rate_slope, 45 / (std::log(100.0) * 0.1), 1e-10);
}

TEST(RateCurves, ValuesBeyondTheRatesAndRowsAreThoseOfTheEnds) {
  const RateCurves curves = make_curves();
  for (const bool logarithmic : {false, true}) {
    for (const double rate : {0.0, 1e-9, 0.0099}) EXPECT_EQ(curves.find(0.2, rate, logarithmic).y, 420);
    EXPECT_EQ(curves.find(0.2, 1e9, logarithmic).y, 600);
    EXPECT_EQ(curves.find(0.2, 1e9, logarithmic).rate_slope, 0);
    EXPECT_EQ(curves.find(9.0, 0.0, logarithmic).y, 440);
    EXPECT_EQ(curves.find(-1.0, 0.0, logarithmic).y, 300);
  }
  EXPECT_EQ(curves.lowest, 300);
}

TEST(RateCurves, LaneHasTheBitsOfTheScalar) {
  const RateCurves curves = make_curves();
  constexpr int width = pack_size<double>;
  const double all_rates[] = {0, 0.01, 0.02, 0.5, 1, 7, 100, 3e4};
  for (int shift = 0; shift < 8; ++shift) {
    alignas(64) double rates[width], at[width], y[width], slope[width];
    for (int lane = 0; lane < width; ++lane) rates[lane] = all_rates[(lane + shift) % 8], at[lane] = 0.04 * lane;
    const auto found = curves.find(load_pack(at), load_pack(rates), true);
    store_pack(y, found.y);
    store_pack(slope, found.rate_slope);
    for (int lane = 0; lane < width; ++lane) {
      EXPECT_EQ(y[lane], curves.find(at[lane], rates[lane], true).y);
      EXPECT_EQ(slope[lane], curves.find(at[lane], rates[lane], true).rate_slope);
    }
  }
}

/// Flat curves of 300 MPa at 1 / s and 500 MPa at 1000 / s.
RateTablePlasticity make_flat(bool logarithmic) {
  RateTablePlasticity law{young, poisson, {}, logarithmic};
  law.hardening.add_curve(1, Rows{{0, 300e6}});
  law.hardening.add_curve(1000, Rows{{0, 500e6}});
  return law;
}

/// The von Mises stress of pure shear at an equivalent rate, far in the plastic range.
double shear_at(const RateTablePlasticity& law, double rate) {
  Point<RateTablePlasticity> point(law, density);
  point.follow({{0, 0, 0, rate * std::sqrt(3.0) / 2, 0, 0}, 0.05 / rate, 50});
  return von_mises(point.stress);
}

TEST(RateTablePlasticity, SteadyFlowHasTheStressOfItsRate) {
  EXPECT_NEAR(shear_at(make_flat(false), 0.1), 300e6, 1);
  EXPECT_NEAR(shear_at(make_flat(false), 500.5), 400e6, 1);
  EXPECT_NEAR(shear_at(make_flat(false), 10), (300 + 200 * 9.0 / 999) * 1e6, 1);
  EXPECT_NEAR(shear_at(make_flat(true), 10), (300 + 200 / 3.0) * 1e6, 1);
  EXPECT_NEAR(shear_at(make_flat(true), 1e5), 500e6, 1);
}

TEST(RateTablePlasticity, OneCurveIsTabulatedPlasticity) {
  RateTablePlasticity law{young, poisson, {}, false};
  law.hardening.add_curve(3, Rows{{0, 300e6}, {0.02, 400e6}, {0.06, 450e6}});
  const TabulatedPlasticity table{young, poisson, {3, {0, 0.02, 0.06}, {300e6, 400e6, 450e6}}};
  Point<RateTablePlasticity> one(law, density);
  Point<TabulatedPlasticity> other(table, density);
  for (const Leg& leg : {Leg{{1, -0.4, -0.4, 0, 0, 0}, 0.03, 40}, Leg{{0, 0, 0.2, 0.9, 0, 0.3}, 0.03, 40}}) {
    one.follow(leg);
    other.follow(leg);
    EXPECT_LT(largest_difference(one.stress, other.stress), 1e-3);  // the last digits, of 4e8
  }
}

/// Curves as a measurement may give them: they fall, cross and jump.
RateTablePlasticity make_random(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  RateTablePlasticity law{young, poisson, {}, uniform(random) < 0.5};
  const int rates = 1 + static_cast<int>(uniform(random) * RateCurves::most_rates);
  double rate = 1e-4;
  for (int k = 0; k < rates; ++k) {
    Rows rows;
    double p = 0;
    for (int row = 0; row < 1 + static_cast<int>(uniform(random) * 20); ++row) {
      rows.push_back({p, 50e6 * std::pow(20.0, uniform(random))});
      p += 0.2 * std::pow(1e-3, uniform(random));
    }
    law.hardening.add_curve(rate, rows);
    rate *= std::pow(1e3, uniform(random)) + 0.05;
  }
  return law;
}

TEST(RateTablePlasticity, EndsOnTheCurvesWhateverTheyAre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int sample = 0; sample < 2000; ++sample) {
    const RateTablePlasticity law = make_random(random);
    Point<RateTablePlasticity> point(law, density);
    for (int i = 0; i < 20; ++i) {
      const double before = point.p(), dt = std::pow(10.0, -2 - 7 * uniform(random));
      const double size = 0.05 * std::pow(1e-4, uniform(random));
      point.advance({0, 0, 0, size * (uniform(random) < 0.8 ? 1 : -1), 0, 0}, dt);
      const double dp = point.p() - before;
      const auto find_flow = [&](double by) { return law.hardening.find(point.p(), by / dt, law.logarithmic).y; };
      ASSERT_GE(dp, 0);
      if (dp > 0) {
        // p has lost the last digits of dp, on which a steep rate depends.
        const double lost = std::numeric_limits<double>::epsilon() * point.p();
        const double a = find_flow(std::max(dp - lost, 0.0)), b = find_flow(dp + lost);
        ASSERT_GE(von_mises(point.stress), std::min(a, b) * (1 - 1e-4)) << "sample " << sample << ", step " << i;
        ASSERT_LE(von_mises(point.stress), std::max(a, b) * (1 + 1e-4)) << "sample " << sample << ", step " << i;
      } else {
        ASSERT_LE(von_mises(point.stress), find_flow(0) * (1 + 1e-12));
      }
    }
  }
}

}  // namespace
}  // namespace percuss::test::rate_table_plasticity_test
