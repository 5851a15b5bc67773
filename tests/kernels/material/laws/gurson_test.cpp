// The law of metals with voids against closed forms and, along a path with all of it, its rate equations.

#include "kernels/material/laws/gurson.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::gurson_test {
namespace {

Gurson make_sample() {
  Gurson law{20e9, 0.3, {3, {0, 0.02, 0.06}, {150e6, 220e6, 250e6}}};
  law.void_fraction = 0.01, law.nucleation_fraction = 0.02, law.nucleation_strain = 0.03;
  law.nucleation_deviation = 0.02, law.cowper_symonds_rate = 2, law.cowper_symonds_exponent = 3;
  return law;
}

[[maybe_unused]] const bool has_samples = provide_sample<Gurson>(make_sample());

constexpr double young = 200e9, poisson = 0.3, density = 7850, yield = 300e6;

Gurson make_law(double voids) {
  Gurson law{young, poisson, {1, {0}, {yield}}};
  law.void_fraction = voids;
  return law;
}

double voids_of(const Point<Gurson>& point) { return point.history[2]; }

/// Mean stress of the surface without shear.
double find_limit(const Gurson& law, double g) {
  return 2 * yield / (3 * law.q2) * std::acosh((1 + law.q3 * g * g) / (2 * law.q1 * g));
}

// The voids take all plastic strain, and none of it is sheared.
TEST(Gurson, PulledAlikeInAllDirectionsHasItsClosedForm) {
  const Gurson law = make_law(0.01);
  Point<Gurson> point(law, density);
  const LameConstants c = law.moduli();
  const double bulk = c.lambda + 2.0 / 3.0 * c.mu;
  for (const double sign : {1.0, 1.0, 1.0, -1.0}) {
    point.follow({{sign, sign, sign, 0, 0, 0}, 0.01, 20000});
    const double strain = point.log_volume - point.stress.xx / bulk;
    EXPECT_NEAR(voids_of(point), 1 - 0.99 * std::exp(-strain), 2e-5);
    EXPECT_NEAR(std::abs(point.stress.xx), find_limit(law, voids_of(point)), 2e-4 * yield);
    EXPECT_NEAR(von_mises(point.stress), 0, 1);
  }
  EXPECT_GT(voids_of(point), 0.05);
}

// Without mean stress q = Y (1 - q1 f), voids stay, and dp is the share (1 - q1 f) / (1 - f) of the strain.
TEST(Gurson, ShearedHasItsClosedForm) {
  Gurson law = make_law(0.1);
  law.hardening = {2, {0, 0.1}, {yield, 500e6}};
  Point<Gurson> point(law, density);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.04, 7});
  const double p = point.p(), q = std::sqrt(3.0) * point.stress.xy;
  EXPECT_NEAR(voids_of(point), 0.1, 1e-12);
  EXPECT_NEAR(q, (yield + 2e9 * p) * 0.85, 1e-9 * yield);
  const double plastic = 2 * 0.04 / std::sqrt(3.0) - q / (3 * law.moduli().mu);
  EXPECT_NEAR(p, plastic * 0.85 / 0.9, 1e-10);
}

TEST(Gurson, WithoutVoidsIsPlasticityByTheTable) {
  Gurson law = make_law(0);
  law.hardening = {3, {0, 0.02, 0.06}, {yield, 400e6, 450e6}};
  law.cowper_symonds_rate = 100, law.cowper_symonds_exponent = 3;
  TabulatedPlasticity solid{young, poisson, law.hardening, 100, 3};
  Point<Gurson> point(law, density);
  Point<TabulatedPlasticity> table(solid, density);
  for (const Leg& leg : {Leg{{1, -0.2, 0.3, 0.3, 0, 0}, 0.02, 10}, Leg{{-1, 0.2, 0.1, 0, 0.7, 0}, 0.03, 7}}) {
    point.follow(leg);
    table.follow(leg);
    EXPECT_LT(largest_difference(point.stress, table.stress), 1e-8 * yield);
    EXPECT_NEAR(point.p(), table.p(), 1e-11);
    EXPECT_NEAR(point.plastic.share, table.plastic.share, 1e-9);
  }
}

TEST(Gurson, NucleatesTheNormalDistribution) {
  Gurson law = make_law(0);
  law.nucleation_fraction = 0.04, law.nucleation_strain = 0.05, law.nucleation_deviation = 0.02;
  Point<Gurson> point(law, density);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.06, 4000});
  const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  const double right = 0.04 * (below((point.p() - 0.05) / 0.02) - below(-0.05 / 0.02));
  EXPECT_GT(right, 0.02);
  EXPECT_NEAR(voids_of(point), right, 1e-6);
}

