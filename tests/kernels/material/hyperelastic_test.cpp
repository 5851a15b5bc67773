// Materials whose stress follows from the deformation, against their closed forms.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/kernels/material/point_driver.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::hyperelastic_test {
namespace {

[[maybe_unused]] const bool has_samples =
    provide_sample<NeoHookean>({3e6, 0.4}) && provide_sample<MooneyRivlin>({0.4e6, 0.1e6, 20e6}) &&
    provide_sample<Yeoh>({0.4e6, -0.02e6, 0.01e6, 20e6}) && provide_sample<ArrudaBoyce>({0.8e6, 3, 20e6}) &&
    provide_sample<Viscoelastic>({1e9, 1e7, {2, {0.01, 0.2}, {5e7, 2e7}}, {1, {0.05}, {4e8}}});

Matrix3<double> turn_about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

/// Simple shear F = I + g e_x e_y in steps: the rotation of its polar decomposition is -atan(g / 2). Returns the Cauchy
/// stress in space.
template <class Law>
Symmetric3<double> shear(const Law& law, double g, int steps) {
  Point<Law> point(law, 1000);
  const double dg = g / steps;
  for (int i = 0; i < steps; ++i) {
    const Matrix3<double> r = turn_about_z(-std::atan((i + 0.5) * dg / 2));
    point.advance(pull_back(r, Symmetric3<double>{0, 0, 0, dg / 2, 0, 0}), 1e-3);
  }
  return push_forward(turn_about_z(-std::atan(g / 2)), point.stress);
}

}  // namespace

TEST(NeoHookean, SimpleShearOfTwoHasItsClosedForm) {
  const NeoHookean law{3e6, 0.4};
  const double mu = law.moduli().mu, g = 2;
  // B - I = g^2 e_x e_x + g (e_x e_y + e_y e_x)
  const Symmetric3<double> expected{mu * g * g, 0, 0, mu * g, 0, 0};
  EXPECT_LT(largest_difference(shear(law, g, 400), expected), 2e-4 * mu);
  // second order in the step
  const double coarse = largest_difference(shear(law, g, 50), expected),
               fine = largest_difference(shear(law, g, 100), expected);
  EXPECT_NEAR(coarse / fine, 4, 0.5);
}

TEST(NeoHookean, VolumeChangeHasItsClosedForm) {
  const NeoHookean law{3e6, 0.4};
  const LameConstants c = law.moduli();
  for (const double stretch : {0.8, 1.3}) {
    Point<NeoHookean> point(law, 1000);
    const double log_stretch = std::log(stretch), j = std::pow(stretch, 3);
    point.follow({{log_stretch, log_stretch, log_stretch, 0, 0, 0}, 1, 50});
    EXPECT_NEAR(point.stress.xx, (c.mu * (stretch * stretch - 1) + c.lambda * std::log(j)) / j, 1e-8 * c.mu);
  }
}

TEST(NeoHookean, TellsTheModuliOfSmallStrains) {
  const NeoHookean law{3e6, 0.4};
  Point<NeoHookean> point(law, 1000);
  point.advance({}, 1e-3);
  EXPECT_NEAR(point.modulus, law.moduli().lambda + 2 * law.moduli().mu, 1e-9 * point.modulus);
}

TEST(NeoHookean, BoundsTheStiffnessOfWavesAlongAPulledBar) {
  const NeoHookean law{3e6, 0.4};
  for (const double stretch : {0.5, 0.9, 1.5, 2.5}) {
    Point<NeoHookean> point(law, 1000);
    point.follow({{std::log(stretch), 0, 0, 0, 0, 0}, 1, 200});
    const double before = point.stress.xx, d = 1e-6, modulus = point.modulus;
    point.advance({d, 0, 0, 0, 0, 0}, 1e-6);
    // rho c^2 = d sigma_xx / d ln(stretch) at a fixed cross-section
    EXPECT_GT(modulus, (point.stress.xx - before) / d * (1 - 1e-5)) << stretch;
  }
}

TEST(MooneyRivlin, IncompressibleTensionHasItsClosedForm) {
  const MooneyRivlin law{0.4e6, 0.1e6, 1e9};
  for (const double stretch : {0.6, 2.0}) {
    Point<MooneyRivlin> point(law, 1000);
    const double rate = std::log(stretch);
    point.follow({{rate, -rate / 2, -rate / 2, 0, 0, 0}, 1, 100});
    const double expected = 2 * (stretch * stretch - 1 / stretch) * (law.c10 + law.c01 / stretch);
    // the midpoint rule for the stretch: (ln 2 / 100)^2 / 12 of strain
    EXPECT_NEAR(point.stress.xx - point.stress.yy, expected, 1e-5 * std::abs(expected));
  }
}

