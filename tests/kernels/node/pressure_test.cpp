#include "kernels/node/pressure.hpp"

#include <gtest/gtest.h>

namespace percuss::test {

namespace {

/// Forces of the slots of one face with the corners `nodes` under a pressure of 3, over nodes at (0, 0), (2, 0), (2, 1)
/// and (0, 1) of the plane z = 0.
Rows3<double> load_face(const int (&nodes)[4], bool follows) {
  PressureFaces faces;
  faces.nodes = Rows4<int>("nodes", 1);
  for (int i = 0; i < 4; ++i) faces.nodes(0, i) = nodes[i];
  faces.load = Array<int>("load", 1);
  faces.dead_share = Rows3<double>("dead_share", 1);
  if (!follows) faces.dead_share(0, 2) = -0.25;  // of a face of area 1
  faces.count = 1;
  const Array<double> pressure("pressure", 1);
  pressure(0) = 3;
  const Rows3<double> x("x", 4), force("force", 4);
  for (const int n : {1, 2}) x(n, 0) = 2;
  for (const int n : {2, 3}) x(n, 1) = 1;
  apply_pressure(ExecSpace(), faces, pressure, x, force);
  ExecSpace().fence();
  return force;
}

/// The sum of the slots of each of four nodes.
void expect_shares(const int (&nodes)[4], bool follows, const double (&expected)[4]) {
  const Rows3<double> force = load_face(nodes, follows);
  double sum[4] = {0, 0, 0, 0};
  for (int i = 0; i < 4; ++i) sum[nodes[i]] += force(i, 2);
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(sum[n], expected[n], 1e-15) << "node " << n;
}

}  // namespace

TEST(Pressure, IsAQuarterOnEachNodeOfAQuadrilateral) {
  expect_shares({0, 1, 2, 3}, true, {-1.5, -1.5, -1.5, -1.5});
  expect_shares({0, 1, 2, 3}, false, {-0.75, -0.75, -0.75, -0.75});
}

TEST(Pressure, IsAThirdOnEachNodeOfATriangleWhicheverCornerStandsTwice) {
  for (const bool follows : {true, false}) {
    constexpr double third = -1;  // of 3 times an area of 1, that of the triangle and of the dead load
    expect_shares({0, 1, 2, 2}, follows, {third, third, third, 0});
    expect_shares({0, 1, 1, 2}, follows, {third, third, third, 0});
    expect_shares({0, 0, 1, 2}, follows, {third, third, third, 0});
    expect_shares({0, 1, 2, 0}, follows, {third, third, third, 0});
  }
}

}  // namespace percuss::test
