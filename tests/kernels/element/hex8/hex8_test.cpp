#include "kernels/element/hex8/thick_shell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernels/material/elastic.hpp"
#include "kernels/material/laws/j2_plasticity.hpp"
#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::hex8_test {

namespace {

constexpr double young = 200e9, poisson = 0.3, density = 7800;

SolidParameters<Elastic> make_parameters() {
  const LameConstants c = find_lame_constants(young, poisson);
  return {{c.lambda, c.mu}, c.lambda, c.mu, 0.05, {0.06, 1.2}};
}

Corners add(const Corners& a, double s, const Corners& b) {
  Corners c = a;
  for (int i = 0; i < 8; ++i) {
    c.x[i] += s * b.x[i];
    c.y[i] += s * b.y[i];
    c.z[i] += s * b.z[i];
  }
  return c;
}

double largest_stress(const Symmetric3<double>& s) {
  return std::max({std::abs(s.xx), std::abs(s.yy), std::abs(s.zz), std::abs(s.xy), std::abs(s.yz), std::abs(s.zx)});
}

template <class State>
double largest_hourglass(const State& state) {
  double largest = 0;
  if constexpr (requires { state.hourglass.mode; }) {
    for (const auto& q : state.hourglass.mode) largest = std::max(largest, norm(q));
  }
  return largest;
}

template <class Kind>
class Hex8Force : public testing::Test {};
using Kinds = testing::Types<KindOf<HexKind::assumed_strain>, KindOf<HexKind::stiffness>, KindOf<HexKind::viscous>,
                             KindOf<HexKind::full>, KindOf<HexKind::thick3>, KindOf<HexKind::thick5>>;
TYPED_TEST_SUITE(Hex8Force, Kinds);

}  // namespace

TYPED_TEST(Hex8Force, HundredImposedTurnsLeaveNoStressAndNoHourglassForce) {
  Random random(11);
  const SolidParameters<Elastic> par = make_parameters();
  const Corners start = make_element(random, 1, 1, 1, 0.2);
  auto state = make_state<Elastic, TypeParam::value>(density * find_volume_gradient(find_modes(start)).volume,
                                                     find_modes(start));
  const Vector3<double> axis{0.6, 0.0, 0.8};
  const int per_turn = 500;
  const double dt = 1e-5;
  Corners x = start;
  for (int n = 1; n <= 100 * per_turn; ++n) {
    const double angle = 2 * std::numbers::pi * n / per_turn;
    const Matrix3<double> q = find_rotation_increment(2 * std::tan(angle / 2) * axis, 1.0);
    const Corners next = apply(q, start);
    Corners v{};
    for (int i = 0; i < 8; ++i) {
      v.x[i] = (next.x[i] - x.x[i]) / dt;
      v.y[i] = (next.y[i] - x.y[i]) / dt;
      v.z[i] = (next.z[i] - x.z[i]) / dt;
    }
    x = next;
    double fx[8], fy[8], fz[8];
    advance_hex8(par, find_modes(x), find_modes(v), dt, state, {fx, fy, fz});
  }
  for (const auto& stress : list_stresses(state)) EXPECT_LT(largest_stress(stress), 1e-12 * young);
  // Q of a unit modal strain is at most E / 48.
  EXPECT_LT(largest_hourglass(state), 1e-12 * young);
}

TYPED_TEST(Hex8Force, PreStressTurnsWithTheElement) {
  Random random(12);
  const SolidParameters<Elastic> par = make_parameters();
  const Corners start = make_element(random, 1, 1, 1, 0.1);
  auto state = make_state<Elastic, TypeParam::value>(density * find_volume_gradient(find_modes(start)).volume,
                                                     find_modes(start));
  const Symmetric3<double> stress0{1e8, -2e8, 3e7, 5e7, -4e7, 6e7};
  if constexpr (std::is_array_v<decltype(state.stress)>) {
    for (auto& stress : state.stress) stress = stress0;
  } else {
    state.stress = stress0;
  }
  const Vector3<double> axis{0, 0.6, 0.8};
  Corners x = start;
  const int steps = 300;
  Matrix3<double> q{};
  for (int n = 1; n <= steps; ++n) {
    q = find_rotation_increment(2 * std::tan(0.5 * 1.5 * n / steps) * axis, 1.0);
    const Corners next = apply(q, start);
    const Corners v = add(next, -1.0, x);
    x = next;
    double fx[8], fy[8], fz[8];
    advance_hex8(par, find_modes(x), find_modes(v), 1.0, state, {fx, fy, fz});
  }
  const Symmetric3<double> expected = push_forward(q, stress0);
  for (const auto& stress : list_stresses(state)) {
    const Symmetric3<double> now = push_forward(state.polar.rotation, stress);
    EXPECT_LT(largest_stress(now + (-1.0) * expected), 1e-11 * 3e8);
  }
}

