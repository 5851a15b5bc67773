// The kinds of hexahedron against exact values: what bends them, what their forces work, where they do not lock.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/element/hex8/thick_shell.hpp"
#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::hex_kinds_test {

namespace {

using Lists = testing::Types<KindOf<HexKind::assumed_strain>, KindOf<HexKind::stiffness>, KindOf<HexKind::viscous>,
                             KindOf<HexKind::full>, KindOf<HexKind::thick3>, KindOf<HexKind::thick5>>;
template <class Kind>
class HexKinds : public testing::Test {};
TYPED_TEST_SUITE(HexKinds, Lists);

template <class Kind>
class HexKindsThatBend : public testing::Test {};
using WithStiffness = testing::Types<KindOf<HexKind::assumed_strain>, KindOf<HexKind::stiffness>, KindOf<HexKind::full>,
                                     KindOf<HexKind::thick3>, KindOf<HexKind::thick5>>;
TYPED_TEST_SUITE(HexKindsThatBend, WithStiffness);

struct Brick {
  Vector3<double> edges;
  Corners corners;
  explicit Brick(double x, double y, double z) : edges{x, y, z} {
    Random random(1);
    corners = make_element(random, x, y, z, 0);
  }
};

/// Twice the energy rate of a velocity field, f . v / dt after a step dt from rest: v K v.
template <HexKind Kind>
double find_stiffness(const LameConstants& m, const Corners& c, const Corners& v) {
  const SolidParameters<Elastic> par{{m.lambda, m.mu}, m.lambda, m.mu, 0.05, {0, 0}};
  auto state = make_state<Elastic, Kind>(1.0);
  const double dt = 1e-8;
  Corners f{};
  advance_hex8(par, find_modes(c), find_modes(v), dt, state, {f.x, f.y, f.z});
  double power = 0;
  for (int i = 0; i < 8; ++i) power += f.x[i] * v.x[i] + f.y[i] * v.y[i] + f.z[i] * v.z[i];
  return power / dt;
}

/// u_x = x z at the corners of a brick: pure bending about y.
Corners bend(const Corners& c) {
  Corners v{};
  for (int i = 0; i < 8; ++i) v.x[i] = c.x[i] * c.z[i];
  return v;
}

/// Puts random stresses into the element.
template <HexKind Kind, class State>
void load(State& state, Random& random) {
  const auto draw = [&] { return Symmetric3<double>{random(), random(), random(), random(), random(), random()}; };
  if constexpr (std::is_array_v<decltype(state.stress)>) {
    for (auto& stress : state.stress) stress = draw();
  } else {
    state.stress = draw();
    if constexpr (Kind != HexKind::viscous) {
      for (auto& q : state.hourglass.mode) q = {random(), random(), random()};
    }
  }
}

}  // namespace

TEST(AssumedStrain, BendsACubeLikeAPlateOfItsMaterial) {
  // Q of xi zeta along x over its rate on a cube of edge h: E / (1 - nu^2) h / 48.
  const double h = 0.7, young = 3.0, poisson = 0.3;
  const LameConstants m = find_lame_constants(young, poisson);
  const Brick cube(h, h, h);
  HourglassModes<double> u{};
  u.mode[1] = {1, 0, 0};
  const ElementAxes<double> axes = find_element_axes(find_modes(cube.corners));
  const auto q = find_assumed_strain_response(find_plate_moduli(m), axes, h * h * h, u).force;
  EXPECT_NEAR(q.mode[1].x, young / (1 - poisson * poisson) * h / 48, 1e-15);
  // It bends across too, unless something holds it: eta zeta along y with Poisson's ratio.
  EXPECT_NEAR(q.mode[0].y, poisson * q.mode[1].x, 1e-15);
  EXPECT_EQ(q.mode[3].x, 0);
}

TEST(AssumedStrain, BendingOfABrickHasTheEnergyOfThePlateStrip) {
  // u = (x z, 0, 0): strain z, energy E / (1 - nu^2) z^2 over the volume: a b c^3 / 12.
  const double young = 2.0, poisson = 0.25, a = 1.3, b = 0.4, c = 0.6;
  const Brick brick(a, b, c);
  const double exact = young / (1 - poisson * poisson) * a * b * c * c * c / 12;
  EXPECT_NEAR(
      find_stiffness<HexKind::assumed_strain>(find_lame_constants(young, poisson), brick.corners, bend(brick.corners)) /
          exact,
      1, 1e-7);
}

TEST(FullIntegration, BendingOfABrickHasTheEnergyOfItsMeanDilatation) {
  // Strain z along x and x / 2 in shear. Mean dilatation 0: 2 mu (2/3 z^2 + 2 (x/2)^2) over the volume.
  const double young = 2.0, poisson = 0.25, a = 1.3, b = 0.4, c = 0.6;
  const LameConstants m = find_lame_constants(young, poisson);
  const Brick brick(a, b, c);
  const double exact = 2 * m.mu * a * b * c * (2.0 / 3 * c * c + 0.5 * a * a) / 12;
  EXPECT_NEAR(find_stiffness<HexKind::full>(m, brick.corners, bend(brick.corners)) / exact, 1, 1e-7);
}

