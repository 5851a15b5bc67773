// Fibres of laws with a flow stress: stretched at a constant rate, against closed forms of one normal stress.

#include "kernels/beam/fibre_laws.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "kernels/beam/beam_step.hpp"

namespace percuss::test::fibre_laws_test {
namespace {

constexpr double young = 200e9, poisson = 0.3, density = 7800;

/// A fibre that is stretched step by step.
template <class Law>
struct Fibre {
  Law law;
  double stress = 0;
  double history[most_fibre_history] = {};

  explicit Fibre(const Law& of) : law(of) {
    if constexpr (requires { law.start(history); }) law.start(history);
  }

  /// By a strain, in steps that take dt each.
  void stretch(double strain, int steps, double dt) {
    const FibreStep step{young, density, dt};
    for (int n = 0; n < steps; ++n) stress = advance_fibre(law, step, stress, strain / steps, history);
  }
};

MaterialTable make_rows(std::initializer_list<std::pair<double, double>> rows) {
  MaterialTable table;
  for (const auto& [x, y] : rows) table.x[table.rows] = x, table.y[table.rows++] = y;
  return table;
}

}  // namespace

// sigma = Y(p), whatever the size of the steps: p = strain - sigma / E.
TEST(FibreLaws, FollowTheirCurvesOfHardening) {
  Fibre<TabulatedPlasticity> table({young, poisson, make_rows({{0, 300e6}, {0.02, 400e6}, {0.1, 440e6}}), 0, 1});
  table.stretch(0.05, 7, 1);
  const double p = table.history[0];
  EXPECT_NEAR(p, 0.05 - table.stress / young, 1e-12);
  EXPECT_NEAR(table.stress, 400e6 + 40e6 * (p - 0.02) / 0.08, 1);

  VocePlasticity voce{young, poisson, 200e6, 150e6, 30, 1e9, 0, 1};
  Fibre<VocePlasticity> of_voce(voce);
  of_voce.stretch(-0.03, 11, 1);
  EXPECT_NEAR(of_voce.history[0], 0.03 + of_voce.stress / young, 1e-12);
  EXPECT_NEAR(of_voce.stress, -(200e6 + 150e6 * -std::expm1(-30 * of_voce.history[0]) + 1e9 * of_voce.history[0]), 1);
}

// At a plastic strain rate r the yield stress is Y (1 + (r / D)^(1/q)).
TEST(FibreLaws, YieldLaterAtHigherRates) {
  for (const double rate : {1.0, 40.0, 1000.0}) {
    Fibre<TabulatedPlasticity> fibre({young, poisson, make_rows({{0, 300e6}}), 40, 5});
    fibre.stretch(0.02, 200, 1e-4 / rate);
    EXPECT_NEAR(fibre.stress, 300e6 * (1 + std::pow(rate / 40, 0.2)), 300) << rate;
  }
}

TEST(FibreLaws, InterpolateTheirTablesOfRates) {
  RateTablePlasticity law{young, poisson, {}, false};
  using Rows = std::vector<std::array<double, 2>>;
  law.hardening.add_curve(0, Rows{{0, 300e6}, {1, 400e6}});
  law.hardening.add_curve(100, Rows{{0, 500e6}, {1, 600e6}});
  Fibre<RateTablePlasticity> fibre(law);
  fibre.stretch(0.1, 100, 1e-3 / 50);  // at a rate of 50, halfway
  EXPECT_NEAR(fibre.stress, 400e6 + 100e6 * fibre.history[0], 2e5);
}

// A + B p^n times 1 + C ln(rate / reference), without heat; with it the temperature is that of the plastic work.
TEST(FibreLaws, FollowJohnsonAndCook) {
  JohnsonCook law;
  law.youngs_modulus = young, law.poissons_ratio = poisson;
  law.a = 350e6, law.b = 300e6, law.n = 0.3, law.c = 0.02, law.m = 1, law.reference_rate = 1;
  law.room_temperature = law.start_temperature = 293, law.melt_temperature = 1800;
  law.specific_heat = 450, law.heating_share = 0;
  Fibre<JohnsonCook> cold(law);
  cold.stretch(0.1, 1000, 1e-4 / 500);
  const double p = cold.history[0];
  EXPECT_NEAR(cold.stress, (350e6 + 300e6 * std::pow(p, 0.3)) * (1 + 0.02 * std::log(500)), 2e5);
  EXPECT_EQ(cold.history[1], 293);

  law.heating_share = 0.9;
  Fibre<JohnsonCook> hot(law);
  double work = 0;
  for (int n = 0; n < 1000; ++n) {
    const double before = hot.stress, strain = hot.history[0];
    hot.stretch(1e-4, 1, 1e-4 / 500);
    work += 0.5 * (before + hot.stress) * (hot.history[0] - strain);
  }
  EXPECT_NEAR(hot.history[1], 293 + 0.9 * work / (density * 450), 0.01);
  const double softer = 1 - (hot.history[1] - 293) / (1800 - 293);
  EXPECT_NEAR(hot.stress, (350e6 + 300e6 * std::pow(hot.history[0], 0.3)) * (1 + 0.02 * std::log(500)) * softer, 3e5);
}

// After a pull the fibre yields back at the stress less twice the isotropic yield stress, whatever the shares.
TEST(FibreLaws, MoveTheirYieldSurface) {
  constexpr double yield = 300e6, hardening = 2e9;
  for (const double share : {0.0, 0.4, 1.0}) {
    Fibre<CombinedHardening> fibre({young, poisson, yield, hardening, share, 0, 1});
    fibre.stretch(0.02, 9, 1);
    const double tangent = young * hardening / (young + hardening);
    EXPECT_NEAR(fibre.stress, yield + tangent * (0.02 - yield / young), 1);
    EXPECT_NEAR(fibre.history[1], share * hardening * fibre.history[0], 1);
    const double width = 2 * (yield + (1 - share) * hardening * fibre.history[0]), top = fibre.stress;
    fibre.stretch(-width / young, 5, 1);
    EXPECT_NEAR(fibre.stress, top - width, 1) << share;
    fibre.stretch(-1e-3, 5, 1);
    EXPECT_NEAR(fibre.stress, top - width - tangent * 1e-3, 1) << share;
  }
}

// One term: the back stress is C / g (1 - exp(-g p)) on the way out; on the way back from there -C / g + (a + C / g)
// exp(-g p). Backward Euler in 4000 steps keeps it to 1e-3.
TEST(FibreLaws, RecoverTheirBackStresses) {
  constexpr double yield = 200e6, modulus = 40e9, rate = 200;
  Fibre<Chaboche> fibre({young, poisson, yield, make_rows({{rate, modulus}}), 0, 0, 0, 0, 1});
  fibre.stretch(0.01, 4000, 1);
  const double there = fibre.history[0], back = modulus / rate * -std::expm1(-rate * there);
  EXPECT_NEAR(fibre.stress, yield + back, 1e-3 * fibre.stress);
  EXPECT_NEAR(there, 0.01 - fibre.stress / young, 1e-12);
  fibre.stretch(-0.02, 8000, 1);
  const double p = fibre.history[0] - there;
  const double again = -modulus / rate + (back + modulus / rate) * std::exp(-rate * p);
  EXPECT_NEAR(fibre.stress, -yield + again, 2e-3 * yield);
}

// A curvature far beyond the first yield of a rectangle gives the plastic moment Y b h^2 / 4, at a rate that of the
// rate.
TEST(FibreLaws, GiveTheSectionItsPlasticMoment) {
  BeamParameters parameters;
  parameters.stiffness = find_beam_stiffness(make_rectangle(0.02, 0.04), young, young / 2.6);
  parameters.law.youngs_modulus = young;
  parameters.called =
      CalledFibreLaw::make(TabulatedPlasticity{young, poisson, make_rows({{0, 300e6}}), 40, 5}, density);
  parameters.fibres = list_rectangle_fibres(0.02, 0.04);
  parameters.bends = true;
  double fibres[(1 + most_fibre_history) * most_beam_fibres] = {};
  BeamForces<double> forces{};
  BeamRates<double> bent{};
  bent.curvature_y = 0.01;
  for (int n = 0; n < 1000; ++n) forces = advance_section(parameters, forces, bent, 1e9, fibres);  // slowly
  EXPECT_NEAR(forces.moment_y, 300e6 * 0.02 * 0.04 * 0.04 / 4, 0.02 * 2400);
  EXPECT_NEAR(forces.normal, 0, 1e-6 * 300e6 * 8e-4);
  // At a curvature rate k the flow stress at z is Y (1 + (k |z| / D)^(1/5)): 2 b integral of z of it.
  const double rate = 1e4, half = 0.02;
  for (int n = 0; n < 4000; ++n) forces = advance_section(parameters, forces, bent, 0.01 / rate, fibres);
  const double exact = 2 * 0.02 * 300e6 * (half * half / 2 + std::pow(rate / 40, 0.2) * std::pow(half, 2.2) / 2.2);
  EXPECT_NEAR(forces.moment_y, exact, 2e-3 * exact);
}

}  // namespace percuss::test::fibre_laws_test
