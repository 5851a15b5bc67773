// Rows of nodes on faces that are made a pack at a time, against the function of one row.

#include "kernels/contact/rows/row_filling.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace percuss::test::row_filling_test {
namespace {

struct Draw {
  std::mt19937 random{31};

  double value(double largest) { return largest * (2 * (static_cast<double>(random()) / 4294967295.0) - 1); }
  Point3 point(double largest) { return {value(largest), value(largest), value(largest)}; }
  bool once_in(unsigned times) { return random() % times == 0; }
};

/// Nodes of a row for each lane, and touches that begin or continue, with and without friction and thickness.
struct DrawnRows {
  static constexpr int lanes = TouchPack::lanes;
  RowNodes at;
  Array<RowTouch> touches = Array<RowTouch>("test::touches", lanes);
  ContactHistory history{Array<std::int64_t>("test::face", lanes), Rows3<double>("test::impulse", lanes),
                         Rows3<double>("test::slip", lanes), Array<double>("test::reference", lanes)};
  RowInputs inputs;
  bool has_spring[lanes];

  DrawnRows(Draw& draw, bool has_friction) {
    const auto nodes = static_cast<std::size_t>(row_nodes * lanes);
    at.x = Rows3<double>("test::x", nodes);
    at.v = Rows3<double>("test::v", nodes);
    at.v_checked = Rows3<double>("test::v_checked", nodes);
    inputs.motion.dt = 0.1;
    inputs.impulse_scale = 0.9;
    inputs.depth_tolerance = 1e-3;
    inputs.springs = draw.once_in(2) ? SpringRows::of_sheets : SpringRows::none;
    for (int lane = 0; lane < lanes; ++lane) {
      place(draw, lane);
      touch(draw, lane, has_friction);
      has_spring[lane] = has_springs(inputs) && draw.once_in(2);
    }
  }

  void place(Draw& draw, int lane) {
    const Point3 square[row_nodes] = {{0.2, 0.1, 0}, {-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}};
    const Point3 origin = draw.point(10), common = draw.point(1);
    const bool is_sliver = draw.once_in(16);
    for (int slot = 0; slot < row_nodes; ++slot) {
      const int node = row_nodes * lane + slot;
      const Point3 off = is_sliver && slot > 0 ? Point3{} : square[slot] + draw.point(0.2);
      store_row(at.x, node, origin + off);
      store_row(at.v, node, common + draw.point(0.3));
      store_row(at.v_checked, node, draw.once_in(2) ? load_row(at.v, node) : common + draw.point(0.3));
    }
  }

