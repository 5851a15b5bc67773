// Two edges: where their lines meet, which way they push, when they go through one another.

#include "kernels/contact/check/edge_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::edge_check_test {
namespace {

constexpr double tight = 1e-14;

TEST(EdgeGeometry, LinesComeClosestWhereTheirDistanceIsSquareToBoth) {
  const EdgePair e{{{0, 0, 0.3}, {4, 0, 0.3}}, {{1, -1, 0}, {1, 3, 0}}};
  const Crossing c = find_crossing(e, 0.05);
  ASSERT_TRUE(c.crosses);
  EXPECT_NEAR(c.s, 0.25, tight);
  EXPECT_NEAR(c.t, 0.25, tight);
  EXPECT_NEAR(c.normal.z, 1, tight);
  EXPECT_NEAR(c.gap, 0.3, tight);
  EXPECT_TRUE(is_inside(c, 0.2));
  EXPECT_FALSE(is_inside(c, 0.3));
}

TEST(EdgeGeometry, NearlyParallelLinesDoNotCross) {
  EXPECT_FALSE(find_crossing({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0.04, 1}}}, 0.05).crosses);
  EXPECT_TRUE(find_crossing({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {1, 0.06, 1}}}, 0.05).crosses);
}

TEST(EdgeGeometry, InwardLiesInTheFaceSquareToTheEdge) {
  const Point3 in = find_inward({0, 0, 0}, {1, 0, 0}, {0.2, 2, 0}, {1.4, 2, 0});
  EXPECT_NEAR(norm(in - Point3{0, 1, 0}), 0, tight);
}

// Two roofs, one upside down on the other: ridges along x (A, hanging) and y (B, standing).
Wedge hanging() { return {{normalize(Point3{0, 1, 1}), normalize(Point3{0, -1, 1})}}; }
Wedge standing() { return {{normalize(Point3{1, 0, -1}), normalize(Point3{-1, 0, -1})}}; }

TEST(EdgeGeometry, APlaneBetweenRidgesPartsTheirWedgesOneWayOnly) {
  EXPECT_NEAR(find_reach_through(hanging(), standing(), {0, 0, 1}), -std::sqrt(0.5), tight);
  EXPECT_NEAR(find_reach_through(hanging(), standing(), {0, 0, -1}), std::sqrt(0.5), tight);
}

TEST(EdgeGeometry, EdgesThatRunPastEachOtherAreNotParted) {
  // The upright edge of a brick in front of the level edge of the next course, both in the plane of the wall.
  const Wedge upright{{{1, 0, 0}, {0, 1, 0}}}, level{{{0, 1, 0}, {0, 0, -1}}};
  EXPECT_GT(find_reach_through(upright, level, {0, 1, 0}), 0.9);
  EXPECT_GT(find_reach_through(upright, level, {0, -1, 0}), 0.9);
}