TYPED_TEST(HexKindsThatBend, BendingDoesNotLockAsTheMaterialBecomesIncompressible) {
  const Brick brick(1, 1, 1);
  const auto bending = [&](double poisson) {
    const LameConstants m = find_lame_constants(2 * (1 + poisson), poisson);  // mu = 1
    return find_stiffness<TypeParam::value>(m, brick.corners, bend(brick.corners));
  };
  // Between 0 and 0.4999 the plate modulus doubles and lambda grows by 5000.
  EXPECT_LT(bending(0.4999) / bending(0.0), 2.001);
}

TYPED_TEST(HexKinds, ForcesWorkWhatInternalAndHourglassEnergyGain) {
  Random random(5);
  const LameConstants m = find_lame_constants(1, 0.3);
  const SolidParameters<J2Plasticity> par{{m.lambda, m.mu, 1e3, 0}, m.lambda, m.mu, 0.05, {0.06, 1.2}};
  for (int k = 0; k < 20; ++k) {
    const Corners x = make_element(random, 1, 0.6, 1.4, 0.2);
    const Corners v = make_element(random, 1, 1, 1, 1);
    auto state = make_state<J2Plasticity, TypeParam::value>(1.0);
    load<TypeParam::value>(state, random);
    double fx[8], fy[8], fz[8];
    // A thick shell gives up the moment of the stress across its thickness.
    if constexpr (is_thick<TypeParam::value>)
      advance_hex8(par, find_modes(x), find_modes(v), 1e-12, state, {fx, fy, fz});
    // A step of no length leaves the viscous pressure of this motion, so that the trapezoid has it at both ends.
    advance_hex8(par, find_modes(x), find_modes(v), 0.0, state, {fx, fy, fz});
    const double dt = 1e-9;  // what forces change in it is 1e-9 of them
    const HexWork<double> work = advance_hex8(par, find_modes(x), find_modes(v), dt, state, {fx, fy, fz}).work;
    double power = 0;
    Vector3<double> force{0, 0, 0}, moment{0, 0, 0};
    for (int i = 0; i < 8; ++i) {
      const Vector3<double> f{fx[i], fy[i], fz[i]};
      power += dot(f, Vector3<double>{v.x[i], v.y[i], v.z[i]});
      force = force + f;
      moment = moment + cross(Vector3<double>{x.x[i], x.y[i], x.z[i]}, f);
    }
    EXPECT_NEAR((work.internal + work.hourglass + work.viscous) / dt, power, 1e-7);
    EXPECT_LT(norm(force), 1e-14);
    EXPECT_LT(norm(moment), 1e-14);
  }
}

TEST(AssumedStrain, ForcesAreLimitedByWhatYieldLeavesAndFollowTheReturn) {
  const LameConstants m = find_lame_constants(1, 0.3);
  const double yield = 1e-3;
  const SolidParameters<J2Plasticity> par{{m.lambda, m.mu, yield, 0}, m.lambda, m.mu, 0, {0, 0}};
  const Brick cube(1, 1, 1);
  auto state = make_state<J2Plasticity, HexKind::assumed_strain>(1.0);
  Corners f{};
  // Bent far beyond yield, with no stress at the centre: the surface holds 1.5 yield, an ideally plastic section.
  for (int i = 0; i < 1000; ++i)
    advance_hex8(par, find_modes(cube.corners), find_modes(bend(cube.corners)), 1e-4, state, {f.x, f.y, f.z});
  const ElementAxes<double> axes = find_element_axes(find_modes(cube.corners));
  EXPECT_NEAR(std::sqrt(find_surface_stress_square(axes, find_modes(cube.corners), 1.0, state.hourglass)) / yield, 1.5,
              0.02);
  EXPECT_LT(std::sqrt(contract(state.stress, state.stress)), 0.1 * yield);
  // Sheared fourfold beyond yield in one step: what is stored falls to a quarter at least.
  const double before = norm(state.hourglass.mode[1]);
  Matrix3<double> g{};
  g.row[0].y = 4 * yield / (std::sqrt(3.0) * m.mu);
  advance_hex8(par, find_modes(cube.corners), find_modes(apply(g, cube.corners)), 1.0, state, {f.x, f.y, f.z});
  EXPECT_LT(norm(state.hourglass.mode[1]), 0.26 * before);
  EXPECT_GT(norm(state.hourglass.mode[1]), 0.002 * before);
}

TEST(AssumedStrain, GuardActsOnNearInvertedElementsOnly) {
  Random random(3);
  for (int k = 0; k < 50; ++k) {
    const VectorModes<double> a = find_modes(make_element(random, 1, 0.3, 2, 0.1));
    EXPECT_EQ(find_guard(a, find_volume_gradient(a)), 0);
  }
  // One corner pushed to the opposite one.
  Corners c = make_element(random, 1, 1, 1, 0);
  c.x[6] = c.y[6] = c.z[6] = -0.3;
  const VectorModes<double> a = find_modes(c);
  const double guard = find_guard(a, find_volume_gradient(a));
  EXPECT_GT(guard, 0.1);
  EXPECT_LE(guard, 1);
}

}  // namespace percuss::test::hex_kinds_test
