// The stage by itself: free nodes with given velocities, no elements behind them.

#include "src/contact/contact_stage.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernels/contact/geometry/contact_limits.hpp"
#include "kernels/contact/geometry/point3.hpp"
#include "src/deck/reading/read_deck.hpp"
#include "src/error.hpp"
#include "src/mesh/decomposition/decompose.hpp"
#include "tests/expect_error.hpp"

namespace percuss::test {
namespace {

const std::string material = "\nmaterials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}\n";

/// Places and velocities of a deck's nodes, unit masses, moved by the stage alone.
struct FreeNodes {
  explicit FreeNodes(const std::string& text, const Point3& shift = {})
      : deck(parse_deck("time: {end: 1}\n" + text + material, "deck.yaml")),
        chunked(load_mesh(deck, Communicator::world())),
        mesh(chunked.mesh),
        stage(chunked, deck, Communicator::world()),
        x("test::x", mesh.nodes.size()),
        v("test::v", mesh.nodes.size()),
        before("test::before", mesh.nodes.size()),
        inverse_mass("test::inverse_mass", mesh.nodes.size()),
        impulse("test::impulse", mesh.nodes.size()) {
    Kokkos::deep_copy(inverse_mass, 1.0);
    for (int n = 0; n < count(); ++n) {
      const Vec3& p = mesh.nodes[static_cast<std::size_t>(n)];
      store_row(x, n, Point3{p[0], p[1], p[2]} + shift);
    }
  }

  int count() const { return static_cast<int>(mesh.nodes.size()); }
  const std::vector<int>& part(const std::string& name) const { return mesh.node_sets.at(name); }
  void set_velocity(const std::string& name, const Point3& velocity) {
    for (const int n : part(name)) store_row(v, n, velocity);
  }
  void hold(const std::string& name) {
    for (const int n : part(name)) store_row(inverse_mass, n, {0, 0, 0});
  }
  std::string prepare() { return stage.prepare(x, v); }
  ContactReport step(double dt) {
    Kokkos::deep_copy(before, v);
    const ContactReport report = stage.apply({x, before, v, inverse_mass, impulse, dt});
    for (int n = 0; n < count(); ++n) store_row(x, n, load_row(x, n) + dt * load_row(v, n));
    return report;
  }

  Deck deck;
  ChunkedMesh chunked;
  const Mesh& mesh;
  ContactStage stage;
  Rows3<double> x, v, before, inverse_mass, impulse;
};

const std::string plate_and_cube = R"(
parts:
  plate: {box: {size: [4, 4, 0.1], cells: [4, 4, 1]}, at: [0, 0, 0], material: m}
  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [1.25, 1.5, 0.25], material: m}
contact: {surfaces: all}
)";

TEST(ContactStage, DoesNothingWhileNothingIsNear) {
  FreeNodes nodes(plate_and_cube);
  nodes.set_velocity("cube", {0, 0, 1});
  EXPECT_TRUE(nodes.stage.is_active());
  EXPECT_EQ(nodes.prepare(), "");
  ContactReport report;
  for (int i = 0; i < 30; ++i) report = nodes.step(0.1);
  EXPECT_EQ(report.candidates, 0);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_EQ(nodes.v(nodes.part("cube")[0], 2), 1);
}

TEST(ContactStage, StopsACubeThatWouldPassAPlateAtTenThicknessesAStep) {
  FreeNodes nodes(plate_and_cube);
  nodes.hold("plate");
  nodes.set_velocity("cube", {0, 0, -10});
  const ContactReport report = nodes.step(0.125);  // 1.25 in one step, the plate is 0.1 thick
  EXPECT_GE(report.interactions, 4);
  EXPECT_TRUE(report.converged);
  for (const int n : nodes.part("cube/z_min"))
    EXPECT_NEAR(nodes.x(n, 2), 0.1, 1e-3 * 1.1);  // the tolerance of the solver
  EXPECT_LT(nodes.stage.measure_penetration(nodes.x), 0.01);
  EXPECT_LT(report.normal_work, 0);
}

