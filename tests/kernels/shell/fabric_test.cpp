// The law of fabrics: Green's strain by threads that follow the membrane, and tension fields.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::fabric_test {
namespace {

using Three = std::array<double, 3>;

FabricLayer make_fabric(double warp, double weft, double shear, double poisson, bool no_compression, double share = 0) {
  FabricConstants c;
  c.warp_modulus = warp;
  c.weft_modulus = weft;
  c.shear_modulus = shear;
  c.poissons_ratio = poisson;
  c.no_compression = no_compression;
  c.compression_share = share;
  return FabricLayer::make(Fabric::make(c));
}

Three find_stress(const FabricLayer& layer, const Three& strain) {
  const double e[3] = {strain[0], strain[1], strain[2]};
  double s[3];
  layer.find_stress(e, s);
  return {s[0], s[1], s[2]};
}

double find_energy(const Three& s, const Three& e) { return 0.5 * (s[0] * e[0] + s[1] * e[1]) + s[2] * e[2]; }

/// The largest energy of tension along any of many directions; 0 if none is stretched.
double find_largest_energy(double warp, double weft, double shear, double poisson, const Three& e) {
  constexpr int directions = 20000;
  double largest = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = i * std::acos(-1.0) / directions, c = std::cos(angle), s = std::sin(angle);
    const double strain = c * c * e[0] + 2 * c * s * e[2] + s * s * e[1];
    const double compliance =
        std::pow(c, 4) / warp + std::pow(s, 4) / weft + (1 / shear - 2 * poisson / warp) * c * c * s * s;
    if (strain > 0) largest = std::max(largest, 0.5 * strain * strain / compliance);
  }
  return largest;
}

/// A membrane of fabric whose warp has an angle to x.
TestShell<FabricLayer> make_membrane(const FabricLayer& layer, const ShellCorners& x, double angle = 0) {
  TestShell<FabricLayer> shell(layer, 1, x, 0.1, 1);
  shell.par.is_membrane = true;
  const auto g = find_shell_geometry(find_differences(x), find_shapes(x));
  const Vec along = g.frame * Vec{std::cos(angle), std::sin(angle), 0};
  const double size = std::hypot(along.x, along.y);
  const auto row = lay_threads(g, {along.x / size, along.y / size});
  std::copy(row.begin(), row.end(), shell.layers.begin() + 3);
  return shell;
}

/// Cauchy's stress xx, yy, xy in space of a flat membrane in the plane.
Three find_stress_in_space(const TestShell<FabricLayer>& shell, const ShellCorners& x) {
  const auto g = find_shell_geometry(find_differences(x), find_shapes(x));
  const double c = g.frame.row[0].x, s = g.frame.row[0].y;
  const double a = shell.layers[0], b = shell.layers[1], t = shell.layers[2];
  return {c * c * a + s * s * b - 2 * c * s * t, s * s * a + c * c * b + 2 * c * s * t,
          c * s * (a - b) + (c * c - s * s) * t};
}

ShellCorners map(const ShellCorners& x, const double (&f)[2][2]) {
  ShellCorners to = x;
  for (std::size_t i = 0; i < 4; ++i) {
    to[i].x = f[0][0] * x[i].x + f[0][1] * x[i].y;
    to[i].y = f[1][0] * x[i].x + f[1][1] * x[i].y;
  }
  return to;
}

}  // namespace

TEST(Fabric, ATensionFieldHasTheLargestEnergyOfAnyTension) {
  Random random(61);
  int wrinkled = 0, slack = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const double warp = 1, weft = std::pow(10, random()), shear = std::pow(10, -1.5 + random());
    const double poisson = 0.12 * (1 + random());
    const FabricLayer sheet = make_fabric(warp, weft, shear, poisson, false),
                      field = make_fabric(warp, weft, shear, poisson, true);
    const Three e{0.1 * random(), 0.1 * random(), 0.1 * random()};
    const Three elastic = find_stress(sheet, e), s = find_stress(field, e);
    const double determinant = s[0] * s[1] - s[2] * s[2], size = std::abs(s[0]) + std::abs(s[1]);
    EXPECT_GE(s[0] + s[1], 0);
    EXPECT_GE(determinant, -1e-12 * size * size);
    if (elastic[0] > 0 && elastic[0] * elastic[1] > elastic[2] * elastic[2]) {
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(s[k], elastic[k]);
      continue;
    }
    const double largest = find_largest_energy(warp, weft, shear, poisson, e);
    EXPECT_NEAR(find_energy(s, e), largest, 1e-5 * largest) << trial;
    ++(largest > 0 ? wrinkled : slack);
    if (largest == 0) continue;
    // What wrinkles take is strain across the tension alone: C^-1 S - E has no part along it.
    const Three strain{s[0] / warp - poisson / warp * s[1] - e[0], s[1] / weft - poisson / warp * s[0] - e[1],
                       s[2] / (2 * shear) - e[2]};
    EXPECT_NEAR(s[0] * strain[0] + s[2] * strain[2], 0, 1e-9 * size) << trial;
    EXPECT_NEAR(s[2] * strain[0] + s[1] * strain[2], 0, 1e-9 * size) << trial;
    EXPECT_NEAR(s[2] * strain[2] + s[1] * strain[1], 0, 1e-9 * size) << trial;
    EXPECT_GT(strain[0] + strain[1], 0) << trial;
  }
  EXPECT_GT(wrinkled, 100);
  EXPECT_GT(slack, 20);
}

