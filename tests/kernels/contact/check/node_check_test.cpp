#include "kernels/contact/check/node_check.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::node_check_test {
namespace {

constexpr double tight = 1e-14;

int face_of(int brick, BrickSide side) { return 6 * brick + side; }

/// A small brick falling on a big one: its lower nodes are nodes 8 to 11.
BrickScene make_drop(const Point3& corner, const Point3& velocity) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 1});
  scene.add_brick(corner, {1, 1, 1}, velocity);
  return scene;
}

TEST(NodeCheck, ANodeThatFallsOnAFaceTouchesItWhereAndWhenItArrives) {
  const CheckedScene scene(make_drop({1, 1, 1.1}, {0, 0, -1}), 0.2);
  const NodeTouches t = scene.at(8);
  ASSERT_EQ(t.count, 1);
  EXPECT_EQ(t.touch[0].face, face_of(0, z_max));
  EXPECT_NEAR(t.touch[0].gap_start, 0.1, tight);
  EXPECT_NEAR(t.touch[0].gap_end, -0.1, tight);
  EXPECT_NEAR(t.touch[0].tau, 0.5, tight);
  EXPECT_NEAR(t.touch[0].normal.z, 1, tight);
  const Point3 place{4 * (t.touch[0].weight[1] + t.touch[0].weight[2]),
                     4 * (t.touch[0].weight[2] + t.touch[0].weight[3]), 0};
  EXPECT_NEAR(place.x, 1, tight);
  EXPECT_NEAR(place.y, 1, tight);
}

TEST(NodeCheck, AThinPlateAtTenThicknessesAStepIsNotTunnelled) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 0.1});
  scene.add_brick({1, 1, 0.5}, {1, 1, 1}, {0, 0, -1});
  const CheckedScene checked(scene, 1.5);
  for (const int node : {8, 9, 10, 11}) {
    const NodeTouches t = checked.at(node);
    ASSERT_EQ(t.count, 1);
    EXPECT_EQ(t.touch[0].face, face_of(0, z_max));
    EXPECT_NEAR(t.touch[0].gap_end, -1.1, 1e-13);
  }
}

TEST(NodeCheck, OfTwoPlatesInTheWayTheFirstIsHit) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {4, 4, 0.1});
  scene.add_brick({0, 0, 0.2}, {4, 4, 0.1});
  scene.add_brick({1, 1, 0.5}, {1, 1, 1}, {0, 0, -1});
  const NodeTouches t = CheckedScene(scene, 1.5).at(16);
  ASSERT_EQ(t.count, 1);
  EXPECT_EQ(t.touch[0].face, face_of(1, z_max));
}

TEST(NodeCheck, ANodeFarBehindAFaceItDidNotPassIsNotInContact) {
  EXPECT_EQ(CheckedScene(make_drop({1, 1, 0.9}, {0, 0, -1}), 0.01).at(8).count, 0);
}

TEST(NodeCheck, ANodeJustBehindAFaceIsInContactWithIt) {
  const NodeTouches t = CheckedScene(make_drop({1, 1, 0.99}, {0, 0, 0}), 0.01).at(8);
  ASSERT_EQ(t.count, 1);
  EXPECT_NEAR(t.touch[0].gap_start, -0.01, tight);
}

TEST(NodeCheck, ANodeThatPassedAFaceInTheLastStepIsHeld) {
  // Behind the face by 0.1, before the last step in front of it by 0.1.
  const NodeTouches t = CheckedScene(make_drop({1, 1, 0.9}, {0, 0, -20}), 0.01).at(8);
  ASSERT_EQ(t.count, 1);
  EXPECT_EQ(t.touch[0].face, face_of(0, z_max));
  EXPECT_EQ(t.touch[0].tau, 0);
  EXPECT_NEAR(t.touch[0].gap_start, -0.1, tight);
  EXPECT_NEAR(t.touch[0].gap_end, -0.3, tight);
  // It came from behind, or from farther than contact reaches.
  EXPECT_EQ(CheckedScene(make_drop({1, 1, 0.9}, {0, 0, -9}), 0.01).at(8).count, 0);
  EXPECT_EQ(CheckedScene(make_drop({1, 1, 0.7}, {0, 0, -40}), 0.01).at(8).count, 0);
}