TEST(ContactStage, ImpulsesAreEqualAndOppositeAndGoneWhenContactIs) {
  FreeNodes nodes(plate_and_cube);
  nodes.hold("plate");
  nodes.set_velocity("cube", {0.5, 0, -10});
  nodes.step(0.0625);
  Point3 sum{};
  double largest = 0;
  for (int n = 0; n < nodes.count(); ++n) {
    sum = sum + load_row(nodes.impulse, n);
    largest = std::max(largest, norm(load_row(nodes.impulse, n)));
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_LT(norm(sum), 1e-14);
  nodes.set_velocity("cube", {0, 0, 1});
  nodes.step(0.0625);
  for (int n = 0; n < nodes.count(); ++n) EXPECT_EQ(norm(load_row(nodes.impulse, n)), 0);
}

TEST(ContactStage, ElementsThatGrowThickerBringNodesIntoReach) {
  // A cube has come through the top of a plate of two layers by more than a contact of elements so thin holds. Then
  // the nodes between the layers go down, and the same depth is a small one: no contact node has moved to speak of.
  const std::string plate = R"(
parts:
  plate: {box: {size: [4, 4, 0.04], cells: [4, 4, 2]}, at: [0, 0, 0], material: m}
  cube: {box: {size: [0.5, 0.5, 0.5], cells: [1, 1, 1]}, at: [1.25, 1.25, 0.03], material: m}
contact: {surfaces: all, reuse_search: )";
  FreeNodes reused(plate + "true}"), fresh(plate + "false}");
  for (int i = 0; i < 6; ++i) {
    int from_reused = 0, from_fresh = 0;
    for (FreeNodes* nodes : {&reused, &fresh}) {
      nodes->set_velocity("cube", {0, 0, -1e-3});
      for (const int n : nodes->part("plate")) {
        const Vec3& place = nodes->mesh.nodes[static_cast<std::size_t>(n)];
        const bool is_inside =
            place[0] > 0 && place[0] < 4 && place[1] > 0 && place[1] < 4 && place[2] > 0.01 && place[2] < 0.03;
        if (is_inside) nodes->v(n, 2) = i == 3 ? -100 : 0;
      }
      (nodes == &reused ? from_reused : from_fresh) = nodes->step(0.01).interactions;
    }
    EXPECT_EQ(from_reused, from_fresh) << "step " << i;
    EXPECT_EQ(from_fresh > 0, i > 3) << "step " << i;
    for (int n = 0; n < reused.count(); ++n)
      for (int d = 0; d < 3; ++d) ASSERT_EQ(reused.v(n, d), fresh.v(n, d)) << "step " << i << " node " << n;
  }
  EXPECT_EQ(reused.stage.searches(), 1);
  EXPECT_GT(reused.stage.pair_counts().left_out, 0);
}

TEST(ContactStage, DeepInAThicknessAHistoryGoesFromFaceToFace) {
  // A cube rests on a thick plate, is put into its thickness, deeper than a node without a history is held, and slides
  // from one of the plate's faces to the next: as slowly as that, one list of near pairs serves all of the way.
  const std::string plate = R"(
parts:
  plate: {shell_plate: {size: [8, 8], cells: [2, 2]}, thickness: 1, material: m}
  cube: {box: {size: [0.2, 0.2, 0.2], cells: [1, 1, 1]}, at: [3.795, 1.9, 0.5], material: m}
contact: {surfaces: all, enforcement: kinematic, reuse_search: )";
  FreeNodes reused(plate + "true}"), fresh(plate + "false}");
  for (FreeNodes* nodes : {&reused, &fresh}) {
    nodes->hold("plate");
    nodes->set_velocity("cube", {0, 0, -1e-3});
    EXPECT_EQ(nodes->step(1).interactions, 4);
    for (const int n : nodes->part("cube")) nodes->x(n, 2) -= 0.4;
  }
  for (int i = 0; i < 12; ++i) {
    int from_reused = 0;
    for (FreeNodes* nodes : {&reused, &fresh}) {
      nodes->set_velocity("cube", {2e-3, 0, -1e-3});
      const int interactions = nodes->step(1).interactions;
      if (nodes == &reused)
        from_reused = interactions;
      else
        EXPECT_EQ(from_reused, interactions) << "step " << i;
    }
    EXPECT_EQ(from_reused, 4) << "step " << i;
  }
  EXPECT_GT(reused.x(reused.part("cube/x_max")[0], 0), 4 + 0.01);
  EXPECT_GT(reused.stage.pair_counts().left_out, 0);
}

TEST(ContactStage, AThickRimThatTurnsKeepsItsDistance) {
  // A strip turns about one end by 2e-3 a step and lifts a cube near the other, where its moved face continues beyond
  // the rim: the cube neither sinks into the thickness nor is thrown off it.
  FreeNodes nodes(R"(
parts:
  strip: {shell_plate: {size: [1, 0.5], cells: [1, 1]}, thickness: 0.2, material: m}
  cube: {box: {size: [0.05, 0.05, 0.05], cells: [1, 1, 1]}, at: [0.9, 0.2, 0.1], material: m}
contact: {surfaces: all, enforcement: kinematic}
)");
  nodes.hold("strip");
  const double turn = 2e-3;
  for (int i = 0; i < 200; ++i) {
    for (const int n : nodes.part("strip")) {
      const Vec3& place = nodes.mesh.nodes[static_cast<std::size_t>(n)];
      const double angle = turn * (i + 1);
      const Point3 to{place[0] * std::cos(angle), place[1], place[0] * std::sin(angle)};
      store_row(nodes.v, n, to - load_row(nodes.x, n));
    }
    nodes.set_velocity("cube", {0, 0, 0});
    nodes.step(1);
    for (const int n : nodes.part("cube/z_min")) {
      const double angle = turn * (i + 1), height = nodes.x(n, 2) * std::cos(angle) - nodes.x(n, 0) * std::sin(angle);
      ASSERT_NEAR(height, 0.1, 1e-6) << "step " << i;
    }
  }
}

TEST(ContactStage, TheReuseOfCandidatesChangesNoBit) {
  const std::string bricks = R"(
parts:
  pile: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, array: {count: [4, 4, 3], pitch: [1.05, 1.03, 1.01]}, material: m}
contact: {surfaces: all, friction: 0.3, reuse_search: )";
  FreeNodes reused(bricks + "true}"), fresh(bricks + "false}");
  for (FreeNodes* nodes : {&reused, &fresh})
    for (int n = 0; n < nodes->count(); ++n) {
      const int brick = n / 8;
      store_row(nodes->v, n, {0.3 * ((brick * 7) % 5 - 2), 0.3 * ((brick * 11) % 7 - 3), 0.2 * ((brick * 3) % 5 - 2)});
    }
  int pushes = 0;
  for (int i = 0; i < 120; ++i) {
    const ContactReport a = reused.step(0.01), b = fresh.step(0.01);
    pushes += a.interactions;
    ASSERT_EQ(a.interactions, b.interactions) << "step " << i;
    for (int n = 0; n < reused.count(); ++n)
      for (int d = 0; d < 3; ++d) ASSERT_EQ(reused.v(n, d), fresh.v(n, d)) << "step " << i << " node " << n;
  }
  EXPECT_GT(pushes, 1000);
  EXPECT_EQ(fresh.stage.searches(), 120);
  EXPECT_LT(reused.stage.searches(), 40);
  EXPECT_GT(reused.stage.pair_counts().left_out, 0);
  EXPECT_EQ(fresh.stage.pair_counts().left_out, 0);
}

