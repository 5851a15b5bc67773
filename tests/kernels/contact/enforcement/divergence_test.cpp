// Rows whose gaps change in other directions than they push.

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/contact/enforcement/row_solution.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::divergence_test {

// Two walls push a node along d1, d2 at 120 degrees, and their gaps change along g1, g2 with g.d = 1 each and
// g1.d2 = g2.d1 = cos(170) / cos(50) = -1.53: whatever both push opens less of one gap than it closes of the other.
TEST(Divergence, RowsThatCloseEachOtherEndWithFinitePushes) {
  const double dt = 0.01, turn = M_PI / 180;
  BrickScene bricks;
  bricks.add_brick({0, 0, 0}, {1, 1, 1}, {0, 0, 1});
  const auto point_up = [&](double angle) { return Point3{std::sin(angle * turn), 0, std::cos(angle * turn)}; };
  const WallPairs walls{to_array(std::vector<ContactWall>{{{0, 0, 0}, point_up(-60), 0}, {{0, 0, 0}, point_up(60), 0}}),
                        to_array(std::vector<int>{0, 1}), to_array(std::vector<int>{0, 0}),
                        to_array(std::vector<double>{1, 1})};
  const CheckedScene scene(bricks, dt, 0);
  const Rows3<double> before = to_rows(bricks.v), inverse_mass = to_rows(bricks.inverse_mass);
  const ContactHistory history = make_empty_history(bricks.num_nodes(), 2);
  const Array<std::int64_t> numbers("test::numbers", static_cast<std::size_t>(bricks.num_nodes()));
  for (int i = 0; i < bricks.num_nodes(); ++i) numbers(i) = i;
  RowSystem system;
  OneRank others;
  const SmallSpace space;
  const RowInputs inputs{scene.motion, before, inverse_mass, numbers, 1};
  const RowSources sources{Array<RowTouch>("test::touches", 0), 0, walls};
  count_rows(space, inputs, sources, system);
  build_rows(space, inputs, sources, history, system, others);
  ASSERT_EQ(system.num_rows, 2);
  for (int r = 0; r < 2; ++r) {
    ContactRow& row = system.rows(r);
    row.gap_gradient = (1 / std::cos(50 * turn)) * point_up(r == 0 ? -110 : 110);
    row.gap = dt * dot(row.gap_gradient, Point3{0, 0, 1});
  }
  pack_geometry(space, system);
  sum_stiffness(space, system);
  RowSumMemory memory;
  const SolveReport solved = solve_kinematic(space, {dt, dt, 1e-3}, system, memory, others);
  EXPECT_TRUE(solved.converged);
  // Symmetric: the pushes p of both close p + cos(120) p = p / 2 of either gap, which misses cos(110) / cos(50).
  for (int r = 0; r < 2; ++r)
    EXPECT_NEAR(system.rows(r).impulse.normal, -2 * std::cos(110 * turn) / std::cos(50 * turn), 2e-2);
}

}  // namespace percuss::test::divergence_test
