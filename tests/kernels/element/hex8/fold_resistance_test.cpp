// Resistance to folding against its own energy, and its step bound against the true largest eigenvalue.

#include "kernels/element/hex8/fold_resistance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::fold_resistance_test {

namespace {

constexpr FoldRule<double> rule{3.0, 0.2};

FoldForces<double> find_forces(const VectorModes<double>& a) {
  const VolumeGradient<double> b = find_volume_gradient(a);
  const EdgeField<double> edges = find_edges(a);
  return find_fold_forces(rule, edges, find_corner_shares(edges, b.volume), b);
}

double find_least_share(const VectorModes<double>& a) {
  return find_smallest_share(find_corner_shares(find_edges(a), find_volume_gradient(a).volume));
}

/// Forces by corner from those by mode.
Corners find_corner_forces(const VectorModes<double>& modes) {
  Corners f{};
  for (int m = 1; m < 8; ++m) f.x[m] = modes[m].x, f.y[m] = modes[m].y, f.z[m] = modes[m].z;
  to_corners(f.x);
  to_corners(f.y);
  to_corners(f.z);
  return f;
}

/// Not a conditional expression of arrays: GCC 12 takes the wrong one under its sanitizers.
double& find_place(Corners& c, int i) {
  double* const coordinates[] = {c.x, c.y, c.z};
  return coordinates[i / 8][i % 8];
}

/// A distorted brick, one corner of which is pushed towards its opposite one until its share is about `share`.
Corners make_folding_element(Random& random, double distortion, double share) {
  Corners c = make_element(random, 1, std::pow(4.0, random()), std::pow(4.0, random()), distortion);
  const int corner = static_cast<int>(3.999 + 4 * random()), opposite = (corner + 2) % 4 + (corner < 4 ? 4 : 0);
  const Corners start = c;
  double low = 0, high = 1;
  for (int n = 0; n < 40; ++n) {
    const double middle = (low + high) / 2;
    for (int k = 0; k < 3; ++k) {
      const int at = corner + 8 * k, to = opposite + 8 * k;
      Corners from = start;
      find_place(c, at) = find_place(from, at) + middle * (find_place(from, to) - find_place(from, at));
    }
    (find_least_share(find_modes(c)) > share ? low : high) = middle;
  }
  return c;
}

}  // namespace

TEST(FoldResistance, EdgesAreThoseOfTheCornersAndForcesTheirTranspose) {
  Random random(3);
  const Corners c = make_element(random, 1, 2, 3, 0.2);
  const EdgeField<double> edges = find_edges(find_modes(c));
  // corners 0 ---, 1 +--, 2 ++-, 3 -+-, 4 --+, 5 +-+, 6 +++, 7 -++
  EXPECT_NEAR(edges.along[0][0].x, c.x[1] - c.x[0], 1e-15);
  EXPECT_NEAR(edges.along[0][1].x, c.x[2] - c.x[3], 1e-15);  // eta = +1
  EXPECT_NEAR(edges.along[0][2].y, c.y[5] - c.y[4], 1e-15);  // zeta = +1
  EXPECT_NEAR(edges.along[1][1].z, c.z[7] - c.z[4], 1e-15);  // zeta = +1
  EXPECT_NEAR(edges.along[1][2].z, c.z[2] - c.z[1], 1e-15);  // xi = +1
  EXPECT_NEAR(edges.along[2][1].z, c.z[5] - c.z[1], 1e-15);  // xi = +1
  EXPECT_NEAR(edges.along[2][2].z, c.z[7] - c.z[3], 1e-15);  // eta = +1
  EdgeField<double> g;
  double power = 0, by_mode = 0;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 4; ++i) {
      g.along[k][i] = {random(), random(), random()};
      power += dot(g.along[k][i], edges.along[k][i]);
    }
  }
  const VectorModes<double> f = gather_edge_forces(g), a = find_modes(c);
  for (int m = 1; m <= 7; ++m) by_mode += dot(f[m], a[m]);
  EXPECT_NEAR(by_mode, power, 1e-13);
}

