// The step estimate against the true largest eigenvalue of the element, found by power iteration on its own forces.

#include "kernels/element/stable_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/element/hex8.hpp"
#include "kernels/material/elastic.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test {

namespace {

constexpr double density = 1000;

/// K v of the element at rest: corner forces of an infinitesimal displacement v, through the element's own pieces.
Corners apply_stiffness(const HexParameters<Elastic>& par, const VectorModes<double>& a,
                        const VolumeGradient<double>& b, const Corners& v) {
  const VectorModes<double> vm = find_modes(v);
  const Matrix3<double> l = find_velocity_gradient(vm, b);
  Symmetric3<double> stress{};
  double none = 0;
  par.material.update(stress, &none, symmetric_part(l));
  HourglassModes<double> q = find_hourglass_rates(vm, a, l);
  const double kappa = find_hourglass_stiffness(find_gradient_size(b).trace, b.volume, par.mu, par.hourglass);
  for (auto& mode : q.mode) mode = kappa * mode;
  Corners f{};
  find_corner_forces(stress, q, a, b, f.x, f.y, f.z);
  return f;
}

double find_largest_frequency_square(const HexParameters<Elastic>& par, const Corners& c, double mass, Random& random) {
  const VectorModes<double> a = find_modes(c);
  const VolumeGradient<double> b = find_volume_gradient(a);
  Corners v{};
  for (int i = 0; i < 8; ++i) v.x[i] = random(), v.y[i] = random(), v.z[i] = random();
  double value = 0;
  for (int n = 0; n < 400; ++n) {
    const Corners f = apply_stiffness(par, a, b, v);
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
  const HexParameters<Elastic> par{{lambda, mu}, lambda, mu, 0.0, {0, 0}};
  EXPECT_NEAR(
      find_largest_frequency_square(par, c, mass, random) / find_frequency_square(g, b.volume, mass, lambda, mu), 1,
      1e-6);
}

TEST(StableStep, BoundHoldsForEveryShapeAndPoissonRatioTried) {
  Random random(2);
  double tightest = 0, loosest = 1;
  for (int k = 0; k < 600; ++k) {
    const double ey = std::pow(10.0, random()), ez = std::pow(10.0, random());
    const double distortion = 0.24 * std::abs(random());
    const Corners c = make_element(random, 1, ey, ez, distortion);
    const VolumeGradient<double> b = find_volume_gradient(find_modes(c));
    ASSERT_GT(b.volume, 0);
    const double poisson = 0.2 + 0.299 * random();
    const LameConstants m = find_lame_constants(1e9, poisson);
    const HexParameters<Elastic> par{{m.lambda, m.mu}, std::max(m.lambda, 0.0), m.mu, 0.05 + 0.05 * random(), {0, 0}};
    const double mass = density * b.volume;
    auto state = make_state<Elastic>(mass);
    Corners rest{};
    double fx[8], fy[8], fz[8];
    const double step = advance_hex8(par, find_modes(c), find_modes(rest), 0.0, state, fx, fy, fz).stable_step;
    const double used = step * std::sqrt(find_largest_frequency_square(par, c, mass, random)) / 2;
    ASSERT_LE(used, 1.0 + 1e-9) << "shape " << k << " ey " << ey << " ez " << ez << " nu " << poisson;
    tightest = std::max(tightest, used);
    if (distortion < 0.1) loosest = std::min(loosest, used);
  }
  EXPECT_GT(tightest, 0.97);
  EXPECT_GT(loosest, 0.6);
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

}  // namespace percuss::test
