// Rows solved together: exact answers, the conditions themselves, and the same bits in any order.

#include "kernels/contact/enforcement/coupled_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "tests/kernels/contact/enforcement/enforced_scene.hpp"

namespace percuss::test::coupled_rows_test {
namespace {

using Scene = EnforcedScene<SmallSpace>;

Scene solve(const BrickScene& bricks, double friction, const WallPairs& walls = Scene::no_walls()) {
  return Scene(bricks, 0.01, friction, walls, Solver::together);
}

TEST(CoupledRows, NodesOfTwoMassesEndWithTheirCommonVelocity) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, 2}, 3);
  bricks.add_brick({0, 0, 1}, {1, 1, 1}, {0, 0, -1}, 1);
  const Scene scene = solve(bricks, 0);
  EXPECT_TRUE(scene.solved.converged);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(scene.v(4 + i).z, 1.25, 3e-10);  // 1e-10 of the closing velocity
    EXPECT_NEAR(scene.v(8 + i).z, 1.25, 3e-10);
    EXPECT_NEAR(scene.p(8 + i).z, 2.25, 3e-10);
  }
  EXPECT_EQ(scene.v(0).z, 2);  // not in contact
}

TEST(CoupledRows, BodiesThatPartAreNotHeld) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, -1});
  bricks.add_brick({0, 0, 1}, {1, 1, 1}, {0, 0, 1});
  const Scene scene = solve(bricks, 0.5);
  for (int n = 0; n < 16; ++n) EXPECT_EQ(scene.v(n).z, n < 8 ? -1 : 1);
  EXPECT_EQ(scene.sums.pushes, 0);
}

TEST(CoupledRows, FrictionSticksAndSlides) {
  for (const double speed : {0.4, 2.0}) {
    BrickScene bricks;
    bricks.add_brick({0, 0, 0}, {4, 4, 1});
    for (Point3& w : bricks.inverse_mass) w = {0, 0, 0};
    bricks.add_brick({1.25, 1.5, 1}, {1, 1, 1}, {speed, 0, -1});
    const Scene scene = solve(bricks, 0.5);
    for (int n = 8; n < 12; ++n) {
      EXPECT_NEAR(scene.v(n).x, std::max(0.0, speed - 0.5), 1e-13);
      EXPECT_NEAR(scene.v(n).z, 0, 1e-13);
    }
  }
}

TEST(CoupledRows, AWallPushesAndRubs) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0.005}, {1, 1, 1}, {3, 0, -1});
  const WallPairs walls{to_array(std::vector<ContactWall>{{{0, 0, 0}, {0, 0, 1}, 0.5}}),
                        to_array(std::vector<int>{0, 0, 0, 0}), to_array(std::vector<int>{0, 1, 2, 3}),
                        to_array(std::vector<double>{1, 1, 1, 1})};
  const Scene scene = solve(bricks, 0, walls);
  for (int n = 0; n < 4; ++n) {
    EXPECT_NEAR(scene.v(n).z, -0.5, 1e-13);
    EXPECT_NEAR(scene.v(n).x, 3 - 0.25, 1e-13);
  }
}

TEST(CoupledRows, TwoHeldBodiesAreLeftAlone) {
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, 2});
  bricks.add_brick({0, 0, 1}, {1, 1, 1}, {0, 0, -1});
  for (Point3& w : bricks.inverse_mass) w = {0, 0, 0};
  const Scene scene = solve(bricks, 0.5);
  EXPECT_TRUE(scene.solved.converged);
  for (int n = 8; n < 12; ++n) EXPECT_EQ(scene.v(n).z, -1);
}

