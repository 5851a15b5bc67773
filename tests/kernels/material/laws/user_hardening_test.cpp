// The yield stress of a user's code against percuss's own law of the same curve, and against its rate equations.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::user_hardening_test {
namespace {

/// What a user would bring: Voce's growth times a linear rate and a softening that is linear in the temperature, which
/// is that of the end of the step. PROPS: yield, growth, its rate, 1 / rate, 1 / temperature; STATEV: the mean strain
/// of the yield.
void sample_vuhard(const int* points, const int*, const int*, const int*, const int*, const int*, const double*,
                   const double*, const double*, const char*, const int* states, const int*, const int*,
                   const double* c, const double*, const double* temperature, const double*, const double*,
                   const double*, const double* strain, const double* rate, double* yield, double* by_temperature,
                   double* by_strain, double* state_new, std::size_t) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double at_rest = c[0] + c[1] * (1 - std::exp(-c[2] * strain[i]));
    const double faster = 1 + c[3] * rate[i], softer = 1 - c[4] * temperature[i];
    yield[i] = at_rest * faster * softer;
    by_strain[i] = c[1] * c[2] * std::exp(-c[2] * strain[i]) * faster * softer;
    by_strain[n + i] = at_rest * c[3] * softer;
    by_temperature[i] = -at_rest * faster * c[4];
    if (*states > 0) state_new[i] = 2 * strain[i];
  }
}

UserHardening make_sample() {
  static int outside = 0;
  UserHardening law;
  law.youngs_modulus = 20e9;
  law.poissons_ratio = 0.25;
  law.code.vuhard = sample_vuhard;
  law.code.has_written_outside = &outside;
  law.constants = {5, {150e6, 100e6, 30, 0.1, 1e-3}};
  law.states = 1;
  law.specific_heat = 200;
  return law;
}

[[maybe_unused]] const bool has_samples = provide_sample<UserHardening>(make_sample());

constexpr double yield = 150e6, growth = 100e6, saturation = 30, over_rate = 0.1, softening = 1e-3;

UserHardening make_law(double rate, double soft) {
  UserHardening law = sample<UserHardening>();
  law.constants = {5, {yield, growth, saturation, rate, soft}};
  return law;
}

/// A turn of the direction of strain, and back.
std::vector<Leg> make_path() {
  return {{{2, -1, -0.5, 0.3, 0, 0}, 0.02, 40}, {{0, 0.1, 0, 0, 4, 1}, 0.02, 25}, {{-3, 1, 1, 0, -1, 0.5}, 0.03, 30}};
}

TEST(UserHardening, IsOurOwnLawOfTheSameCurve) {
  Point<UserHardening> user(make_law(0, 0), sample_density);
  Point<VocePlasticity> ours({20e9, 0.25, yield, growth, saturation}, sample_density);
  for (const Leg& leg : make_path()) {
    for (int i = 0; i < leg.steps; ++i) {
      user.advance(scale(leg.time / leg.steps, leg.rate), leg.time / leg.steps);
      ours.advance(scale(leg.time / leg.steps, leg.rate), leg.time / leg.steps);
      EXPECT_LT(largest_difference(user.stress, ours.stress), 1e-11 * 20e9);
      EXPECT_NEAR(user.p(), ours.p(), 1e-12);
      EXPECT_NEAR(user.plastic.share, ours.plastic.share, 1e-9);
      EXPECT_NEAR(user.plastic.loading, ours.plastic.loading, 1e-9);
    }
  }
  EXPECT_GT(user.p(), 0.1);
  EXPECT_NEAR(user.history[3], 2 * user.p(), 1e-14);  // its state variable
}

