// Sums over the rows of a step that are made a pack at a time, against the functions of one row.

#include <gtest/gtest.h>

#include <limits>

#include "kernels/contact/rows/row_geometry.hpp"
#include "tests/kernels/contact/enforcement/enforced_scene.hpp"

namespace percuss::test::row_stiffness_test {
namespace {

using Small = EnforcedScene<SmallSpace>;

/// A row that nothing can move has lost its friction since, but not its tangents.
int count_first_directions(const ContactRow& row) { return norm(row.tangent[0]) > 0 ? 3 : 1; }

/// What a row adds to S of the node in a slot.
Point3 sum_of_slot(const ContactRow& row, int slot) {
  Point3 sum{};
  for (int d = 0; d < count_first_directions(row); ++d) {
    const Point3& direction = get_direction(row, d);
    sum = sum + find_abs(spread_impulse(row, slot, direction, find_couple(row, direction)));
  }
  return sum;
}

/// S of all places, in the order of the entries.
std::vector<Point3> sum_by_place(const RowSystem& system) {
  std::vector<Point3> sums(static_cast<std::size_t>(system.num_nodes));
  for (int a = 0; a < system.num_nodes; ++a)
    for (int i = system.offset(a); i < system.offset(a + 1); ++i) {
      const int entry = system.entry(i);
      Point3& sum = sums[static_cast<std::size_t>(a)];
      sum = sum + sum_of_slot(system.rows(entry / row_nodes), entry % row_nodes);
    }
  return sums;
}

/// D of direction d of a row.
double find_stiffness(const RowSystem& system, const std::vector<Point3>& sums, const ContactRow& row, int d) {
  const Point3& direction = get_direction(row, d);
  double stiffness = 0;
  for (int slot = 0; slot < count_nodes(row); ++slot) {
    const Point3 c = find_abs(spread_impulse(row, slot, direction, find_couple(row, direction)));
    const Point3 s = sums[static_cast<std::size_t>(row.place[slot])];
    const Point3 w = load_row(system.at.inverse_mass, row.place[slot]);
    stiffness += (c.x * s.x * w.x + c.y * s.y * w.y) + c.z * s.z * w.z;
  }
  return stiffness;
}

void expect_bounds_of_one_row(const BrickScene& bricks, double friction, const WallPairs& walls) {
  const Small scene(bricks, 0.01, friction, walls);
  const RowSystem& system = scene.system;
  ASSERT_GT(system.num_rows, 9);
  const std::vector<Point3> sums = sum_by_place(system);
  for (int a = 0; a < system.num_nodes; ++a) {
    const Point3 found = load_row(system.abs_sum, a), one = sums[static_cast<std::size_t>(a)];
    EXPECT_EQ(found.x, one.x);
    EXPECT_EQ(found.y, one.y);
    EXPECT_EQ(found.z, one.z);
  }
  for (int r = 0; r < system.num_rows; ++r) {
    const ContactRow& row = system.rows(r);
    if (row.is_held) continue;
    EXPECT_EQ(row.stiffness, find_stiffness(system, sums, row, 0));
    if (!(row.friction > 0)) continue;
    EXPECT_EQ(row.tangential_stiffness,
              std::max(find_stiffness(system, sums, row, 1), find_stiffness(system, sums, row, 2)));
  }
}

/// The floor below the first brick of a pile.
WallPairs make_floor(double friction) {
  return {to_array(std::vector<ContactWall>{{{0, 0, 0}, {0, 0, 1}, friction}}), to_array(std::vector<int>{0, 0, 0, 0}),
          to_array(std::vector<int>{0, 1, 2, 3}), to_array(std::vector<double>{1, 1, 1, 1})};
}

TEST(RowStiffness, HasTheBitsOfOneRowWithAndWithoutFriction) {
  expect_bounds_of_one_row(make_pile(), 0.4, Small::no_walls());
  expect_bounds_of_one_row(make_pile(), 0, Small::no_walls());
}

TEST(RowStiffness, HasTheBitsOfOneRowWhereOnlySomeRowsOfAPackHaveFriction) {
  expect_bounds_of_one_row(make_pile(), 0.4, make_floor(0));
  expect_bounds_of_one_row(make_pile(), 0, make_floor(0.3));
}

TEST(RowStiffness, HasTheBitsOfOneRowBesideNodesThatAreHeld) {
  expect_bounds_of_one_row(make_brick_wall(4), 0.3, Small::no_walls());
}

TEST(ShareSums, AddRowsInTheirOrderWhateverTheFourthColumnHolds) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  alignas(64) const double rows[] = {7, 7, 7, none, 1e17, 1, 0.5, none, 1, 2, 0.25, none, -1e17, 3, 0.125, none};
  const Point3 sum = sum_rows_of_four(rows, 1, 4);
  EXPECT_EQ(sum.x, 0);  // 1e17 + 1 is 1e17
  EXPECT_EQ(sum.y, 6);
  EXPECT_EQ(sum.z, 0.875);
  EXPECT_EQ(sum_rows_of_four(rows, 2, 2).x, 0);
}

}  // namespace
}  // namespace percuss::test::row_stiffness_test
