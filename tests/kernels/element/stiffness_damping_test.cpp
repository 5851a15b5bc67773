// Damping in proportion to stiffness of one element: its power, its symmetry, and the largest step that is stable.

#include "kernels/element/stiffness_damping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::stiffness_damping_test {
namespace {

constexpr double lambda = 3e9, mu = 2e9, density = 1000;

Corners damp(bool is_full, const DampingModuli& moduli, const Corners& x, const Corners& u) {
  Corners f{};
  if (is_full)
    find_full_damping(moduli, find_modes(x), find_modes(u), CornerForces<double>{f.x, f.y, f.z});
  else
    find_mean_damping(moduli, find_modes(x), find_modes(u), CornerForces<double>{f.x, f.y, f.z});
  return f;
}

double find_power(const Corners& f, const Corners& u) {
  double sum = 0;
  for (int i = 0; i < 8; ++i) sum += f.x[i] * u.x[i] + f.y[i] * u.y[i] + f.z[i] * u.z[i];
  return sum;
}

Corners make_random_velocities(Random& random) {
  Corners u{};
  for (int i = 0; i < 8; ++i) u.x[i] = random(), u.y[i] = random(), u.z[i] = random();
  return u;
}

}  // namespace

// At a uniform rate D the power is V (lambda (tr D)^2 + 2 mu D:D), times beta, with one point and with eight.
TEST(StiffnessDampingForces, OfAUniformRateHaveThePowerOfIt) {
  Random random(3);
  for (const bool is_full : {false, true}) {
    const Corners x = make_element(random, 1, 0.6, 1.7, 0.1);
    const Matrix3<double> gradient = random_matrix(random, 1);
    const Symmetric3<double> d = symmetric_part(gradient);
    const double volume = find_volume_gradient(find_modes(x)).volume;
    const Corners u = apply(gradient, x);
    const double power = find_power(damp(is_full, {lambda, mu}, x, u), u);
    const double expected = volume * (lambda * trace(d) * trace(d) + 2 * mu * contract(d, d));
    EXPECT_NEAR(power, expected, 1e-12 * expected);
  }
}

TEST(StiffnessDampingForces, TakeEnergyAndKeepMomenta) {
  Random random(5);
  for (int sample = 0; sample < 20; ++sample) {
    const bool is_full = sample % 2 == 1;
    const Corners x = make_element(random, 1, 0.6, 1.7, 0.2), u = make_random_velocities(random);
    const Corners f = damp(is_full, {lambda, mu}, x, u);
    double size = 0;
    Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
    for (int i = 0; i < 8; ++i) {
      const Vector3<double> force{f.x[i], f.y[i], f.z[i]};
      sum = sum + force;
      moment = moment + cross(Vector3<double>{x.x[i], x.y[i], x.z[i]}, force);
      size += norm(force);
    }
    EXPECT_GT(find_power(f, u), 0);
    EXPECT_LT(norm(sum), 1e-14 * size);
    EXPECT_LT(norm(moment), 1e-14 * size);
  }
}

// A cube that breathes is an oscillator whose frequency the element's bound has exactly. Central differences with a
// damping that lags half a step grow beyond find_damped_step(), and decay below it.
TEST(StiffnessDampingForces, AreStableUpToTheDampedStepAndNotBeyond) {
  const double edge = 0.5, mass = density * edge * edge * edge;
  Random random(7);
  const Corners x = make_element(random, edge, edge, edge, 0);
  const VolumeGradient<double> b = find_volume_gradient(find_modes(x));
  const double square = find_frequency_square(find_gradient_size(b), b.volume, mass, lambda, mu);
  const double undamped = find_stable_step(square, 0.0);
  for (const double xi : {0.01, 0.3, 1.0, 5.0}) {
    const double beta = 2 * xi / std::sqrt(square), bound = find_damped_step(undamped, beta);
    EXPECT_NEAR(bound, undamped * (std::sqrt(1 + xi * xi) - xi), 1e-14 * undamped);
    EXPECT_NEAR(bound, find_stable_step(square, beta * square), 1e-14 * undamped);
    for (const double share : {0.999, 1.001}) {
      const double dt = share * bound;
      double u = 1, v = 0, largest = 0;  // displacements u x, velocities v x
      for (int step = 0; step < 4000; ++step) {
        const auto force = [&](const DampingModuli& moduli, double by) {
          return damp(false, moduli, x, apply({{{by, 0, 0}, {0, by, 0}, {0, 0, by}}}, x)).x[6];
        };
        v -= dt * (force({lambda, mu}, u) + force({beta * lambda, beta * mu}, v)) / (mass / 8 * x.x[6]);
        u += dt * v;
        if (step >= 3900) largest = std::max(largest, std::abs(u));
      }
      EXPECT_EQ(largest > 10, share > 1) << xi << " " << share << " " << largest;
    }
  }
}

}  // namespace percuss::test::stiffness_damping_test