TEST(ContactStage, FarFromTheOriginTheSameContactsAreFound) {
  // Shifts by powers of two; all coordinates are multiples of 2^-8 and keep their bits.
  FreeNodes here(plate_and_cube), there(plate_and_cube, {1048576, -2097152, 4194304});
  for (FreeNodes* nodes : {&here, &there}) {
    for (const int n : nodes->part("plate/z_max")) nodes->x(n, 2) += 0.125 - 0.1;
    nodes->set_velocity("cube", {0.25, 0.5, -1});
    const ContactReport report = nodes->step(0.25);
    EXPECT_EQ(report.interactions, 4);
  }
  for (int n = 0; n < here.count(); ++n)
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(here.v(n, d), there.v(n, d), 1e-9);
}

const std::string overlapping = R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [2, 2, 1]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0.25, 0.5, 0.95], material: m}
contact: {surfaces: all, overlap: )";

TEST(ContactStage, OverlapAtTheStartIsReportedAndAcceptedWithoutForce) {
  FreeNodes nodes(overlapping + "accept}");
  EXPECT_THAT(
      nodes.prepare(),
      testing::AllOf(testing::HasSubstr("5 contact nodes"), testing::HasSubstr("0.05"), testing::HasSubstr("accepted"),
                     testing::HasSubstr("4 of 'b' in 'a' (up to 0.05)"), testing::HasSubstr("1 of 'a' in 'b'")));
  for (int i = 0; i < 10; ++i) {
    const ContactReport report = nodes.step(0.01);
    EXPECT_EQ(report.normal_work, 0);
  }
  EXPECT_NEAR(nodes.stage.measure_penetration(nodes.x), 0.05, 1e-12);
  // Deeper than accepted it does not get.
  nodes.set_velocity("b", {0, 0, -1});
  for (int i = 0; i < 10; ++i) nodes.step(0.01);
  EXPECT_LT(nodes.stage.measure_penetration(nodes.x), 0.05 + 1e-3);
  EXPECT_GT(nodes.stage.measure_penetration(nodes.x), 0.04);
}

