#include "kernels/node/pressure.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "kernels/core/tensor.hpp"

namespace percuss::test::pressure_test {

namespace {

/// One face over nodes at (0, 0), (2, 0), (2, 1) and (0, 1) of the plane z = 0, under a pressure of 3.
struct LoadedFace {
  PressureFaces faces;
  Array<double> pressure{"pressure", 1};
  Rows3<double> x{"x", 4}, v{"v", 4}, force{"force", 4};
  PressureSums sums{"sums", 1};

  LoadedFace(const int (&nodes)[4], bool follows) {
    faces.nodes = Rows4<int>("nodes", 1);
    for (int i = 0; i < 4; ++i) faces.nodes(0, i) = nodes[i];
    faces.load = Array<int>("load", 1);
    faces.dead_share = Rows3<double>("dead_share", 1);
    if (!follows) faces.dead_share(0, 2) = -0.25;  // of a face of area 1
    faces.first_of_run = Array<int>("first_of_run", 2);
    faces.first_of_run(1) = faces.count = faces.run_count = 1;
    pressure(0) = 3;
    for (const int n : {1, 2}) x(n, 0) = 2;
    for (const int n : {2, 3}) x(n, 1) = 1;
  }

  void apply() {
    apply_pressure(ExecSpace(), faces, pressure, {x, v, {1, 1, 0}}, force, sums);
    ExecSpace().fence();
  }
};

/// Forces of the slots of that face with the corners `nodes`.
Rows3<double> load_face(const int (&nodes)[4], bool follows) {
  LoadedFace face(nodes, follows);
  face.apply();
  return face.force;
}

/// The sum of the slots of each of four nodes.
void expect_shares(const int (&nodes)[4], bool follows, const double (&expected)[4]) {
  const Rows3<double> force = load_face(nodes, follows);
  double sum[4] = {0, 0, 0, 0};
  for (int i = 0; i < 4; ++i) sum[nodes[i]] += force(i, 2);
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(sum[n], expected[n], 1e-15) << "node " << n;
}

}  // namespace

TEST(Pressure, IsAQuarterOnEachNodeOfAQuadrilateral) {
  expect_shares({0, 1, 2, 3}, true, {-1.5, -1.5, -1.5, -1.5});
  expect_shares({0, 1, 2, 3}, false, {-0.75, -0.75, -0.75, -0.75});
}

TEST(Pressure, IsAThirdOnEachNodeOfATriangleWhicheverCornerStandsTwice) {
  for (const bool follows : {true, false}) {
    constexpr double third = -1;  // of 3 times an area of 1, that of the triangle and of the dead load
    expect_shares({0, 1, 2, 2}, follows, {third, third, third, 0});
    expect_shares({0, 1, 1, 2}, follows, {third, third, third, 0});
    expect_shares({0, 0, 1, 2}, follows, {third, third, third, 0});
    expect_shares({0, 1, 2, 0}, follows, {third, third, third, 0});
  }
}

/// -p int N_i n dA of a bilinear face, by 2x2 Gauss points, which are exact.
std::array<Vector3<double>, 4> integrate(const Vector3<double> (&corner)[4], double p) {
  constexpr double xi[4] = {-1, 1, 1, -1}, eta[4] = {-1, -1, 1, 1};
  const double r = 1 / std::sqrt(3.0);
  std::array<Vector3<double>, 4> load{};
  for (int g = 0; g < 4; ++g) {
    Vector3<double> along{0, 0, 0}, across{0, 0, 0};
    for (int i = 0; i < 4; ++i) {
      along = along + (0.25 * xi[i] * (1 + eta[i] * r * eta[g])) * corner[i];
      across = across + (0.25 * eta[i] * (1 + xi[i] * r * xi[g])) * corner[i];
    }
    for (std::size_t i = 0; i < 4; ++i)
      load[i] = load[i] + (-0.25 * p * (1 + xi[i] * r * xi[g]) * (1 + eta[i] * r * eta[g])) * cross(along, across);
  }
  return load;
}

TEST(Pressure, IsConsistentOnAFaceThatWarpsAndTapers) {
  const Vector3<double> corner[4] = {{0.1, -0.2, 0.3}, {2.3, 0.1, -0.4}, {1.6, 1.2, 0.5}, {-0.3, 0.8, -0.2}};
  LoadedFace face({0, 1, 2, 3}, true);
  for (int n = 0; n < 4; ++n) {
    face.x(n, 0) = corner[n].x;
    face.x(n, 1) = corner[n].y;
    face.x(n, 2) = corner[n].z;
  }
  face.apply();
  const auto expected = integrate(corner, 3);
  for (int n = 0; n < 4; ++n) {
    const Vector3<double>& load = expected[static_cast<std::size_t>(n)];
    EXPECT_NEAR(face.force(n, 0), load.x, 1e-14);
    EXPECT_NEAR(face.force(n, 1), load.y, 1e-14);
    EXPECT_NEAR(face.force(n, 2), load.z, 1e-14);
  }
}

/// Sums of the slots, of their moments about (1, 1, 0) and of their powers.
void expect_sums_of_slots(const LoadedFace& face, double old_power) {
  double sum[PressureSum::count] = {};
  for (int i = 0; i < 4; ++i) {
    const int n = face.faces.nodes(0, i);
    const double f = face.force(i, 2);
    sum[PressureSum::force + 2] += f;
    sum[PressureSum::moment] += (face.x(n, 1) - 1) * f;
    sum[PressureSum::moment + 1] -= (face.x(n, 0) - 1) * f;
    sum[PressureSum::power] += f * face.v(n, 2);
  }
  sum[PressureSum::old_power] = old_power;
  for (int k = 0; k < PressureSum::count; ++k) EXPECT_NEAR(face.sums(0, k), sum[k], 1e-14) << "sum " << k;
}

TEST(Pressure, SumsForcesMomentsAndPowers) {
  for (const auto& nodes : {std::array{0, 1, 2, 3}, std::array{0, 1, 2, 2}, std::array{0, 0, 1, 3}}) {
    const int corners[4] = {nodes[0], nodes[1], nodes[2], nodes[3]};
    LoadedFace face(corners, true);
    for (int n = 0; n < 4; ++n) face.v(n, 2) = n + 1;
    face.apply();
    expect_sums_of_slots(face, 0);
    const double power = face.sums(0, PressureSum::power);
    face.pressure(0) = 5;
    face.apply();  // the forces of before are those under 3
    expect_sums_of_slots(face, power);
    face.pressure(0) = 0;
    face.apply();
    expect_sums_of_slots(face, 5.0 / 3 * power);
    EXPECT_EQ(face.force(2, 2), 0);
    face.apply();  // nothing acts and nothing did
    expect_sums_of_slots(face, 0);
  }
}

}  // namespace percuss::test::pressure_test
