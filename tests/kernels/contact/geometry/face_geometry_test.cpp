#include "kernels/contact/surface/face_pack.hpp"

#include <gtest/gtest.h>

#include <random>

namespace percuss::test::face_geometry_test {
namespace {

constexpr double tight = 1e-14;

FacePoints shift(const FacePoints& face, const Point3& point) {
  FacePoints shifted = face;
  for (Point3& corner : shifted.corner) corner = corner - point;
  return shifted;
}

const FacePoints unit_square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};

TEST(FaceGeometry, ClosestPointAboveTheInsideIsTheFootOfThePerpendicular) {
  const FacePoint p = find_closest_point(shift(unit_square, {0.3, 0.6, 2}));
  EXPECT_NEAR(p.distance, 2, tight);
  EXPECT_EQ(p.off, 0);
  const Point3 place = interpolate(unit_square, p.weight);
  EXPECT_NEAR(place.x, 0.3, tight);
  EXPECT_NEAR(place.y, 0.6, tight);
}

TEST(FaceGeometry, ClosestPointBesideAnEdgeIsOnTheEdgeAndSaysHowFarBeside) {
  const FacePoint p = find_closest_point(shift(unit_square, {0.5, -3, 4}));
  EXPECT_NEAR(p.distance, 5, tight);
  EXPECT_NEAR(p.off, 3, tight);
  EXPECT_NEAR(p.weight[0], 0.5, tight);
  EXPECT_NEAR(p.weight[1], 0.5, tight);
}

TEST(FaceGeometry, ClosestPointBeyondACornerIsTheCorner) {
  const FacePoint p = find_closest_point(shift(unit_square, {4, 5, 0}));
  EXPECT_NEAR(p.distance, 5, tight);
  EXPECT_NEAR(p.off, 5, tight);
  EXPECT_EQ(p.weight[2], 1);
}

TEST(FaceGeometry, PointsOverAnEdgeOrCornerOfTheFaceAreNotBesideIt) {
  for (const Point3 point : {Point3{0.5, 0, 1}, Point3{1, 1, -2}, Point3{0, 0.25, 0.5}})
    EXPECT_LT(find_closest_point(shift(unit_square, point)).off, tight);
}

TEST(FaceGeometry, WeightsSumToOneAndNoPointOfTheFaceIsCloser) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-2, 3), warp(-0.3, 0.3), fraction(0, 1);
  for (int i = 0; i < 200; ++i) {
    FacePoints face = unit_square;
    for (Point3& corner : face.corner) corner = corner + Point3{warp(random), warp(random), warp(random)};
    const FacePoints local = shift(face, {uniform(random), uniform(random), uniform(random)});
    const FacePoint p = find_closest_point(local);
    EXPECT_NEAR(p.weight[0] + p.weight[1] + p.weight[2] + p.weight[3], 1, tight);
    EXPECT_NEAR(norm(interpolate(local, p.weight)), p.distance, 1e-13);
    for (int j = 0; j < 50; ++j) {
      double weight[4];
      const double a = fraction(random), b = fraction(random) * (1 - a);
      set_fan_weights(j % 4, {1 - a - b, a, b}, weight);
      EXPECT_GE(norm(interpolate(local, weight)), p.distance - 1e-13);
    }
  }
}

TEST(FaceGeometry, NormalOfTheFanIsThatOfItsArea) {
  const FacePoints warped{{{0, 0, 0.2}, {1, 0, -0.2}, {1, 1, 0.2}, {0, 1, -0.2}}};
  Point3 area{};
  for (int k = 0; k < 4; ++k) {
    const Point3 m = find_middle(warped);
    area = area + cross(warped.corner[k] - m, warped.corner[(k + 1) % 4] - m);
  }
  const Point3 expected = normalize(area), normal = find_face_normal(warped);
  EXPECT_NEAR(norm(normal - expected), 0, tight);
}

TEST(FaceGeometry, FourTrianglesAtOnceAreFourOneByOneToTheBit) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-2, 3), warp(-0.3, 0.3);
  for (int i = 0; i < 2000; ++i) {
    FacePoints face = unit_square;
    for (Point3& corner : face.corner) corner = corner + Point3{warp(random), warp(random), warp(random)};
    // Every fourth point lies on a corner, an edge or the plane of the first triangle, where regions meet.
    Point3 point{uniform(random), uniform(random), uniform(random)};
    if (i % 4 == 1) point = face.corner[0];
    if (i % 4 == 2) point = 0.5 * (face.corner[1] + face.corner[2]);
    if (i % 4 == 3) point = find_middle(face);
    const FacePoints local = shift(face, point);
    FanClosest closest;
    find_closest_on_fan(find_middle(local), local.corner, closest);
    for (int k = 0; k < 4; ++k) {
      const Point3 one = find_closest_on_triangle(find_middle(local), local.corner[k], local.corner[(k + 1) % 4]);
      EXPECT_EQ(closest.bary[0][k], one.x);
      EXPECT_EQ(closest.bary[1][k], one.y);
      EXPECT_EQ(closest.bary[2][k], one.z);
    }
  }
}

