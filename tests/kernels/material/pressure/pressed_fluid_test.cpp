// Fluids under pressure at the start: closed forms, and dp/dh = rho g with the first law, integrated independently.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/material/pressure/equations_of_state.hpp"
#include "kernels/material/pressure/pressed_fluid.hpp"

namespace percuss::test {
namespace {

constexpr double density = 1000;

/// Both sides of dp = (weight / J) ds and de = -p dJ by central differences about half of the depth.
template <class State>
void compare_with_differences(const State& state, double pressure, double weight) {
  constexpr double part = 1e-3;
  const PressedFluid at = press(state, density, pressure, 0.5 * weight),
                     above = press(state, density, pressure, (0.5 - part) * weight),
                     below = press(state, density, pressure, (0.5 + part) * weight);
  const double rise = find_pressure(state, density, below).pressure - find_pressure(state, density, above).pressure;
  EXPECT_NEAR(rise, 2 * part * weight / at.j, 2e-5 * rise);
  const double work = -find_pressure(state, density, at).pressure * (below.j - above.j);
  EXPECT_NEAR(below.energy - above.energy, work, 2e-5 * std::abs(work));
}

}  // namespace

TEST(PressedFluid, OfALinearStateHasItsClosedForm) {
  const LinearState water{2.2e9};
  for (const double pressure : {0.0, 1e5, 1e8}) {
    for (const double weight : {5e3, 4e7, 4e8}) {  // half a metre, 4 km, 40 km
      const double exact = (2.2e9 + pressure) * std::exp(weight / 2.2e9) - 2.2e9;
      const PressedFluid at = press(water, density, pressure, weight);
      EXPECT_NEAR(find_pressure(water, density, at).pressure, exact, 1e-6 + 1e-9 * exact);
      // e = K (J - 1 - ln J)
      EXPECT_NEAR(at.energy, 2.2e9 * (at.j - 1 - std::log(at.j)), 1e-5 + 1e-9 * exact);
    }
  }
}

/// p^(1 - 1/gamma) rises linearly with the depth: a dry adiabatic atmosphere.
TEST(PressedFluid, OfAGasIsAnAdiabaticAtmosphere) {
  const double gamma = 1.4, start = 1e5, share = 1 - 1 / gamma;
  const IdealGasState gas{gamma, start / (gamma - 1)};
  for (const double pressure : {5e4, 1e5, 2e5}) {
    const double density_there = density * std::pow(pressure / start, 1 / gamma), height = 0.3 * pressure;
    const double exact = pressure * std::pow(1 + share * height / pressure, 1 / share);
    const double found =
        find_pressure(gas, density, press(gas, density, pressure, height * density / density_there)).pressure;
    EXPECT_NEAR(found, exact, 1e-6 * exact);
  }
}

TEST(PressedFluid, OfEveryStateHasTheWeightAboveAndTheFirstLaw) {
  compare_with_differences(LinearState{10e9}, 0, 1e9);
  compare_with_differences(MieGrueneisenState{4000, 1.5, 2, 1e8}, 3e8, 1e9);
  compare_with_differences(PolynomialState{1e8, 10e9, 5e9, 20e9, 0.5, 0.3, 0.1, 1e9}, 0, 1e9);
  compare_with_differences(TillotsonState{0.5, 1.5, 18e9, 18e9, 16e6, 5, 5, 3.5e6, 18e6, 0}, 0, 1e9);
  TabulatedState table;
  table.gamma = 0.5;
  table.cold.rows = 2;
  table.cold.x[0] = -1, table.cold.y[0] = 10e9, table.cold.x[1] = 0, table.cold.y[1] = 0;
  table.heat.rows = 1;
  table.heat.y[0] = 1;
  compare_with_differences(table, 1e8, 1e9);
}

/// Straight lines of p over ln J: on one of slope -k, dp/dJ = -k / J and dp/ds = weight / J, so that J falls by weight
/// over k.
TEST(PressedFluid, OfATableWithKinksHasTheWeightAbove) {
  TabulatedState table;
  table.cold.rows = 4;
  const double x[] = {-0.5, -0.01, 0, 0.1}, y[] = {2e8, 2e4, 0, -2e5};
  for (int i = 0; i < 4; ++i) table.cold.x[i] = x[i], table.cold.y[i] = y[i];
  table.heat.rows = 1;
  const double soft = 2e6, stiff = (2e8 - 2e4) / 0.49;
  const double of_soft = soft * (1 - std::exp(-0.01));  // weight down to the kink
  for (const double more : {0.5, 1.0, 1e3}) {
    const double j = std::exp(-0.01) - more * of_soft / stiff;
    const PressedFluid at = press(table, density, 0, (1 + more) * of_soft);
    EXPECT_NEAR(at.j, j, 2e-6);
    const double exact = 2e4 - stiff * (std::log(j) + 0.01);
    EXPECT_NEAR(find_pressure(table, density, at).pressure, exact, 1e-4 * exact) << more;
  }
}

TEST(PressedFluid, BeyondItsHighestPressureThereIsNone) {
  const PolynomialState soft{0, 4e6, -4e7, 0, 0, 0, 0, 0};  // at most 1e5, at 1 / J = 1.05
  EXPECT_TRUE(std::isnan(press(soft, density, 0, 2e5).j));
  EXPECT_NEAR(press(soft, density, 9e4, 0).j, 1 / (1.05 - std::sqrt(1e4 / 4e7)), 1e-9);
}

}  // namespace percuss::test
