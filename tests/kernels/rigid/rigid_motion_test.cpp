// The turn of a rigid body against its nodes, its invariants and Euler's equations.

#include "kernels/rigid/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/rigid/body_response.hpp"

namespace percuss::test::rigid_motion_test {
namespace {

using Vector = Vector3<double>;

constexpr Symmetric3<double> principal{1, 2, 2.5, 0, 0, 0};

/// A body that turns freely.
struct FreeBody {
  Symmetric3<double> inertia;
  Vector momentum;
  Orientation orientation{};

  Symmetric3<double> inertia_now() const { return push_forward(find_rotation(orientation), inertia); }
  double energy() const { return 0.5 * dot(momentum, solve(inertia_now(), momentum)); }
  Vector advance(double dt) {
    const Vector q = find_turn(inertia_now(), momentum, {}, dt);
    orientation = turn(orientation, q);
    return q;
  }
};

/// Euler's equations in the axes of the body by Runge and Kutta's rule: angular momentum there at a time.
Vector integrate_euler(Vector y, double time, int steps) {
  const auto rate = [](const Vector& m) { return cross(m, solve(principal, m)); };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const Vector a = rate(y), b = rate(y + (0.5 * h) * a), c = rate(y + (0.5 * h) * b), d = rate(y + h * c);
    y = y + (h / 6) * (a + 2.0 * b + 2.0 * c + d);
  }
  return y;
}

double find_euler_error(int steps) {
  const double time = 10;
  const Vector start{0.1, 2, 0.3};
  FreeBody body{principal, start};
  for (int i = 0; i < steps; ++i) body.advance(time / steps);
  const Vector exact = integrate_euler(start, time, 20000);
  return norm(transpose_times(find_rotation(body.orientation), body.momentum) - exact);
}

TEST(RigidTurn, HasTheAngularMomentumThatWasAskedFor) {
  const Symmetric3<double> inertia{2, 3, 4, 0.3, -0.2, 0.1};
  const Vector momentum{1, -2, 3};
  for (const double dt : {1e-9, 1e-3, 0.3}) {
    const Vector found = find_spin_momentum(inertia, find_turn(inertia, momentum, {}, dt), dt);
    EXPECT_LT(norm(found - momentum), 1e-14 * norm(momentum)) << dt;
  }
}

TEST(RigidTurn, MovesNodesWithTheMeanVelocityAndTheMomentumOfTheBody) {
  const std::vector<Vector> nodes{{1, 2, 3}, {-1, 0.5, 1}, {2, -1, -2}, {-2, -1.5, -2}};  // about their centre
  Symmetric3<double> inertia{};
  for (const Vector& r : nodes)
    inertia =
        inertia +
        Symmetric3<double>{
            r.y * r.y + r.z * r.z, r.z * r.z + r.x * r.x, r.x * r.x + r.y * r.y, -r.x * r.y, -r.y * r.z, -r.z * r.x};
  const Vector momentum{10, -20, 5};
  const double dt = 0.1;
  const Vector q = find_turn(inertia, momentum, {}, dt);
  const Matrix3<double> rotation = find_rotation(turn({}, q));
  Vector sum{};
  for (const Vector& r : nodes) {
    const Vector next = rotation * r, mean = cross((2 / dt) * q, 0.5 * (r + next)), moved = (1 / dt) * (next - r);
    EXPECT_LT(norm(mean - moved), 1e-13 * norm(moved));
    sum = sum + cross(r, moved);
  }
  EXPECT_LT(norm(sum - momentum), 1e-13 * norm(momentum));
}

// A spin about the middle axis turns over again and again. Momentum is state; energy is an integral of the scheme.
TEST(RigidTurn, ConservesTheEnergyOfAFreeBodyThatTurnsOver) {
  FreeBody body{principal, {1e-3, 2 * 6.28, 1e-3}};
  const double energy = body.energy(), dt = 1e-2;  // a hundred steps a turn
  double least = 1;
  for (int i = 0; i < 20000; ++i) {
    body.advance(dt);
    EXPECT_NEAR(body.energy() / energy, 1, 1e-12);  // round-off of 20000 turns of the axes
    least = std::min(least, get(find_rotation(body.orientation) * Vector{0, 1, 0}, 1));
  }
  EXPECT_LT(least, -0.99);  // the middle axis has been upside down
}

TEST(RigidTurn, ConvergesToEulersEquationsWithTheSquareOfTheStep) {
  const double coarse = find_euler_error(1000), fine = find_euler_error(2000);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(RigidTurn, LeavesHeldRotationsAsTheyAreAskedFor) {
  const Symmetric3<double> inertia{2, 3, 4, 0.3, -0.2, 0.1};
  HeldSpin hold;
  hold.held[1] = true;
  hold.rate[1] = 0.7;
  const double dt = 0.05;
  const Vector momentum{1, -2, 3}, q = find_turn(inertia, momentum, hold, dt);
  EXPECT_DOUBLE_EQ(2 / dt * q.y, 0.7);
  const Vector found = find_spin_momentum(inertia, q, dt);
  EXPECT_NEAR(found.x, momentum.x, 1e-13);
  EXPECT_NEAR(found.z, momentum.z, 1e-13);
}

TEST(RigidBody, InertiaOfFreeRotationsIsThatWithoutTheOthers) {
  const Symmetric3<double> inertia{2, 3, 4, 0.3, -0.2, 0.1};
  const Symmetric3<double> one = invert_free(inertia, {true, true, false});
  EXPECT_DOUBLE_EQ(one.zz, 1.0 / 4);
  EXPECT_EQ(one.xx, 0);
  EXPECT_EQ(one.xy, 0);
  const Symmetric3<double> two = invert_free(inertia, {true, false, false});
  const double determinant = 3 * 4 - 0.04;
  EXPECT_NEAR(two.yy, 4 / determinant, 1e-15);
  EXPECT_NEAR(two.yz, 0.2 / determinant, 1e-15);
  EXPECT_EQ(two.xx, 0);
}

// Impulses on nodes and the velocities of nodes do the same work: the response is symmetric, and on its diagonal the
// compliance of a node.
TEST(BodyResponse, IsSymmetric) {
  const BodyResponse body{{}, {0.5, 0.5, 0}, {2, 3, 4, 0.3, -0.2, 0.1}};
  const Vector r{1, -2, 0.5}, s{0.3, 0.7, -1};
  for (int i = 0; i < 3; ++i) {
    Vector p{0, 0, 0};
    set(p, i, 1);
    const BodyChange of_p = find_change(body, find_wrench(r, p));
    EXPECT_NEAR(get(of_p.at(r), i), get(find_compliance(body, r), i), 1e-14);
    for (int k = 0; k < 3; ++k) {
      Vector j{0, 0, 0};
      set(j, k, 1);
      EXPECT_NEAR(get(of_p.at(s), k), get(find_change(body, find_wrench(s, j)).at(r), i), 1e-14);
    }
  }
}

}  // namespace
}  // namespace percuss::test::rigid_motion_test