TEST(FoldResistance, ShareOfACornerIsItsTripleProductOverTheVolume) {
  Random random(5);
  Corners c = make_element(random, 1, 1, 1, 0);
  EXPECT_NEAR(find_least_share(find_modes(c)), 1, 1e-14);
  // Corner 6 of a unit cube moved by d along the diagonal: J = 1 - 3 d there, V = 1 - 3 d / 4 + ..., exactly below.
  const double d = 0.25;
  c.x[6] -= d, c.y[6] -= d, c.z[6] -= d;
  const double volume = find_volume_gradient(find_modes(c)).volume;
  EXPECT_NEAR(find_least_share(find_modes(c)), (1 - 3 * d) / volume, 1e-14);
}

TEST(FoldResistance, ForceIsTheGradientOfTheEnergy) {
  Random random(7);
  for (int n = 0; n < 200; ++n) {
    Corners c = make_folding_element(random, 0.15, 0.1 + 0.25 * random());
    const Corners f = find_corner_forces(find_forces(find_modes(c)).mode);
    Corners copy = f;
    double size = 0;
    for (int i = 0; i < 24; ++i) size = std::max(size, std::abs(find_place(copy, i)));
    for (int i = 0; i < 24; ++i) {
      const double place = find_place(c, i), h = 1e-6;
      find_place(c, i) = place + h;
      const double high = find_forces(find_modes(c)).energy;
      find_place(c, i) = place - h;
      const double low = find_forces(find_modes(c)).energy;
      find_place(c, i) = place;
      EXPECT_NEAR(find_place(copy, i), (high - low) / (2 * h), 1e-5 * size + 1e-9);  // second order, round-off
    }
  }
}

TEST(FoldResistance, NothingAboveTheThresholdNoMomentumNoMoment) {
  Random random(9);
  int acting = 0;
  for (int n = 0; n < 400; ++n) {
    const Corners c = make_folding_element(random, 0.15, 0.2 + 0.2 * random());
    const VectorModes<double> a = find_modes(c);
    const FoldForces<double> forces = find_forces(a);
    const Corners f = find_corner_forces(forces.mode);
    if (find_least_share(a) >= rule.threshold) {
      EXPECT_EQ(forces.energy, 0);
      for (int i = 0; i < 8; ++i) EXPECT_TRUE(f.x[i] == 0 && f.y[i] == 0 && f.z[i] == 0);
      continue;
    }
    ++acting;
    EXPECT_GT(forces.energy, 0);
    double sum = 0, moment = 0, size = 0;
    for (int i = 0; i < 8; ++i) {
      sum += f.x[i];
      moment += c.x[i] * f.y[i] - c.y[i] * f.x[i];
      size += std::abs(f.x[i]) + std::abs(f.y[i]);
    }
    EXPECT_NEAR(sum, 0, 1e-15 * size);
    EXPECT_NEAR(moment, 0, 1e-14 * size);
  }
  EXPECT_GT(acting, 100);
}

TEST(FoldResistance, TurnsWithTheElementAndIgnoresUniformDeformation) {
  Random random(11);
  const double angle = 1.1, s = std::sin(angle), t = std::cos(angle);
  for (int n = 0; n < 50; ++n) {
    const Corners c = make_folding_element(random, 0.1, 0.05);
    Corners turned = c, stretched = c;
    for (int i = 0; i < 8; ++i) {
      turned.x[i] = t * c.x[i] - s * c.y[i], turned.y[i] = s * c.x[i] + t * c.y[i];
      stretched.x[i] = 0.5 * c.x[i] + 0.7 * c.y[i], stretched.y[i] = 1.5 * c.y[i];
    }
    const FoldForces<double> one = find_forces(find_modes(c)), other = find_forces(find_modes(turned));
    const Corners f = find_corner_forces(one.mode), g = find_corner_forces(other.mode);
    EXPECT_NEAR(other.energy, one.energy, 1e-13 * one.energy + 1e-16);
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(g.x[i], t * f.x[i] - s * f.y[i], 1e-13);
    EXPECT_NEAR(find_least_share(find_modes(stretched)), find_least_share(find_modes(c)), 1e-13);
  }
}