  void touch(Draw& draw, int lane, bool has_friction) {
    RowTouch touch;
    touch.key = 100 + lane;
    touch.record = touch.old_record = lane;
    if (draw.once_in(3)) touch.old_record = -1;
    const double a = 0.5 + draw.value(0.5), b = 0.5 + draw.value(0.5);
    const double weight[4] = {(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b};
    for (int k = 0; k < 4; ++k) touch.weight[k + 1] = -weight[k];
    touch.normal = normalize(Point3{0, 0, 1} + draw.point(draw.once_in(4) ? 2 : 0.1));
    touch.gap_start = draw.once_in(5) ? 0 : draw.value(draw.once_in(2) ? 1e-2 : 1e-5);
    touch.gap_end = touch.gap_start + draw.value(draw.once_in(4) ? 0.3 : 1e-3);
    touch.size = 0.5;
    touch.friction = has_friction && !draw.once_in(4) ? 0.4 : 0;
    touch.has_thickness = draw.once_in(3);
    touch.is_caught = draw.once_in(2);
    touches(lane) = touch;
    store_row(history.impulse, lane, draw.once_in(4) ? Point3{} : draw.point(1) + 0.5 * touch.normal);
    store_row(history.slip, lane, draw.point(draw.once_in(2) ? 1e-5 : 1e-3));
    history.reference(lane) = draw.once_in(2) ? 0 : 5e-3;
  }

  ContactRow fill_one(int lane) const {
    ContactRow row;
    for (int slot = 0; slot < row_nodes; ++slot) row.place[slot] = row_nodes * lane + slot;
    row.has_spring = has_spring[lane];
    fill_touch_row(history, inputs, at, touches(lane), row);
    return row;
  }

  Array<ContactRow> fill_together(int count) const {
    const Array<ContactRow> rows("test::rows", lanes);
    TouchPack pack;
    for (int lane = 0; lane < count; ++lane) {
      int places[row_nodes];
      for (int slot = 0; slot < row_nodes; ++slot) places[slot] = row_nodes * lane + slot;
      pack.add(touches(lane), lane, places, load_last_contact(history, touches(lane)), has_spring[lane]);
    }
    pack.fill_up();
    make_face_rows(pack, inputs, at, touches, rows);
    return rows;
  }
};

void expect_same_bits(double a, double b) { EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << a << " and " << b; }
void expect_same_bits(const Point3& a, const Point3& b) {
  expect_same_bits(a.x, b.x);
  expect_same_bits(a.y, b.y);
  expect_same_bits(a.z, b.z);
}
void expect_same_bits(const RowImpulse& a, const RowImpulse& b) {
  expect_same_bits(a.normal, b.normal);
  for (int d = 0; d < 2; ++d) expect_same_bits(a.tangential[d], b.tangential[d]);
}

void expect_same_bits(const ContactRow& a, const ContactRow& b) {
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.record, b.record);
  EXPECT_EQ(a.is_caught, b.is_caught);
  EXPECT_EQ(a.has_thickness, b.has_thickness);
  EXPECT_EQ(a.has_spring, b.has_spring);
  for (int slot = 0; slot < row_nodes; ++slot) {
    EXPECT_EQ(a.place[slot], b.place[slot]);
    expect_same_bits(a.weight[slot], b.weight[slot]);
    expect_same_bits(a.rho[slot], b.rho[slot]);
  }
  const Symmetric3<double>&i = a.inverse_inertia, &j = b.inverse_inertia;
  expect_same_bits(Point3{i.xx, i.yy, i.zz}, Point3{j.xx, j.yy, j.zz});
  expect_same_bits(Point3{i.xy, i.yz, i.zx}, Point3{j.xy, j.yz, j.zx});
  for (const auto vector :
       {&ContactRow::arm, &ContactRow::normal, &ContactRow::gap_gradient, &ContactRow::force, &ContactRow::couple})
    expect_same_bits(a.*vector, b.*vector);
  for (const auto value : {&ContactRow::gap, &ContactRow::target, &ContactRow::friction, &ContactRow::size,
                           &ContactRow::gap_start, &ContactRow::reference, &ContactRow::depth_tolerance})
    expect_same_bits(a.*value, b.*value);
  for (int d = 0; d < 2; ++d) {
    expect_same_bits(a.tangent[d], b.tangent[d]);
    expect_same_bits(a.slide[d], b.slide[d]);
  }
  expect_same_bits(a.impulse, b.impulse);
  expect_same_bits(a.previous, b.previous);
}

TEST(RowFilling, EachLaneHasTheBitsOfOneRow) {
  Draw draw;
  int pushing = 0, deep = 0, limited = 0;
  for (int turn = 0; turn < 2000; ++turn) {
    const DrawnRows drawn(draw, turn % 3 != 0);
    const int count = 1 + turn % DrawnRows::lanes;
    const Array<ContactRow> rows = drawn.fill_together(count);
    for (int lane = 0; lane < count; ++lane) {
      const ContactRow row = drawn.fill_one(lane);
      expect_same_bits(rows(lane), row);
      pushing += row.impulse.normal > 0 && row.friction > 0 ? 1 : 0;
      deep += row.gap_start < 0 ? 1 : 0;
      ContactRow unlimited = row;
      set_target(unlimited);
      limited += row.target < unlimited.target ? 1 : 0;
    }
  }
  EXPECT_GT(pushing, 200);
  EXPECT_GT(deep, 200);
  EXPECT_GT(limited, 50);
}

}  // namespace
}  // namespace percuss::test::row_filling_test
