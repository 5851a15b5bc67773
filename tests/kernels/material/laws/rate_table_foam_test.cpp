// Foam with curves for several rates, along paths of its principal stretches, against its curves and closed forms.

#include "kernels/material/laws/rate_table_foam.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/kernels/material/samples.hpp"

namespace percuss::test::rate_table_foam_test {
namespace {

RateTableFoam make_sample() {
  using Rows = std::vector<std::array<double, 2>>;
  RateTableFoam law{};
  law.youngs_modulus = 5e6, law.hysteretic_unloading = 0.2, law.unloading_shape = 2;
  law.compression.add_curve(0.1, Rows{{0, 0}, {0.05, 0.2e6}, {0.6, 0.3e6}, {0.8, 2e6}});
  law.compression.add_curve(2, Rows{{0, 0}, {0.05, 0.4e6}, {0.7, 0.8e6}, {0.8, 3e6}});
  return law;
}

[[maybe_unused]] const bool has_samples = provide_sample<RateTableFoam>(make_sample());

using Rows = std::vector<std::array<double, 2>>;

/// Densifies from 0.6 on, three rates; the curves have rows of their own.
RateTableFoam make_foam() {
  RateTableFoam law{};
  law.youngs_modulus = 5e6;
  law.compression.add_curve(0.01, Rows{{0, 0}, {0.05, 0.1e6}, {0.6, 0.2e6}, {0.8, 1e6}, {0.9, 4e6}});
  law.compression.add_curve(1, Rows{{0, 0}, {0.04, 0.14e6}, {0.6, 0.3e6}, {0.8, 1.5e6}, {0.9, 6e6}});
  law.compression.add_curve(100, Rows{{0, 0}, {0.05, 0.25e6}, {0.55, 0.5e6}, {0.8, 2.5e6}, {0.9, 9e6}});
  law.engineering = true;
  return law;
}

double find_on_rows(const RateTableFoam& law, int k, double strain) { return law.find_line(k, strain).value; }

/// A point of unit volume that is led by the logarithms of its stretches along fixed axes.
class FoamPoint {
 public:
  explicit FoamPoint(const RateTableFoam& of) : law(of) { RateTableFoam::start(history); }

  void advance(const Symmetric3<double>& de, double dt) {
    const double j = std::exp(log_volume += trace(de));
    PointStep<double> step{{de, dt, j, 1, 0, 0}, stress, history};
    const Symmetric3<double> before = stress;
    const double volume = std::exp(log_volume - 0.5 * trace(de));
    law.update(step);
    stress = step.stress;
    modulus = step.lambda + 2 * step.mu;
    work += volume * contract(0.5 * (before + stress), de);
  }

  /// Crushes or stretches along x at a constant rate of the nominal strain.
  void lead(double to_strain, double rate, int steps) {
    const double from = strain();
    for (int i = 1; i <= steps; ++i) {
      const double next = std::log(1 - (from + (to_strain - from) * i / steps));
      advance({next - log_volume, 0, 0, 0, 0, 0}, std::abs(to_strain - from) / (rate * steps));
    }
  }
  void hold(double time, int steps) {
    for (int i = 0; i < steps; ++i) advance({0, 0, 0, 0, 0, 0}, time / steps);
  }
  double strain() const { return 1 - std::exp(log_volume); }