TEST(MooneyRivlin, SimpleShearHasItsClosedForm) {
  const MooneyRivlin law{0.4e6, 0.1e6, 1e9};
  const double g = 1.5;
  const Symmetric3<double> stress = shear(law, g, 400);
  // sigma_xy = 2 (c10 + c01) g; normal differences 2 c10 g^2 and 2 c01 g^2
  EXPECT_NEAR(stress.xy, 2 * 0.5e6 * g, 2e-4 * 0.5e6);
  EXPECT_NEAR(stress.xx - stress.zz, 2 * law.c10 * g * g, 5e-4 * 0.5e6);
  EXPECT_NEAR(stress.zz - stress.yy, 2 * law.c01 * g * g, 5e-4 * 0.5e6);
}

TEST(Yeoh, IncompressibleTensionHasItsClosedForm) {
  const Yeoh law{0.4e6, -0.02e6, 0.01e6, 1e9};
  for (const double stretch : {0.6, 2.0}) {
    Point<Yeoh> point(law, 1000);
    const double rate = std::log(stretch), i = stretch * stretch + 2 / stretch - 3;
    point.follow({{rate, -rate / 2, -rate / 2, 0, 0, 0}, 1, 100});
    const double slope = law.c10 + 2 * law.c20 * i + 3 * law.c30 * i * i;
    const double expected = 2 * (stretch * stretch - 1 / stretch) * slope;
    EXPECT_NEAR(point.stress.xx - point.stress.yy, expected, 1e-4 * std::abs(expected));
  }
}

TEST(ArrudaBoyce, FollowsTheChainsOfEightUpToHalfOfTheirLocking) {
  const double mu = 0.8e6, locking = 6;
  const ArrudaBoyce law = ArrudaBoyce::make({mu, locking, 1e9});
  for (const double stretch : {0.7, 2.5}) {
    Point<ArrudaBoyce> point(law, 1000);
    const double rate = std::log(stretch);
    point.follow({{rate, -rate / 2, -rate / 2, 0, 0, 0}, 1, 200});
    // the inverse Langevin function, of which the five terms are the beginning: L(x) = coth x - 1 / x = chain / locking
    const double chain = std::sqrt((stretch * stretch + 2 / stretch) / 3), wanted = chain / locking;
    double low = 1e-6, high = 100;
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (low + high);
      (1 / std::tanh(middle) - 1 / middle < wanted ? low : high) = middle;
    }
    const double expected = mu * locking / (3 * chain) * low * (stretch * stretch - 1 / stretch);
    EXPECT_NEAR(point.stress.xx - point.stress.yy, expected, 1e-3 * std::abs(expected)) << stretch;
  }
}

template <class Law>
void expect_bounded_waves(const Law& law) {
  for (const double stretch : {0.5, 0.9, 1.5, 2.5}) {
    Point<Law> point(law, 1000);
    point.follow({{std::log(stretch), 0, 0, 0, 0, 0}, 1, 200});
    const double before = point.stress.xx, d = 1e-6, modulus = point.modulus;
    point.advance({d, 0, 0, 0, 0, 0}, 1e-6);
    EXPECT_GT(modulus, (point.stress.xx - before) / d * (1 - 1e-5)) << stretch;
  }
}

TEST(Yeoh, BoundsTheStiffnessOfWavesAlongAPulledBar) { expect_bounded_waves(Yeoh{0.4e6, -0.02e6, 0.01e6, 20e6}); }

TEST(ArrudaBoyce, BoundsTheStiffnessOfWavesAlongAPulledBar) {
  expect_bounded_waves(ArrudaBoyce::make({0.8e6, 3, 20e6}));
}

TEST(ArrudaBoyce, TellsTheShearModulusOfSmallStrains) {
  const double square = 3 * 3;  // of the locking stretch
  const double expected = 0.8e6 * (1 + 3 / (5 * square) + 99 / (175 * square * square) +
                                   513 / (875 * std::pow(square, 3)) + 42039 / (67375 * std::pow(square, 4)));
  EXPECT_NEAR(ArrudaBoyce::make({0.8e6, 3, 20e6}).moduli().mu, expected, 1e-12 * expected);
}

