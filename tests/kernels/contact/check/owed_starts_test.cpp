// What is found of touches and of nodes together, against what is found of them one by one.

#include "kernels/contact/check/owed_starts.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test {
namespace {

struct Draw {
  std::mt19937 random{41};

  double value(double largest) { return largest * (2 * (static_cast<double>(random()) / 4294967295.0) - 1); }
  Point3 point(double largest) { return {value(largest), value(largest), value(largest)}; }
};

/// Bricks with crooked faces.
BrickScene draw_bricks(Draw& draw) {
  BrickScene bricks = make_pile();
  for (Point3& x : bricks.x) x = x + draw.point(0.2);
  for (Point3& v : bricks.v) v = v + draw.point(1);
  return bricks;
}

TEST(OwedStarts, EachTouchHasTheGapThatItWouldHaveAlone) {
  Draw draw;
  const CheckedScene scene(draw_bricks(draw), 0.01);
  const CheckInputs inputs = scene.inputs();
  constexpr int nodes = 16;
  NodeTouches together[nodes], alone[nodes];
  for (int node = 0; node < nodes; ++node) {
    together[node].count = node % (contact_limits::max_touches + 1);
    for (int i = 0; i < together[node].count; ++i) {
      Touch& touch = together[node].touch[i];
      start_touch((5 * node + i) % scene.surface.num_faces, 1, 0, touch);
      touch.normal = normalize(load_row(scene.faces.normal, touch.face) + draw.point(i == 0 ? 0.1 : 2));
      touch.gap_start = -7;
      touch.owes_start = i != 1;
    }
    alone[node] = together[node];
  }
  OwedStarts<Thickness::none> owed;
  for (int node = 0; node < nodes; ++node) owed.add(inputs, node, together[node]);
  owed.settle();
  int found = 0;
  for (int node = 0; node < nodes; ++node) {
    const CheckedNode checked = load_checked_node(scene.surface, scene.motion, node);
    for (int i = 0; i < alone[node].count; ++i, ++found) {
      settle_start<Thickness::none>(inputs, checked, alone[node].touch[i]);
      EXPECT_EQ(together[node].touch[i].gap_start, alone[node].touch[i].gap_start);
      EXPECT_FALSE(together[node].touch[i].owes_start);
      const double kept = together[node].touch[i].gap_start;
      EXPECT_TRUE(i != 1 || kept == -7) << kept;
    }
  }
  EXPECT_EQ(found, 24);
}

/// One node that is a corner of `around` faces, whose normals are drawn, and no two of which share another node.
struct Hub {
  ContactSurface surface;
  FaceState faces;

  Hub(Draw& draw, int around, double spread) {
    std::vector<std::array<int, 4>> corners;
    std::vector<int> offset{0}, held_by;
    for (int f = 0; f < around; ++f) {
      std::array<int, 4> face{3 * f + 1, 3 * f + 2, 3 * f + 3, 3 * f + 3};
      std::swap(face[static_cast<std::size_t>(f % 4)], face[2]);
      face[static_cast<std::size_t>(f % 4)] = 0;
      corners.push_back(face);
      held_by.push_back(f);
    }
    offset.push_back(around);
    surface.num_nodes = 1;
    surface.num_faces = around;
    surface.face_corners = to_rows4(corners);
    surface.nodes_to_faces_offset = to_array(offset);
    surface.nodes_to_faces = to_array(held_by);
    const auto count = static_cast<std::size_t>(around);
    faces = {Rows3<double>("test::normal", count), Array<double>("test::size", count), Boxes("test::box", count)};
    faces.vertex = Array<CornerDirections>("test::vertex", count);
    for (int f = 0; f < around; ++f) store_row(faces.normal, f, normalize(Point3{0, 0, 1} + draw.point(spread)));
  }
};

TEST(VertexNormals, OfAllFacesAroundANodeAreThoseOfEachFace) {
  Draw draw;
  int apart = 0;
  for (int turn = 0; turn < 400; ++turn) {
    const int around = 1 + turn % 9;
    const Hub hub(draw, around, turn % 2 == 0 ? 0.2 : 0.6);
    set_vertex_normals_at(hub.surface, hub.faces, 0);
    for (int f = 0; f < around; ++f) {
      const int at = f % 4;
      const Point3 expected = find_vertex_normals(hub.surface, hub.faces, f, [at](int i) { return i == at; }).of[at];
      const Point3 got = hub.faces.vertex(f).of[at], other = hub.faces.vertex(0).of[0];
      EXPECT_EQ(got.x, expected.x);
      EXPECT_EQ(got.y, expected.y);
      EXPECT_EQ(got.z, expected.z);
      apart += got.x != other.x ? 1 : 0;
    }
  }
  EXPECT_GT(apart, 100);
}

}  // namespace
}  // namespace percuss::test