/// Faces warped, cut to triangles, drawn to a line or a point, seen from places where regions meet and from others.
FacePoints draw_face(std::mt19937& random, int i) {
  std::uniform_real_distribution<double> uniform(-2, 3), warp(-0.3, 0.3);
  FacePoints face = unit_square;
  for (Point3& corner : face.corner) corner = corner + Point3{warp(random), warp(random), warp(random)};
  if (i % 5 == 1) face.corner[(i / 5) % 4] = face.corner[(i / 5 + 1) % 4];
  if (i % 25 == 2) face = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  if (i % 25 == 3) face.corner[1] = face.corner[2] = face.corner[3] = face.corner[0];
  Point3 point{uniform(random), uniform(random), uniform(random)};
  if (i % 4 == 1) point = face.corner[0];
  if (i % 4 == 2) point = 0.5 * (face.corner[1] + face.corner[2]);
  if (i % 4 == 3) point = find_middle(face);
  return shift(face, point);
}

TEST(FacePack, LanesHaveTheBitsOfOneFace) {
  constexpr int lanes = FacePack::lanes;
  std::mt19937 random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Rows3<double> normals("normals", lanes);
  const FaceState state{normals, {}, {}};
  for (int i = 0; i < 4000;) {
    FacePack pack;
    RelativeFace face[lanes];
    const int count = 1 + i % lanes;
    for (int lane = 0; lane < count; ++lane, ++i) {
      face[lane].start = draw_face(random, i);
      for (Point3& move : face[lane].move.corner) move = {uniform(random), uniform(random), uniform(random)};
      store_row(normals, lane, find_face_normal(find_end(face[lane])));
      add_face(state, lane, face[lane], pack);
    }
    measure_motion(pack);
    ClosestPack at_start, at_end;
    find_closest_points(pack.start, at_start);
    find_closest_points(pack.end, at_end);
    for (int lane = 0; lane < count; ++lane) {
      const FacePoints start = face[lane].start, end = find_end(face[lane]);
      const auto expect_same = [&](const FacePoint& expected, const FacePoint& got) {
        for (int k = 0; k < 4; ++k) EXPECT_EQ(expected.weight[k], got.weight[k]);
        EXPECT_EQ(expected.triangle, got.triangle);
        EXPECT_EQ(expected.distance, got.distance);
        EXPECT_EQ(expected.off, got.off);
        EXPECT_TRUE(is_same_point(expected.normal, got.normal));
      };
      expect_same(find_closest_point(start), at_start[lane]);
      expect_same(find_closest_point(end), at_end[lane]);
      double least = 1e300, most = -1e300, most_start = -1e300;
      for (int k = 0; k < 4; ++k) {
        const double before = -dot(load_row(normals, lane), start.corner[k]);
        const double after = -dot(load_row(normals, lane), end.corner[k]);
        least = std::min({least, before, after});
        most = std::max({most, before, after});
        most_start = std::max(most_start, before);
        EXPECT_TRUE(is_same_point(pack.end[lane].corner[k], end.corner[k]));
      }
      EXPECT_EQ(pack.range.least[lane], least);
      EXPECT_EQ(pack.range.most[lane], most);
      EXPECT_EQ(pack.range.most_start[lane], most_start);
    }
  }
}

TEST(FaceGeometry, FourUnitVectorsAtOnceAreFourOneByOneToTheBit) {
  double four[3][4] = {{3, 0, -1e-200, 1}, {4, 0, 2, 1e3}, {-12, 0, 0.1, 7}};
  Point3 one[4];
  for (int k = 0; k < 4; ++k) one[k] = normalize(Point3{four[0][k], four[1][k], four[2][k]});
  normalize_four(four);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(four[0][k], one[k].x);
    EXPECT_EQ(four[1][k], one[k].y);
    EXPECT_EQ(four[2][k], one[k].z);
  }
}

TEST(FaceGeometry, ADegenerateFaceGivesNumbers) {
  const FacePoints line{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}};
  const FacePoint p = find_closest_point(shift(line, {0.25, 1, 0}));
  EXPECT_NEAR(p.weight[0] + p.weight[1] + p.weight[2] + p.weight[3], 1, tight);
  EXPECT_TRUE(std::isfinite(p.distance) && std::isfinite(p.off));
}

}  // namespace
}  // namespace percuss::test::face_geometry_test
