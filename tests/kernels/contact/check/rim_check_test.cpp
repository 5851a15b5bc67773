// Ends of edges before rims of shells: bounds that spare the exact check, and faces of edges that are kept for a step.

#include "kernels/contact/check/rim_check.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::rim_check_test {
namespace {

/// Any values, the same in every run.
struct Draw {
  std::mt19937 engine{7};
  double operator()() { return std::uniform_real_distribution<>(-1, 1)(engine); }
  Point3 point(double scale) { return {scale * (*this)(), scale * (*this)(), scale * (*this)()}; }
};

/// An end over the rim of edge B, which lies along y with its shell on the side of +x.
EndBeforeRim place_end(const Point3& from, const Point3& to) {
  EndBeforeRim e;
  e.from.away = from;
  e.to.away = to;
  e.along = {1, 0, 0};
  return e;
}

TEST(RimCheck, EndsAboveAShellAreBesideItsRim) {
  EdgeFaces faces[2];
  faces[1].wedge = {{{1, 0, 0}, {1, 0, 0}}};
  EXPECT_TRUE(is_surely_beside(place_end({0, 0, 0.1}, {0, 0, 0.09}), faces));
  EXPECT_FALSE(is_surely_beside(place_end({-0.1, 0, 0}, {0, 0, 0.1}), faces));  // it comes from the front
  EXPECT_FALSE(is_surely_beside(place_end({0, 0, 0.1}, {-0.1, 0, 0}), faces));  // it goes there
}

TEST(RimCheck, WhatIsSurelyBesideARimIsNotBeforeIt) {
  Draw draw;
  int num_beside = 0;
  for (int i = 0; i < 20000; ++i) {
    EdgeFaces faces[2];
    for (EdgeFaces& edge : faces) edge.wedge.inward[0] = edge.wedge.inward[1] = normalize(draw.point(1));
    const EndBeforeRim e = place_end(draw.point(0.1), draw.point(0.1));
    if (!is_surely_beside(e, faces)) continue;
    ++num_beside;
    EXPECT_FALSE(is_before_rim(e, faces, normalize(e.from.away), false));
    EXPECT_FALSE(is_before_rim(e, faces, normalize(e.to.away), false));
  }
  EXPECT_GT(num_beside, 5000);
}

/// Two shells of one face each, whose first edges may meet.
struct TwoRims {
  explicit TwoRims(Draw& draw) {
    std::vector<Point3> x(8), v(8);
    for (std::size_t i = 0; i < 8; ++i) {
      const double side = i % 4 < 2 ? 0 : 1, end = i % 2 == 0 ? -0.5 : 0.5;
      x[i] = (i < 4 ? Point3{end, side, 0} : Point3{end + 0.4, -0.2 - side, 0}) + draw.point(0.15);
      v[i] = draw.point(0.1);
    }
    motion = {to_rows(x), to_rows(v), 1};
    surface.num_edges = 2;
    const Rows2<int> ends("test::ends", 2);
    const Array<double> offset("test::offset", 2);
    for (int e = 0; e < 2; ++e) {
      for (int i = 0; i < 2; ++i) ends(e, i) = 4 * e + i;
      offset(e) = 0.1;
    }
    surface.ends = ends;
    surface.wings = to_rows4({{2, 3, 2, 3}, {6, 7, 6, 7}});
    surface.offset = offset;
    for (int e = 0; e < 2; ++e) faces(e) = load_edge_faces(surface, motion, e);
  }
  /// Whether they touch, and by which gap at the end of the step.
  std::pair<bool, double> check(const Array<EdgeFaces>& kept) const {
    EdgeTouch touch;
    const CheckedEdges checked{surface, motion, kept, {0, 1}, nullptr};
    const MovingPair pair = load_moving_pair(surface, motion, 0, 1);
    const bool touches = check_edge_pair(checked, pair, touch) || check_rim_pair(checked, pair, touch);
    return {touches, touches ? touch.gap_end : 0};
  }

  EdgeSurface surface;
  SurfaceMotion motion;
  Array<EdgeFaces> faces = Array<EdgeFaces>("test::edge_faces", 2);
};

TEST(RimCheck, FacesThatAreKeptForTheStepGiveTheSameTouches) {
  Draw draw;
  int num_touches = 0;
  for (int i = 0; i < 2000; ++i) {
    const TwoRims rims(draw);
    const auto kept = rims.check(rims.faces);
    EXPECT_EQ(kept, rims.check(Array<EdgeFaces>("test::edge_faces", 0)));
    num_touches += kept.first ? 1 : 0;
  }
  EXPECT_GT(num_touches, 100);
  EXPECT_LT(num_touches, 1900);
}

}  // namespace
}  // namespace percuss::test::rim_check_test