TEST(NodeCheck, AFaceKeepsANodeThatItPushedUntilTheNodeIsBesideItAtTheStart) {
  for (const double x : {3.995, 4.02}) {  // h is 1; a node with a history may be beside by 0.01
    CheckedScene scene(make_drop({x, 1, 1}, {5, 0, -1}), 0.01);
    scene.history_face(3 * 8) = face_of(0, z_max);
    scene.check();
    const NodeTouches t = scene.at(8);
    ASSERT_EQ(t.count, 1) << x;  // of the side x_max, beside which it is, where the top does not keep it
    EXPECT_EQ(t.touch[0].face, face_of(0, x < 4.01 ? z_max : x_max));
    EXPECT_EQ(t.touch[0].is_kept, x < 4.01);
    if (x > 4.01) continue;
    EXPECT_NEAR(t.touch[0].gap_start, 0, tight);
    EXPECT_NEAR(t.touch[0].gap_end, -0.01, tight);
    EXPECT_NEAR(4 * (t.touch[0].weight[1] + t.touch[0].weight[2]), x, tight);  // the place of n
  }
}

TEST(NodeCheck, CoincidentStackedBricksTouchByTheirOpposedFacesOnly) {
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {1, 1, 1});
  scene.add_brick({0, 0, 1}, {1, 1, 1});
  const CheckedScene checked(scene, 0.01);
  for (int node = 0; node < 16; ++node) {
    const NodeTouches t = checked.at(node);
    const bool lower_top = node >= 4 && node < 8, upper_bottom = node >= 8 && node < 12;
    ASSERT_EQ(t.count, lower_top || upper_bottom ? 1 : 0) << node;
    if (t.count == 1) {
      EXPECT_EQ(t.touch[0].face, lower_top ? face_of(1, z_min) : face_of(0, z_max));
    }
  }
}

TEST(NodeCheck, BricksInLineDoNotTouchByTheirFlushFaces) {
  // Two flush neighbours side by side: top faces are level, only the faces between them are opposed.
  BrickScene scene;
  scene.add_brick({0, 0, 0}, {1, 1, 1});
  scene.add_brick({1, 0, 0}, {1, 1, 1});
  const CheckedScene checked(scene, 0.01);
  for (const int node : {1, 2, 5, 6}) {
    const NodeTouches t = checked.at(node);
    ASSERT_EQ(t.count, 1);
    EXPECT_EQ(t.touch[0].face, face_of(1, x_min));
  }
}

TEST(NodeCheck, AConcaveCornerHoldsANodeByBothFaces) {
  // A floor and a wall, each a body of its own; the small brick sits in the corner and moves into both.
  BrickScene scene;
  scene.add_brick({0, 0, -1}, {4, 4, 1});
  scene.add_brick({-1, 0, 0}, {1, 4, 4});
  scene.add_brick({0.001, 1, 0.001}, {1, 1, 1}, {-1, 0, -1});
  const NodeTouches t = CheckedScene(scene, 0.01).at(16);
  ASSERT_EQ(t.count, 2);
  EXPECT_EQ(t.touch[0].face, face_of(0, z_max));
  EXPECT_EQ(t.touch[1].face, face_of(1, x_max));
}

TEST(NodeCheck, AConvexEdgeHoldsANodeByOneFace) {
  // A corner node just inside the edge of the big brick, behind its top by less than behind its side.
  const NodeTouches t = CheckedScene(make_drop({3.99, 1, 0.995}, {0, 0, 0}), 0.01).at(8);
  ASSERT_EQ(t.count, 1);
  EXPECT_EQ(t.touch[0].face, face_of(0, z_max));
}

TEST(NodeCheck, HistoryDecidesBeforeDepth) {
  // A node as above with a history on the side: it stays there though the top is nearer.
  CheckedScene scene(make_drop({3.99, 1, 0.995}, {0, 0, 0}), 0.01);
  scene.history_face(3 * 8) = face_of(0, x_max);
  scene.check();
  const NodeTouches t = scene.at(8);
  ASSERT_EQ(t.count, 1);
  EXPECT_EQ(t.touch[0].face, face_of(0, x_max));
  EXPECT_TRUE(t.touch[0].same_face);
}

TEST(NodeCheck, ANodeWithAHistoryIsHeldDownToItsDepthAndHasTheGapOfTheStart) {
  for (const double depth : {0.0, 0.05, 0.2, 0.26}) {  // contact holds down to 0.25 h, and h is 1
    CheckedScene scene(make_drop({1, 1, 1 - depth}, {0.5, 0, -0.1}), 0.01);
    scene.history_face(3 * 8) = face_of(0, z_max);
    scene.check();
    const NodeTouches t = scene.at(8);
    ASSERT_EQ(t.count, depth < 0.25 ? 1 : 0) << depth;
    if (t.count == 0) continue;
    EXPECT_FALSE(t.touch[0].owes_start);
    EXPECT_NEAR(t.touch[0].gap_start, -depth, tight);
    EXPECT_NEAR(t.touch[0].gap_end, -depth - 0.001, tight);
  }
}

