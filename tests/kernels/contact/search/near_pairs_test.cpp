// Pairs that are left out of the check: none that it would have accepted.

#include <gtest/gtest.h>

#include <random>

#include "kernels/contact/search/near_pairs.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::near_pairs_test {
namespace {

/// Bricks of size 1 side by side and on one another, `gap` apart.
BrickScene make_loose_wall(double gap) {
  BrickScene bricks;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        bricks.add_brick({(1 + gap) * i + 0.3 * (k % 2), (1 + gap) * j, (1 + gap) * k}, {1, 1, 1});
  return bricks;
}

/// Makes its faces those of shells of this half thickness.
void thicken(CheckedScene& scene, double half) {
  const auto faces = static_cast<std::size_t>(scene.surface.num_faces), corners = 4 * faces;
  const auto nodes = static_cast<std::size_t>(scene.surface.num_nodes);
  scene.surface.offsets = {half,
                           to_array(std::vector<double>(faces, half)),
                           to_array(std::vector<double>(nodes, half)),
                           to_array(std::vector<int>(corners + 1, 0)),
                           to_array(std::vector<int>()),
                           to_array(std::vector<int>(corners, 0))};
  scene.faces.slab = Array<FaceSlab>("test::slab", faces);
  scene.check();
}

void expect_same(const NodeTouches& a, const NodeTouches& b, int node) {
  ASSERT_EQ(a.count, b.count) << "node " << node;
  for (int i = 0; i < a.count; ++i) {
    EXPECT_EQ(a.touch[i].face, b.touch[i].face);
    EXPECT_EQ(a.touch[i].record, b.touch[i].record);
    EXPECT_EQ(a.touch[i].gap_start, b.touch[i].gap_start);
    EXPECT_EQ(a.touch[i].gap_end, b.touch[i].gap_end);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(a.touch[i].weight[k], b.touch[i].weight[k]);
  }
}

std::vector<NodeTouches> list_touches(const CheckedScene& scene) {
  std::vector<NodeTouches> touches;
  for (int n = 0; n < scene.surface.num_nodes; ++n) touches.push_back(scene.at(n));
  return touches;
}

/// The nodes remember what they touch.
void remember(CheckedScene& scene, const std::vector<NodeTouches>& touches) {
  for (int n = 0; n < scene.surface.num_nodes; ++n)
    for (int i = 0; i < contact_limits::max_touches; ++i) {
      const NodeTouches& of = touches[static_cast<std::size_t>(n)];
      scene.history_face(contact_limits::max_touches * n + i) = i < of.count ? of.touch[i].face : -1;
    }
}

Point3 draw_in_ball(std::mt19937& random, double radius) {
  const auto draw = [&] { return radius * (2 * (static_cast<double>(random()) / 4294967295.0) - 1); };
  for (;;) {
    const Point3 p{draw(), draw(), draw()};
    if (norm(p) <= radius) return p;
  }
}

/// A unit vector by which a brick of the wall goes towards one neighbour and away from the other.
Point3 find_approach(int brick, int draw) {
  const int place[3] = {brick / 9, brick / 3 % 3, brick % 3}, axis = draw % 3;
  const double way = (place[axis] + draw / 3) % 2 == 0 ? 1 : -1;
  return {axis == 0 ? way : 0, axis == 1 ? way : 0, axis == 2 ? way : 0};
}

struct Counts {
  int near = 0, all = 0, touches = 0;
};

/// Compares checks of the near pairs and of all while the nodes stay within the travel of where the former were listed:
/// bricks go most of it towards each other.
Counts compare_checks(double gap, double half_thickness, double travel) {
  CheckedScene scene(make_loose_wall(gap), 0.5, 0, 2 * gap);
  if (half_thickness > 0) thicken(scene, half_thickness);
  const Rows3<double> origin = to_rows(make_loose_wall(gap).x);
  std::mt19937 random(7);
  remember(scene, list_touches(scene));
  Counts counts;
  for (int round = 0; round < 4; ++round) {
    NearScratch scratch;
    CandidateList near;
    Kokkos::deep_copy(scene.x, origin);
    Kokkos::deep_copy(scene.v, 0.0);
    scene.check();
    EXPECT_TRUE(list_near_pairs(SmallSpace(), scene.inputs(), scene.candidates,
                                {travel, static_cast<double>(scene.candidates.num_pairs)}, scratch, near));
    counts.near += near.num_pairs;
    counts.all += scene.candidates.num_pairs;
    for (int draw = 0; draw < 8; ++draw) {
      for (int n = 0; n < scene.surface.num_nodes; ++n) {
        const Point3 x = draw_in_ball(random, 0.1 * travel),
                     to = 0.9 * travel * find_approach(n / 8, draw) + draw_in_ball(random, 0.1 * travel);
        store_row(scene.x, n, load_row(origin, n) + x);
        store_row(scene.v, n, (1 / scene.motion.dt) * (to - x));
      }
      scene.check();
      const std::vector<NodeTouches> all = list_touches(scene);
      std::swap(scene.candidates, near);
      scene.check();
      for (int n = 0; n < scene.surface.num_nodes; ++n) {
        expect_same(scene.at(n), all[static_cast<std::size_t>(n)], n);
        counts.touches += all[static_cast<std::size_t>(n)].count;
      }
      std::swap(scene.candidates, near);
      remember(scene, all);
    }
  }
  return counts;
}

// Gaps that two sides close only if both go nearly all of the travel towards each other.

TEST(NearPairs, SolidsAreCheckedAlike) {
  const Counts counts = compare_checks(0.9, 0, 0.5);
  EXPECT_GT(counts.touches, 100);
  EXPECT_LT(counts.near, 0.95 * counts.all);
}

TEST(NearPairs, ShellsAreCheckedAlike) {
  // Half a thickness of the brick's faces and of its nodes each.
  const Counts counts = compare_checks(0.04 + 0.18, 0.02, 0.1);
  EXPECT_GT(counts.touches, 100);
  EXPECT_LT(counts.near, 0.95 * counts.all);
}

TEST(NearPairs, AtRestOnlyWhatTouchesIsNear) {
  const Counts apart = compare_checks(0.4, 0, 1e-6);
  EXPECT_EQ(apart.touches, 0);
  EXPECT_EQ(apart.near, 0);
  EXPECT_GT(apart.all, 500);
}

}  // namespace
}  // namespace percuss::test::near_pairs_test
