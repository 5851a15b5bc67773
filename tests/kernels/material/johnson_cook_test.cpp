// Johnson-Cook at several rates, heated to its melting point, against its rate equations in many small steps.

#include <gtest/gtest.h>

#include "tests/kernels/material/point_driver.hpp"

namespace percuss::test {
namespace {

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

}  // namespace
}  // namespace percuss::test