TEST(Fabric, AShearedIsotropicSheetHasTheDiagonalTensionOfReissner) {
  // Pure shear e: tension E e along the diagonal alone.
  const double young = 2, poisson = 0.3, e = 1e-3;
  const FabricLayer field = make_fabric(young, young, young / (2 * (1 + poisson)), poisson, true);
  for (const double sign : {1.0, -1.0}) {
    const Three s = find_stress(field, {0, 0, sign * e});
    EXPECT_NEAR(s[0], 0.5 * young * e, 1e-12 * young * e);
    EXPECT_NEAR(s[1], 0.5 * young * e, 1e-12 * young * e);
    EXPECT_NEAR(s[2], sign * 0.5 * young * e, 1e-12 * young * e);
  }
}

TEST(Fabric, StressIsTheDerivativeOfTheEnergy) {
  Random random(62);
  const double step = 1e-6;
  for (int trial = 0; trial < 200; ++trial) {
    const FabricLayer field = make_fabric(1, std::pow(10, random()), 0.1, 0.2, true, trial % 2 == 0 ? 0 : 0.01);
    const Three e{0.1 * random(), 0.1 * random(), 0.1 * random()};
    const Three s = find_stress(field, e);
    for (std::size_t k = 0; k < 3; ++k) {
      Three up = e, down = e;
      up[k] += step;
      down[k] -= step;
      const double slope = (find_energy(find_stress(field, up), up) - find_energy(find_stress(field, down), down)) /
                           (2 * step * (k == 2 ? 2 : 1));
      EXPECT_NEAR(s[k], slope, 2e-5) << trial << " " << k;  // a slope may change within the difference
    }
  }
}

TEST(Fabric, LargeStretchAlongTheWarpIsThatOfGreensStrain) {
  // S = E1 (l^2 - 1) / 2, Cauchy's l S for a width that stays, whatever the shape of the element.
  const double stretch = 1.5, modulus = 2;
  const FabricLayer layer = make_fabric(modulus, 1, 0.1, 0, false);
  Random random(63);
  for (int trial = 0; trial < 20; ++trial) {
    ShellCorners x = make_quad(random, 1.5, 1, 0.2, 0);
    if (trial % 2 == 0) x[3] = x[2];
    TestShell<FabricLayer> shell = make_membrane(layer, x);
    const ShellCorners to = map(x, {{stretch, 0}, {0, 1}});
    shell.advance(to, {}, {}, 0);
    const Three stress = find_stress_in_space(shell, to);
    EXPECT_NEAR(stress[0], stretch * modulus * 0.5 * (stretch * stretch - 1), 1e-12);
    EXPECT_NEAR(stress[1], 0, 1e-12);
    EXPECT_NEAR(stress[2], 0, 1e-12);
  }
}

TEST(Fabric, ThreadsFollowAShearOfTheWeft) {
  // Simple shear g: the weft turns and stretches, E22 = g^2 / 2 and E12 = g / 2; sigma = F S F^T.
  const double g = 0.8, weft = 3, shear = 0.1;
  const ShellCorners x{Vec{0, 0, 0}, Vec{1, 0, 0}, Vec{1, 1, 0}, Vec{0, 1, 0}};
  TestShell<FabricLayer> shell = make_membrane(make_fabric(1, weft, shear, 0, false), x);
  const ShellCorners to = map(x, {{1, g}, {0, 1}});
  shell.advance(to, {}, {}, 0);
  const double s22 = weft * g * g / 2, s12 = shear * g;
  const Three stress = find_stress_in_space(shell, to);
  EXPECT_NEAR(stress[0], 2 * g * s12 + g * g * s22, 1e-12);
  EXPECT_NEAR(stress[1], s22, 1e-12);
  EXPECT_NEAR(stress[2], s12 + g * s22, 1e-12);
}

TEST(Fabric, ATurnGivesNoStressAndACycleGivesBackItsEnergy) {
  Random random(64);
  for (const bool no_compression : {false, true}) {
    const ShellCorners start = make_quad(random, 1.2, 1, 0.1, 0.2);
    TestShell<FabricLayer> shell = make_membrane(make_fabric(1, 0.5, 0.1, 0.2, no_compression, 1e-3), start, 0.3);
    const Vec axis = (1 / std::sqrt(14.0)) * Vec{1, 2, 3};
    ShellCorners turned;
    for (std::size_t i = 0; i < 4; ++i) turned[i] = rotate(axis, 2, start[i]);
    shell.advance(turned, {}, {}, 0);
    EXPECT_LT(largest_norm(shell.force), 1e-14);
    const ShellCorners v = random_field(random, 0.1);
    ShellCorners back;
    for (std::size_t i = 0; i < 4; ++i) back[i] = Vec{0, 0, 0} - v[i];
    const double there = shell.advance(test::move(turned, v, 1), v, {}, 1).work.internal;
    EXPECT_GT(there, 0);
    EXPECT_NEAR(shell.advance(turned, back, {}, 1).work.internal, -there, 1e-12 * there);
  }
}

