// Hardening laws along paths that load, turn, reverse and change their rate, against the rate equations in many small
// steps.

#include <gtest/gtest.h>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::hardening_test {
namespace {

[[maybe_unused]] const bool has_samples =
    provide_sample<Elastic>({20e9, 0.3}) && provide_sample<J2Plasticity>({20e9, 0.3, 200e6, 1e9}) &&
    provide_sample<PowerLawPlasticity>({20e9, 0.3, 150e6, 300e6, 0.4, 2, 3}) &&
    provide_sample<VocePlasticity>({20e9, 0.25, 150e6, 100e6, 30, 0.5e9, 2, 3}) &&
    provide_sample<TabulatedPlasticity>({20e9, 0.3, {3, {0, 0.02, 0.06}, {150e6, 220e6, 250e6}}, 2, 4}) &&
    provide_sample<CombinedHardening>({20e9, 0.3, 150e6, 2e9, 0.6, 2, 3});

constexpr double young = 200e9, poisson = 0.3, density = 7850, yield_stress = 300e6;

/// Pull, shear, and back: 3 % each, at 1 / s.
std::vector<Leg> make_path(int steps) {
  return {{{1, -0.4, -0.4, 0, 0, 0}, 0.03, steps},
          {{0, 0, 0.2, 0.9, 0, 0.3}, 0.03, steps},
          {{-1, 0.3, 0.6, -0.5, 0.4, 0}, 0.05, steps}};
}

template <class Law, class Yield, class Slope>
void compare(const Law& law, double kinematic, const Yield& yield, const Slope& slope, double tolerance) {
  Point<Law> point(law, density);
  PlasticReference reference{find_lame_constants(young, poisson)};
  reference.kinematic = kinematic;
  for (const Leg& leg : make_path(400)) {
    point.follow(leg);
    reference.follow_by_consistency(leg, 200000, yield, slope);
    EXPECT_LT(largest_difference(point.stress, reference.stress()), tolerance * yield_stress);
    EXPECT_NEAR(point.p(), reference.p, tolerance * 0.03);
  }
  EXPECT_GT(point.p(), 0.05);
}

/// A law with the rate of Cowper and Symonds, D = 100 / s and q = 3, through changes of speed; yield: of |s - a| at
/// rest.
template <class Law, class Yield>
void compare_at_rates(const Law& law, double kinematic, const Yield& yield) {
  Point<Law> point(law, density);
  PlasticReference reference{law.moduli()};
  reference.kinematic = kinematic;
  const auto rate = [&](double size, double p, double) {
    return size > yield(p) ? 100 * std::pow(size / yield(p) - 1, 3) : 0;
  };
  for (const double speed : {20.0, 2000.0, -300.0}) {
    const Leg leg{{speed, -0.5 * speed, -0.5 * speed, 0.3 * speed, 0, 0.1 * speed}, 0.03 / std::abs(speed), 1000};
    point.follow(leg);
    reference.follow_by_rate(leg, 200000, rate);
    EXPECT_LT(largest_difference(point.stress, reference.stress()), 3e-3 * yield_stress) << speed;
    EXPECT_NEAR(point.p(), reference.p, 1e-4);
  }
  EXPECT_GT(point.p(), 0.05);
}

TEST(Hardening, PowerLawFollowsTheRateEquations) {
  PowerLawPlasticity law{young, poisson, yield_stress, 500e6, 0.3};
  // the reference starts where the slope is finite
  compare(
      law, 0, [](double p) { return yield_stress + 500e6 * std::pow(p, 0.3); },
      [](double p) { return 500e6 * 0.3 * std::pow(std::max(p, 1e-9), -0.7); }, 2e-3);
}

TEST(Hardening, VoceFollowsTheRateEquations) {
  VocePlasticity law{young, poisson, yield_stress, 200e6, 40, 1e9};
  compare(
      law, 0, [](double p) { return yield_stress + 200e6 * (1 - std::exp(-40 * p)) + 1e9 * p; },
      [](double p) { return 200e6 * 40 * std::exp(-40 * p) + 1e9; }, 2e-3);
}

TEST(Hardening, TableFollowsTheRateEquations) {
  TabulatedPlasticity law{};
  law.youngs_modulus = young;
  law.poissons_ratio = poisson;
  law.hardening = {3, {0, 0.02, 0.06}, {yield_stress, 400e6, 450e6}};
  compare(
      law, 0,
      [](double p) { return p < 0.02   ? yield_stress + 5e9 * p
                            : p < 0.06 ? 400e6 + 1.25e9 * (p - 0.02)
                                       : 450e6; },
      [](double p) { return p < 0.02   ? 5e9
                            : p < 0.06 ? 1.25e9
                                       : 0; }, 2e-3);
}

TEST(Hardening, KinematicAndIsotropicTogetherFollowTheRateEquations) {
  CombinedHardening law{young, poisson, yield_stress, 10e9, 0.6};
  compare(
      law, 6e9, [](double p) { return yield_stress + 4e9 * p; }, [](double) { return 4e9; }, 3e-3);
}

TEST(Hardening, KinematicHardeningYieldsEarlyOnReversalInShear) {
  const CombinedHardening law{young, poisson, yield_stress, 10e9, 1};
  Point<CombinedHardening> point(law, density);
  const double mu = law.moduli().mu, shear_yield = yield_stress / std::sqrt(3.0);
  point.follow({{0, 0, 0, 1, 0, 0}, 0.01, 10});
  const double peak = point.stress.xy;
  // tau = tau_y + (H/3) gamma_p, gamma_p = gamma - tau / mu
  EXPECT_NEAR(peak, (shear_yield + 10e9 / 3 * 0.02) / (1 + 10e9 / 3 / mu), 1e-6 * peak);
  point.follow({{0, 0, 0, -1, 0, 0}, 0.999 * shear_yield / mu, 1});
  EXPECT_EQ(point.plastic.share, 1);
  point.follow({{0, 0, 0, -1, 0, 0}, 0.002 * shear_yield / mu, 1});
  EXPECT_LT(point.plastic.share, 1);  // 2 tau_y below the peak
}

TEST(Hardening, CowperSymondsDoublesTheFlowStressAtItsRate) {
  PowerLawPlasticity law{young, poisson, yield_stress, 0, 1, 40, 5};
  Point<PowerLawPlasticity> point(law, density);
  // pure shear at an equivalent rate of 40 / s, far into the plastic range
  point.follow({{0, 0, 0, 40 * std::sqrt(3.0) / 2, 0, 0}, 0.05 / 40, 50});
  EXPECT_NEAR(von_mises(point.stress), 2 * yield_stress, 1e-6 * yield_stress);
}

TEST(Hardening, CowperSymondsFollowsItsRateEquationThroughChangesOfRate) {
  compare_at_rates(VocePlasticity{young, poisson, yield_stress, 200e6, 40, 0, 100, 3}, 0,
                   [](double p) { return yield_stress + 200e6 * (1 - std::exp(-40 * p)); });
}

TEST(Hardening, CowperSymondsFollowsItsRateEquationOverATable) {
  TabulatedPlasticity law{young, poisson, {3, {0, 0.02, 0.06}, {yield_stress, 400e6, 450e6}}, 100, 3};
  compare_at_rates(law, 0, [](double p) {
    return p < 0.02 ? yield_stress + 5e9 * p : p < 0.06 ? 400e6 + 1.25e9 * (p - 0.02) : 450e6;
  });
}

TEST(Hardening, CowperSymondsFollowsItsRateEquationAboutABackStress) {
  // 40 % of 5 GPa widen the surface, and grow with the rate; the back stress does not.
  compare_at_rates(CombinedHardening{young, poisson, yield_stress, 5e9, 0.6, 100, 3}, 3e9,
                   [](double p) { return yield_stress + 2e9 * p; });
}

TEST(Hardening, LaneDoesNotDependOnItsNeighbours) {
  using Lanes = Pack<double>;
  constexpr int width = pack_size<double>;
  const CalledMaterial material =
      make_called_material(PowerLawPlasticity{young, poisson, yield_stress, 500e6, 0.3, 40, 5}, density);
  alignas(64) double rows[width];
  Lanes history[2] = {Lanes(0), Lanes(0)};
  for (int lane = 0; lane < width; ++lane) rows[lane] = 1e-3 * (lane - 1);
  const Lanes shear = load_pack(rows);
  PointStep<Lanes> step{
      {{Lanes(0), Lanes(0), Lanes(0), shear, Lanes(0), Lanes(0)}, Lanes(1e-5), Lanes(1), Lanes(1), Lanes(0), 0},
      {Lanes(0), Lanes(0), Lanes(0), Lanes(0), Lanes(0), Lanes(0)},
      history};
  material.update(step);
  alignas(64) double stress[width];
  store_pack(stress, step.stress.xy);
  for (int lane = 0; lane < width; ++lane) {
    double one_history[2] = {0, 0};
    PointStep<double> one{{{0, 0, 0, rows[lane], 0, 0}, 1e-5, 1, 1, 0, 0}, {}, one_history};
    material.update(one);
    EXPECT_EQ(stress[lane], one.stress.xy) << lane;
  }
}

}  // namespace
}  // namespace percuss::test::hardening_test
