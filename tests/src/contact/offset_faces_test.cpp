// Faces moved outward for the thickness of shells, of a surface with rings and rims.

#include "kernels/contact/surface/offset_faces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/contact/check/pair_check.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/contact/check/check_space.hpp"

namespace percuss::test {
namespace {

/// A crooked patch of 3 x 3 shells of edge 1 and half thickness `half`, both sides, and a free node.
struct CrookedPatch {
  static constexpr int edge = 4, node = edge * edge;  // nodes along an edge; the free one
  Rows3<double> x = Rows3<double>("test::x", node + 1), v = Rows3<double>("test::v", node + 1);
  CheckSpace check;

  explicit CrookedPatch(double half) {
    SurfaceLists lists;
    for (int n = 0; n <= node; ++n) lists.nodes.push_back(n);
    lists.node_class.assign(lists.nodes.size(), 0);
    for (int j = 0; j + 1 < edge; ++j) {
      for (int i = 0; i + 1 < edge; ++i) {
        const int a = edge * j + i, b = a + 1, c = b + edge, d = a + edge;
        lists.corners.push_back({a, d, c, b});
        lists.corners.push_back({a, b, c, d});
      }
    }
    lists.backs = lists.corners;
    lists.face_class.assign(lists.corners.size(), 0);
    lists.face_body.assign(lists.corners.size(), 0);
    lists.face_offset.assign(lists.corners.size(), half);
    SurfaceShare share;
    share.largest_offset = half;
    std::vector<std::int64_t> numbers(lists.corners.size());
    std::vector<int> faces(numbers.size());
    for (std::size_t f = 0; f < numbers.size(); ++f) numbers[f] = faces[f] = static_cast<int>(f);
    set_surface(make_contact_surface(lists, share), numbers, check);
    check.candidates.num_faces = static_cast<int>(faces.size());
    check.candidates.faces = to_view("test::faces", faces);
    check.candidates.is_candidate = to_view("test::boxed", std::vector<int>(faces.size(), 1));
  }