TEST(NodeCheck, ASeamOfTwoFacesGivesOneHitWhicheverSideOfItTheNodeFallsOn) {
  for (const double offset : {-1e-9, -1e-16, 0.0, 1e-16, 1e-9}) {
    BrickScene scene;
    scene.add_brick({-2, 0, 0}, {2, 4, 1});
    scene.add_brick({0, 0, 0}, {2, 4, 1});
    scene.add_brick({offset, 1, 1.05}, {1, 1, 1}, {0, 0, -1});
    const NodeTouches t = CheckedScene(scene, 0.1).at(16);
    ASSERT_EQ(t.count, 1) << offset;
    EXPECT_NEAR(t.touch[0].gap_end, -0.05, 1e-13);
  }
}

TEST(NodeCheck, ANodeThatSlidesOverASeamIsNotCaughtByTheSideOfTheNextBody) {
  // The leading lower edge (node 17 of the small brick) passes from the first body's top to the second one's.
  for (const double height : {-1e-12, 0.0, 1e-12}) {
    BrickScene scene;
    scene.add_brick({-2, 0, 0}, {2, 4, 1});
    scene.add_brick({0, 0, 0}, {2, 4, 1});
    scene.add_brick({-1.005, 1, 1 + height}, {1, 1, 1}, {1, 0, -0.5});
    CheckedScene checked(scene, 0.01);
    checked.history_face(3 * 17) = face_of(0, z_max);
    checked.check();
    const NodeTouches t = checked.at(17);
    ASSERT_EQ(t.count, 1);
    EXPECT_NEAR(t.touch[0].normal.z, 1, tight);
  }
}

TEST(NodeCheck, ANodeSlippingInBelowAnEdgeIsLiftedWhenShallowAndCaughtWhenDeep) {
  // The lower edge of a brick (nodes 8, 11: faces -x and -z) comes back in +x over the left top edge of the big one:
  // the big one's left side looks the same way as the brick's own, so nothing opposes it.
  for (const double depth : {0.002, 0.01}) {
    const NodeTouches t = CheckedScene(make_drop({-0.005, 1, 1 - depth}, {1, 0, 0}), 0.01).at(8);
    ASSERT_EQ(t.count, 1);
    EXPECT_EQ(t.touch[0].face, face_of(0, depth < 0.005 ? z_max : x_min));
  }
}

TEST(NodeCheck, FarFromTheOriginTheSameTouchesAreFound) {
  // A shift by a power of two larger than the scene rounds all coordinates, which are multiples of 2^-12, by nothing.
  const Point3 far{1048576, -2097152, 524288};
  const double q = 1.0 / 4096;
  const BrickScene near_scene = make_drop({1 + 7 * q, 1 + 3 * q, 1 + 11 * q}, {0.25, -0.5, -1});
  BrickScene far_scene = near_scene;
  for (Point3& x : far_scene.x) x = x + far;
  const CheckedScene a(near_scene, 0.0625), b(far_scene, 0.0625);
  for (const int node : {8, 9, 10, 11}) {
    const NodeTouches s = a.at(node), t = b.at(node);
    ASSERT_EQ(s.count, 1);
    ASSERT_EQ(t.count, 1);
    EXPECT_EQ(s.touch[0].face, t.touch[0].face);
    EXPECT_EQ(s.touch[0].gap_start, t.touch[0].gap_start);
    EXPECT_EQ(s.touch[0].gap_end, t.touch[0].gap_end);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(s.touch[0].weight[i], t.touch[0].weight[i]);
  }
}

TEST(NodeCheck, TheListOfTouchesKeepsTheBestInOrderOfTheirKeys) {
  TouchList list;
  for (int i = 0; i < 40; ++i) {
    Touch t;
    start_touch((i * 17) % 40, 1, 0, t);
    list.insert(t);
  }
  ASSERT_EQ(list.count, TouchList::capacity);
  for (int i = 0; i < list.count; ++i) EXPECT_EQ(list.touch[i].face, i);
}

}  // namespace
}  // namespace percuss::test::node_check_test
