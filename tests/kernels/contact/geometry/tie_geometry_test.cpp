#include "kernels/contact/geometry/tie_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/contact/rows/tie_row.hpp"

namespace percuss::test::tie_geometry_test {
namespace {

const FacePoints warped{{{0, 0, 0.1}, {1.1, 0.05, 0}, {1, 0.9, 0.05}, {-0.1, 1, -0.02}}};

TieGeometry make_tie(const FacePoints& face, const Point3& offset) {
  TieGeometry tie;
  const double weights[4] = {0.4, 0.3, 0.2, 0.1};
  for (int i = 0; i < 4; ++i) tie.weight[i] = weights[i];
  tie.offset = offset;
  tie.face = center_face(face);
  tie.size = 1;
  return tie;
}

/// A rotation about `axis` by `angle`, moved by (3, -2, 5).
Point3 move(const Point3& axis, double angle, const Point3& a) {
  const Point3 n = normalize(axis);
  return std::cos(angle) * a + (std::sin(angle) * cross(n, a) + ((1 - std::cos(angle)) * dot(n, a)) * n) +
         Point3{3, -2, 5};
}

FacePoints move(const Point3& axis, double angle, const FacePoints& face) {
  FacePoints moved;
  for (int i = 0; i < 4; ++i) moved.corner[i] = move(axis, angle, face.corner[i]);
  return moved;
}

/// Where the tie wants its node.
Point3 find_place(const TieGeometry& tie, const FacePoints& face) {
  return interpolate(face, tie.weight) + turn_tie(tie, face).offset;
}

TEST(TieGeometry, TurnsTheOffsetWithARigidFace) {
  const Point3 offset{0.02, -0.03, 0.2};
  const TieGeometry tie = make_tie(warped, offset);
  for (const double angle : {0.0, 1e-9, 0.3, 2.0, 3.14, 5.0}) {
    const Point3 axis{1, -2, 0.5};
    const Point3 wanted = move(axis, angle, interpolate(warped, tie.weight) + offset);
    // round-off of coordinates of some 5
    EXPECT_LT(norm(find_place(tie, move(axis, angle, warped)) - wanted), 1e-14) << angle;
  }
}

TEST(TieGeometry, KeepsTheLengthOfTheOffsetWhenTheFaceDeforms) {
  const Point3 offset{0.02, -0.03, 0.2};
  FacePoints stretched = warped;
  stretched.corner[1] = {1.6, 0.3, 0.2};
  stretched.corner[3] = {0.3, 0.6, -0.3};
  EXPECT_NEAR(norm(turn_tie(make_tie(warped, offset), stretched).offset), norm(offset), 1e-15);
}

/// The row that holds a tie at `face`, its node at the tie's place.
ContactRow make_row(const TieGeometry& tie, const FacePoints& face) {
  const TurnedTie turned = turn_tie(tie, face);
  ContactRow row;
  row.kind = RowKind::tie;
  row.count = row_nodes;
  row.arm = turned.offset;
  row.inverse_inertia = invert(turned.inertia);
  for (int i = 0; i < 4; ++i) {
    row.weight[i + 1] = -tie.weight[i];
    row.rho[i + 1] = turned.face.corner[i];
  }
  return row;
}

TEST(TieGeometry, ImpulsesOfADeformedTieBalance) {
  const TieGeometry tie = make_tie(warped, {0.02, -0.03, 0.2});
  FacePoints now = move({1, 1, 0}, 0.8, warped);
  now.corner[2] = now.corner[2] + Point3{0.3, -0.1, 0.2};
  const ContactRow row = make_row(tie, now);
  const Point3 impulse{0.7, -1.1, 0.4}, couple = find_couple(row, impulse);
  const Point3 node = find_place(tie, now);
  Point3 sum{}, moment{};
  for (int slot = 0; slot < row_nodes; ++slot) {
    const Point3 force = spread_impulse(row, slot, impulse, couple);
    sum = sum + force;
    moment = moment + cross(slot == 0 ? node : now.corner[slot - 1], force);
  }
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(moment), 1e-14);
}

TEST(TieGeometry, WorkVelocityIsTheRateOfTheConstraint) {
  const TieGeometry tie = make_tie(warped, {0.02, -0.03, 0.2});
  FacePoints now = move({0, 1, 1}, 1.1, warped);
  now.corner[0] = now.corner[0] + Point3{-0.2, 0.1, 0.1};
  const Point3 velocity[row_nodes] = {
      {0.3, 0.1, -0.2}, {0.5, -0.4, 0.1}, {-0.2, 0.3, 0.6}, {0.1, 0.2, -0.5}, {0.4, 0, 0.2}};
  const auto miss = [&](double t) {
    FacePoints face;
    for (int i = 0; i < 4; ++i) face.corner[i] = now.corner[i] + t * velocity[i + 1];
    return t * velocity[0] - find_place(tie, face);
  };
  constexpr double t = 1e-5;  // central differences: 1e-10 of the velocities and round-off over t
  const Point3 rate = (0.5 / t) * (miss(t) - miss(-t));
  const Point3 u = find_work_velocity(make_row(tie, now), [&](int slot) { return velocity[slot]; });
  EXPECT_LT(norm(rate - u), 1e-9);
}

// A triangle of shells is a face whose corner stands twice: the tie of a node above it is the same whichever that is.
TEST(TieGeometry, OfATriangleDoesNotDependOnTheCornerThatStandsTwice) {
  const Point3 start[3] = {{0, 0, 0.1}, {1.1, 0.05, 0}, {0.2, 0.9, 0.05}};
  const Point3 now[3] = {{0.1, 0.2, 0.1}, {0.9, 0.4, 0.3}, {0, 1.1, 0.5}};
  const Point3 impulse{0.7, -1.1, 0.4};
  Point3 first_place{}, first_force[3]{};
  for (int twice = 0; twice < 3; ++twice) {
    const int order[4] = {(twice + 1) % 3, (twice + 2) % 3, twice, twice};
    FacePoints face, moved;
    for (int i = 0; i < 4; ++i) {
      face.corner[i] = start[order[i]];
      moved.corner[i] = now[order[i]];
    }
    const Point3 node = 0.5 * start[0] + (0.3 * start[1] + 0.2 * start[2]) + 0.25 * find_face_normal(face);
    FacePoints seen;
    for (int i = 0; i < 4; ++i) seen.corner[i] = face.corner[i] - node;
    const FacePoint closest = find_closest_point(seen);
    EXPECT_NEAR(closest.distance, 0.25, 1e-15);
    TieGeometry tie;
    for (int i = 0; i < 4; ++i) tie.weight[i] = closest.weight[i];
    tie.offset = -interpolate(seen, closest.weight);
    tie.face = center_face(face);
    const Point3 place = find_place(tie, moved);
    const ContactRow row = make_row(tie, moved);
    Point3 force[3]{};
    for (int slot = 1; slot < row_nodes; ++slot)
      force[order[slot - 1]] = force[order[slot - 1]] + spread_impulse(row, slot, impulse, find_couple(row, impulse));
    if (twice == 0) first_place = place;
    EXPECT_LT(norm(place - first_place), 1e-15) << twice;
    for (int i = 0; i < 3; ++i) {
      if (twice == 0) first_force[i] = force[i];
      EXPECT_LT(norm(force[i] - first_force[i]), 1e-14) << twice << i;
    }
  }
}

// The Gibbs vector of a rotation by `angle` has the length 2 tan(angle / 2).
TEST(TurningRow, FindsTheTurnOfAFace) {
  const Point3 axis = normalize(Point3{1, -2, 0.5});
  for (const double angle : {1e-9, 1e-3, 0.3, 2.0}) {
    const Point3 turn = find_turn(center_face(warped), center_face(move(axis, angle, warped)));
    EXPECT_LT(norm(turn - 2 * std::tan(0.5 * angle) * axis), 1e-14 * (1 + norm(turn))) << angle;
  }
}

// The moment on the node and the forces on the corners balance, and the velocity of the row is l (w - W), W the rate of
// the polar rotation of the face.
TEST(TurningRow, MomentsBalanceAndDoNoWorkWhereBothTurnAlike) {
  const TieGeometry tie = make_tie(warped, {});
  FacePoints now = move({0, 1, 1}, 1.1, warped);
  now.corner[0] = now.corner[0] + Point3{-0.2, 0.1, 0.1};
  ContactRow row = make_row(tie, now);
  for (double& weight : row.weight) weight = 0;
  row.arm = {};
  row.lever = 0.7;
  const Point3 p{0.7, -1.1, 0.4}, couple = find_couple(row, p);
  Point3 sum{}, moment = row.lever * p;
  for (int slot = 1; slot < row_nodes; ++slot) {
    const Point3 force = spread_impulse(row, slot, p, couple);
    sum = sum + force;
    moment = moment + cross(now.corner[slot - 1], force);
  }
  EXPECT_LT(norm(sum), 1e-15);
  EXPECT_LT(norm(moment), 1e-14);
  const Point3 velocity[row_nodes] = {
      {0.3, 0.1, -0.2}, {0.5, -0.4, 0.1}, {-0.2, 0.3, 0.6}, {0.1, 0.2, -0.5}, {0.4, 0, 0.2}};
  constexpr double h = 1e-6;
  FacePoints before, after;
  for (int i = 0; i < 4; ++i) {
    before.corner[i] = now.corner[i] - h * velocity[i + 1];
    after.corner[i] = now.corner[i] + h * velocity[i + 1];
  }
  const Point3 rate = (0.5 / h) * find_turn(turn_tie(tie, before).face, turn_tie(tie, after).face);
  const Point3 found = find_work_velocity(row, [&](int slot) { return velocity[slot]; });
  EXPECT_LT(norm(found + row.lever * rate), 1e-9);  // differences
}

}  // namespace
}  // namespace percuss::test::tie_geometry_test