TEST(Viscoelastic, RelaxesAfterASuddenShear) {
  Viscoelastic law{};
  law.bulk_modulus = 1e9;
  law.long_term_shear_modulus = 1e6;
  law.relaxation = {2, {1e-3, 1e-1}, {3e6, 2e6}};
  Point<Viscoelastic> point(law, 1000);
  EXPECT_NEAR(law.moduli().mu, 6e6, 1e-6);
  point.follow({{0, 0, 0, 0.01 / 1e-9, 0, 0}, 1e-9, 1});
  EXPECT_NEAR(point.stress.xy, 2 * 6e6 * 0.01, 1e-5 * 12e4);
  for (const double time : {1e-3, 1e-2, 0.2}) {
    point.follow({{}, time - point.time, 7});
    const double modulus = 1e6 + 3e6 * std::exp(-time / 1e-3) + 2e6 * std::exp(-time / 1e-1);
    EXPECT_NEAR(point.stress.xy, 2 * modulus * 0.01, 1e-5 * 12e4);
  }
}

TEST(Viscoelastic, ConstantRateIsExactWhateverTheStep) {
  Viscoelastic law{};
  law.bulk_modulus = 1e9;
  law.relaxation = {1, {1e-3}, {3e6}};
  for (const int steps : {1, 7, 100000}) {
    Point<Viscoelastic> point(law, 1000);
    point.follow({{30, 0, 0, 0, 0, 0}, 2e-3, steps});
    const double deviatoric = 2 * 3e6 * 20 * 1e-3 * (1 - std::exp(-2.0));
    EXPECT_NEAR(point.stress.xx, 1e9 * 0.06 + deviatoric, 1e-9 * 1e9 * 0.06);
    EXPECT_NEAR(point.stress.xx - point.stress.yy, 1.5 * deviatoric, 1e-9 * 1e9 * 0.06);
  }
}

TEST(Viscoelastic, RelaxesInVolumeAfterASuddenCompression) {
  Viscoelastic law{};
  law.bulk_modulus = 2e7;
  law.long_term_shear_modulus = 1e6;
  law.bulk_relaxation = {2, {1e-3, 1e-1}, {3e7, 1e7}};
  Point<Viscoelastic> point(law, 1000);
  EXPECT_NEAR(law.moduli().lambda, 6e7 - 2.0 / 3.0 * 1e6, 1e-6);
  point.follow({{-0.01 / 1e-9, -0.01 / 1e-9, -0.01 / 1e-9, 0, 0, 0}, 1e-9, 1});
  EXPECT_NEAR(point.stress.xx, -0.03 * 6e7, 1e-5 * 18e5);
  for (const double time : {1e-3, 1e-2, 0.2}) {
    point.follow({{}, time - point.time, 7});
    const double modulus = 2e7 + 3e7 * std::exp(-time / 1e-3) + 1e7 * std::exp(-time / 1e-1);
    EXPECT_NEAR(point.stress.xx, -0.03 * modulus, 1e-5 * 18e5);
    EXPECT_NEAR(point.stress.xx, point.stress.zz, 1e-9 * 18e5);
  }
}

TEST(Viscoelastic, BothPartsAtAConstantRateAreExactWhateverTheStep) {
  Viscoelastic law{};
  law.bulk_modulus = 2e7;
  law.relaxation = {6, {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 1}, {1e6, 2e6, 3e6, 4e6, 5e6, 6e6}};
  law.bulk_relaxation = {1, {2e-3}, {3e7}};
  const double rate = 5, time = 4e-3;
  for (const int steps : {1, 9}) {
    Point<Viscoelastic> point(law, 1000);
    point.follow({{rate, 0, 0, 0, 0, 0}, time, steps});
    const double mean = rate * (2e7 * time + 3e7 * 2e-3 * (1 - std::exp(-2.0)));
    double deviator = 0;
    for (int i = 0; i < 6; ++i) {
      const double tau = law.relaxation.x[i];
      deviator += 2 * law.relaxation.y[i] * rate * 2 / 3 * tau * (1 - std::exp(-time / tau));
    }
    EXPECT_NEAR(trace(point.stress) / 3, mean, 1e-9 * mean);
    EXPECT_NEAR(point.stress.xx, mean + deviator, 1e-9 * mean);
  }
}

TEST(PrincipalAxes, PutTheTensorTogetherAgain) {
  for (const Symmetric3<double>& a : {Symmetric3<double>{2, 1, 3, 0.3, -0.7, 0.1}, Symmetric3<double>{1, 1, 1, 0, 0, 0},
                                      Symmetric3<double>{1, 1, 5, 1e-9, 0, 2}, Symmetric3<double>{0, 0, 0, 1, 1, 1}}) {
    const PrincipalAxes<double> axes = find_principal_axes(a);
    Symmetric3<double> sum{};
    for (int i = 0; i < 3; ++i) {
      const Vector3<double>& n = axes.direction[i];
      sum = sum + axes.value[i] * Symmetric3<double>{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
      EXPECT_NEAR(norm(n), 1, 1e-14);
    }
    EXPECT_LT(largest_difference(sum, a), 1e-14 * 6);
  }
}

}  // namespace percuss::test::hyperelastic_test