  /// Draws places and velocities; of some draws the faces turn by a good part of a right angle in the step.
  SurfaceMotion draw(std::mt19937& random) {
    const auto draw = [&](double largest) {
      return largest * (2 * (static_cast<double>(random()) / 4294967295.0) - 1);
    };
    const auto draw_point = [&](double largest) { return Point3{draw(largest), draw(largest), draw(largest)}; };
    const double pace = draw(1), fold = draw(0.8);
    const Point3 spin = pace * pace * draw_point(1.2);
    for (int n = 0; n < node; ++n) {
      const double along = n % edge, across = static_cast<double>(n) / edge;
      const Point3 place{along, across, fold * (n % edge == 1 ? 1 : 0)};
      store_row(x, n, place + draw_point(0.15));
      store_row(v, n, cross(spin, load_row(x, n)) + pace * pace * draw_point(0.1));
    }
    store_row(x, node, Point3{1.5, 1.5, 0} + Point3{draw(1.5), draw(1.5), draw(0.8)});
    store_row(v, node, cross(spin, load_row(x, node)) + pace * draw_point(0.2));
    const SurfaceMotion motion{x, v, 1};
    update_faces(SmallSpace(), check.surface, motion, check.candidates, StillFaces(), check.faces);
    return motion;
  }
};

TEST(OffsetFaces, WhatIsOffTheSlabIsOffTheMovedFace) {
  constexpr double half = 0.3, beyond = 0.01, deepest = 0.2;
  CrookedPatch patch(half);
  std::mt19937 random(3);
  int off = 0, on = 0;
  for (int draw = 0; draw < 4000; ++draw) {
    const SurfaceMotion motion = patch.draw(random);
    const CheckedNode node = load_checked_node(patch.check.surface, motion, CrookedPatch::node);
    const MovingSurface moving{patch.check.surface, motion, patch.check.faces};
    for (int face = 0; face < patch.check.surface.num_faces; ++face) {
      const RelativeFace moved = load_touched_face(moving, node.x, node.v, face, half);
      const Point3 normal = load_row(patch.check.faces.normal, face);
      const PlaneRange<double> range = find_plane_range(moved.start.corner, find_end(moved).corner, normal);
      const bool is_out = range.least > beyond || range.most < -deepest;
      const bool is_off = is_off_slab(patch.check.faces.slab(face), normal, motion, node, {half, beyond, deepest});
      EXPECT_TRUE(is_out || !is_off) << "draw " << draw << " face " << face;
      off += is_off ? 1 : 0;
      on += is_out ? 0 : 1;
    }
  }
  EXPECT_GT(off, 10000);
  EXPECT_GT(on, 10000);
}

TEST(OffsetFaces, TurnWithTheFaceThroughTheStep) {
  // A rigid turn by 0.3: seen from a node that turns along, the moved corners only turn.
  constexpr double half = 0.3;
  CrookedPatch patch(half);
  std::mt19937 random(5);
  SurfaceMotion motion = patch.draw(random);
  const Point3 axis{0.6, 0.8, 0};
  for (int n = 0; n <= CrookedPatch::node; ++n) {
    const Point3 p = load_row(patch.x, n);
    const Point3 turned =
        std::cos(0.3) * p + std::sin(0.3) * cross(axis, p) + (1 - std::cos(0.3)) * dot(axis, p) * axis;
    store_row(patch.v, n, turned - p);
  }
  update_faces(SmallSpace(), patch.check.surface, motion, patch.check.candidates, StillFaces(), patch.check.faces);
  const CheckedNode node = load_checked_node(patch.check.surface, motion, CrookedPatch::node);
  const MovingSurface moving{patch.check.surface, motion, patch.check.faces};
  for (int face = 0; face < patch.check.surface.num_faces; ++face) {
    const RelativeFace moved = load_touched_face(moving, node.x, node.v, face, half);
    const RelativeFace flat = load_relative_face(patch.check.surface, motion, node.x, node.v, face);
    const FacePoints end = find_end(moved), flat_end = find_end(flat);
    const Point3 normal_start = patch.check.faces.slab(face).normal_at_start,
                 normal_end = load_row(patch.check.faces.normal, face);
    for (int i = 0; i < 4; ++i) {
      const Point3 at_start = moved.start.corner[i] - flat.start.corner[i], at_end = end.corner[i] - flat_end.corner[i];
      EXPECT_NEAR(dot(at_start, normal_start), half, 1e-14);
      EXPECT_NEAR(dot(at_end, normal_end), half, 1e-14);
      EXPECT_NEAR(norm(at_start), norm(at_end), 1e-14);
    }
  }
}

void expect_same(const Point3& a, const Point3& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

/// Push directions at the middle and at a corner of a face, and the face moved outward, as a pair reads them.
struct ReadOfFace {
  Point3 middle, corner;
  RelativeFace moved;

  ReadOfFace(const MovingSurface& moving, int face, double half) {
    const double at_middle[4] = {0.25, 0.25, 0.25, 0.25}, at_corner[4] = {0, 1, 0, 0};
    middle = find_push_direction(moving.surface, moving.faces, face, at_middle);
    corner = find_push_direction(moving.surface, moving.faces, face, at_corner);
    moved = load_touched_face(moving, {0.3, 0.2, 0.1}, {}, face, half);
  }
};

void expect_same(const ReadOfFace& a, const ReadOfFace& b) {
  expect_same(a.middle, b.middle);
  expect_same(a.corner, b.corner);
  for (int i = 0; i < 4; ++i) {
    expect_same(a.moved.start.corner[i], b.moved.start.corner[i]);
    expect_same(a.moved.move.corner[i], b.moved.move.corner[i]);
  }
}

TEST(PreparedFaces, AreThoseThatWereReadMoreThanOnceAndGiveTheSameBits) {
  constexpr double half = 0.3;
  std::mt19937 random(9);
  for (int draw = 0; draw < 50; ++draw) {
    CrookedPatch patch(half);
    const SurfaceMotion motion = patch.draw(random);
    const MovingSurface moving{patch.check.surface, motion, patch.check.faces};
    const auto update = [&] {
      update_faces(SmallSpace(), patch.check.surface, motion, patch.check.candidates, StillFaces(), patch.check.faces);
    };
    std::vector<ReadOfFace> unprepared;
    for (int face = 0; face < 10; ++face) unprepared.emplace_back(moving, face, half);
    load_touched_face(moving, {0.3, 0.2, 0.1}, {}, 10, half);
    update();
    for (int face = 0; face < patch.check.surface.num_faces; ++face)
      EXPECT_EQ(patch.check.faces.is_prepared(face), face < 10 ? 1 : 0);
    for (int face = 0; face < 10; ++face)
      expect_same(ReadOfFace(moving, face, half), unprepared[static_cast<std::size_t>(face)]);
    update();
    EXPECT_EQ(patch.check.faces.is_prepared(0), 1);
    update();  // nothing has read them
    EXPECT_EQ(patch.check.faces.is_prepared(0), 0);
  }
}

TEST(PreparedFaces, OfSolidsAreThoseThatWereReadAndGiveTheSameBits) {
  std::mt19937 random(10);
  for (int draw = 0; draw < 50; ++draw) {
    CrookedPatch patch(0);
    const SurfaceMotion motion = patch.draw(random);
    const MovingSurface moving{patch.check.surface, motion, patch.check.faces};
    const double at_middle[4] = {0.25, 0.25, 0.25, 0.25}, at_edge[4] = {0, 0.3, 0.7, 0};
    const auto find_both = [&](int face) {
      return std::array<Point3, 2>{find_push_direction(moving.surface, moving.faces, face, at_middle),
                                   find_push_direction(moving.surface, moving.faces, face, at_edge)};
    };
    std::vector<std::array<Point3, 2>> unprepared;
    for (int face = 0; face < 10; ++face) unprepared.push_back(find_both(face));
    update_faces(SmallSpace(), patch.check.surface, motion, patch.check.candidates, StillFaces(), patch.check.faces);
    for (int face = 0; face < patch.check.surface.num_faces; ++face)
      EXPECT_EQ(patch.check.faces.is_prepared(face), face < 10 ? 1 : 0);
    for (std::size_t face = 0; face < 10; ++face)
      for (std::size_t k = 0; k < 2; ++k) expect_same(find_both(static_cast<int>(face))[k], unprepared[face][k]);
  }
}

/// Size of a face by its corners and, but for a shell, the distance of the middles of its two sides.
double find_size(const CrookedPatch& patch, int face, double half, const RelativeFace& relative, bool& is_thin) {
  const ContactSurface& surface = patch.check.surface;
  Point3 corners{}, backs{};
  for (int k = 0; k < 4; ++k) {
    corners = corners + load_row(patch.x, surface.nodes(surface.face_corners(face, k)));
    backs = backs + load_row(patch.x, surface.face_backs(face, k));
  }
  const double thickness = half > 0 ? 2 * half : norm(0.25 * (corners - backs));
  const double edge = find_shortest_edge(relative.start);
  is_thin = thickness < edge;
  return is_thin ? thickness : edge;
}

/// Shells of half thickness `half`, or with 0 faces of solids, measured together as each by itself.
void expect_measured(double half) {
  CrookedPatch patch(half);
  const int apart = 5, faces = patch.check.candidates.num_faces -= 1;  // the last pack of faces is not full
  patch.check.candidates.is_candidate(apart) = 0;
  if (half == 0) {  // behind a face some nodes elsewhere in the patch
    std::vector<std::array<int, 4>> backs;
    for (int face = 0; face <= faces; ++face)
      backs.push_back({face % 16, (3 * face + 1) % 16, (5 * face + 2) % 16, (7 * face + 3) % 16});
    patch.check.surface.face_backs = to_rows("test::backs", backs);
  }
  std::mt19937 random(7);
  int thin = 0, thick = 0;
  for (int draw = 0; draw < 50; ++draw) {
    const SurfaceMotion motion = patch.draw(random);
    const ContactSurface& surface = patch.check.surface;
    const FaceState& found = patch.check.faces;
    Boxes boxes("test::boxes", static_cast<std::size_t>(faces));
    for (int face = 0; face < faces; ++face) {
      const int corner = surface.face_corners(face, 0);
      const RelativeFace relative = load_relative_face(surface, motion, corner, face);
      const Point3 normal = find_face_normal(find_end(relative));
      expect_same(load_row(found.normal, face), normal);
      EXPECT_NEAR(norm(normal), 1, 1e-15);
      if (face == apart) {
        EXPECT_GT(found.box(face, 0), found.box(face, 3));  // which nothing meets
        continue;
      }
      bool is_thin = false;
      EXPECT_NEAR(found.size(face), find_size(patch, face, half, relative, is_thin), 1e-14);
      thin += is_thin ? 1 : 0;
      thick += is_thin ? 0 : 1;
      bound_face(
          motion, [&](int i) { return surface.nodes(surface.face_corners(face, i)); },
          contact_limits::capture * found.size(face) + find_offset_reach(half, half), boxes, face);
      for (int side = 0; side < 6; ++side) EXPECT_EQ(found.box(face, side), boxes(face, side));
      if (half == 0) continue;
      const int node = surface.nodes(corner);
      const FaceSlab slab = find_slab(load_row(motion.x, node), motion.dt * load_row(motion.v, node), relative, normal);
      const FaceSlab& stored = found.slab(face);
      expect_same(stored.origin, slab.origin);
      expect_same(stored.move, slab.move);
      expect_same(stored.normal_at_start, slab.normal_at_start);
      EXPECT_EQ(stored.low_start, slab.low_start);
      EXPECT_EQ(stored.high_start, slab.high_start);
      EXPECT_EQ(stored.low_end, slab.low_end);
      EXPECT_EQ(stored.high_end, slab.high_end);
      EXPECT_EQ(stored.turn, slab.turn);
    }
  }
  EXPECT_GT(thin, 50);
  EXPECT_GT(thick, 50);
}

TEST(UpdateFaces, MeasuresShellsTogetherAsEachByItself) { expect_measured(0.45); }

TEST(UpdateFaces, MeasuresFacesOfSolidsTogetherAsEachByItself) { expect_measured(0); }

}  // namespace
}  // namespace percuss::test