  RateTableFoam law;
  Symmetric3<double> stress{};
  double history[RateTableFoam::history_count] = {};
  double log_volume = 0, modulus = 0, work = 0;
};

}  // namespace

TEST(RateTableFoam, CompressionAtAConstantRateIsItsCurve) {
  const RateTableFoam law = make_foam();
  for (int k = 0; k < 3; ++k) {
    FoamPoint point(law);
    for (const double strain : {0.02, 0.04, 0.2, 0.5, 0.7, 0.88, 0.95}) {
      point.lead(strain, law.compression.rate[k], 2000);
      const double right = find_on_rows(law, k, strain);
      EXPECT_NEAR(-point.stress.xx, right, 1e-3 * right) << k << " at " << strain;
      EXPECT_NEAR(point.stress.yy, 0, 1e-3 * right);  // the midpoint rule for the stretch, against the modulus
    }
  }
}

TEST(RateTableFoam, BetweenTheRatesTheStressIsStraightOverTheRateOrItsLogarithm) {
  RateTableFoam law = make_foam();
  for (const bool logarithmic : {false, true}) {
    law.logarithmic = logarithmic;
    for (const double rate : {0.001, 0.1, 0.4, 10.0, 60.0, 1000.0}) {
      FoamPoint point(law);
      point.lead(0.45, rate, 4000);
      const double inside = std::min(std::max(rate, 0.01), 100.0);
      const int k = inside < 1 ? 0 : 1;
      const double low = law.compression.rate[k], high = law.compression.rate[k + 1];
      const double share = logarithmic ? std::log(inside / low) / std::log(high / low) : (inside - low) / (high - low);
      const double right = (1 - share) * find_on_rows(law, k, 0.45) + share * find_on_rows(law, k + 1, 0.45);
      EXPECT_NEAR(-point.stress.xx, right, 1e-3 * right) << rate;
    }
  }
}

TEST(RateTableFoam, RateIsThatOfTheLogarithmOrOfTheVolumeWhereAskedFor) {
  RateTableFoam law = make_foam();
  law.engineering = false;
  FoamPoint own(law);
  for (int i = 0; i < 2000; ++i) own.advance({-0.7 / 2000, 0, 0, 0, 0, 0}, 0.7 / 2000);  // 1 / s
  EXPECT_NEAR(-own.stress.xx, find_on_rows(law, 1, own.strain()), 1e-3 * 0.3e6);
  law.of_volume = true;
  FoamPoint volume(law);  // 1 / s of volume, a quarter of it along x
  for (int i = 0; i < 2000; ++i) volume.advance(1e-4 * Symmetric3<double>{-1, -1.5, -1.5, 0, 0, 0}, 4e-4);
  const double x = 1 - std::exp(-0.2), y = std::exp(-0.3);
  EXPECT_NEAR(-volume.stress.xx * y * y, find_on_rows(law, 1, x), 1e-3 * 0.3e6);
}

TEST(RateTableFoam, UnloadsOnTheCurveOfTheLowestRateWithTheWorkBetweenTheCurvesLost) {
  const RateTableFoam law = make_foam();
  FoamPoint point(law);
  point.lead(0.5, 100, 4000);
  const double up = 0.5 * 0.05 * 0.25e6 + 0.45 * 0.5 * (0.25e6 + 0.475e6);
  EXPECT_NEAR(point.work, up, 1e-3 * up);
  const double over = 0.475e6 - find_on_rows(law, 0, 0.5);
  point.lead(0.3, 100, 4000);
  EXPECT_NEAR(-point.stress.xx, find_on_rows(law, 0, 0.3), 1);
  point.lead(0, 100, 4000);
  EXPECT_NEAR(point.stress.xx, 0, 1);
  // q falls along K = 5e6 and the growth of Q there, of 100 / s: 0.5e6 - 0.1e6 / 0.55, while R dt relaxes it
  const double rest = 0.5 * 0.05 * 0.1e6 + 0.45 * 0.5 * (0.1e6 + find_on_rows(law, 0, 0.5));
  const double elastic = over * over / (2 * (5e6 + 0.5e6 - 0.1e6 / 0.55));
  EXPECT_LT(point.work, up - rest);
  EXPECT_GT(point.work, up - rest - elastic);
}

TEST(RateTableFoam, ReleaseLosesTheShareOfItsClosedForm) {
  for (const double shape : {0.5, 1.0, 3.0}) {
    for (const double exponent : {1.0, 2.5}) {
      RateTableFoam law = make_foam();
      law.hysteretic_unloading = 0.2, law.unloading_shape = shape, law.unloading_exponent = exponent;
      FoamPoint point(law);
      point.lead(0.7, 1e-3, 8000);  // below the rates: the lowest curve
      const double stored = 0.5 * 0.05 * 0.1e6 + 0.55 * 0.15e6 + 0.5 * 0.1 * (0.2e6 + 0.6e6);
      EXPECT_NEAR(point.work, stored, 1e-4 * stored);
      point.lead(0, 1e-3, 16000);
      // 0.8 times the integral of (1 - x^s)^n, a beta function
      const double lost = 0.8 * std::beta(1 / shape, exponent + 1) / shape;
      EXPECT_NEAR(point.work, lost * stored, 2e-3 * stored) << shape << " " << exponent;
    }
  }
}

TEST(RateTableFoam, HeldItRelaxesToTheCurveOfTheLowestRate) {
  FoamPoint point(make_foam());
  point.lead(0.4, 50, 4000);
  const double start = point.stress.xx;
  point.hold(1, 4000);
  EXPECT_LT(-point.stress.xx, 0.7 * -start);
  point.hold(50, 4000);
  EXPECT_NEAR(-point.stress.xx, find_on_rows(point.law, 0, 0.4), 1e-6 * 1e6);
}

TEST(RateTableFoam, ClosedPathsGiveNoEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    RateTableFoam law = make_foam();
    law.hysteretic_unloading = trial % 2 == 0 ? 0.1 : 1;
    law.tension_cutoff = trial % 3 == 0 ? 0.2e6 : 0;
    law.logarithmic = trial % 4 < 2, law.of_volume = trial % 5 == 0;
    FoamPoint point(law);
    double sum[3] = {};
    for (int leg = 0; leg < 8; ++leg) {
      const double time = std::pow(10, 2 * uniform(random));
      double to[3];
      for (double& t : to) t = leg == 7 ? 0 : 0.9 * uniform(random) - 0.5;
      for (int i = 0; i < 400; ++i)
        point.advance((1 / 400.0) * Symmetric3<double>{to[0] - sum[0], to[1] - sum[1], to[2] - sum[2], 0, 0, 0},
                      time / 400);
      for (int k = 0; k < 3; ++k) sum[k] = to[k];
    }
    EXPECT_GT(point.work, 0) << trial;
  }
}

