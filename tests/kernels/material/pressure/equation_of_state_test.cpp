// Equations of state along isentropes and Hugoniots, against closed forms or the first law integrated independently.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::equation_of_state_test {
namespace {

[[maybe_unused]] const bool has_samples = provide_sample<Fluid>({});

constexpr double density = 2000;

TillotsonState make_tillotson() { return {0.5, 1.5, 18e9, 18e9, 16e6, 5, 5, 3.5e6, 18e6, 0}; }

/// Volume from 1 to `end` in equal steps of its logarithm.
template <class Law>
void change_volume(Point<Law>& point, double end, int steps) {
  const double from = point.log_volume, step = (std::log(end) - from) / steps;
  for (int i = 0; i < steps; ++i) point.advance({step / 3, step / 3, step / 3, 0, 0, 0}, 1e-6);
}

double find_pressure(const Symmetric3<double>& stress) { return -trace(stress) / 3; }

/// e along the isentrope de = -p dJ by Runge and Kutta's fourth-order method.
double integrate_isentrope(const std::function<double(double, double)>& pressure, double e, double from, double to) {
  const int steps = 4000;
  const double h = (to - from) / steps;
  for (int i = 0; i < steps; ++i) {
    const double j = from + i * h;
    const double k1 = -pressure(j, e), k2 = -pressure(j + h / 2, e + h / 2 * k1),
                 k3 = -pressure(j + h / 2, e + h / 2 * k2), k4 = -pressure(j + h, e + h * k3);
    e += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return e;
}

template <class State>
double evaluate(const State& state, double j, double e) {
  return state(j, e, StatePoint<double>{density, 1e9, 1, 0}).pressure;
}

/// The end of an isentrope against the independent integration, and the modulus there against its slope.
template <class State>
void compare_isentrope(const State& state, double end) {
  Point<Fluid> point(Fluid{}, density, state);
  point.time = 1e9;  // explosives have burnt
  point.advance({}, 0);
  change_volume(point, end, 4000);
  const auto pressure = [&](double j, double e) { return evaluate(state, j, e); };
  const double e = integrate_isentrope(pressure, state.find_start_energy(), 1, end);
  const double scale = std::abs(pressure(end, e)) + 1e-3 * point.modulus;
  EXPECT_NEAR(find_pressure(point.stress), pressure(end, e), 1e-5 * scale) << end;
  const double d = 1e-4 * end;
  const double above = pressure(end + d, integrate_isentrope(pressure, e, end, end + d));
  const double below = pressure(end - d, integrate_isentrope(pressure, e, end, end - d));
  EXPECT_NEAR(point.modulus, -end * (above - below) / (2 * d), 1e-3 * point.modulus) << end;
}

}  // namespace

// The work of the cutoff heats; compressed again, the pressure is that of the state with this energy.
TEST(EquationOfState, StaysLevelAtItsCutoff) {
  MieGrueneisenState state{4000, 1.5, 2, 1e8};
  state.least_pressure = -3e7;
  Point<Fluid> point(Fluid{}, density, state);
  point.advance({}, 0);
  change_volume(point, 1.05, 4000);
  EXPECT_EQ(find_pressure(point.stress), -3e7);
  change_volume(point, 0.98, 4000);
  const auto pressure = [&](double j, double e) { return std::max(evaluate(state, j, e), -3e7); };
  const double open = integrate_isentrope(pressure, 1e8, 1, 1.05), e = integrate_isentrope(pressure, open, 1.05, 0.98);
  EXPECT_NEAR(find_pressure(point.stress), pressure(0.98, e), 1e-5 * pressure(0.98, e));
}

TEST(Fluid, HasTwiceItsViscosityTimesTheDeviatorOfTheRate) {
  Point<Fluid> point(Fluid{2.5}, density, LinearState{10e9});
  const double dt = 1e-6;
  point.advance({3e-6, 0, 0, 4e-6, -1e-6, 0}, dt);
  EXPECT_NEAR(point.stress.xy, 2 * 2.5 * 4, 1e-12);
  EXPECT_NEAR(point.stress.yz, 2 * 2.5 * -1, 1e-12);
  EXPECT_NEAR(point.stress.xx - point.stress.yy, 2 * 2.5 * 3, 1e-9);
  point.advance({}, dt);
  EXPECT_EQ(point.stress.xy, 0);
}

TEST(EquationOfState, EveryKindFollowsItsIsentropesAndTellsTheirModulus) {
  for (const double end : {0.7, 0.95, 1.05}) {
    compare_isentrope(LinearState{10e9}, end);
    compare_isentrope(MieGrueneisenState{4000, 1.5, 2, 1e8}, end);
    compare_isentrope(PolynomialState{1e8, 10e9, 5e9, 20e9, 0.5, 0.3, 0.1, 1e9}, end);
    compare_isentrope(IdealGasState{1.4, 2.5e5}, end);
    compare_isentrope(make_tillotson(), end);
    compare_isentrope(JwlState{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 7e9, 6930, {0, 0, 0}}, end);
  }
  compare_isentrope(JwlState{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 7e9, 6930, {0, 0, 0}}, 5);
}

TEST(EquationOfState, IdealGasKeepsItsAdiabatToSecondOrder) {
  const double gamma = 1.4;
  double errors[2];
  for (const int k : {0, 1}) {
    Point<Fluid> point(Fluid{}, density, IdealGasState{gamma, 2.5e5});
    point.advance({}, 0);
    EXPECT_NEAR(find_pressure(point.stress), 1e5, 1e-6);
    change_volume(point, 0.5, k == 0 ? 20 : 40);
    errors[k] = find_pressure(point.stress) / (1e5 * std::pow(2, gamma)) - 1;
  }
  EXPECT_LT(std::abs(errors[1]), 1e-3);
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
}

TEST(EquationOfState, JumpLandsOnTheHugoniot) {
  // From rest e = p (1 - J) / 2 at the far side of a shock, which is what the trapezoid gives in one step.
  const MieGrueneisenState copper{3940, 1.489, 2.02, 0};
  for (const double up : {100.0, 500.0, 1500.0}) {
    Point<Fluid> point(Fluid{}, 8930, copper);
    point.advance({}, 0);
    const double us = 3940 + 1.489 * up;
    change_volume(point, 1 - up / us, 1);
    EXPECT_NEAR(find_pressure(point.stress), 8930 * us * up, 1e-9 * 8930 * us * up);
    EXPECT_NEAR(point.history[1], 0.5 * 8930 * up * up, 1e-9 * 8930 * up * up);
  }
}

TEST(EquationOfState, ViscousPressureHeats) {
  Point<Fluid> point(Fluid{}, density, IdealGasState{1.4, 2.5e5});
  point.advance({}, 0);
  point.viscosity = 3e4;
  change_volume(point, 0.9, 1);
  // e1 = e0 + ((p0 + p1) / 2 + q) 0.1
  EXPECT_NEAR(point.history[1], 2.5e5 + 0.1 * (0.5 * (1e5 + find_pressure(point.stress)) + 3e4), 1e-6);
}

TEST(EquationOfState, StrengthKeepsItsDeviatorAndHeats) {
  const J2Plasticity law = J2Plasticity::make({70e9, 0.33, 300e6, 0});
  const MieGrueneisenState state{5350, 1.34, 2, 0};
  Point<J2Plasticity> point(law, 2703, state);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.1, 1000});
  EXPECT_NEAR(point.stress.xy, 300e6 / std::sqrt(3.0), 1);
  // all work at constant volume: elastic and plastic
  const double tau = 300e6 / std::sqrt(3.0), elastic = tau * tau / (2 * law.mu);
  EXPECT_NEAR(point.history[2], 2 * tau * 0.1 - elastic, 2e-3 * 2 * tau * 0.1);
  EXPECT_NEAR(find_pressure(point.stress), 2 * point.history[2], 1e-6 * find_pressure(point.stress));
}

