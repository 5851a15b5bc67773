// Chaboche's law against its closed forms and, along paths that turn, its rate equations in many small steps.

#include "kernels/material/laws/chaboche.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::chaboche_test {
namespace {

[[maybe_unused]] const bool has_samples =
    provide_sample<Chaboche>({20e9, 0.3, 100e6, {3, {0, 40, 300}, {0.5e9, 3e9, 20e9}}, 60e6, 20, 0.5e9, 2, 3});

constexpr double young = 200e9, poisson = 0.3, density = 7850, yield = 200e6;
constexpr double gamma[2] = {40, 500}, modulus[2] = {4e9, 60e9};

Chaboche make_law(double cyclic = 0, double rate = 0) {
  return {young, poisson, yield, {2, {gamma[0], gamma[1]}, {modulus[0], modulus[1]}}, cyclic, rate};
}

/// Back stress at p of a first loading, as a uniaxial stress.
double find_back(double p) {
  double sum = 0;
  for (int k = 0; k < 2; ++k) sum += modulus[k] / gamma[k] * (1 - std::exp(-gamma[k] * p));
  return sum;
}

/// Half the range of it in a loop that repeats, with p in each half.
double find_stable_back(double p) {
  double sum = 0;
  for (int k = 0; k < 2; ++k) sum += modulus[k] / gamma[k] * std::tanh(0.5 * gamma[k] * p);
  return sum;
}

TEST(Chaboche, FirstLoadingHasItsClosedForm) {
  for (const double cyclic : {0.0, 80e6, -60e6}) {
    Point<Chaboche> point(make_law(cyclic, 25), density);
    for (int i = 0; i < 4; ++i) {
      point.follow({{0, 0, 0, 1, 0, 0}, 0.01, 4000});
      const double p = point.p(), right = yield + cyclic * (1 - std::exp(-25 * p)) + find_back(p);
      EXPECT_NEAR(std::sqrt(3.0) * point.stress.xy, right, 1e-3 * yield);
    }
    EXPECT_GT(point.p(), 0.04);
  }
}

TEST(Chaboche, LoopThatRepeatsHasItsClosedForm) {
  constexpr double cyclic = 80e6;
  Point<Chaboche> point(make_law(cyclic, 25), density);
  double before = 0, peak = 0;
  for (int i = 0; i < 61; ++i) {
    before = point.p();
    peak = point.stress.xy;
    point.follow({{0, 0, 0, i % 2 == 0 ? 1.0 : -1.0, 0, 0}, i == 0 ? 0.01 : 0.02, 4000});
  }
  const double right = yield + cyclic + find_stable_back(point.p() - before);
  EXPECT_NEAR(std::sqrt(3.0) * point.stress.xy, right, 1e-3 * yield);
  EXPECT_NEAR(point.stress.xy, -peak, 1e-6 * yield);
}

/// The rate equations by Euler's method.
struct Reference {
  LameConstants moduli = find_lame_constants(young, poisson);
  Symmetric3<double> deviator{}, back[2]{};
  double p = 0, cyclic, rate;

  void follow(const Leg& leg, int substeps) {
    const double dt = leg.time / substeps, mean = trace(leg.rate) / 3;
    const Symmetric3<double> shape = leg.rate + Symmetric3<double>{-mean, -mean, -mean, 0, 0, 0};
    for (int i = 0; i < substeps; ++i) {
      const Symmetric3<double> about = deviator + (-1.0) * (back[0] + back[1]);
      const double size = von_mises(about), left = cyclic * std::exp(-rate * p);
      const Symmetric3<double> n = (size > 0 ? 1 / size : 0) * about;
      const double loading = 3 * moduli.mu * contract(n, shape);
      double flow = 0;
      if (size >= yield + cyclic - left && loading > 0) {
        double resistance = 3 * moduli.mu + rate * left;
        for (int k = 0; k < 2; ++k) resistance += modulus[k] - 1.5 * gamma[k] * contract(n, back[k]);
        flow = loading / resistance;
      }
      deviator = deviator + (2 * moduli.mu * dt) * (shape + (-1.5 * flow) * n);
      for (int k = 0; k < 2; ++k) back[k] = back[k] + (flow * dt) * (modulus[k] * n + (-gamma[k]) * back[k]);
      p += flow * dt;
    }
  }
};

TEST(Chaboche, FollowsItsRateEquationsAroundCorners) {
  Point<Chaboche> point(make_law(80e6, 25), density);
  Reference reference;
  reference.cyclic = 80e6, reference.rate = 25;
  for (const Leg& leg : {Leg{{1, -0.5, -0.5, 0, 0, 0}, 0.02, 4000}, Leg{{0, 0.2, -0.2, 0.9, 0, 0.3}, 0.02, 4000},
                         Leg{{-1, 0.4, 0.6, -0.5, 0.4, 0}, 0.03, 6000}}) {
    point.follow(leg);
    reference.follow(leg, 400000);
    const double mean = trace(point.stress) / 3;
    EXPECT_LT(largest_difference(point.stress + Symmetric3<double>{-mean, -mean, -mean, 0, 0, 0}, reference.deviator),
              2e-3 * yield);
    EXPECT_NEAR(point.p(), reference.p, 1e-5);
  }
  EXPECT_GT(point.p(), 0.05);
}

TEST(Chaboche, OneTermThatDoesNotRecoverIsCombinedHardening) {
  Point<Chaboche> point({young, poisson, yield, {1, {0}, {6e9}}, 0, 0, 4e9}, density);
  Point<CombinedHardening> combined({young, poisson, yield, 10e9, 0.6}, density);
  for (const Leg& leg : {Leg{{1, -0.5, -0.5, 0.3, 0, 0}, 0.02, 10}, Leg{{-1, 0.2, 0.8, 0, 0.7, 0}, 0.03, 7}}) {
    point.follow(leg);
    combined.follow(leg);
    EXPECT_LT(largest_difference(point.stress, combined.stress), 1e-9 * yield);
    EXPECT_NEAR(point.plastic.share, combined.plastic.share, 1e-9);
  }
}

TEST(Chaboche, NamesConstantsThatContradictEachOther) {
  EXPECT_STREQ(make_law().find_fault(), "");
  EXPECT_STRNE(make_law(-yield, 1).find_fault(), "");
  EXPECT_STRNE((Chaboche{young, poisson, yield, {1, {-1}, {1e9}}}.find_fault()), "");
}

}  // namespace
}  // namespace percuss::test::chaboche_test