TEST(RateTableFoam, TellsTheModulusOfAnyStep) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double largest = 0;
  for (int trial = 0; trial < 100; ++trial) {
    RateTableFoam law = make_foam();
    law.hysteretic_unloading = trial % 2 == 0 ? 0.1 : 1;
    law.unloading_shape = 3, law.unloading_exponent = trial % 4 < 2 ? 1 : 2;
    const bool is_short = trial % 3 == 0;  // nothing relaxes
    FoamPoint point(law);
    for (int i = 0; i < 2000; ++i) {
      const double target = i < 1000 ? 1.2 * (1 + uniform(random)) : 0;  // 0.9 of strain and back, unsteady
      const double de = 1e-3 * (uniform(random) - (point.log_volume > -target ? 0.5 : -0.5));
      const double before = point.stress.xx, modulus = point.modulus;
      point.advance({de, 0, 0, 0, 0, 0}, is_short ? 1e-9 : std::pow(10, -4 + 2 * uniform(random)));
      const bool grows = std::abs(point.stress.xx) > std::abs(before);
      if (i == 0 || !(grows || is_short)) continue;
      const double most = std::max(modulus, point.modulus) * std::abs(de);
      EXPECT_LE(std::abs(point.stress.xx - before), 1.03 * most + 2)
          << trial << " " << i;  // corners, the midpoint rule
      largest = std::max(largest, std::abs(point.stress.xx - before) / most);
    }
  }
  EXPECT_GT(largest, 0.9);
}

TEST(RateTableFoam, TensionIsStraightUpToItsCutoffAndHeldOrLost) {
  RateTableFoam law = make_foam();
  FoamPoint free(law);
  free.lead(-0.1, 10, 400);
  EXPECT_NEAR(free.stress.xx, 0.5e6, 1);
  law.tension_cutoff = 0.2e6;
  FoamPoint held(law);
  held.lead(-0.1, 10, 400);
  EXPECT_NEAR(held.stress.xx, 0.2e6, 1);
  held.lead(-0.02, 10, 400);
  EXPECT_NEAR(held.stress.xx, 0.1e6, 1);
  law.fails = true;
  FoamPoint lost(law);
  lost.lead(-0.03, 10, 400);
  EXPECT_NEAR(lost.stress.xx, 0.15e6, 1);
  lost.lead(-0.1, 10, 400);
  EXPECT_EQ(lost.stress.xx, 0);
  lost.lead(-0.02, 10, 400);
  EXPECT_EQ(lost.stress.xx, 0);
  lost.lead(0.3, 1, 400);
  EXPECT_NEAR(-lost.stress.xx, find_on_rows(law, 1, 0.3), 1e-3 * 0.3e6);
}

TEST(RateTableFoam, TensionFollowsTheCurvesWhereTheyHaveRowsOfIt) {
  RateTableFoam law{};
  law.youngs_modulus = 5e6, law.engineering = true;
  law.compression.add_curve(0, Rows{{-0.5, -0.4e6}, {-0.1, -0.2e6}, {0, 0}, {0.5, 0.5e6}});
  law.compression.add_curve(10, Rows{{-0.4, -0.9e6}, {0, 0}, {0.5, 1e6}});
  FoamPoint slow(law), fast(law), back(law);
  slow.lead(-0.3, 1e-6, 2000);
  EXPECT_NEAR(slow.stress.xx, 0.3e6, 10);
  fast.lead(-0.3, 10, 2000);
  EXPECT_NEAR(fast.stress.xx, 0.675e6, 10);
  law.hysteretic_unloading = 0.5;
  FoamPoint released(law);
  released.lead(-0.3, 1e-6, 4000);
  const double stored = 0.01e6 + 0.2 * 0.25e6;
  EXPECT_NEAR(released.work, stored, 1e-3 * stored);
  released.lead(0, 1e-6, 8000);
  EXPECT_NEAR(released.work, 0.25 * stored, 1e-3 * stored);
}