TEST(ContactStage, OverlapAtTheStartIsPushedOutSlowlyIfTheDeckSaysSo) {
  FreeNodes nodes(overlapping + "push_out}");
  EXPECT_THAT(nodes.prepare(), testing::HasSubstr("pushed out"));
  for (int i = 0; i < 2; ++i) nodes.step(0.01);  // held in the first
  double fastest = 0;
  for (int n = 0; n < nodes.count(); ++n) fastest = std::max(fastest, norm(load_row(nodes.v, n)));
  EXPECT_GT(fastest, 0);
  EXPECT_LT(fastest, 0.05 / 1000 / 0.01 + 1e-6);  // a thousandth of the overlap a step
  for (int i = 0; i < 1000; ++i) nodes.step(0.01);
  EXPECT_LT(nodes.stage.measure_penetration(nodes.x), 0.01);
}

TEST(ContactStage, OverlapThatOpensByItselfForAStepIsNotForgotten) {
  FreeNodes nodes(overlapping + "push_out}");
  nodes.prepare();
  for (int i = 0; i < 2; ++i) nodes.step(0.01);  // the second needs no push, for the first one still moves the bodies
  const double before = nodes.stage.measure_penetration(nodes.x);
  for (int i = 0; i < 10; ++i) {
    Kokkos::deep_copy(nodes.v, 0.0);
    nodes.step(0.01);
  }
  EXPECT_NEAR(nodes.stage.measure_penetration(nodes.x), before - 10 * 0.05 / 1000, 0.05 / 1000);
}

TEST(ContactStage, OverlapOfFlushBodiesIsFoundAndHeld) {
  for (const double depth : {0.03, 0.1, 0.2}) {
    FreeNodes nodes(
        "parts:\n  a: {box: {size: [4, 1, 2], cells: [4, 1, 2]}, material: m}\n  b: {box: {size: [4, 1, 2], "
        "cells: [4, 1, 2]}, at: [0, 0, " +
        std::to_string(2 - depth) + "], material: m}\ncontact: {surfaces: [[a, b]]}");
    EXPECT_THAT(nodes.prepare(), testing::HasSubstr("20 contact nodes overlap"));
    nodes.set_velocity("b", {0, 0, -1});
    for (int i = 0; i < 20; ++i) nodes.step(0.01);
    const int low = nodes.part("b/z_min")[0], high = nodes.part("a/z_max")[0];
    EXPECT_NEAR(nodes.x(high, 2) - nodes.x(low, 2), depth, 1e-3);
    EXPECT_THAT(nodes.stage.describe_overlap_left(nodes.x), testing::HasSubstr("20 contact nodes"));
  }
}

TEST(ContactStage, OverlapIsRefusedIfTheDeckSaysSo) {
  FreeNodes nodes(overlapping + "refuse}");
  try {
    nodes.prepare();
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(),
                testing::AllOf(testing::HasSubstr("deck.yaml:"), testing::HasSubstr("5 contact nodes overlap"),
                               testing::HasSubstr("deepest 0.05")));
  }
}

/// Tubes of 16 elements around, crossed: two edges of 22 degrees overlap by 0.026 of the shortest edge, no node does.
std::string cross_tubes(const std::string& overlap) {
  return R"(
parts:
  a: {tube: {inner_radius: 0.06, outer_radius: 0.1, length: 0.4, cells: [1, 16, 3]}, rotate: [{axis: x, angle: 90}], at: [0, 0.2, 0], material: m}
  b: {tube: {inner_radius: 0.06, outer_radius: 0.1, length: 0.41, cells: [1, 16, 3]}, rotate: [{axis: y, angle: 90}], at: [-0.2, 0, 0.199], material: m}
contact: {surfaces: all, overlap: )" +
         overlap + "}";
}