TEST(CornerForces, BalanceInSumMomentAndPower) {
  Random random(13);
  for (int k = 0; k < 30; ++k) {
    const Corners x = make_element(random, 1, 0.6, 1.4, 0.2);
    Corners v{};
    for (int i = 0; i < 8; ++i) {
      v.x[i] = random();
      v.y[i] = random();
      v.z[i] = random();
    }
    const VectorModes<double> a = find_modes(x), vm = find_modes(v);
    const VolumeGradient<double> b = find_volume_gradient(a);
    const Symmetric3<double> t{random(), random(), random(), random(), random(), random()};
    HourglassModes<double> q;
    for (auto& mode : q.mode) mode = {random(), random(), random()};
    double fx[8], fy[8], fz[8];
    find_corner_forces(t, q, a, b, {fx, fy, fz});
    Vector3<double> force{0, 0, 0}, moment{0, 0, 0};
    double power = 0;
    for (int i = 0; i < 8; ++i) {
      const Vector3<double> f{fx[i], fy[i], fz[i]};
      force = force + f;
      moment = moment + cross(Vector3<double>{x.x[i], x.y[i], x.z[i]}, f);
      power += dot(f, Vector3<double>{v.x[i], v.y[i], v.z[i]});
    }
    EXPECT_LT(norm(force), 1e-13);
    EXPECT_LT(norm(moment), 1e-13);
    const Matrix3<double> l = find_velocity_gradient(vm, b);
    const double expected = b.volume * contract(t, symmetric_part(l)) + find_power(q, find_hourglass_rates(vm, a, l));
    EXPECT_NEAR(power, expected, 1e-12);
  }
}

TYPED_TEST(Hex8Force, UniaxialStrainGivesTheExactStress) {
  Random random(14);
  const SolidParameters<Elastic> par = make_parameters();
  // The strains that a thick shell assumes are exact where its edges across are alike.
  Corners x = make_element(random, 1, 1, 1, is_thick<TypeParam::value> ? 0 : 0.15);
  auto state = make_state<Elastic, TypeParam::value>(density, find_modes(x));
  const int steps = 100;
  const double end = 1.1;
  double length = 1;
  for (int n = 1; n <= steps; ++n) {
    const double next = 1 + (end - 1) * n / steps;
    Matrix3<double> g{};
    g.row[0].x = next / length - 1;  // relative to the current geometry
    const Corners v = apply(g, x);
    x = add(x, 1.0, v);
    length = next;
    double fx[8], fy[8], fz[8];
    advance_hex8(par, find_modes(x), find_modes(v), 1.0, state, {fx, fy, fz});
  }
  // Mid-point strain rates sum to ln(1.1) with an error of dt^2 / 12: 1e-8 relative here. J sigma follows it.
  const LameConstants c = find_lame_constants(young, poisson);
  for (const auto& stress : list_stresses(state)) {
    EXPECT_NEAR(end * stress.xx / ((c.lambda + 2 * c.mu) * std::log(end)), 1, 1e-6);
    EXPECT_NEAR(end * stress.yy / (c.lambda * std::log(end)), 1, 1e-6);
    EXPECT_LT(std::abs(stress.xy), 1e-12 * young);
  }
  EXPECT_LT(largest_hourglass(state), 1e-12 * young);
}

TEST(J2Plasticity, UniaxialStrainFollowsTheExactSolution) {
  const LameConstants c = find_lame_constants(young, poisson);
  const double yield = 400e6, hardening = 2e9;
  const J2Plasticity law{c.lambda, c.mu, yield, hardening};
  Symmetric3<double> stress{};
  double p = 0;
  const double strain = 0.02;
  for (int n = 0; n < 50; ++n) law.update(stress, &p, Symmetric3<double>{strain / 50, 0, 0, 0, 0, 0});
  // sigma_x - sigma_y = yield + H p = 2 mu (strain - 3/2 p)
  const double expected_p = (2 * c.mu * strain - yield) / (3 * c.mu + hardening);
  EXPECT_NEAR(p, expected_p, 1e-12);
  EXPECT_NEAR(stress.xx - stress.yy, yield + hardening * expected_p, 1e-3);
  EXPECT_NEAR(trace(stress) / 3, (c.lambda + 2.0 / 3 * c.mu) * strain, 1e-3);
}