/// Two roofs of one triangle-like wedge each: A hangs at `height` over B and moves down by `fall` in the step. B's
/// first face ends at `eave`.
struct Roofs {
  Roofs(double height, double fall, double shift = 0, double eave = -1) {
    const std::vector<Point3> x = {{-0.5 + shift, 0, height},
                                   {0.5 + shift, 0, height},
                                   {0, -0.5, 0},
                                   {0, 0.5, 0},
                                   {-0.5 + shift, 1, height + 1},
                                   {0.5 + shift, 1, height + 1},
                                   {-0.5 + shift, -1, height + 1},
                                   {0.5 + shift, -1, height + 1},
                                   {1, -0.5, eave},
                                   {1, 0.5, eave},
                                   {-1, -0.5, -1},
                                   {-1, 0.5, -1}};
    std::vector<Point3> v(x.size());
    for (const int i : {0, 1, 4, 5, 6, 7}) v[static_cast<std::size_t>(i)] = {0, 0, -fall};
    motion = {to_rows(x), to_rows(v), 1};
    surface.num_edges = 2;
    const Rows2<int> ends("test::ends", 2);
    const int of_edges[2][2] = {{0, 1}, {2, 3}};
    for (int e = 0; e < 2; ++e)
      for (int i = 0; i < 2; ++i) ends(e, i) = of_edges[e][i];
    surface.ends = ends;
    surface.wings = to_rows4({{4, 5, 6, 7}, {8, 9, 10, 11}});
  }
  /// A also moves by this towards -x in the step.
  void slide(double by) {
    std::vector<Point3> v;
    for (int n = 0; n < 12; ++n)
      v.push_back(load_row(motion.v, n) - (n < 2 || (n > 3 && n < 8) ? by : 0.0) * Point3{1, 0, 0});
    motion = {motion.x, to_rows(v), motion.dt};
  }
  /// The edge of A.
  void set_blunt() {
    const Array<int> blunt("test::blunt", 2);
    blunt(0) = 1;
    surface.is_blunt = blunt;
  }
  /// B, moved along itself by `aside`, is the ridge of a face between its wings at x = 1 and -1.
  void set_ridge(double aside) {
    set_blunt();
    const Array<int> kinds("test::ridge", 2);
    kinds(1) = warped_ridge;
    surface.is_blunt = kinds;
    surface.wings = to_rows4({{4, 5, 6, 7}, {12, 12, 13, 13}});
    std::vector<Point3> x, v;
    for (int n = 0; n < 12; ++n) {
      x.push_back(load_row(motion.x, n) + (n == 2 || n == 3 ? Point3{0, aside, 0} : Point3{}));
      v.push_back(load_row(motion.v, n));
    }
    x.insert(x.end(), {{1, aside, -1}, {-1, aside, -1}});
    v.resize(x.size());
    motion = {to_rows(x), to_rows(v), motion.dt};
  }
  bool check(const Point3* last = nullptr) {
    return check_edge_pair({surface, motion, faces, {0, 1}, last}, load_moving_pair(surface, motion, 0, 1), touch);
  }

  EdgeSurface surface;
  SurfaceMotion motion;
  Array<EdgeFaces> faces = Array<EdgeFaces>("test::edge_faces", 0);
  EdgeTouch touch;
};

TEST(EdgeCheck, EdgesThatMeetInTheStepTouch) {
  Roofs r(0.05, 0.06);
  ASSERT_TRUE(r.check());
  EXPECT_NEAR(r.touch.normal.z, 1, tight);
  EXPECT_NEAR(r.touch.gap_start, 0.05, tight);
  EXPECT_NEAR(r.touch.gap_end, -0.01, tight);
  EXPECT_NEAR(r.touch.s, 0.5, tight);
  EXPECT_NEAR(r.touch.size, 1, tight);
}

TEST(EdgeCheck, EdgesThatStayApartDoNot) { EXPECT_FALSE(Roofs(0.1, 0.05).check()); }

TEST(EdgeCheck, NoSpeedIsTooHigh) {
  Roofs r(0.3, 50);
  ASSERT_TRUE(r.check());
  EXPECT_NEAR(r.touch.gap_start, 0.3, 1e-12);
  EXPECT_NEAR(r.touch.gap_end, -49.7, 1e-12);
}

TEST(EdgeCheck, EdgesDeepInsideAtTheStartDidNotComeThroughEachOther) {
  EXPECT_FALSE(Roofs(-0.1, 0.01).check());
  const Point3 up{0, 0, 1};
  EXPECT_TRUE(Roofs(-0.1, 0.01).check(&up));   // unless they are remembered
  EXPECT_FALSE(Roofs(-0.3, 0.01).check(&up));  // and not too deep for that
}

TEST(EdgeCheck, EdgesThatHaveCrossedInTheLastStepTouch) {
  Roofs r(-0.1, 0.11);
  ASSERT_TRUE(r.check());
  EXPECT_NEAR(r.touch.gap_start, -0.1, tight);
  EXPECT_NEAR(r.touch.gap_end, -0.21, tight);
  EXPECT_FALSE(Roofs(-0.1, 0.09).check());   // it had crossed a step before, on both edges
  EXPECT_FALSE(Roofs(-0.26, 0.27).check());  // it is deeper than any contact holds
}

