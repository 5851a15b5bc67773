#include "kernels/contact/surface/node_areas.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "kernels/core/host_copy.hpp"

namespace percuss::test::node_areas_test {
namespace {

/// One node with corners of faces around it. areas: of these corners.
NodeFaces make_node(const std::vector<Point3>& areas) {
  std::vector<std::array<double, 3>> rows;
  std::vector<int> faces;
  for (const Point3& a : areas) {
    rows.push_back({a.x, a.y, a.z});
    faces.push_back(static_cast<int>(faces.size()));
  }
  return {to_view("first", std::vector<int>{0, static_cast<int>(areas.size())}), to_view("faces", faces),
          percuss::to_rows("areas", rows)};
}

TEST(NodeAreas, ACornerHasAQuarterOfAQuadrilateralAndAThirdOfATriangle) {
  const Point3 quad[4] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
  EXPECT_DOUBLE_EQ(find_corner_area(quad, false).z, 6.0 / 4);
  for (int repeated = 0; repeated < 4; ++repeated) {
    Point3 triangle[4] = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {2, 3, 0}};
    for (int i = 0; i < 4; ++i) triangle[i] = quad[i];
    triangle[(repeated + 1) % 4] = triangle[repeated];
    EXPECT_DOUBLE_EQ(find_corner_area(triangle, true).z, 3.0 / 3) << repeated;
  }
  // The vector of a warped face is that of any surface with the same edge: half its diagonals' cross product.
  const Point3 warped[4] = {{0, 0, 0.5}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(find_corner_area(warped, false).z, 0.25);
  EXPECT_DOUBLE_EQ(find_corner_area(warped, false).x, 0);
}

TEST(NodeAreas, CountsWhatFacesShowAgainstTheForce) {
  // At the edge of a block: two faces below, a side, which does not count.
  const NodeFaces edge = make_node({{0, 0, -0.25}, {0, 0, -0.25}, {0.5, 0, 0}});
  EXPECT_DOUBLE_EQ(edge.find_area(0, {0, 0, 1}), 0.5);
  EXPECT_EQ(edge.find_area(0, {0, 0, -1}), 0);
  // A force that leans by 30 degrees sees them smaller, and the side, which is turned away by 60 degrees or more, not.
  EXPECT_NEAR(edge.find_area(0, {-0.49, 0, std::sqrt(1 - 0.49 * 0.49)}), 0.5 * std::sqrt(1 - 0.49 * 0.49), 1e-15);
  // The edge itself is hit from the side and below.
  const double c = std::sqrt(0.5);
  EXPECT_NEAR(edge.find_area(0, {-c, 0, c}), c * (0.5 + 0.5), 1e-15);
}

TEST(NodeAreas, PressIsTheImpulseOverTheArea) {
  const NodeFaces edge = make_node({{0, 0, -0.25}, {0, 0, -0.25}});
  double area = -1;
  EXPECT_DOUBLE_EQ(find_press(edge, 0, {0, 0, 3}, area), 6);
  EXPECT_DOUBLE_EQ(area, 0.5);
  EXPECT_EQ(find_press(edge, 0, {0, 0, 0}, area), 0);
  EXPECT_EQ(area, 0);
  EXPECT_EQ(find_press(edge, 0, {0, 0, -3}, area), 0);
}

}  // namespace
}  // namespace percuss::test::node_areas_test