TEST(J2Plasticity, ReturnsTheShareOfTheTrialDeviatorThatIsLeft) {
  const LameConstants c = find_lame_constants(young, poisson);
  const J2Plasticity law{c.lambda, c.mu, 100e6, 0};
  Symmetric3<double> stress{};
  double p = 0;
  EXPECT_EQ(law.update(stress, &p, Symmetric3<double>{0, 0, 0, 1e-6, 0, 0}).share, 1.0);
  // a trial of four times the yield stress is scaled to a quarter
  stress = {};
  const PlasticReturn<double> plastic =
      law.update(stress, &p, Symmetric3<double>{0, 0, 0, 400e6 / (std::sqrt(3.0) * 2 * c.mu), 0, 0});
  EXPECT_NEAR(plastic.share, 0.25, 1e-12);
  EXPECT_NEAR(plastic.flow_stress, 100e6, 1e-3);
  EXPECT_NEAR(plastic.loading, 1, 1e-12);
  EXPECT_NEAR(stress.xy, 100e6 / std::sqrt(3.0), 1e-3);
}

TEST(BulkViscosity, MatchesItsFormulaInCompressionAndExpansion) {
  const BulkViscosity b{0.1, 1.5};
  EXPECT_NEAR(find_viscous_pressure(b, 2.0, 0.5, 3.0, -4.0).pressure, 2 * 0.5 * (0.1 * 3 * 4 + 2.25 * 0.5 * 16), 1e-12);
  EXPECT_NEAR(find_viscous_pressure(b, 2.0, 0.5, 3.0, 4.0).pressure, -2 * 0.5 * 0.1 * 3 * 4, 1e-12);
}

TYPED_TEST(Hex8Force, PacksGiveTheSameBitsAsScalars) {
  Random random(15);
  constexpr int width = pack_size<double>;
  const LameConstants c = find_lame_constants(young, poisson);
  const SolidParameters<J2Plasticity> par{{c.lambda, c.mu, 100e6, 1e9}, c.lambda, c.mu, 0.05, {0.06, 1.2}};
  VectorModes<double> a[width], v[width];
  alignas(64) double packed_a[7][3][width], packed_v[7][3][width];
  for (int lane = 0; lane < width; ++lane) {
    a[lane] = find_modes(make_element(random, 1, 1, 1, 0.2));
    v[lane] = find_modes(make_element(random, 100, 100, 100, 0.4));
    for (int m = 1; m < 8; ++m) {
      packed_a[m - 1][0][lane] = a[lane][m].x, packed_v[m - 1][0][lane] = v[lane][m].x;
      packed_a[m - 1][1][lane] = a[lane][m].y, packed_v[m - 1][1][lane] = v[lane][m].y;
      packed_a[m - 1][2][lane] = a[lane][m].z, packed_v[m - 1][2][lane] = v[lane][m].z;
    }
  }
  using Lanes = Pack<double>;
  VectorModes<Lanes> pa, pv;
  for (int m = 1; m < 8; ++m) {
    pa[m] = {load_pack(packed_a[m - 1][0]), load_pack(packed_a[m - 1][1]), load_pack(packed_a[m - 1][2])};
    pv[m] = {load_pack(packed_v[m - 1][0]), load_pack(packed_v[m - 1][1]), load_pack(packed_v[m - 1][2])};
  }
  auto ps = make_state<J2Plasticity, TypeParam::value>(Lanes(density));
  Lanes fx[8], fy[8], fz[8];
  advance_hex8(par, pa, pv, Lanes(1e-4), ps, {fx, fy, fz});
  for (int lane = 0; lane < width; ++lane) {
    auto s = make_state<J2Plasticity, TypeParam::value>(density);
    double sx[8], sy[8], sz[8];
    advance_hex8(par, a[lane], v[lane], 1e-4, s, {sx, sy, sz});
    alignas(64) double row[width];
    for (int i = 0; i < 8; ++i) {
      store_pack(row, fx[i]);
      EXPECT_EQ(row[lane], sx[i]);
      store_pack(row, fz[i]);
      EXPECT_EQ(row[lane], sz[i]);
    }
    const int point = TypeParam::value == HexKind::full ? 5 : 0;
    store_pack(row, ps.history.value[0][point]);
    EXPECT_EQ(row[lane], s.history.value[0][point]);
  }
}

}  // namespace percuss::test::hex8_test