// An edge that takes over what a node has held until then: a step before, its end was beside the other edge.
TEST(EdgeCheck, EdgesThatSlideAcrossTheirEndsTouchThoughTheyHaveCrossed) {
  const auto touches = [](double fall, double slide) {
    Roofs r(-0.025, fall, 0.45);
    r.slide(slide);
    return r.check();
  };
  EXPECT_TRUE(touches(0.01, 0.06));
  EXPECT_FALSE(touches(0.01, 0.04));   // it was on the edge
  EXPECT_FALSE(touches(0.004, 0.06));  // it was as deep as no new pair may be
}

// One face of B rises through the plane of the crossing: so bricks in line run past each other, and so a stiff edge
// lies across a ridge that it has bent.
TEST(EdgeCheck, EdgesBesideAFaceThatRisesThroughTheirPlaneTouchOnlyOnceTheyHaveCrossed) {
  const double rising = 0.2, steep = 0.4;  // sines 0.196 and 0.371
  EXPECT_TRUE(Roofs(0.01, 0.014).check());
  EXPECT_FALSE(Roofs(0.01, 0.014, 0, rising).check());
  EXPECT_TRUE(Roofs(0.01, 0.016, 0, rising).check());
  EXPECT_FALSE(Roofs(0.01, 0.016, 0, steep).check());
}

TEST(EdgeCheck, EdgesBesideAFaceThatRisesThroughTheirPlaneDoNotSayWhereTheyCameFrom) {
  const double rising = 0.2;
  EXPECT_TRUE(Roofs(-0.015, 0.01, 0, rising).check());
  EXPECT_FALSE(Roofs(-0.025, 0.01, 0, rising).check());
}

TEST(EdgeCheck, BluntEdgesTouchOnlyOnceTheyHaveCrossed) {
  const auto touches = [](double height, double fall, const Point3* last = nullptr) {
    Roofs r(height, fall);
    r.set_blunt();
    return r.check(last);
  };
  EXPECT_FALSE(touches(0.01, 0.014));
  EXPECT_TRUE(touches(0.01, 0.016));
  EXPECT_TRUE(touches(0.3, 50));
  EXPECT_FALSE(touches(-0.025, 0.01));
  const Point3 up{0, 0, 1};
  EXPECT_TRUE(touches(0.01, 0.005, &up));  // remembered
}

// Springs give way by 0.05 of the size, and blunt edges touch 5e-3 beyond that, however slowly they come there.
TEST(EdgeCheck, BluntEdgesBetweenSpringsTouchWhereSlowBodiesCross) {
  const auto touches = [](double height, double fall) {
    Roofs r(height, fall);
    r.set_blunt();
    r.surface.springs = SpringRows::all;
    return r.check();
  };
  EXPECT_FALSE(touches(-0.0545, 1e-4));
  EXPECT_TRUE(touches(-0.05495, 1e-4));
}

TEST(EdgeCheck, BluntEdgesOverlapAtTheStartOnceTheyWouldTouch) {
  const auto depth = [](double height, bool has_springs) {
    Roofs r(height, 0);
    r.motion.dt = 0;
    r.set_blunt();
    r.surface.springs = has_springs ? SpringRows::all : SpringRows::none;
    return find_edge_depth(r.surface, r.motion, 0, 1, r.touch);
  };
  EXPECT_EQ(depth(-0.004, false), 0);
  EXPECT_NEAR(depth(-0.006, false), 0.006, tight);
  EXPECT_NEAR(depth(-0.2, false), 0.2, tight);
  EXPECT_EQ(depth(-0.6, false), 0);
  EXPECT_EQ(depth(-0.054, true), 0);
  EXPECT_NEAR(depth(-0.056, true), 0.056, tight);
}

