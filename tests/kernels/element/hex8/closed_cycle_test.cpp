// What elements give back: a body that returns to its shape must have its energy back, or long vibrations gain some in
// every period. With rates that have no potential the work of a closed cycle is of the third power of its size, so that
// it grows beside the energy, which is of the second.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/element/hex8/hex8_full.hpp"
#include "kernels/material/elastic.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::closed_cycle_test {
namespace {

constexpr LameConstants moduli{1.5, 1.0};

struct Cycle {
  Corners start, first, second;  // x = start + size ((1 - cos t) first + sin t second)
};

Cycle make_cycle(int seed, bool is_linear) {
  Random random(static_cast<std::uint64_t>(seed));
  Cycle cycle{make_element(random, 1, 1, 1, 0), {}, {}};
  if (is_linear) {
    cycle.first = apply(random_matrix(random, 0.5), cycle.start);
    cycle.second = apply(random_matrix(random, 0.5), cycle.start);
  } else {
    for (auto* field : {&cycle.first, &cycle.second}) {
      for (auto* direction : {&field->x, &field->y, &field->z}) {
        for (double& value : *direction) value = 0.5 * random();
      }
    }
  }
  return cycle;
}

/// Places of the cycle at an angle, direction by direction.
Corners place(const Cycle& cycle, double size, double angle) {
  const double first = size * (1 - std::cos(angle)), second = size * std::sin(angle);
  Corners x{};
  for (int i = 0; i < 8; ++i) {
    x.x[i] = cycle.start.x[i] + first * cycle.first.x[i] + second * cycle.second.x[i];
    x.y[i] = cycle.start.y[i] + first * cycle.first.y[i] + second * cycle.second.y[i];
    x.z[i] = cycle.start.z[i] + first * cycle.first.z[i] + second * cycle.second.z[i];
  }
  return x;
}

Corners subtract(const Corners& a, const Corners& b) {
  Corners d{};
  for (int i = 0; i < 8; ++i) d.x[i] = a.x[i] - b.x[i], d.y[i] = a.y[i] - b.y[i], d.z[i] = a.z[i] - b.z[i];
  return d;
}

/// Work of one round on an element of an elastic material.
template <HexKind Kind>
double find_work(const Cycle& cycle, double size) {
  constexpr int steps = 1000;
  const SolidParameters<Elastic> par{{moduli.lambda, moduli.mu}, moduli.lambda, moduli.mu, 0.05, {0, 0}};
  auto state = make_state<Elastic, Kind>(1.0);
  Corners x = cycle.start, f{};
  double work = 0;
  for (int n = 1; n <= steps; ++n) {
    const Corners next = place(cycle, size, 2 * std::numbers::pi * n / steps), v = subtract(next, x);
    const auto result = advance_hex8(par, find_modes(next), find_modes(v), 1.0, state, {f.x, f.y, f.z});
    work += result.work.internal + result.work.hourglass;
    x = next;
  }
  return work;
}

/// Root of the mean square over random cycles, as a share of mu size^2 V, which is the size of the energy in them.
template <HexKind Kind>
double find_loss(double size, bool is_linear) {
  constexpr int cycles = 8;
  double square = 0;
  for (int seed = 1; seed <= cycles; ++seed) {
    const double work = find_work<Kind>(make_cycle(seed, is_linear), size);
    square += work * work / cycles;
  }
  return std::sqrt(square) / (moduli.mu * size * size);
}

/// Largest entry of a - b.
double find_difference(const Matrix3<double>& a, const Matrix3<double>& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector3<double> d = a.row[i] - b.row[i];
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

}  // namespace

// With the rate of Cauchy's stress 3.5e-2 at 0.02, and half of it at 0.01.
TEST(ClosedCycle, OfLinearMotionGivesNothingInTheLowerOrders) {
  EXPECT_LT(find_loss<HexKind::assumed_strain>(0.02, true), 5e-7);
  EXPECT_GT(find_loss<HexKind::assumed_strain>(0.08, true) / find_loss<HexKind::assumed_strain>(0.04, true), 14);
  EXPECT_LT(find_loss<HexKind::full>(0.02, true), 5e-7);
}

// With assumed strains of the shape of now 8.6e-3 at 0.02, in the first power of the size.
TEST(ClosedCycle, OfAnyMotionGivesNothingInTheFirstOrderWithAssumedStrain) {
  EXPECT_LT(find_loss<HexKind::assumed_strain>(0.02, false), 1.2e-4);
  EXPECT_GT(find_loss<HexKind::assumed_strain>(0.04, false) / find_loss<HexKind::assumed_strain>(0.02, false), 3.7);
}

// Before, 7.6e-3 and 1.4e-2.
TEST(ClosedCycle, OfAnyMotionGivesLittleWithTheOtherKinds) {
  EXPECT_LT(find_loss<HexKind::stiffness>(0.02, false), 1.5e-3);
  EXPECT_LT(find_loss<HexKind::full>(0.02, false), 4e-3);
}

TEST(ElasticStress, TimesTheVolumeGrowsByTheElasticIncrement) {
  const Symmetric3<double> stress{0.3, -0.2, 0.1, 0.05, -0.07, 0.02}, de{0.01, -0.02, 0.005, 0.003, 0.001, -0.004};
  const double j = 0.9, next = 0.88;
  const Symmetric3<double> after = stress + find_cauchy_increment(moduli, stress, de, {next - j, 1 / next});
  const Symmetric3<double> expected = j * stress + find_elastic_increment(moduli, de);
  EXPECT_NEAR(next * after.xx, expected.xx, 1e-16);
  EXPECT_NEAR(next * after.yz, expected.yz, 1e-16);
}

// Compression by 0.4 along x: the pressure of that direction adds to what the material resists.
TEST(ElasticStress, StiffensWithPressureAndWithTheDensity) {
  const Moduli<double> found = find_elastic_moduli(moduli, bound_pressure<double>({-0.4, 0, 0, 0, 0, 0}), 1.25);
  EXPECT_NEAR(found.lambda, 1.25 * moduli.lambda, 1e-15);
  EXPECT_NEAR(found.mu, 1.25 * moduli.mu + 0.2, 1e-15);
  EXPECT_EQ(bound_pressure<double>({0.4, 0.1, 0.1, 0, 0, 0}), 0);
  EXPECT_EQ(bound_by_rows<double>({0.5, 0.25, 0, -0.125, 0, 0.0625}), 0.6875);
}

TEST(StartShape, HasTheMetricAndTheVolumeOfTheStart) {
  Random random(3);
  const Corners start = make_element(random, 1, 0.7, 1.3, 0);
  const Matrix3<double> growth = identity_matrix<double>() + random_matrix(random, 0.3);
  Polar<double> polar{find_rotation_factor(growth), {}};
  polar.stretch = symmetric_product(growth, polar.rotation);
  // the factor of growth is a few digits short of exact: what counts is V R
  const Matrix3<double> f = full(polar.stretch) * polar.rotation;
  const VectorModes<double> a = find_modes(start), now = find_modes(apply(f, start));
  const StartShape<double> found = find_start_shape(now, polar.stretch, find_volume_gradient(now).volume);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.axes.square[k], dot(a[1 + k], a[1 + k]), 1e-12);
  for (const double product : found.axes.product) EXPECT_NEAR(product, 0, 1e-12);
  EXPECT_NEAR(found.volume, 1 * 0.7 * 1.3, 1e-14);
  EXPECT_NEAR(dot(found.axes.g[0], now[1]), dot(a[1], a[1]), 1e-12);
}

TEST(ForceIncrement, CarriesGradientsAsTheStepCarriesPlaces) {
  Random random(4);
  const Matrix3<double> l = random_matrix(random, 0.4), one = identity_matrix<double>();
  const Matrix3<double> f = inverse(one + (-0.5) * l) * (one + 0.5 * l);
  EXPECT_LT(find_difference(transpose(f) * find_force_increment(l, 1.0), one), 1e-15);
}

}  // namespace percuss::test::closed_cycle_test
