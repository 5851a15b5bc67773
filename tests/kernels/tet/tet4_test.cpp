// The tetrahedron as a pure function: its geometry, its forces and their power, its step.

#include "kernels/tet/tet4.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/tet/tet_chunks.hpp"
#include "tests/kernels/tet/tet_patch.hpp"

namespace percuss::test::tet4_test {
namespace {

/// A random tetrahedron of positive volume, its heights some tenth of its size or more.
TetCorners<double> make_corners(Random& random) {
  for (;;) {
    TetCorners<double> x;
    for (auto& corner : x.at) corner = {random(), random(), random()};
    if (find_tet_geometry(x).volume > 0.05) return x;
  }
}

TetCorners<double> make_velocities(Random& random) {
  TetCorners<double> v;
  for (auto& corner : v.at) corner = {random(), random(), random()};
  return v;
}

TetCorners<double> apply(const Matrix3<double>& g, const TetCorners<double>& x) {
  TetCorners<double> u;
  for (int i = 0; i < 4; ++i) u[i] = g * x[i];
  return u;
}

Symmetric3<double> random_tensor(Random& random) {
  return {random(), random(), random(), random(), random(), random()};
}

TEST(Tet4Geometry, OfTheUnitTetrahedronIsThatOfTheBooks) {
  const TetGeometry<double> g = find_tet_geometry(TetCorners<double>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  EXPECT_DOUBLE_EQ(g.volume, 1.0 / 6);
  const double b[4][3] = {{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(6 * g.b[i].x, b[i][0]);
    EXPECT_DOUBLE_EQ(6 * g.b[i].y, b[i][1]);
    EXPECT_DOUBLE_EQ(6 * g.b[i].z, b[i][2]);
  }
}

TEST(Tet4Geometry, BIsTheDerivativeOfTheVolume) {
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    const TetCorners<double> x = make_corners(random);
    const TetGeometry<double> g = find_tet_geometry(x);
    for (int i = 0; i < 4; ++i) {  // the volume is linear in each corner: differences are exact
      TetCorners<double> up = x;
      up[i].y += 1;
      EXPECT_NEAR(find_tet_geometry(up).volume - g.volume, g.b[i].y, 1e-14);
    }
  }
}

TEST(Tet4Geometry, GradientOfALinearFieldIsExact) {
  Random random(4);
  const TetCorners<double> x = make_corners(random);
  const Matrix3<double> g = random_matrix(random, 1);
  const TetGeometry<double> geometry = find_tet_geometry(x);
  const Matrix3<double> l = (1 / geometry.volume) * find_volume_times_gradient(apply(g, x), geometry);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(l.row[i].x, g.row[i].x, 1e-13);
    EXPECT_NEAR(l.row[i].y, g.row[i].y, 1e-13);
    EXPECT_NEAR(l.row[i].z, g.row[i].z, 1e-13);
  }
}

TEST(Tet4Force, OfAStressSumsToNothingAndHasItsPower) {
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    const TetCorners<double> x = make_corners(random), v = make_velocities(random);
    const Symmetric3<double> p = random_tensor(random);
    const TetGeometry<double> g = find_tet_geometry(x);
    const TetCorners<double> f = find_tet_forces(g, p);
    Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
    double power = 0;
    for (int i = 0; i < 4; ++i) {
      sum = sum + f[i];
      moment = moment + cross(x[i], f[i]);
      power += dot(f[i], v[i]);
    }
    EXPECT_NEAR(norm(sum), 0, 1e-15);
    EXPECT_NEAR(norm(moment), 0, 1e-14);
    EXPECT_NEAR(power, contract(p, symmetric_part(find_volume_times_gradient(v, g))), 1e-14);
  }
}

TEST(Tet4Force, ARigidTurnStrainsNothing) {
  Random random(6);
  TetCorners<double> x = make_corners(random);
  const SolidParameters<Elastic> par = make_tet_parameters({2e9, 1e9});
  ElasticTet state = make_tet(1);
  const Vector3<double> axis{0.3, -0.5, 0.4};
  for (int step = 0; step < 50; ++step) {  // each turns about the middle of its way, as the mid-point rule is exact for
    const Matrix3<double> turn = find_rotation(1.0, axis);
    const TetCorners<double> end = apply(turn, x);
    TetCorners<double> v;
    for (int i = 0; i < 4; ++i) v[i] = 1.0 * (end[i] - x[i]);
    const TetMotion<double> m = follow_tet(end, v, 1.0);
    const TetPoint<double> p = advance_tet4<false>(par, end, m, m.d, 1.0, state);
    EXPECT_NEAR(std::sqrt(contract(p.stress, p.stress)), 0, 1e-11 * 1e9);
    x = end;
  }
}

TEST(Tet4Force, ActsInTheVolumeThatTheMaterialHasSeen) {
  for (const double x : {-2.0, -1.0, -0.5, -1e-9, 0.0, 1e-3, 0.7, 2.0})
    EXPECT_NEAR(find_power_of_e(x), std::exp(x), 1e-14 * std::exp(x)) << x;
  for (const double x : {-4.0, 4.0}) EXPECT_NEAR(find_power_of_e(x), std::exp(x), 1e-12 * std::exp(x)) << x;
  // over a step in which the gap grows from 0.3 to 0.31: e^-0.3 and e^-0.31; the series of the step ends with its cube
  const MaterialVolume<double> ratio = find_material_volume(0.31, 0.01);
  EXPECT_NEAR(ratio.before, std::exp(-0.3), 1e-9);
  EXPECT_NEAR(ratio.now, std::exp(-0.31), 1e-14);
  const Symmetric3<double> before{1.1, 0.9, 1, 0, 0, 0}, after{1.2, 0.9, 1, 0, 0, 0};
  const VolumeChange<double> change = find_volume_change(ratio, before, after);
  EXPECT_NEAR(change.growth, 1.08 * ratio.now - 0.99 * ratio.before, 1e-15);
  EXPECT_NEAR(change.inverse, 1 / (1.08 * ratio.now), 1e-15);
}

TEST(Tet4Force, BlendKeepsTheMeanTraceAndAShareOfTheDeviator) {
  Random random(7);
  const Symmetric3<double> own = random_tensor(random), mean = random_tensor(random);
  const Symmetric3<double> both = blend(own, mean, 0.3);
  EXPECT_NEAR(trace(both), trace(mean), 1e-15);
  EXPECT_NEAR(both.xy, 0.7 * own.xy + 0.3 * mean.xy, 1e-15);
  EXPECT_NEAR(both.xx - trace(both) / 3, 0.7 * (own.xx - trace(own) / 3) + 0.3 * (mean.xx - trace(mean) / 3), 1e-15);
  // the transpose: blend is symmetric in what it takes its power from
  const Symmetric3<double> s = random_tensor(random);
  const auto take_mean = [&](const Symmetric3<double>& a) { return blend(Symmetric3<double>{}, a, 0.3); };
  EXPECT_NEAR(contract(s, take_mean(own)), contract(take_mean(s), own), 1e-15);
}

TEST(Tet4Step, OfAPlainElementIsBoundedByItsTrueLargestFrequency) {
  Random random(8);
  double tightest = 0;
  for (int k = 0; k < 200; ++k) {
    const TetCorners<double> x = make_corners(random);
    const LameConstants c = find_lame_constants(1e9, 0.2 + 0.299 * random());
    const SolidParameters<Elastic> par = make_tet_parameters(c);
    const double mass = 1000 * find_tet_geometry(x).volume, dt = 1e-8;
    TetCorners<double> v = make_velocities(random);
    double square = 0;
    for (int i = 0; i < 300; ++i) {
      ElasticTet state = make_tet(mass);
      const TetMotion<double> m = follow_tet(x, v, dt);
      const TetPoint<double> p = advance_tet4<false>(par, x, m, m.d, dt, state);
      const TetCorners<double> f = find_tet_forces(p.geometry, p.stress);
      double product = 0, length = 0, size = 0;
      for (int n = 0; n < 4; ++n) {
        product += dot(f[n], v[n]) / dt;
        length += dot(v[n], v[n]);
        size = std::max(size, norm(f[n]));
      }
      square = 4 * product / (mass * length);
      for (int n = 0; n < 4; ++n) v[n] = (1 / size) * f[n];
    }
    const double step = find_plain_step(find_tet_geometry(x), mass, {c.lambda + 2.0 / 3.0 * c.mu, c.mu, 0});
    const double used = step * std::sqrt(square) / 2;
    ASSERT_LE(used, 1 + 1e-7) << "shape " << k;
    tightest = std::max(tightest, used);
  }
  EXPECT_GT(tightest, 0.9);
}

TEST(Tet4Records, LieAsTheirPlacesSay) {
  ElasticTet s{};
  const auto place = [&](const double& scalar) { return static_cast<int>(&scalar - reinterpret_cast<double*>(&s)); };
  EXPECT_EQ(place(s.polar.rotation.row[0].x), TetRecord::rotation);
  EXPECT_EQ(place(s.stress.xx), TetRecord::stress);
  EXPECT_EQ(place(s.guard), TetRecord::guard);
  EXPECT_EQ(sizeof(TetState<double, J2Plasticity>), TetRecord::find_size(1) * sizeof(double));
}

}  // namespace
}  // namespace percuss::test::tet4_test
