#include "kernels/element/hex8/centroid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::centroid_test {

namespace {

constexpr Vector3<double> weight{3.0, -7.0, 9.81};
constexpr double mass = 2.5;

/// w . xc by 3x3x3 Gauss points, which have one more than is needed.
double find_height_of_centroid(const Corners& c) {
  const double g = std::sqrt(0.6), place[3] = {-g, 0, g}, of_place[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  double volume = 0, moment = 0;
  for (int p = 0; p < 27; ++p) {
    const int at[3] = {p % 3, p / 3 % 3, p / 9};
    const double xi = place[at[0]], eta = place[at[1]], zeta = place[at[2]];
    Matrix3<double> j{};
    double height = 0;
    for (int i = 0; i < 8; ++i) {
      const double sx = 1 + corner_xi[i] * xi, sy = 1 + corner_eta[i] * eta, sz = 1 + corner_zeta[i] * zeta;
      const Vector3<double> dn{corner_xi[i] * sy * sz / 8, corner_eta[i] * sx * sz / 8, corner_zeta[i] * sx * sy / 8};
      j.row[0] = j.row[0] + c.x[i] * dn;
      j.row[1] = j.row[1] + c.y[i] * dn;
      j.row[2] = j.row[2] + c.z[i] * dn;
      height += sx * sy * sz / 8 * (weight.x * c.x[i] + weight.y * c.y[i] + weight.z * c.z[i]);
    }
    const double part = of_place[at[0]] * of_place[at[1]] * of_place[at[2]] * determinant(j);
    volume += part;
    moment += part * height;
  }
  return moment / volume;
}

/// An element of which some corners of the hexahedron coincide.
Corners collapse(const Collapsed& shape, const Corners& own) {
  Corners c{};
  for (int i = 0; i < 8; ++i) {
    c.x[i] = own.x[shape.corner[i]];
    c.y[i] = own.y[shape.corner[i]];
    c.z[i] = own.z[shape.corner[i]];
  }
  return c;
}

double find_energy(const Collapsed& shape, const Corners& own) {
  const Corners c = collapse(shape, own);
  double mean = 0;
  for (int i = 0; i < 8; ++i) mean += shape.share[i] * (weight.x * c.x[i] + weight.y * c.y[i] + weight.z * c.z[i]);
  return -mass * (find_height_of_centroid(c) - mean);
}

/// Forces of the corners of the element.
Corners find_forces(const Collapsed& shape, const Corners& own) {
  double f[3][8];
  find_centroid_forces(find_modes(collapse(shape, own)), mass, weight, f);
  if (!shape.is_whole) add_weight_of_shares(shape, mass, weight, f);
  Corners forces{};
  for (int i = 0; i < 8; ++i) {
    forces.x[shape.corner[i]] += f[0][i];
    forces.y[shape.corner[i]] += f[1][i];
    forces.z[shape.corner[i]] += f[2][i];
  }
  return forces;
}

/// Central differences of the energy are exact to some 1e-9 of the weight.
void expect_gradient(const Collapsed& shape, int corners, const Corners& own) {
  constexpr double step = 1e-5;
  Corners forces = find_forces(shape, own);
  double sum[3] = {};
  for (int i = 0; i < corners; ++i)
    for (int k = 0; k < 3; ++k) {
      Corners plus = own, minus = own;
      (k == 0 ? plus.x : k == 1 ? plus.y : plus.z)[i] += step;
      (k == 0 ? minus.x : k == 1 ? minus.y : minus.z)[i] -= step;
      const double force = (k == 0 ? forces.x : k == 1 ? forces.y : forces.z)[i];
      const double expected = (find_energy(shape, plus) - find_energy(shape, minus)) / (2 * step);
      EXPECT_NEAR(force, expected, 1e-7) << "corner " << i << " direction " << k;
      sum[k] += force;
    }
  for (const double total : sum) EXPECT_NEAR(total, 0, 1e-13);
}

}  // namespace

TEST(Centroid, ForcesAreTheGradientOfTheEnergyOfDistortedHexahedra) {
  Random random(1);
  const Collapsed shape = find_collapsed(ElementFamily::hexahedra);
  for (int k = 0; k < 20; ++k) expect_gradient(shape, 8, make_element(random, 1.0, 0.7, 1.9, 0.2));
}

TEST(Centroid, WedgesAndPyramidsAreHexahedraWithCornersThatCoincide) {
  Random random(2);
  const Corners wedge{{0, 1, 0, 0, 1, 0}, {0, 0, 1, 0, 0, 1}, {0, 0, 0, 1, 1, 1}};
  const Corners pyramid{{0, 1, 1, 0, 0.5}, {0, 0, 1, 1, 0.5}, {0, 0, 0, 0, 0.8}};
  for (int k = 0; k < 20; ++k) {
    Corners a = wedge, b = pyramid;
    for (int i = 0; i < 6; ++i) {
      for (Corners* const c : {&a, &b}) {
        c->x[i] += 0.15 * random();
        c->y[i] += 0.15 * random();
        c->z[i] += 0.15 * random();
      }
    }
    expect_gradient(find_collapsed(ElementFamily::wedges), 6, a);
    expect_gradient(find_collapsed(ElementFamily::pyramids), 5, b);
  }
}

TEST(Centroid, WeightCountsUpToTwiceGravityOrToTheJumpOfAWave) {
  Random random(3);
  const VectorModes<double> a = find_modes(make_element(random, 0.1, 0.1, 0.1, 0));
  const Vector3<double> gravity{0, 0, -9.81};
  const auto share = [&](const Vector3<double>& w, double modulus, double mass = 1) {  // density 1000
    return find_weight_share(a, mass, w, gravity, modulus);
  };
  EXPECT_EQ(share({0, 0, 0}, 1e7), 1);                       // free fall
  EXPECT_EQ(share({0, 0, -19.6}, 0), 1);                     // a gas without pressure
  EXPECT_NEAR(share({0, 0, -981}, 0), 0.02, 1e-15);          // cut to twice gravity
  EXPECT_NEAR(share({981, 0, 0}, 2.2e9), 1, 1e-15);          // water in a crash: 4.5e-5 of its modulus
  EXPECT_NEAR(share({1e6, 0, 0}, 2.2e9), 0.022, 1e-12);      // a shock: 0.001 of 2.2e6 over 0.1
  EXPECT_NEAR(share({1e6, 0, 0}, 2.2e9, 4), 0.0055, 1e-12);  // of a scaled mass
}

}  // namespace percuss::test::centroid_test