TEST(FoldResistance, WorkOfAStepIsTheTrapezoidOfItsForces) {
  Random random(13);
  const Corners c = make_folding_element(random, 0.1, 0.1);
  const VectorModes<double> start = find_modes(c);
  Corners rate{};
  for (int i = 0; i < 24; ++i) find_place(rate, i) = random();
  const VectorModes<double> v = find_modes(rate);
  const double dt = 1e-2;
  VectorModes<double> end;
  double work = 0;
  for (int m = 1; m <= 7; ++m) end[m] = start[m] + dt * v[m];
  const FoldForces<double> before = find_forces(start), after = find_forces(end);
  for (int m = 1; m <= 7; ++m) work += 0.5 * dt * dot(before.mode[m] + after.mode[m], v[m]);
  const FoldStep<double> step = resist_folding(rule, {end, v, dt});
  EXPECT_NEAR(step.work, work, 1e-12 * std::abs(work));
  EXPECT_NEAR(step.work, after.energy - before.energy, 1e-2 * std::abs(work));
  EXPECT_DOUBLE_EQ(step.depth, rule.threshold - find_least_share(end));
}

TEST(FoldResistance, StiffnessBoundIsAboveTheLargestEigenvalueOfTheHessian) {
  Random random(17);
  double tightest = 0;
  for (int n = 0; n < 300; ++n) {
    const Corners c = make_folding_element(random, 0.2 * std::abs(random()), 0.05 + 0.14 * random());
    Corners rest{};
    const double bound = resist_folding(rule, {find_modes(c), find_modes(rest), 0.0}).stiffness;
    Corners v{};
    for (int i = 0; i < 24; ++i) find_place(v, i) = random();
    double value = 0;
    for (int k = 0; k < 60; ++k) {  // the power iteration, shifted by the bound so that negative ones do not win
      double size = 0, product = 0;
      for (int i = 0; i < 24; ++i) size += find_place(v, i) * find_place(v, i);
      const double h = 1e-7;
      Corners high = c, low = c;
      for (int i = 0; i < 24; ++i) {
        find_place(v, i) /= std::sqrt(size);
        find_place(high, i) += h * find_place(v, i);
        find_place(low, i) -= h * find_place(v, i);
      }
      Corners f = find_corner_forces(find_forces(find_modes(high)).mode);
      Corners g = find_corner_forces(find_forces(find_modes(low)).mode);
      for (int i = 0; i < 24; ++i) {
        const double column = (find_place(f, i) - find_place(g, i)) / (2 * h);
        product += find_place(v, i) * column;
        find_place(v, i) = column + bound * find_place(v, i);
      }
      value = product;
    }
    EXPECT_LE(value, bound * (1 + 1e-6)) << n;
    tightest = std::max(tightest, value / bound);
  }
  EXPECT_GT(tightest, 0.3);
}

TEST(FoldResistance, StepCountsTheStiffnessBesideThatOfTheElement) {
  // undamped: 1 / dt^2 = 1 / step^2 + 8 k / (4 m) would do; the bound is below it and above the smaller of the two over
  // 2
  const double step = 0.3, mass = 2, stiffness = 5;
  const double joined = join_fold_step(step, stiffness, mass);
  EXPECT_LT(joined, 1 / std::sqrt(1 / (step * step) + 2 * stiffness / mass));
  EXPECT_NEAR(joined / step + 2 * stiffness / mass * joined * joined, 1, 1e-14);
  EXPECT_DOUBLE_EQ(join_fold_step(step, 0.0, mass), step);
}

TEST(FoldResistance, AnElementWithAFoldingCornerIsOblique) {
  Random random(19);
  for (int n = 0; n < 4000; ++n) {
    const VectorModes<double> a =
        find_modes(make_folding_element(random, 0.45 * std::abs(random()), 0.18 + 0.05 * random()));
    const VolumeGradient<double> b = find_volume_gradient(a);
    if (!(b.volume > 0)) continue;
    EXPECT_GT(find_obliqueness(a, find_gradient_size(b), b.volume), unfolded_obliqueness);
  }
}

}  // namespace percuss::test::fold_resistance_test