TEST(Fabric, ForcesAreTheDerivativeOfItsEnergyHoweverFarItIsStretched) {
  Random random(65);
  const double step = 1e-6;
  for (int trial = 0; trial < 40; ++trial) {
    ShellCorners start = make_quad(random, 1.2, 1, 0.1, trial % 2 == 0 ? 0.2 : 0);
    if (trial % 4 == 3) start[3] = start[2];
    const FabricLayer layer = make_fabric(1, 0.5, 0.1, 0.2, trial % 3 == 0, 1e-2);
    ShellCorners x = start;
    const Vec push[4] = {random_vector(random, 0.2), random_vector(random, 0.2), random_vector(random, 0.2),
                         random_vector(random, 0.2)};
    for (std::size_t i = 0; i < 4; ++i) x[i] = x[i] + push[i];
    if (trial % 4 == 3) x[3] = x[2];
    // Without the forces of the hourglass modes, which a step with dt = 0 leaves at 0.
    const auto find_energy_at = [&](const ShellCorners& at) {
      TestShell<FabricLayer> shell = make_membrane(layer, start, 0.3);
      const auto g = find_shell_geometry(find_differences(at), find_shapes(at));
      shell.advance(at, {}, {}, 0);
      const double start_area = 0.5 / (shell.layers[3] * shell.layers[6] - shell.layers[4] * shell.layers[5]);
      EXPECT_GT(g.area, 0);
      return shell.layers[3 + FabricHistory::energy] * start_area * 0.1;
    };
    TestShell<FabricLayer> shell = make_membrane(layer, start, 0.3);
    shell.advance(x, {}, {}, 0);
    for (std::size_t i = 0; i < (trial % 4 == 3 ? 2 : 4); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        ShellCorners up = x, down = x;
        (k == 0 ? up[i].x : k == 1 ? up[i].y : up[i].z) += step;
        (k == 0 ? down[i].x : k == 1 ? down[i].y : down[i].z) -= step;
        const double slope = (find_energy_at(up) - find_energy_at(down)) / (2 * step);
        const double force = k == 0 ? shell.force[i].x : k == 1 ? shell.force[i].y : shell.force[i].z;
        EXPECT_NEAR(force, slope, 1e-6) << trial << " " << i << " " << k;
      }
  }
}

TEST(Fabric, BoundIsBelowTheExactStepHoweverFarItIsStretched) {
  Random random(66);
  double largest = 0, least = 1e300;
  for (int trial = 0; trial < 300; ++trial) {
    const ShellCorners start = make_quad(random, 1 + 2 * (1 + random()), 1, 0.15, trial % 2 == 0 ? 0.2 : 0);
    const FabricLayer layer = make_fabric(1, std::pow(10, random()), 0.1, 0.2, trial % 3 == 0, 1e-2);
    const TestShell<FabricLayer> shell = make_membrane(layer, start, random());
    const ShellCorners x = map(start, {{1 + 0.5 * (1 + random()), 0.3 * random()}, {0, 1 + 0.5 * (1 + random())}});
    TestShell<FabricLayer> placed = shell;
    const double bound = placed.advance(x, {}, {}, 0).stable_step;
    // The largest eigenvalue of the stiffness by differences, by the power method.
    const double mass = shell.state.mass / 4, step = 1e-6;
    ShellCorners v = random_field(random, 1);
    double size = 0;
    for (int i = 0; i < 300; ++i) {
      double square = 0;
      for (const Vec& u : v) square += dot(u, u);
      for (Vec& u : v) u = (1 / std::sqrt(square)) * u;
      TestShell<FabricLayer> up = placed, down = placed;
      ShellCorners back;
      for (std::size_t k = 0; k < 4; ++k) back[k] = Vec{0, 0, 0} - v[k];
      up.advance(test::move(x, v, step), v, {}, step);
      down.advance(test::move(x, back, step), back, {}, step);
      size = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        v[k] = (1 / (2 * step * mass)) * (up.force[k] - down.force[k]);
        size += dot(v[k], v[k]);
      }
      size = std::sqrt(size);
    }
    const double share = bound / (2 / std::sqrt(size));
    largest = std::max(largest, share);
    least = std::min(least, share);
  }
  EXPECT_LE(largest, 1 + 1e-4);
  EXPECT_GT(least, 0.15);
}

}  // namespace percuss::test::fabric_test