/// x of the symmetric positive definite system a x = b, by Cholesky; none if it is singular.
std::optional<std::vector<double>> solve_dense(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double diagonal = a[j][j];
    for (std::size_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    if (!(a[j][j] > 1e-12 * diagonal)) return std::nullopt;
    a[j][j] = std::sqrt(a[j][j]);
    for (std::size_t i = j + 1; i < n; ++i) {
      for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

/// The frictionless rows of a scene as a dense problem.
struct DenseProblem {
  DenseProblem(const BrickScene& bricks, const RowSystem& system, double dt)
      : rows(static_cast<std::size_t>(system.num_rows)), c(rows, std::vector<Point3>(bricks.x.size())) {
    for (std::size_t r = 0; r < rows; ++r) {
      const ContactRow& row = system.rows(static_cast<int>(r));
      b.push_back((row.gap - row.target) / dt);
      for (int slot = 0; slot < count_nodes(row); ++slot)
        c[r][static_cast<std::size_t>(system.nodes(row.place[slot]))] =
            spread_impulse(row, slot, row.normal, find_couple(row, row.normal));
    }
    a.assign(rows, std::vector<double>(rows, 0));
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t q = 0; q < rows; ++q)
        for (std::size_t n = 0; n < bricks.x.size(); ++n) a[r][q] += bricks.inverse_mass[n].x * dot(c[r][n], c[q][n]);
  }

  /// p for the pushing rows `set`, if all conditions hold within `slack`.
  std::optional<std::vector<double>> try_set(unsigned set, double slack) const {
    std::vector<std::size_t> pushing;
    for (std::size_t r = 0; r < rows; ++r)
      if ((set >> r & 1U) != 0) pushing.push_back(r);
    std::vector<std::vector<double>> part(pushing.size(), std::vector<double>(pushing.size()));
    std::vector<double> right;
    for (std::size_t i = 0; i < pushing.size(); ++i) {
      for (std::size_t j = 0; j < pushing.size(); ++j) part[i][j] = a[pushing[i]][pushing[j]];
      right.push_back(-b[pushing[i]]);
    }
    const auto found = solve_dense(part, right);
    if (!found) return std::nullopt;
    std::vector<double> p(rows, 0);
    for (std::size_t i = 0; i < pushing.size(); ++i) {
      if ((*found)[i] < 0) return std::nullopt;
      p[pushing[i]] = (*found)[i];
    }
    for (std::size_t r = 0; r < rows; ++r) {
      double w = b[r];
      for (std::size_t q = 0; q < rows; ++q) w += a[r][q] * p[q];
      if (w < -slack) return std::nullopt;
    }
    return p;
  }

  std::size_t rows;
  std::vector<std::vector<Point3>> c;
  std::vector<double> b;
  std::vector<std::vector<double>> a;
};

TEST(CoupledRows, ACoupledPileEndsAtTheExactSolutionFoundByTryingEverySet) {
  const BrickScene bricks = make_pile();
  const Scene scene = solve(bricks, 0);
  const DenseProblem dense(bricks, scene.system, 0.01);
  ASSERT_GE(dense.rows, 12U);
  ASSERT_LE(dense.rows, 18U);
  std::optional<std::vector<double>> exact;
  for (unsigned set = 0; set < 1U << dense.rows && !exact; ++set) exact = dense.try_set(set, 1e-12);
  ASSERT_TRUE(exact);
  EXPECT_GE(std::count_if(exact->begin(), exact->end(), [](double p) { return p > 0; }), 6);
  // Velocities are unique, pushes are not always.
  for (std::size_t n = 0; n < bricks.x.size(); ++n) {
    Point3 dv{};
    for (std::size_t r = 0; r < dense.rows; ++r) dv = dv + (*exact)[r] * bricks.inverse_mass[n].x * dense.c[r][n];
    const int i = static_cast<int>(n);
    EXPECT_LT(norm(scene.v(i) - load_row(scene.before, i) - dv), 1e-9);  // of closing velocities of order one
  }
}

TEST(CoupledRows, AStaggeredWallOfBricksConverges) {
  for (const double friction : {0.0, 0.3})
    for (const int n : {3, 6}) {
      const BrickScene bricks = make_brick_wall(n);
      const Scene scene = solve(bricks, friction);
      EXPECT_TRUE(scene.solved.converged);
      EXPECT_LE(scene.solved.complementarity, 1e-10);
      EXPECT_LE(scene.sums.residual,
                1e-10 * 0.01);  // of a closing velocity of some 0.1 in dt = 0.01, relative to h = 1
    }
}

/// Relative velocity of a row after the impulses along a direction.
double find_rate(const Scene& scene, const ContactRow& row, const Point3& direction) {
  const auto velocity = [&](int slot) { return scene.v(scene.system.nodes(row.place[slot])); };
  return dot(direction, find_work_velocity(row, velocity));
}

TEST(CoupledRows, RubsAreWithinCoulombsConeAndAgainstTheSliding) {
  // Tops of a held floor: no two rows push the same nodes the same way.
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {9, 4, 1});
  for (Point3& w : bricks.inverse_mass) w = {0, 0, 0};
  const double speeds[4] = {0.05, 0.4, 0.8, 3};
  for (int i = 0; i < 4; ++i) bricks.add_brick({0.3 + 2 * i, 1.1, 1}, {1.2, 0.9, 1}, {speeds[i], -0.3 * speeds[i], -1});
  const Scene scene = solve(bricks, 0.5);
  int sticking = 0, sliding = 0;
  for (int r = 0; r < scene.system.num_rows; ++r) {
    const ContactRow& row = scene.system.rows(r);
    const double* t = row.impulse.tangential;
    const double w[2] = {find_rate(scene, row, row.tangent[0]), find_rate(scene, row, row.tangent[1])};
    const double friction = std::hypot(t[0], t[1]), slip = std::hypot(w[0], w[1]);
    EXPECT_LE(friction, 0.5 * row.impulse.normal * (1 + 1e-12));
    if (slip > 1e-9) {
      ++sliding;
      EXPECT_NEAR(friction, 0.5 * row.impulse.normal, 1e-12);
      EXPECT_NEAR(t[0] * w[0] + t[1] * w[1], -friction * slip, 1e-12);
    } else {
      ++sticking;
    }
  }
  EXPECT_EQ(sticking, 8);
  EXPECT_EQ(sliding, 8);
}

TEST(CoupledRows, MomentumAndBookedWorkClose) {
  const BrickScene bricks = make_pile();
  const Scene scene = solve(bricks, 0.4);
  ASSERT_GT(scene.sums.pushes, 6);
  const Gain gain = find_gain(scene, bricks);
  EXPECT_LT(norm(gain.linear), 1e-13);
  EXPECT_LT(norm(gain.angular), 1e-13);
  EXPECT_NEAR(scene.sums.normal_work.round() + scene.sums.friction_work.round(), gain.kinetic, 1e-13);
}

TEST(CoupledRows, TheOrderInWhichRowsArriveChangesNoBit) {
  const BrickScene bricks = make_brick_wall(4);
  const Scene scene = solve(bricks, 0.3);
  const Array<const std::int64_t> numbers = Scene::count_up(bricks.num_nodes());
  // As the solver met them: without an answer from before.
  std::vector<CoupledRow> rows = list_coupled_rows(scene.system, numbers);
  for (CoupledRow& row : rows) row.row.impulse = RowImpulse{};
  std::vector<RowImpulse> a, b;
  solve_in_key_order(rows, 0.01, a);
  std::vector<std::size_t> order(rows.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<CoupledRow> shuffled;
  for (const std::size_t i : order) shuffled.push_back(rows[i]);
  solve_in_key_order(shuffled, 0.01, b);
  for (std::size_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(b[i].normal, a[order[i]].normal);
    for (int d = 0; d < 2; ++d) ASSERT_EQ(b[i].tangential[d], a[order[i]].tangential[d]);
  }
}

}  // namespace
}  // namespace percuss::test::coupled_rows_test