TEST(ContactStage, OverlapOfBluntEdgesIsHeldPushedOutOrRefused) {
  FreeNodes refused(cross_tubes("refuse"));
  EXPECT_ERROR(refused.prepare(), InputError, "contact.overlap");
  FreeNodes held(cross_tubes("accept"));
  EXPECT_THAT(held.prepare(), testing::HasSubstr("1 pair"));
  held.set_velocity("a", {0, 0, 1});
  double work = 0;
  for (int i = 0; i < 10; ++i) work += held.step(1e-4).normal_work;
  EXPECT_LT(work, 0);
  EXPECT_LT(held.stage.measure_penetration(held.x), 0.027);
  FreeNodes pushed(cross_tubes("push_out"));
  pushed.prepare();
  for (int i = 0; i < 600; ++i) pushed.step(1e-4);
  EXPECT_LT(pushed.stage.measure_penetration(pushed.x), 0.015);
}

TEST(ContactStage, OverlapTooDeepToHoldIsSaidToBe) {
  FreeNodes nodes(R"(
parts:
  a: {box: {size: [2, 2, 1], cells: [2, 2, 1]}, material: m}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0.5, 0.5, 0.6], material: m}
contact: {surfaces: all})");
  EXPECT_THAT(nodes.prepare(), testing::HasSubstr("5 of them lie deeper"));
}

TEST(ContactStage, ABodyBehindAWallIsToldAndOneThatTouchesIsNot) {
  const auto prepare = [](double height) {
    FreeNodes nodes("parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 0, " + std::to_string(height) +
                    "], material: m}}\nwalls: [{normal: -z}]");
    return nodes.prepare();
  };
  EXPECT_EQ(prepare(-1), "");
  EXPECT_EQ(
      prepare(-0.8),
      "4 contact nodes overlap a wall at the start, deepest 0.2 at node 5: accepted as the reference; 4 of 'a' behind "
      "walls.0 (up to 0.2)");
  EXPECT_EQ(
      prepare(1),
      "8 contact nodes overlap a wall at the start, deepest 2 at node 5: accepted as the reference; 8 of 'a' behind "
      "walls.0 (up to 2)");
}

TEST(ContactStage, AWallStopsNodesWithoutContactBetweenBodies) {
  FreeNodes nodes(R"(
parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 0, 0.05], material: m}}
walls: [{point: [0, 0, 0], normal: [0, 0, 1]}])");
  ASSERT_TRUE(nodes.stage.is_active());
  EXPECT_EQ(nodes.prepare(), "");
  nodes.set_velocity("a", {0, 0, -1});
  const ContactReport report = nodes.step(0.1);
  EXPECT_EQ(report.interactions, 4);
  const double depth_tolerance = 1.05 * contact_limits::depth_tolerance;  // of the largest coordinate
  for (const int n : nodes.part("a/z_min")) EXPECT_NEAR(nodes.x(n, 2), -depth_tolerance, 1e-15);
  EXPECT_NEAR(nodes.stage.measure_penetration(nodes.x), depth_tolerance, 1e-15);
}

TEST(ContactStage, AuditsSeeANodeInsideABodyWhateverIsInUse) {
  FreeNodes nodes(plate_and_cube);
  for (const int n : nodes.part("cube")) nodes.x(n, 2) -= 0.17;        // 0.02 into the plate of 0.1
  EXPECT_NEAR(nodes.stage.measure_penetration(nodes.x), 0.02, 1e-12);  // edges of the plate's faces are 1
  for (const int n : nodes.part("cube")) nodes.x(n, 2) += 0.17;
  EXPECT_EQ(nodes.stage.measure_penetration(nodes.x), 0);
}

TEST(ContactStage, StickingDoesNotCreep) {
  // A block on a wall, pressed and pulled below Coulomb's limit for 20 000 steps.
  FreeNodes nodes(R"(
parts: {a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
walls: [{point: [0, 0, 0], normal: [0, 0, 1], friction: 0.5}])");
  nodes.prepare();
  const double dt = 0.01;
  for (int i = 0; i < 20000; ++i) {
    for (const int n : nodes.part("a/z_min")) store_row(nodes.v, n, load_row(nodes.v, n) + dt * Point3{0.4, 0.1, -1});
    nodes.step(dt);
  }
  for (const int n : nodes.part("a/z_min")) {
    const Vec3& start = nodes.mesh.nodes[static_cast<std::size_t>(n)];
    EXPECT_NEAR(nodes.x(n, 0), start[0], 1e-9);
    EXPECT_NEAR(nodes.x(n, 1), start[1], 1e-9);
  }
}

}  // namespace
}  // namespace percuss::test