TEST(EquationOfState, TillotsonIsContinuousWhereItVaporises) {
  const TillotsonState state = make_tillotson();
  for (const double e : {state.incipient_energy * density, state.vapour_energy * density}) {
    EXPECT_NEAR(evaluate(state, 1.3, e * (1 - 1e-9)), evaluate(state, 1.3, e * (1 + 1e-9)), 1e-6 * 18e9);
  }
  EXPECT_NEAR(evaluate(state, 1 - 1e-9, 1e9), evaluate(state, 1 + 1e-9, 1e9), 1e-6 * 18e9);
  // cold and compressed: A m + B m^2
  EXPECT_NEAR(evaluate(state, 1 / 1.1, 0), 18e9 * (0.1 + 0.01), 1);
}

TEST(EquationOfState, ExplosiveBurnsWhenTheDetonationArrives) {
  const JwlState tnt{371.2e9, 3.231e9, 4.15, 0.95, 0.3, 7e9, 6930, {0, 0, 0}};
  const CalledMaterial material = make_called_material(Fluid{}, 1630, tnt);
  EXPECT_TRUE(material.changes_at_rest);
  double history[CalledMaterial::history_count];
  const double center[3] = {0.06930, 0, 0};  // 10 us away
  start_history(material, history, center);
  const double length = 1.386e-3;  // burns in 0.3 us
  Symmetric3<double> stress{};
  const auto find = [&](double time) {
    PointStep<double> step{{{}, 1e-7, 1, length, 0, time}, stress, history};
    material.update(step);
    stress = step.stress;
    EXPECT_GT(step.lambda, 0);
    return find_pressure(stress);
  };
  EXPECT_EQ(find(9.9e-6), 0);
  const double burnt =
      371.2e9 * (1 - 0.3 / 4.15) * std::exp(-4.15) + 3.231e9 * (1 - 0.3 / 0.95) * std::exp(-0.95) + 2.1e9;
  EXPECT_NEAR(find(10.15e-6), burnt / 2, 1e-6 * burnt);
  EXPECT_NEAR(find(11e-6), burnt, 1e-9 * burnt);
}

}  // namespace percuss::test::equation_of_state_test