// Above the critical fraction g goes straight to 1 / q1 at that of failure, where nothing is left.
TEST(Gurson, CoalescesAndFails) {
  Gurson law = make_law(0.02);
  law.critical_void_fraction = 0.05, law.failure_void_fraction = 0.1;
  Point<Gurson> point(law, density);
  bool has_seen = false;
  while (point.history[3] > 0 && point.log_volume < 1) {
    point.follow({{1, 1, 1, 0, 0, 0}, 1e-4, 20});
    const double f = voids_of(point);
    if (f < 0.06 || f > 0.09) continue;
    has_seen = true;
    EXPECT_NEAR(point.stress.xx, find_limit(law, 0.05 + (1 / 1.5 - 0.05) * (f - 0.05) / 0.05), 1e-3 * yield);
  }
  EXPECT_TRUE(has_seen);
  EXPECT_EQ(voids_of(point), 0.1);
  EXPECT_EQ(point.history[3], 0);
  EXPECT_LT(point.stress.xx, 0.01 * yield);
}

/// The rate equations in strain, by Euler's method with the consistency of a hardening metal.
struct Reference {
  Gurson law;
  double slope;
  double mean = 0, p = 0, f = 0;
  Symmetric3<double> deviator{};

  void follow(const Leg& leg, int substeps) {
    const LameConstants c = law.moduli();
    const double dt = leg.time / substeps, bulk = c.lambda + 2.0 / 3.0 * c.mu, third = trace(leg.rate) / 3;
    const Symmetric3<double> shape = leg.rate + Symmetric3<double>{-third, -third, -third, 0, 0, 0};
    for (int i = 0; i < substeps; ++i) {
      const double y = yield + slope * p, q = von_mises(deviator), angle = 1.5 * law.q2 * mean / y;
      const double surface = q * q / (y * y) + 2 * law.q1 * f * std::cosh(angle) - 1 - law.q3 * f * f;
      const double by_mean = 3 * law.q1 * law.q2 * f * std::sinh(angle) / y;  // derivatives of the surface
      const Symmetric3<double> by_shape = (3 / (y * y)) * deviator;
      const double loading = 3 * bulk * third * by_mean + 2 * c.mu * contract(by_shape, shape);
      double flow = 0;
      if (surface >= 0 && loading > 0) {
        const double work = (mean * by_mean + contract(by_shape, deviator)) / ((1 - f) * y);  // dp / flow
        const double by_yield = -2 * q * q / (y * y * y) - 2 * law.q1 * f * std::sinh(angle) * angle / y;
        const double by_voids = 2 * law.q1 * std::cosh(angle) - 2 * law.q3 * f;
        flow = loading / (bulk * by_mean * by_mean + 2 * c.mu * contract(by_shape, by_shape) - by_yield * slope * work -
                          by_voids * (1 - f) * by_mean);
        p += flow * work * dt;
        f += (1 - f) * flow * by_mean * dt;
      }
      mean += bulk * (3 * third - flow * by_mean) * dt;
      deviator = deviator + (2 * c.mu * dt) * (shape + (-flow) * by_shape);
    }
  }
};

TEST(Gurson, FollowsItsRateEquations) {
  Gurson law = make_law(0.02);
  law.q1 = 1.4, law.q2 = 0.95, law.q3 = 1.8;
  law.hardening = {2, {0, 1}, {yield, yield + 1.5e9}};
  Point<Gurson> point(law, density);
  Reference reference{law, 1.5e9};
  reference.f = 0.02;
  for (const Leg& leg : {Leg{{1, -0.4, -0.3, 0, 0, 0}, 0.03, 6000}, Leg{{0.4, 0.2, 0, 0.9, 0, 0.3}, 0.02, 4000},
                         Leg{{-1, 0.3, 0.5, -0.5, 0.4, 0}, 0.03, 6000}}) {
    point.follow(leg);
    reference.follow(leg, 600000);
    const double m = trace(point.stress) / 3;
    EXPECT_NEAR(m, reference.mean, 4e-3 * yield);
    EXPECT_LT(largest_difference(point.stress + Symmetric3<double>{-m, -m, -m, 0, 0, 0}, reference.deviator),
              4e-3 * yield);
    EXPECT_NEAR(point.p(), reference.p, 2e-5);
    EXPECT_NEAR(voids_of(point), reference.f, 2e-5);
  }
}

TEST(Gurson, StaysFiniteUnderAShock) {
  Point<Gurson> point(make_law(0.05), density);
  point.advance({-0.2, -0.2, -0.2, 0.01, 0, 0}, 1e-7);
  EXPECT_TRUE(std::isfinite(point.stress.xx) && std::isfinite(point.stress.xy));
  EXPECT_GE(voids_of(point), 0);
  EXPECT_LT(voids_of(point), 0.05);
}

TEST(Gurson, NamesConstantsThatContradictEachOther) {
  EXPECT_STREQ(make_law(0.1).find_fault(), "");
  Gurson law = make_law(0.1);
  law.critical_void_fraction = 0.1;
  EXPECT_STRNE(law.find_fault(), "");
  law.critical_void_fraction = 0.2, law.failure_void_fraction = 0.2;
  EXPECT_STRNE(law.find_fault(), "");
  EXPECT_STRNE(make_law(0.7).find_fault(), "");
}

}  // namespace
}  // namespace percuss::test::gurson_test