// The equations at the end of each step: the stress is the yield stress there, and heat is the mean stress of the step.
TEST(UserHardening, EndsEachStepOnItsYieldSurface) {
  const UserHardening law = make_law(over_rate, softening);
  Point<UserHardening> point(law, sample_density);
  double hottest = 0;
  for (const Leg& leg : make_path()) {
    const double dt = leg.time / leg.steps;
    for (int i = 0; i < leg.steps; ++i) {
      const double p = point.p(), temperature = point.history[2];
      const double first = yield + growth * (1 - std::exp(-saturation * p));  // where the point begins to yield
      const double before = std::max(von_mises(point.stress), first * (1 - softening * temperature));
      const double volume = point.last_volume;
      point.advance(scale(dt, leg.rate), dt);
      const double dp = point.p() - p;
      if (dp == 0) continue;
      const double now = von_mises(point.stress);
      const double at_rest = yield + growth * (1 - std::exp(-saturation * point.p()));
      EXPECT_NEAR(now, at_rest * (1 + over_rate * dp / dt) * (1 - softening * point.history[2]), 1e-9 * now);
      const double middle = 0.5 * (volume + point.last_volume);  // V / V(0), by which the work of a unit of mass grows
      const double heat = law.heating_share * middle * 0.5 * (before + now) * dp / (sample_density * law.specific_heat);
      EXPECT_NEAR(point.history[2] - temperature, heat, 1e-9 * heat);
      hottest = point.history[2];
    }
  }
  EXPECT_GT(hottest, 20);
}

TEST(UserHardening, FollowsItsRateEquations) {
  const UserHardening law = make_law(over_rate, softening);
  Point<UserHardening> point(law, sample_density);
  PlasticReference reference{law.moduli()};
  reference.heat = law.heating_share / (sample_density * law.specific_heat);
  const auto rate = [](double size, double p, double temperature) {
    const double at_rest = (yield + growth * (1 - std::exp(-saturation * p))) * (1 - softening * temperature);
    return std::max(size / at_rest - 1, 0.0) / over_rate;
  };
  for (Leg leg : make_path()) {
    leg.steps *= 100;
    point.follow(leg);
    reference.follow_by_rate(leg, 400000, rate);
    EXPECT_NEAR(von_mises(point.stress), von_mises(reference.stress()), 1e-3 * yield);
    EXPECT_NEAR(point.p(), reference.p, 1e-4);
    EXPECT_NEAR(point.history[2], reference.temperature, 2e-3 * reference.temperature);
  }
}

/// sample_vuhard() with slopes of 0, and once with a stress that is no number.
template <int Wrong>
void tell_wrongly(const int* points, const int* a, const int* b, const int* d, const int* e, const int* f,
                  const double* g, const double* h, const double* k, const char* l, const int* states, const int* m,
                  const int* o, const double* c, const double* q, const double* temperature, const double* r,
                  const double* s, const double* t, const double* strain, const double* rate, double* told,
                  double* by_temperature, double* by_strain, double* state_new, std::size_t u) {
  sample_vuhard(points, a, b, d, e, f, g, h, k, l, states, m, o, c, q, temperature, r, s, t, strain, rate, told,
                by_temperature, by_strain, state_new, u);
  for (int i = 0; i < *points; ++i) by_temperature[i] = by_strain[i] = by_strain[*points + i] = 0;
  if (Wrong == 1) told[0] = std::nan("");
  if (Wrong == 2) told[*points] = 1;
}

TEST(UserHardening, NeedsNoSlopes) {
  UserHardening law = make_law(over_rate, softening), flat = law;
  flat.code.vuhard = tell_wrongly<0>;
  Point<UserHardening> point(law, sample_density), other(flat, sample_density);
  for (const Leg& leg : make_path()) {
    point.follow(leg);
    other.follow(leg);
    EXPECT_LT(largest_difference(point.stress, other.stress), 1e-9 * yield);
  }
}

TEST(UserHardening, EndsTheRunWhereTheCodeTellsNoNumberOrWritesElsewhere) {
  for (const VuhardFunction code : {VuhardFunction(tell_wrongly<1>), VuhardFunction(tell_wrongly<2>)}) {
    UserHardening law = make_law(0, 0);
    law.code.vuhard = code;
    Point<UserHardening> point(law, sample_density);
    point.advance({1e-4, 0, 0, 0, 0, 0}, 1e-4);
    EXPECT_TRUE(std::isnan(point.stress.xx));
  }
}

}  // namespace
}  // namespace percuss::test::user_hardening_test
