// Johnson-Cook at several rates, heated to its melting point, against its rate equations in many small steps.

#include <gtest/gtest.h>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::johnson_cook_test {
namespace {

JohnsonCook make_sample() {
  JohnsonCook law{20e9, 0.3, 150e6, 200e6, 0.4, 0.02, 1.1};
  law.reference_rate = 0.1;
  law.melt_temperature = 900;
  law.specific_heat = 200;
  return law;
}

[[maybe_unused]] const bool has_samples = provide_sample<JohnsonCook>(make_sample());

JohnsonCook make_steel() {
  JohnsonCook law{206.9e9, 0.3, 806e6, 614e6, 0.168, 0.0089, 1.1};
  law.start_temperature = law.room_temperature = 20;
  law.melt_temperature = 1540;
  law.specific_heat = 460;
  return law;
}

TEST(JohnsonCook, FollowsItsRateEquations) {
  const JohnsonCook law = make_steel();
  Point<JohnsonCook> point(law, 7830);
  PlasticReference reference{law.moduli()};
  reference.temperature = 20;
  reference.heat = law.heating_share / (7830 * law.specific_heat);
  const auto rate = [](double size, double p, double temperature) {
    const double t = std::clamp((temperature - 20) / 1520, 0.0, 1.0);
    const double yield = (806e6 + 614e6 * std::pow(p, 0.168)) * (1 - std::pow(t, 1.1));
    if (size < yield) return 0.0;
    return std::exp(std::min((size / yield - 1) / 0.0089, 40.0));  // where r > 1
  };
  for (const double speed : {100.0, 10000.0, -1000.0}) {
    const Leg leg{{speed, -0.5 * speed, -0.5 * speed, 0, 0.4 * speed, 0}, 0.3 / std::abs(speed), 3000};
    point.follow(leg);
    reference.follow_by_rate(leg, 1500000, rate);
    EXPECT_NEAR(von_mises(point.stress), von_mises(reference.stress()), 2e-3 * 806e6) << speed;
    EXPECT_NEAR(point.p(), reference.p, 1e-3);
    EXPECT_NEAR(point.history[2], reference.temperature, 1e-3 * (reference.temperature - 20));
  }
  EXPECT_GT(point.history[2], 200);
}

TEST(JohnsonCook, HasNoStrengthWhereItMelts) {
  JohnsonCook law = make_steel();
  law.start_temperature = 1600;
  Point<JohnsonCook> point(law, 7830);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.1, 10});
  EXPECT_LT(von_mises(point.stress), 1e-6 * 806e6);
  EXPECT_EQ(point.history[2], 1600);
}

TEST(JohnsonCook, HeatsByTheShareOfItsPlasticWork) {
  JohnsonCook law = make_steel();
  law.b = law.c = 0;
  law.melt_temperature = 1e12;  // no softening
  Point<JohnsonCook> point(law, 7830);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.2, 20});
  // the first step's mean flow stress counts its elastic part
  EXPECT_NEAR(point.history[2] - 20, 0.9 * 806e6 * point.p() / (7830 * 460), 0.03 * (point.history[2] - 20));
}

/// Elastic, in degrees Celsius, with Gamma = 2.
Point<JohnsonCook> make_compressed(const MieGrueneisenState& state) {
  JohnsonCook law{117e9, 0.35, 1e15, 0, 1, 0, 1};
  law.start_temperature = law.room_temperature = 20;
  law.absolute_zero = -273.15;
  law.melt_temperature = 1e4;
  law.specific_heat = 383;
  Point<JohnsonCook> point(law, 8930, state);
  point.advance({}, 0);
  return point;
}

TEST(JohnsonCook, IsHeatedByCompressionAlongTheIsentrope) {
  Point<JohnsonCook> point = make_compressed({3940, 1.489, 2, 0});
  for (const double end : {0.8, 1.0, 1.05}) {
    const double step = (std::log(end) - point.log_volume) / 300;
    for (int i = 0; i < 100; ++i) point.advance({step, step, step, 0, 0, 0}, 1e-9);
    // T exp(Gamma J) = const
    EXPECT_NEAR(point.history[2] + 273.15, 293.15 * std::exp(2 * (1 - end)), 1e-9 * 293.15) << end;
  }
}

TEST(JohnsonCook, IsHeatedByAShock) {
  const MieGrueneisenState copper{3940, 1.489, 2, 0};
  const double up = 1000, us = 3940 + 1.489 * up, end = 1 - up / us, jump = 8930 * us * up;
  Point<JohnsonCook> point = make_compressed(copper);
  // Along the line of Rayleigh: what the equation of state lacks of the stress there is the viscous pressure.
  const int steps = 4000;
  const double change = (end - 1) / steps;
  for (int i = 0; i < steps; ++i) {
    const double from = 1 + i * change, to = from + change, de = std::log(to / from) / 3;
    const double mean = 0.5 * jump * ((1 - from) + (1 - to)) / (1 - end);
    point.viscosity = mean + trace(point.stress) / 3;
    point.advance({de, de, de, 0, 0, 0}, 1e-9);
  }
  const double energy = 0.5 * 8930 * up * up;
  ASSERT_NEAR(point.history[3], energy, 1e-3 * energy);
  // e(J) of the isentrope from rest, by Runge and Kutta's method; from there heat at constant volume
  double cold = 0;
  const double h = (end - 1) / 2000;
  const auto pressure = [&](double j, double e) { return copper(j, e, StatePoint<double>{8930, 0, 1, 0}).pressure; };
  for (int i = 0; i < 2000; ++i) {
    const double j = 1 + i * h, k1 = -pressure(j, cold), k2 = -pressure(j + h / 2, cold + h / 2 * k1);
    const double k3 = -pressure(j + h / 2, cold + h / 2 * k2), k4 = -pressure(j + h, cold + h * k3);
    cold += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double rise = (energy - cold) / (8930 * 383), isentrope = 293.15 * std::exp(2 * (1 - end)) - 273.15;
  EXPECT_GT(rise, 50);
  EXPECT_NEAR(point.history[2], isentrope + rise, 1e-3 * (isentrope + rise));
}

}  // namespace
}  // namespace percuss::test::johnson_cook_test
