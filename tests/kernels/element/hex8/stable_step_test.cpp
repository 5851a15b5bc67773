// The step estimate against the true largest eigenvalue of the element, found by power iteration on its own forces.

#include "kernels/element/hex8/stable_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/element/hex8/thick_shell.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::stable_step_test {

namespace {

constexpr double density = 1000;

/// K v of the element at rest: its own forces after an infinitesimal displacement. Stresses grow from zero, so that
/// what is left of the second order is 1e-8 of the first.
template <HexKind Kind, class Material>
Corners apply_stiffness(const SolidParameters<Material>& par, const Corners& c, double mass, const Corners& v) {
  auto state = make_state<Material, Kind>(mass, find_modes(c));
  Corners f{};
  const double dt = 1e-8;
  advance_hex8(par, find_modes(c), find_modes(v), dt, state, {f.x, f.y, f.z});
  for (int i = 0; i < 8; ++i) f.x[i] /= dt, f.y[i] /= dt, f.z[i] /= dt;
  return f;
}

template <HexKind Kind, class Material>
double find_largest_frequency_square(const SolidParameters<Material>& par, const Corners& c, double mass,
                                     Random& random) {
  Corners v{};
  for (int i = 0; i < 8; ++i) v.x[i] = random(), v.y[i] = random(), v.z[i] = random();
  double value = 0;
  for (int n = 0; n < 200; ++n) {
    const Corners f = apply_stiffness<Kind>(par, c, mass, v);
    double size = 0, product = 0, square = 0;
    for (int i = 0; i < 8; ++i) {
      product += v.x[i] * f.x[i] + v.y[i] * f.y[i] + v.z[i] * f.z[i];
      square += v.x[i] * v.x[i] + v.y[i] * v.y[i] + v.z[i] * v.z[i];
      size = std::max({size, std::abs(f.x[i]), std::abs(f.y[i]), std::abs(f.z[i])});
    }
    value = product / square;
    v = f;
    for (int i = 0; i < 8; ++i) v.x[i] /= size, v.y[i] /= size, v.z[i] /= size;
  }
  return 8 * value / mass;
}

Elastic make_material(const LameConstants& m, const Elastic*) { return {m.lambda, m.mu}; }
/// One that never yields.
J2Plasticity make_material(const LameConstants& m, const J2Plasticity*) { return {m.lambda, m.mu, 1e30, 0}; }

/// Compares the step bound of random elements (edge ratios to 100, Poisson's ratio -0.1 to 0.499) with the limit.
template <HexKind Kind, class Material>
void compare_bounds(double largest_distortion, int count) {
  Random random(2);
  double tightest = 0, loosest = 1;
  for (int k = 0; k < count; ++k) {
    const double ey = std::pow(10.0, random()), ez = std::pow(10.0, random());
    const double distortion = largest_distortion * std::abs(random());
    const Corners c = make_element(random, 1, ey, ez, distortion);
    const VolumeGradient<double> b = find_volume_gradient(find_modes(c));
    const double poisson = 0.2 + 0.299 * random();
    const LameConstants m = find_lame_constants(1e9, poisson);
    const SolidParameters<Material> par{make_material(m, static_cast<const Material*>(nullptr)),
                                        std::max(m.lambda, 0.0),
                                        m.mu,
                                        0.05 + 0.05 * random(),
                                        {0, 0}};
    const double mass = density * b.volume;
    auto state = make_state<Material, Kind>(mass, find_modes(c));
    Corners rest{};
    double fx[8], fy[8], fz[8];
    const HexResult<double> result = advance_hex8(par, find_modes(c), find_modes(rest), 0.0, state, {fx, fy, fz});
    if (!(result.size > 0)) continue;  // inverted in a corner
    const double used = result.stable_step * std::sqrt(find_largest_frequency_square<Kind>(par, c, mass, random)) / 2;
    ASSERT_LE(used, 1.0 + 1e-7) << "shape " << k << " ey " << ey << " ez " << ez << " nu " << poisson;
    tightest = std::max(tightest, used);
    if (distortion < 0.1) loosest = std::min(loosest, used);
  }
  EXPECT_GT(tightest, 0.95);
  EXPECT_GT(loosest, 0.6);
}

}  // namespace

TEST(StableStep, BoundIsExactForTheCubeWithoutShearCoupling) {
  // A cube of edge h: the triaxial mode has omega^2 = 8 (3 lambda + 2 mu) g / (rho V^2), g = h^4 / 2.
  const double h = 0.5, lambda = 3e9, mu = 2e9;
  Random random(1);
  const Corners c = make_element(random, h, h, h, 0);
  const VolumeGradient<double> b = find_volume_gradient(find_modes(c));
  const GradientSize<double> g = find_gradient_size(b);
  EXPECT_NEAR(g.largest / (h * h * h * h / 2), 1, 1e-14);
  EXPECT_NEAR(find_thickness(g, b.volume) / h, 1, 1e-14);
  const double mass = density * b.volume;
  EXPECT_NEAR(find_frequency_square(g, b.volume, mass, lambda, mu) / (4 * (3 * lambda + 2 * mu) / (density * h * h)), 1,
              1e-14);
  const SolidParameters<Elastic> par{{lambda, mu}, lambda, mu, 0.0, {0, 0}};
  EXPECT_NEAR(find_largest_frequency_square<HexKind::stiffness>(par, c, mass, random) /
                  find_frequency_square(g, b.volume, mass, lambda, mu),
              1, 1e-6);
}

TEST(StableStep, BoundHoldsForEveryShapeAndPoissonRatioWithAssumedStrain) {
  compare_bounds<HexKind::assumed_strain, Elastic>(0.24, 300);
}
TEST(StableStep, BoundHoldsForEveryShapeAndPoissonRatioWithTheGuardOfNearInvertedElements) {
  compare_bounds<HexKind::assumed_strain, J2Plasticity>(0.45, 300);
}
TEST(StableStep, BoundHoldsForEveryShapeAndPoissonRatioWithStiffness) {
  compare_bounds<HexKind::stiffness, Elastic>(0.24, 300);
}
TEST(StableStep, BoundHoldsForEveryShapeAndPoissonRatioWithFullIntegration) {
  compare_bounds<HexKind::full, Elastic>(0.24, 200);
}

TEST(StableStep, DampingShortensTheStepOfALaggedOscillator) {
  // x'' + rate x' + omega^2 x = 0 by central differences with v(n-1/2): the amplification at the limit is exactly -1.
  const double omega = 3, rate = 1.7;
  const double dt = find_stable_step(omega * omega, rate);
  const auto grows = [&](double step) {
    double x = 1, v = 0;
    for (int n = 0; n < 4000; ++n) {
      v += step * (-omega * omega * x - rate * v);
      x += step * v;
    }
    return std::abs(x) > 2 || std::abs(v) > 2 * omega;
  };
  EXPECT_FALSE(grows(0.999 * dt));
  EXPECT_TRUE(grows(1.01 * dt));
}

}  // namespace percuss::test::stable_step_test