// B is the diagonal of a face whose other corners are at z = -1: the fan of the face is 0.5 below its middle, and a
// share of this beside it.
TEST(EdgeCheck, RidgesOfWarpedFacesTouchOnlyOnceTheirFanIsCrossed) {
  const auto touches = [](double height, double fall, double aside = 0) {
    Roofs r(height, fall);
    r.set_ridge(aside);
    return r.check();
  };
  EXPECT_FALSE(touches(-0.49, 0.014));
  EXPECT_TRUE(touches(-0.49, 0.016));
  EXPECT_FALSE(touches(-0.24, 0.014, 0.25));
  EXPECT_TRUE(touches(-0.24, 0.016, 0.25));
  EXPECT_FALSE(touches(-0.53, 0.01));  // began deep inside
  EXPECT_TRUE(touches(0.3, 50));
}

TEST(EdgeCheck, ARidgeOfAWarpedFaceIsRememberedAsDeepBelowItsFanAsOthers) {
  const Point3 up{0, 0, 1};
  const auto touches = [&](double height) {
    Roofs r(height, 0.001);
    r.set_ridge(0);
    return r.check(&up);
  };
  EXPECT_TRUE(touches(-0.74));
  EXPECT_FALSE(touches(-0.76));
}

// Both wings of a triangle are one node.
TEST(EdgeCheck, TheSizeOfTrianglesIsTheirShortestEdge) {
  Roofs r(0.01, 0.02);
  r.set_ridge(0);
  r.surface.is_blunt = Array<int>("test::sharp", 0);
  ASSERT_TRUE(r.check());
  EXPECT_NEAR(r.touch.size, 1, tight);
}

TEST(EdgeCheck, EndsBelongToNodesAndFaces) {
  EXPECT_TRUE(Roofs(0.01, 0.02, 0.498).check());
  EXPECT_FALSE(Roofs(0.01, 0.02, 0.4995).check());
  EXPECT_FALSE(Roofs(0.01, 0.02, 0.6).check());
}

// The end of an edge longer than h is beside the face there, and meets nothing.
TEST(EdgeCheck, EndsOfEdgesThatHaveCrossedTouch) {
  Roofs r(-0.006, 0.003, 0.4995);
  ASSERT_TRUE(r.check());
  EXPECT_NEAR(r.touch.s, 0.0005, tight);
  EXPECT_NEAR(r.touch.gap_end, -0.009, tight);
  r.surface.springs = SpringRows::all;  // which nodes and faces have, too
  EXPECT_FALSE(r.check());
  EXPECT_FALSE(Roofs(-0.004, 0.003, 0.4995).check());
}

TEST(EdgeCheck, ARememberedContactIsKeptAtAnEndThatItsDepthTakesItPast) {
  const Point3 up{0, 0, 1};
  const auto fall_past = [&](double past, double fall) {  // A begins `past` of its edge beyond B
    Roofs r(0, fall, 0.5 + past);
    EXPECT_FALSE(r.check());
    const bool kept = r.check(&up);
    if (kept) {
      EXPECT_EQ(r.touch.s, 0);
      EXPECT_NEAR(r.touch.t, 0.5, tight);
      EXPECT_NEAR(r.touch.gap_start, 0, tight);
      EXPECT_NEAR(r.touch.gap_end, -fall, tight);
    }
    return kept;
  };
  EXPECT_TRUE(fall_past(0.025, 0));
  EXPECT_FALSE(fall_past(0.035, 0));
  EXPECT_TRUE(fall_past(0.07, 0.1));   // into a valley, on its predicted way
  EXPECT_FALSE(fall_past(0.09, 0.1));  // off the edge
  EXPECT_TRUE(fall_past(0.05, 0.4));   // deeper than any contact reaches: held where it was
}

TEST(EdgeCheck, DepthIsThatOfTheRidges) {
  Roofs r(-0.2, 0);
  r.motion.dt = 0;
  EXPECT_NEAR(find_edge_depth(r.surface, r.motion, 0, 1, r.touch), 0.2, tight);
  Roofs apart(0.2, 0);
  EXPECT_EQ(find_edge_depth(apart.surface, apart.motion, 0, 1, apart.touch), 0);
}

}  // namespace
}  // namespace percuss::test::edge_check_test
