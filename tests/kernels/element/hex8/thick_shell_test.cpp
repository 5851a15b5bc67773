// The thick shell against exact values: no strain where none is, bending and stretching of a plate however thin, a
// section that yields, and the bound of its step for shapes that lean, taper and warp.

#include "kernels/element/hex8/thick_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::thick_shell_test {

namespace {

constexpr HexKind three = HexKind::thick3, five = HexKind::thick5;

SolidParameters<Elastic> make_elastic(double young, double poisson) {
  const LameConstants m = find_lame_constants(young, poisson);
  return {{m.lambda, m.mu}, std::max(m.lambda, 0.0), m.mu, 0, {0, 0}};
}

/// v K v of an element at rest.
template <HexKind Kind>
double find_stiffness(const SolidParameters<Elastic>& par, const Corners& c, const Corners& v) {
  auto state = make_state<Elastic, Kind>(1.0);
  const double dt = 1e-8;
  Corners f{};
  advance_hex8(par, find_modes(c), find_modes(v), dt, state, {f.x, f.y, f.z});
  double power = 0;
  for (int i = 0; i < 8; ++i) power += f.x[i] * v.x[i] + f.y[i] * v.y[i] + f.z[i] * v.z[i];
  return power / dt;
}

Corners make_plate_element(double length, double width, double thickness) {
  Random random(1);
  return make_element(random, length, width, thickness, 0);
}

/// A plate bent to a cylinder about y, u = (x z, 0, -x^2 / 2) at the corners, with what Poisson's ratio does to the
/// mean of its thickness left out.
Corners bend(const Corners& c) {
  Corners v{};
  for (int i = 0; i < 8; ++i) {
    v.x[i] = c.x[i] * c.z[i];
    v.z[i] = -0.5 * c.x[i] * c.x[i];
  }
  return v;
}

/// Twisted, u = (y z, x z, -x y).
Corners twist(const Corners& c) {
  Corners v{};
  for (int i = 0; i < 8; ++i) {
    v.x[i] = c.y[i] * c.z[i];
    v.y[i] = c.x[i] * c.z[i];
    v.z[i] = -c.x[i] * c.y[i];
  }
  return v;
}

/// A shell whose middle surface is a distorted and warped quadrilateral, its edges across of random length and lean.
struct ShellShape {
  double width, thickness, distortion, warp, taper, lean, slant;
};
Corners make_shell(Random& random, const ShellShape& s) {
  Corners c{};
  const double slant = s.slant * random(), lean_x = s.slant * random(), lean_y = s.slant * random();
  for (int i = 0; i < 4; ++i) {
    const double x = 0.5 * corner_xi[i] + s.distortion * random(),
                 y = s.width * (0.5 * corner_eta[i] + s.distortion * random()), z = s.warp * random();
    const Vector3<double> across{s.thickness * (s.lean * random() + lean_x), s.thickness * (s.lean * random() + lean_y),
                                 s.thickness * (1 + s.taper * random())};
    for (const int side : {0, 1}) {
      const double share = side - 0.5;
      c.x[i + 4 * side] = x + slant * y / s.width + share * across.x;
      c.y[i + 4 * side] = y + share * across.y;
      c.z[i + 4 * side] = z + share * across.z;
    }
  }
  return c;
}

/// Largest eigenvalue of M^-1 K by power iteration.
double find_largest_square(const SolidParameters<J2Plasticity>& par, const Corners& c, double mass, Random& random) {
  Corners v{};
  for (int i = 0; i < 8; ++i) v.x[i] = random(), v.y[i] = random(), v.z[i] = random();
  double value = 0;
  const VectorModes<double> a = find_modes(c);
  for (int n = 0; n < 150; ++n) {
    const VectorModes<double> force = probe_columns<3>(Moduli<double>{par.lambda, par.mu}, a, find_modes(v));
    Corners f{};
    find_full_forces(force, identity_matrix<double>(), 0.0, find_volume_gradient(a), {f.x, f.y, f.z});
    double product = 0, square = 0, size = 0;
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

struct BoundUse {
  double most = 0, mean = 0;
};
BoundUse compare_bounds(const ShellShape& most, int count) {
  Random random(3);
  BoundUse use;
  int used_shapes = 0;
  for (int k = 0; k < count; ++k) {
    const double share = std::abs(random());
    const ShellShape shape{std::pow(10.0, std::abs(random()) * most.width),
                           std::pow(10.0, -1 + random()),
                           most.distortion * share,
                           most.warp * share,
                           most.taper * share,
                           most.lean * std::abs(random()),
                           most.slant * std::abs(random())};
    const Corners c = make_shell(random, shape);
    const LameConstants m = find_lame_constants(1e9, 0.2 + 0.299 * random());
    const SolidParameters<J2Plasticity> par{{m.lambda, m.mu, 1e30, 0}, std::max(m.lambda, 0.0), m.mu, 0, {0, 0}};
    const double mass = 1000 * find_volume_gradient(find_modes(c)).volume;
    auto state = make_state<J2Plasticity, three>(mass);
    Corners rest{}, f{};
    const auto result = advance_hex8(par, find_modes(c), find_modes(rest), 0.0, state, {f.x, f.y, f.z});
    if (!(result.size > 0)) continue;  // inverted at a point
    const double of = result.stable_step * std::sqrt(find_largest_square(par, c, mass, random)) / 2;
    EXPECT_LE(of, 1 + 1e-6) << "shape " << k << " width " << shape.width << " thickness " << shape.thickness
                            << " distortion " << shape.distortion << " lean " << shape.lean;
    use.most = std::max(use.most, of);
    use.mean += of;
    ++used_shapes;
  }
  use.mean /= used_shapes;
  return use;
}

}  // namespace

TEST(ThickShell, BendsAsAPlateHoweverThin) {
  const double young = 7, width = 0.8;
  for (const double thickness : {1.0, 0.1, 0.01, 0.001}) {
    for (const double poisson : {0.0, 0.3, 0.499}) {
      const Corners c = make_plate_element(1, width, thickness);
      const double rigidity = young * std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
      EXPECT_NEAR(find_stiffness<three>(make_elastic(young, poisson), c, bend(c)) / (rigidity * width), 1, 2e-6);
      EXPECT_NEAR(find_stiffness<five>(make_elastic(young, poisson), c, bend(c)) / (rigidity * width), 1, 2e-6);
      // Twist: 2 D (1 - nu) on the area.
      EXPECT_NEAR(
          find_stiffness<three>(make_elastic(young, poisson), c, twist(c)) / (2 * rigidity * (1 - poisson) * width), 1,
          2e-6);
    }
  }
}

TEST(ThickShell, BendsAsAPlateInPlaneSkewed) {
  // A parallelogram of the plane, whose transverse shear follows its edges.
  Corners c = make_plate_element(1, 1, 0.02);
  for (int i = 0; i < 8; ++i) c.x[i] += 0.5 * c.y[i];
  const double rigidity = std::pow(0.02, 3) / (12 * (1 - 0.09));
  EXPECT_NEAR(find_stiffness<three>(make_elastic(1, 0.3), c, twist(c)) / (2 * rigidity * 0.7), 1, 1e-5);
}

TEST(ThickShell, HasNoEnergyInRigidMotionsAlone) {
  // 18 strains: the least energy of random motions without the rigid ones stays away from 0.
  Random random(4);
  const Corners c = make_plate_element(1, 1, 1);
  const SolidParameters<Elastic> par = make_elastic(1, 0.3);
  for (int direction = 0; direction < 3; ++direction) {
    for (int mode = 4; mode <= 7; ++mode) {
      Corners v{};
      double(&u)[8] = direction == 0 ? v.x : direction == 1 ? v.y : v.z;
      for (double& value : u) value = 0;
      u[mode] = 1;
      to_corners(u);
      EXPECT_GT(find_stiffness<three>(par, c, v), 0.05) << direction << ' ' << mode;
    }
  }
}

TEST(ThickShell, StretchesWithoutStressAcross) {
  // A plate that is free to thin: E / (1 - nu^2) in one direction, held in the other.
  const double young = 3, poisson = 0.3;
  const Corners c = make_plate_element(1, 1, 0.05);
  Matrix3<double> g{};
  g.row[0].x = 1;
  g.row[2].z = -poisson / (1 - poisson);
  EXPECT_NEAR(
      find_stiffness<three>(make_elastic(young, poisson), c, apply(g, c)) / (young / (1 - poisson * poisson) * 0.05), 1,
      1e-7);
}

TEST(ThickShell, TakesEveryLinearMotionOfAFlatPlateOfAnyQuadrilateral) {
  Random random(7);
  const ShellShape shape{1, 0.1, 0.15, 0, 0, 0, 0};
  for (int k = 0; k < 10; ++k) {
    const Corners c = make_shell(random, shape);
    const SolidParameters<Elastic> par = make_elastic(1, 0.3);
    auto state = make_state<Elastic, three>(1.0);
    const Matrix3<double> g = random_matrix(random, 1);
    Corners f{};
    const double dt = 1e-9;
    advance_hex8(par, find_modes(c), find_modes(apply(g, c)), dt, state, {f.x, f.y, f.z});
    const Symmetric3<double> exact = find_elastic_increment(par.material.moduli(), symmetric_part(g));
    for (const auto& stress : state.stress) {
      const Symmetric3<double> error = (1 / dt) * stress + (-1.0) * exact;
      EXPECT_LT(std::sqrt(contract(error, error)), 1e-6);
    }
  }
}

TEST(ThickShell, ASectionThatYieldsHasTheMomentOfItsPoints) {
  // Bent as a wide plate far beyond yield: sigma_y (2 / sqrt 3) h^2 / 4 times the sum that the rule has for |z|.
  const double yield = 1e-3, width = 0.8, thickness = 0.05;
  const LameConstants m = find_lame_constants(1, 0.3);
  const SolidParameters<J2Plasticity> par{{m.lambda, m.mu, yield, 0}, m.lambda, m.mu, 0, {0, 0}};
  const Corners c = make_plate_element(1, width, thickness);
  auto state = make_state<J2Plasticity, five>(1.0);
  Corners f{};
  for (int n = 0; n < 20000; ++n) advance_hex8(par, find_modes(c), find_modes(bend(c)), 1e-4, state, {f.x, f.y, f.z});
  double power = 0;
  const Corners v = bend(c);
  for (int i = 0; i < 8; ++i) power += f.x[i] * v.x[i] + f.y[i] * v.y[i] + f.z[i] * v.z[i];
  double rule = 0;
  for (int l = 0; l < 5; ++l) rule += LayerRule<5>::weight[l] * std::abs(LayerRule<5>::place[l]);
  EXPECT_NEAR(rule, 0.9449, 1e-4);
  EXPECT_NEAR(power / (rule * 2 / std::sqrt(3.0) * yield * width * thickness * thickness / 4), 1, 0.002);
  // A strain linear in zeta leaves some stress across the thickness, which has no moment.
  double moment = 0;
  for (int l = 0; l < 5; ++l) {
    moment += LayerRule<5>::weight[l] * LayerRule<5>::place[l] * state.stress[4 * l].zz;
    EXPECT_LT(std::abs(state.stress[4 * l].zz), 0.2 * yield);
  }
  EXPECT_LT(std::abs(moment), 1e-2 * yield);
}

TEST(ThickShell, TheMeanOverItsPointsIsThatOverItsVolume) {
  const auto mean = [](const double* place, int layers, int power) {
    return find_point_mean(4 * layers, [&](int p) { return std::pow(place[p / 4], power); });
  };
  EXPECT_NEAR(mean(LayerRule<3>::place, 3, 0), 1, 1e-15);
  EXPECT_NEAR(mean(LayerRule<3>::place, 3, 4), 1.0 / 5, 1e-15);
  EXPECT_NEAR(mean(LayerRule<5>::place, 5, 0), 1, 1e-15);
  EXPECT_NEAR(mean(LayerRule<5>::place, 5, 8), 1.0 / 9, 1e-15);
}

TEST(ThickShell, AFewLargeStepsBendASectionAsManySmallOnes) {
  // What plastic flow needs across the thickness beyond elasticity is foreseen: 129 steps of half the strain at yield.
  const auto bend_in = [](int steps) {
    const LameConstants m = find_lame_constants(210000, 0.3);
    const SolidParameters<J2Plasticity> par{{m.lambda, m.mu, 100, 0}, m.lambda, m.mu, 0, {0, 0}};
    Corners x = make_plate_element(10, 10, 10), v{}, f{};
    for (int i = 0; i < 8; ++i) v.x[i] = 0.1 * corner_xi[i] * corner_zeta[i];
    auto state = make_state<J2Plasticity, three>(1.0);
    double work = 0;
    for (int n = 0; n < steps; ++n) {
      for (int i = 0; i < 8; ++i) x.x[i] += v.x[i] / steps;
      work += advance_hex8(par, find_modes(x), find_modes(v), 1.0 / steps, state, {f.x, f.y, f.z}).work.internal;
    }
    return work;
  };
  const double fine = bend_in(5000);
  EXPECT_NEAR(bend_in(129) / fine, 1, 0.003);
  EXPECT_NEAR(bend_in(20) / fine, 1, 0.06);
}

TEST(ThickShell, BoundOfTheStepIsThatOfThePlateWave) {
  // A thin square: omega^2 = 4 (lambda + 2 mu) / (rho h^2) across, and little more from the other directions.
  const SolidParameters<Elastic> par = make_elastic(1e9, 0.3);
  const Corners c = make_plate_element(1, 1, 0.02);
  auto state = make_state<Elastic, three>(1000 * 0.02);
  Corners rest{}, f{};
  const double step = advance_hex8(par, find_modes(c), find_modes(rest), 0.0, state, {f.x, f.y, f.z}).stable_step;
  const double exact = 0.02 / std::sqrt((par.lambda + 2 * par.mu) / 1000);
  EXPECT_LT(step, exact);
  EXPECT_GT(step, 0.999 * exact);
}

TEST(ThickShell, BoundHoldsForEveryShape) {
  EXPECT_GT(compare_bounds({1, 0, 0, 0, 0, 0, 0}, 100).mean, 0.9);          // bricks
  EXPECT_GT(compare_bounds({1, 0, 0.25, 0, 0, 0, 0}, 300).mean, 0.85);      // distorted in the plane
  EXPECT_GT(compare_bounds({1, 0, 0.25, 0, 0.5, 0, 0}, 300).mean, 0.8);     // tapered, too
  EXPECT_GT(compare_bounds({1, 0, 0, 0.3, 0, 0, 0}, 300).mean, 0.8);        // warped
  EXPECT_GT(compare_bounds({1, 0, 0, 0, 0, 1, 0}, 500).mean, 0.6);          // edges that lean apart
  EXPECT_GT(compare_bounds({1, 0, 0.25, 0.3, 0.5, 1, 0}, 1000).mean, 0.4);  // all
  EXPECT_GT(compare_bounds({1, 0, 0.25, 0.3, 0.5, 1, 1}, 2000).mean, 0.3);  // and oblique
}

}  // namespace percuss::test::thick_shell_test