TEST(RateTableFoam, IsTheSameInTurnedAxes) {
  const RateTableFoam law = make_foam();
  const double c = std::cos(0.5236), s = std::sin(0.5236);
  const Matrix3<double> q{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
  FoamPoint straight(law), turned(law);
  for (int i = 0; i < 200; ++i) {
    const double sign = i < 150 ? 1 : -1;
    const Symmetric3<double> de = sign * 1e-3 * Symmetric3<double>{-3, 1, -1, 0, 0, 0};
    straight.advance(de, 1e-4);
    turned.advance(push_forward(q, de), 1e-4);
  }
  const Symmetric3<double> right = push_forward(q, straight.stress);
  EXPECT_NEAR(turned.stress.xx, right.xx, 1e-3);
  EXPECT_NEAR(turned.stress.yy, right.yy, 1e-3);
  EXPECT_NEAR(turned.stress.xy, right.xy, 1e-3);
  EXPECT_NEAR(turned.work, straight.work, 1e-9 * straight.work);
}

TEST(RateTableFoam, LaneHasTheBitsOfTheScalar) {
  constexpr int width = pack_size<double>, count = RateTableFoam::history_count;
  RateTableFoam law = make_foam();
  law.logarithmic = true, law.hysteretic_unloading = 0.3, law.unloading_exponent = 2, law.tension_cutoff = 0.2e6;
  law.fails = true;
  Pack<double> history[count];
  for (auto& h : history) h = Pack<double>(0.0);
  for (int k = 0; k < 3; ++k) history[k] = Pack<double>(1.0);
  std::vector<FoamPoint> points(width, FoamPoint(law));
  Symmetric3<Pack<double>> stress{};
  for (int i = 0; i < 300; ++i) {
    alignas(64) double x[width], y[width], xy[width], j[width], now[width];
    for (int lane = 0; lane < width; ++lane) {
      const double sign = i < 40 * (lane + 1) ? 1 : -1;
      x[lane] = -4e-3 * sign, y[lane] = 1e-3 * (lane - 3) * sign, xy[lane] = 2e-3 * sign;
      points[static_cast<std::size_t>(lane)].advance({x[lane], y[lane], 0, xy[lane], 0, 0}, 1e-4);
      j[lane] = std::exp(points[static_cast<std::size_t>(lane)].log_volume);
    }
    const Pack<double> none(0.0);
    PointStep<Pack<double>> step{
        {{load_pack(x), load_pack(y), none, load_pack(xy), none, none}, Pack<double>(1e-4), load_pack(j), 1.0, 0.0},
        stress,
        history};
    law.update(step);
    stress = step.stress;
    store_pack(now, stress.xx);
    for (int lane = 0; lane < width; ++lane)
      EXPECT_EQ(now[lane], points[static_cast<std::size_t>(lane)].stress.xx) << i << " " << lane;
  }
}

TEST(RateTableFoam, RefusesCurvesThatAreNoneOfAFoam) {
  const auto find_fault = [](double rate, const Rows& first, const Rows& second) {
    RateTableFoam law{};
    law.youngs_modulus = 1;
    law.compression.add_curve(rate, first);
    law.compression.add_curve(rate + 1, second);
    return std::string(law.find_fault());
  };
  const Rows good{{0, 0}, {0.5, 1}};
  EXPECT_EQ(find_fault(0, good, good), "");
  EXPECT_EQ(find_fault(0, {{0.1, 0.1}, {0.5, 1}}, good), "a curve without the row [0, 0]");
  EXPECT_EQ(find_fault(0, good, {{0, 0}}), "a curve without a row of compression");
  EXPECT_EQ(find_fault(0, good, {{0, 0}, {0.5, -1}}), "a curve whose stress has not the sign of its strain");
  EXPECT_EQ(find_fault(0, {{0, 0}, {0.1, 1}, {0.5, 0.5}}, good), "a curve of the lowest rate whose stress falls");
  EXPECT_EQ(find_fault(0, good, {{-1, -1}, {0, 0}, {0.5, 1}}), "rows of tension in some curves and not in others");
}

}  // namespace percuss::test::rate_table_foam_test
