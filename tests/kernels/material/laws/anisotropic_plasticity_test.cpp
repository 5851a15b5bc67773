// Hill's plasticity of solids against its closed forms and against von Mises plasticity.

#include "kernels/material/laws/anisotropic_plasticity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::anisotropic_plasticity_test {
namespace {

[[maybe_unused]] const bool has_samples = provide_sample<AnisotropicPlasticity>(
    with_oblique_axes(AnisotropicPlasticityConstants{10e9, 0.3, {2, {0, 0.1}, {20e6, 60e6}}, {0.7, 1.6, 1.1}}));

constexpr double yield = 200, slope = 100;

AnisotropicPlasticityConstants make_constants() {
  AnisotropicPlasticityConstants c;
  c.youngs_modulus = 70e3;
  c.poissons_ratio = 0.3;
  c.hardening = {2, {0, 1}, {yield, yield + slope}};
  return c;
}

}  // namespace

TEST(AnisotropicPlasticity, IsMisesPlasticityWhereAllRatiosAreOne) {
  AnisotropicPlasticityConstants c = make_constants();
  const double first[3] = {1, 2, 0.5};
  for (int k = 0; k < 3; ++k) c.first_axis[k] = first[k];
  Point<AnisotropicPlasticity> a(AnisotropicPlasticity::make(c), 1);
  Point<J2Plasticity> b(J2Plasticity::make({70e3, 0.3, yield, slope}), 1);
  const Leg legs[] = {{{1, -0.3, 0.2, 0.4, -0.2, 0.1}, 0.05, 20}, {{-1, 0.5, 0.1, 0.4, 0.9, -0.4}, 0.1, 30}};
  for (const Leg& leg : legs) {
    a.follow(leg);
    b.follow(leg);
    EXPECT_LT(largest_difference(a.stress, b.stress), 1e-10 * yield);
    EXPECT_NEAR(a.p(), b.p(), 1e-12);
    EXPECT_NEAR(a.plastic.flow_stress, b.plastic.flow_stress, 1e-10 * yield);
  }
  EXPECT_GT(a.p(), 0.1);
}

TEST(AnisotropicPlasticity, YieldsByItsSixRatios) {
  // At constant volume along one mode the stress is a multiple of the surface: shears, and each axis against the
  // others.
  AnisotropicPlasticityConstants c = make_constants();
  const double normal[3] = {0.9, 1.15, 1.05}, shear[3] = {1.1, 0.85, 0.95};
  for (int k = 0; k < 3; ++k) {
    c.yield_ratios[k] = normal[k];
    c.shear_yield_ratios[k] = shear[k];
  }
  const Strain shears[3] = {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  for (int k = 0; k < 3; ++k) {
    Point<AnisotropicPlasticity> point(AnisotropicPlasticity::make(c), 1);
    point.follow({shears[k], 0.02, 1});
    const Symmetric3<double>& s = point.stress;
    const double got = k == 0 ? s.xy : (k == 1 ? s.yz : s.zx);
    EXPECT_NEAR(got, shear[k] / std::sqrt(3.0) * (yield + slope * point.p()), 1e-9 * yield) << k;
  }
}

TEST(AnisotropicPlasticity, FlowsInTensionByItsStrainRatios) {
  // Uniaxial stress along axis 2, which lies along z of space: the lateral strains by Newton's method.
  AnisotropicPlasticityConstants c = make_constants();
  const double r[3] = {1.8, 1.2, 2.3}, first[3] = {1, 0, 0}, second[3] = {0, 0, 1};
  for (int k = 0; k < 3; ++k) {
    c.r_values[k] = r[k];
    c.first_axis[k] = first[k];
    c.second_axis[k] = second[k];
  }
  const AnisotropicPlasticity law = AnisotropicPlasticity::make(c);
  double p = 0;
  Symmetric3<double> stress{}, strain{};
  const auto advance = [&](const Strain& by, double& of) {
    PointStep<double> step{};
    step.motion.de = by;
    step.motion.dt = 1;
    step.stress = stress;
    step.history = &of;
    law.update(step);
    return step.stress;
  };
  for (int i = 0; i < 20; ++i) {
    Strain de{0, 0, 1e-3, 0, 0, 0};
    for (int iteration = 0; iteration < 40; ++iteration) {
      const auto look = [&](const Strain& by) {
        double other = p;
        return advance(by, other);
      };
      constexpr double d = 1e-8;
      const Symmetric3<double> at = look(de);
      if (std::abs(at.xx) + std::abs(at.yy) < 1e-9 * yield) break;
      const Symmetric3<double> x = look(de + Strain{d, 0, 0, 0, 0, 0}), y = look(de + Strain{0, d, 0, 0, 0, 0});
      const double a = (x.xx - at.xx) / d, b = (y.xx - at.xx) / d, e = (x.yy - at.yy) / d, f = (y.yy - at.yy) / d;
      const double over = 1 / (a * f - b * e);
      de.xx -= over * (f * at.xx - b * at.yy);
      de.yy -= over * (a * at.yy - e * at.xx);
    }
    stress = advance(de, p);
    strain = strain + de;
  }
  const double across_1 = std::sqrt(r[2] * (1 + r[0]) / (r[0] * (1 + r[2])));
  EXPECT_NEAR(stress.zz, across_1 * (yield + slope * p), 1e-8 * yield);
  const double lateral = 0.3 / 70e3 * stress.zz;
  EXPECT_NEAR((strain.xx + lateral) / (strain.yy + lateral), r[2], 1e-6 * r[2]);  // width along x, thickness along y
}

TEST(AnisotropicPlasticity, NamesWhatIsWrong) {
  AnisotropicPlasticityConstants c = make_constants();
  EXPECT_STREQ(c.find_fault(), "");
  c.r_values[1] = 0;
  EXPECT_STREQ(c.find_fault(), "r_values that are not positive");
  c = make_constants();
  c.exponent = 1;
  EXPECT_STREQ(c.find_fault(), "an exponent that is not between 2 and 40");
  c = make_constants();
  const double open[3] = {1, 1, 0.4};
  for (int k = 0; k < 3; ++k) c.yield_ratios[k] = open[k];
  EXPECT_STREQ(c.find_fault(), "yield ratios that no closed yield surface has (F G + G H + H F is not positive)");
  c.exponent = 8;
  EXPECT_STREQ(c.find_fault(), "yield_ratios with an exponent (they are Hill's: leave it 2)");
}

}  // namespace percuss::test::anisotropic_plasticity_test
