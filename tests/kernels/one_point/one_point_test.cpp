// The one-point wedge and pyramid as pure functions: geometry, forces and their power, step.

#include "kernels/one_point/one_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernels/one_point/one_point_chunks.hpp"
#include "tests/kernels/one_point/random_solid.hpp"

namespace percuss::test::one_point_test {
namespace {

/// Corners of the hexahedron that collapses to the shape.
constexpr std::array<int, 8> collapsed(Wedge6) { return {0, 1, 2, 2, 3, 4, 5, 5}; }
constexpr std::array<int, 8> collapsed(Pyramid5) { return {0, 1, 2, 3, 4, 4, 4, 4}; }

/// Mean gradient and volume of the collapsed hexahedron, by the modes of its own kernel.
template <class Shape>
CornerGradient<double, Shape> find_collapsed_gradient(const Places<Shape>& x) {
  constexpr std::array<int, 8> corner = collapsed(Shape());
  double u[3][8];
  for (std::size_t i = 0; i < 8; ++i) {
    u[0][i] = x[corner[i]].x;
    u[1][i] = x[corner[i]].y;
    u[2][i] = x[corner[i]].z;
  }
  for (auto& row : u) to_modes(row);
  VectorModes<double> a;
  for (int m = 1; m < 8; ++m) a[m] = {u[0][m], u[1][m], u[2][m]};
  const VolumeGradient<double> b = find_volume_gradient(a);
  double f[3][8] = {};
  for (int m = 1; m <= 6; ++m) {
    f[0][m] = b[m].x / 64;
    f[1][m] = b[m].y / 64;
    f[2][m] = b[m].z / 64;
  }
  for (auto& row : f) to_corners(row);
  CornerGradient<double, Shape> g{};
  g.volume = b.volume;
  for (std::size_t i = 0; i < 8; ++i) g.b[corner[i]] = g.b[corner[i]] + Vector3<double>{f[0][i], f[1][i], f[2][i]};
  return g;
}

template <class Shape>
class OnePoint : public testing::Test {};
using Shapes = testing::Types<Wedge6, Pyramid5>;
struct NameShape {
  template <class Shape>
  static std::string GetName(int) {
    return Shape::corners == 6 ? "Wedge6" : "Pyramid5";
  }
};
TYPED_TEST_SUITE(OnePoint, Shapes, NameShape);

TEST(OnePointGeometry, OfTheShapesOfReferenceIsThatOfTheBooks) {
  EXPECT_DOUBLE_EQ(find_corner_gradient(reference_places(Wedge6())).volume, 0.5);
  EXPECT_DOUBLE_EQ(find_corner_gradient(reference_places(Pyramid5())).volume, 1.0 / 3);
  const auto g = find_corner_gradient(reference_places(Wedge6()));
  EXPECT_DOUBLE_EQ(g.b[1].x, 0.25);  // half of V times the gradient (1, 0) of the triangle's shape function
  EXPECT_DOUBLE_EQ(g.b[3].z, 1.0 / 6);
}

TYPED_TEST(OnePoint, HasVolumeAndMeanGradientOfTheCollapsedHexahedron) {
  Random random(3);
  for (int k = 0; k < 50; ++k) {
    const auto x = make_places<TypeParam>(random, 0.4);
    const auto g = find_corner_gradient(x);
    const auto expected = find_collapsed_gradient(x);
    EXPECT_NEAR(g.volume, expected.volume, 1e-14);
    for (int i = 0; i < TypeParam::corners; ++i) EXPECT_NEAR(norm(g.b[i] - expected.b[i]), 0, 1e-14);
  }
}

TYPED_TEST(OnePoint, FindsTheGradientOfALinearFieldExactly) {
  Random random(4);
  for (int k = 0; k < 50; ++k) {
    const auto x = make_places<TypeParam>(random, 0.4);
    const Matrix3<double> a = random_matrix(random, 1);
    const auto g = find_corner_gradient(x);
    const Matrix3<double> l = find_mean_gradient(apply(a, x), g);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(norm(l.row[i] - a.row[i]), 0, 1e-12);
    const auto gamma = find_hourglass_vectors(x, g);
    for (int h = 0; h < TypeParam::modes; ++h) {
      Vector3<double> sum{0, 0, 0};
      double of_one = 0;
      for (int i = 0; i < TypeParam::corners; ++i) {
        sum = sum + gamma.of[h][i] * (a * x[i]);
        of_one += gamma.of[h][i];
      }
      EXPECT_NEAR(norm(sum), 0, 1e-13);
      EXPECT_NEAR(of_one, 0, 1e-14);
    }
  }
}

TYPED_TEST(OnePoint, HasModesOfUnitLengthThatAreOrthogonal) {
  for (int h = 0; h < TypeParam::modes; ++h) {
    for (int k = 0; k < TypeParam::modes; ++k) {
      double product = 0;
      for (int i = 0; i < TypeParam::corners; ++i) product += TypeParam::mode[h][i] * TypeParam::mode[k][i];
      EXPECT_NEAR(product, h == k ? 1 : 0, 1e-15);
    }
  }
}

TYPED_TEST(OnePoint, HasForcesThatSumToNothingAndHaveTheirPower) {
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    const auto x = make_places<TypeParam>(random, 0.4);
    const auto v = make_motion<TypeParam>(random);
    const Symmetric3<double> p{random(), random(), random(), random(), random(), random()};
    ModeVectors<double, TypeParam> q;
    for (auto& mode : q.at) mode = {random(), random(), random()};
    const auto g = find_corner_gradient(x);
    Places<TypeParam> f;
    find_corner_forces(p, q, g, find_hourglass_vectors(x, g), f);
    Vector3<double> sum{0, 0, 0}, moment{0, 0, 0};
    double power = 0;
    for (int i = 0; i < TypeParam::corners; ++i) {
      sum = sum + f[i];
      moment = moment + cross(x[i], f[i]);
      power += dot(f[i], v[i]);
    }
    EXPECT_NEAR(norm(sum), 0, 1e-14);
    EXPECT_NEAR(norm(moment), 0, 1e-14);
    const Matrix3<double> l = find_mean_gradient(v, g);
    double expected = g.volume * contract(p, symmetric_part(l));
    const auto rates = find_modes(v), places = find_modes(x);
    for (int h = 0; h < TypeParam::modes; ++h) expected += dot(q.at[h], rates.at[h] - l * places.at[h]);
    EXPECT_NEAR(power, expected, 1e-13);
  }
}

TYPED_TEST(OnePoint, TurnedRigidlyHasNoForces) {
  Random random(6);
  auto x = make_places<TypeParam>(random, 0.3);
  const auto par = make_solid_parameters({2e9, 1e9});
  auto state = make_solid<TypeParam>(1);
  Places<TypeParam> f;
  for (int step = 0; step < 50; ++step) {  // each turns about the middle of its way, as the mid-point rule is exact for
    const Places<TypeParam> end = apply(find_rotation(1.0, {0.3, -0.5, 0.4}), x);
    Places<TypeParam> v;
    for (int i = 0; i < TypeParam::corners; ++i) v[i] = end[i] - x[i];
    advance_solid(par, end, v, 1.0, state, f);
    for (int i = 0; i < TypeParam::corners; ++i) EXPECT_NEAR(norm(f[i]), 0, 1e-11 * 1e9);
    x = end;
  }
}

// Work of the stresses and of hourglass control: with a small step from rest the energy 1/2 u K u of both.
TYPED_TEST(OnePoint, StoresTheWorkThatItsForcesDo) {
  Random random(7);
  const auto x = make_places<TypeParam>(random, 0.3);
  const auto u = make_motion<TypeParam>(random);
  const double small = 1e-7;
  Places<TypeParam> end, v, f;
  for (int i = 0; i < TypeParam::corners; ++i) {
    end[i] = x[i] + small * u[i];
    v[i] = small * u[i];
  }
  auto state = make_solid<TypeParam>(1);
  const auto result = advance_solid(make_solid_parameters({2e9, 1e9}), end, v, 1.0, state, f);
  double power = 0;
  for (int i = 0; i < TypeParam::corners; ++i) power += 0.5 * dot(f[i], v[i]);
  EXPECT_GT(result.work.hourglass, 0.01 * result.work.internal);
  EXPECT_NEAR((result.work.internal + result.work.hourglass) / power, 1, 1e-6);
}

/// Largest eigenvalue of M^-1 K by the power method, from the forces of small motions.
template <class Shape>
double find_frequency_square(const Places<Shape>& x, const SolidParameters<Elastic>& par, double mass, Random& random) {
  const double small = 1e-7;
  Places<Shape> u = make_motion<Shape>(random);
  double square = 0;
  for (int k = 0; k < 400; ++k) {
    auto state = make_solid<Shape>(mass);
    Places<Shape> end, v, f;
    double length = 0;
    for (int i = 0; i < Shape::corners; ++i) length += dot(u[i], u[i]);
    double edge = 1e300;
    for (int i = 1; i < Shape::corners; ++i) edge = std::min(edge, norm(x[i] - x[0]));
    const double scale = small * edge / std::sqrt(length);
    for (int i = 0; i < Shape::corners; ++i) {
      v[i] = scale * u[i];
      end[i] = x[i] + v[i];
    }
    advance_solid(par, end, v, 1.0, state, f);
    double work = 0, kinetic = 0;
    for (int i = 0; i < Shape::corners; ++i) {
      const double of_corner = Shape::mass_share[i] * mass;
      work += dot(f[i], v[i]);
      kinetic += of_corner * dot(v[i], v[i]);
      u[i] = (1 / of_corner) * f[i];
    }
    square = work / kinetic;
  }
  return square;
}

TYPED_TEST(OnePoint, HasAStepBelowThatOfItsTrueLargestFrequency) {
  Random random(8);
  double tightest = 0;
  const Vector3<double> stretches[] = {{1, 1, 1},    {1, 1, 0.1}, {1, 1, 10},  {10, 1, 1},
                                       {1, 100, 10}, {1, 0.3, 1}, {0.01, 1, 1}};
  for (int k = 0; k < 210; ++k) {
    const double distortion = k < 7 ? 0 : 0.1 * (k % 5);
    const auto x = make_places<TypeParam>(random, distortion, stretches[k % 7]);
    const LameConstants c = find_lame_constants(1e9, 0.25 + 0.24 * random());
    const double hourglass[] = {0.05, 0.5, 2, 0};
    const auto par = make_solid_parameters(c, hourglass[k / 7 % 4]);
    const double mass = 1000 * find_corner_gradient(x).volume;
    auto state = make_solid<TypeParam>(mass);
    Places<TypeParam> f;
    const double step = advance_solid(par, x, Places<TypeParam>{}, 0.0, state, f).stable_step;
    const double used = step * std::sqrt(find_frequency_square(x, par, mass, random)) / 2;
    ASSERT_LE(used, 1 + 1e-5) << "shape " << k;
    EXPECT_GT(used, 0.55) << "shape " << k;
    tightest = std::max(tightest, used);
  }
  EXPECT_GT(tightest, 0.97);
}

/// Other numberings of the same element, by corner.
std::vector<std::array<int, 6>> numberings(Wedge6) {
  return {{1, 2, 0, 4, 5, 3}, {2, 0, 1, 5, 3, 4}, {3, 5, 4, 0, 2, 1}};
}
std::vector<std::array<int, 5>> numberings(Pyramid5) { return {{1, 2, 3, 0, 4}, {2, 3, 0, 1, 4}}; }

TYPED_TEST(OnePoint, HasTheSameForcesHoweverItIsNumbered) {
  Random random(9);
  const auto x = make_places<TypeParam>(random, 0.3);
  const auto v = make_motion<TypeParam>(random);
  const auto par = make_solid_parameters({2e9, 1e9}, 0.7, {0.06, 1.2});
  const auto advance = [&](const Places<TypeParam>& at, const Places<TypeParam>& by) {
    auto state = make_solid<TypeParam>(1000);
    Places<TypeParam> f;
    advance_solid(par, at, by, 1e-3, state, f);
    return f;
  };
  const auto f = advance(x, v);
  for (const auto& order : numberings(TypeParam())) {
    Places<TypeParam> xs, vs;
    for (std::size_t i = 0; i < order.size(); ++i) {
      xs.at[i] = x[order[i]];
      vs.at[i] = v[order[i]];
    }
    const auto fs = advance(xs, vs);
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_NEAR(norm(fs.at[i] - f[order[i]]), 0, 1e-11 * norm(f[order[i]]));
  }
}

// For shapes cut from a cube both thicknesses are about its edge. Those of the pyramid are equal along and across its
// axis.
TEST(OnePointStep, HasAThicknessThatIsTheWayOfAWave) {
  const auto find = [](const auto& x) {
    const auto g = find_corner_gradient(x);
    return find_thickness(find_gradient_sizes(g, find_hourglass_vectors(x, g)), g.volume);
  };
  EXPECT_NEAR(find(reference_places(Pyramid5())), std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(find(apply<Wedge6>({{{1e3, 0, 0}, {0, 1e3, 0}, {0, 0, 1}}}, reference_places(Wedge6()))), 1, 1e-5);
}

// Viscosity: tangent eta: the rate of damping eta tr G / (m V) is the largest eigenvalue of M^-1 C, a form of rank one.
TYPED_TEST(OnePoint, HasAStepThatKnowsItsViscosity) {
  Random random(10);
  const auto x = make_places<TypeParam>(random, 0.3);
  const auto g = find_corner_gradient(x);
  const auto size = find_gradient_sizes(g, find_hourglass_vectors(x, g));
  double sum = 0;
  for (int i = 0; i < TypeParam::corners; ++i) sum += dot(g.b[i], g.b[i]) / TypeParam::mass_share[i];
  EXPECT_NEAR(size.trace, sum, 1e-14 * sum);
  const double step = find_one_point_step<double>(size, g.volume, 2.0, {0, 0, 0, 5.0});
  EXPECT_NEAR(step, 2 / (5.0 * sum / (2.0 * g.volume)), 1e-12 * step);
}

TYPED_TEST(OnePoint, HasRecordsThatLieAsTheirPlacesSay) {
  using Record = OnePointRecord<TypeParam>;
  ElasticSolid<TypeParam> s{};
  const auto place = [&](const double& scalar) { return static_cast<int>(&scalar - reinterpret_cast<double*>(&s)); };
  EXPECT_EQ(place(s.polar.rotation.row[0].x), Record::rotation);
  EXPECT_EQ(place(s.stress.xx), Record::stress);
  EXPECT_EQ(place(s.hourglass.at[0].x), Record::hourglass);
  EXPECT_EQ(sizeof(OnePointState<double, J2Plasticity, TypeParam>), Record::find_size(1) * sizeof(double));
}

}  // namespace
}  // namespace percuss::test::one_point_test
