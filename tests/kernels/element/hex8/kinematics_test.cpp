#include "kernels/element/hex8/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::kinematics_test {

namespace {

Polar<double> make_polar() { return {identity_matrix<double>(), {1, 1, 1, 0, 0, 0}}; }

double largest(const Matrix3<double>& m) {
  double size = 0;
  for (const auto& r : m.row) size = std::max({size, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
  return size;
}

/// Simple shear F = I + gamma e1 e2: Omega turns by atan(gamma / 2) in total (Dienes 1979).
double shear_rotation_error(int steps) {
  const double gamma = 4;
  Polar<double> p = make_polar();
  Matrix3<double> turn;
  for (int n = 0; n < steps; ++n) {
    Matrix3<double> l{};
    l.row[0].y = gamma;  // rate over unit time; constant for simple shear
    advance_polar(l, 1.0 / steps, p, turn);
  }
  const double angle = std::atan2(p.rotation.row[0].y, p.rotation.row[0].x);
  return std::abs(angle - std::atan(gamma / 2));
}

}  // namespace

TEST(Kinematics, RotationIncrementIsOrthogonalForAnyStep) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Vector3<double> w{10 * random(), 10 * random(), 10 * random()};
    const Matrix3<double> r = find_rotation_increment(w, 0.3);
    EXPECT_LT(largest(r * transpose(r) - identity_matrix<double>()), 1e-14);
    EXPECT_NEAR(determinant(r), 1, 1e-14);
  }
}

TEST(Kinematics, RigidSpinOfAHundredTurnsLeavesTheStretchAlone) {
  Polar<double> p = make_polar();
  p.stretch = {1.4, 0.8, 1.1, 0.2, 0.1, -0.05};
  const double tr = trace(p.stretch), square = contract(p.stretch, p.stretch);
  const Matrix3<double> spin = antisymmetric(Vector3<double>{0.3, -0.5, 0.8});
  Matrix3<double> turn;
  for (int n = 0; n < 100 * 400; ++n) advance_polar(spin, 2 * std::numbers::pi / 400, p, turn);
  // Round-off of 40 000 steps, each 1e-16: at most 4e-12 if all went one way.
  EXPECT_NEAR(trace(p.stretch), tr, 4e-12);
  EXPECT_NEAR(contract(p.stretch, p.stretch), square, 4e-12);
  EXPECT_LT(largest(p.rotation * transpose(p.rotation) - identity_matrix<double>()), 4e-12);
}

TEST(Kinematics, RotationInSimpleShearConvergesAtEighthOrder) {
  const double coarse = shear_rotation_error(10), fine = shear_rotation_error(20);
  EXPECT_LT(fine, 5e-11);
  EXPECT_GT(std::log2(coarse / fine), 7.5);
}

TEST(Kinematics, StretchAndRotationMultiplyToTheDeformation) {
  // A constant velocity gradient L0 over steps that see the mid-point gradient: F is known from the increments.
  Random random(7);
  const int steps = 200;
  const Matrix3<double> l = random_matrix(random, 1.0);
  const double dt = 1.0 / steps;
  Polar<double> p = make_polar();
  Matrix3<double> f = identity_matrix<double>();
  for (int n = 0; n < steps; ++n) {
    const Matrix3<double> half = (0.5 * dt) * l;
    f = inverse(identity_matrix<double>() - half) * ((identity_matrix<double>() + half) * f);
    const Matrix3<double> before = p.rotation;
    Matrix3<double> turn;
    advance_polar(l, dt, p, turn);
    EXPECT_LT(largest(p.rotation - turn * before), 1e-15);
  }
  // What the rotation misses in a step is far below round-off here.
  EXPECT_LT(largest(full(p.stretch) * p.rotation - f), 1e-12);
}

}  // namespace percuss::test::kinematics_test
