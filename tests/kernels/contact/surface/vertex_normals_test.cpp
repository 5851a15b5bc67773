// Vertex normals of the faces around a node, found together, against those of one face.

#include <gtest/gtest.h>

#include <random>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::vertex_normals_test {
namespace {

struct Draw {
  std::mt19937 random{41};

  double value(double largest) { return largest * (2 * (static_cast<double>(random()) / 4294967295.0) - 1); }
  Point3 point(double largest) { return {value(largest), value(largest), value(largest)}; }
};

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
}  // namespace percuss::test::vertex_normals_test
