#include "kernels/contact/search/pair_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "kernels/contact/search/kd_order.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::points_in_box_test {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Boxes bound_all(const BrickScene& scene, double reach) {
  const ContactSurface s = scene.surface();
  Boxes boxes("test::boxes", static_cast<std::size_t>(s.num_faces));
  const Rows3<double> x = to_rows(scene.x);
  for (int f = 0; f < s.num_faces; ++f) {
    bound_face(
        SurfaceMotion{x, x, 0}, [&](int corner) { return s.face_corners(f, corner); }, reach, boxes, f);
  }
  return boxes;
}

/// Every node against every face.
Pairs find_by_brute_force(const BrickScene& scene, const Boxes& boxes) {
  const ContactSurface s = scene.surface();
  Pairs pairs;
  for (int n = 0; n < s.num_nodes; ++n)
    for (int f = 0; f < s.num_faces; ++f) {
      const Point3 p = scene.x[static_cast<std::size_t>(n)];
      const bool inside = p.x >= boxes(f, 0) && p.y >= boxes(f, 1) && p.z >= boxes(f, 2) && p.x <= boxes(f, 3) &&
                          p.y <= boxes(f, 4) && p.z <= boxes(f, 5);
      if (inside && n / 8 != f / 6) pairs.emplace_back(n, f);
    }
  return pairs;
}

template <class Space>
Pairs find_pairs(const BrickScene& scene, const Boxes& boxes, SearchScratch& scratch) {
  CandidateList list;
  const Rows3<double> x = to_rows(scene.x);
  find_candidate_pairs(Space(), scene.surface(), {x, boxes}, 10'000'000, scratch, list);
  Pairs pairs;
  for (int n = 0; n < scene.num_nodes(); ++n)
    for (int c = list.offset(n); c < list.offset(n + 1); ++c) pairs.emplace_back(n, list.face(c));
  EXPECT_EQ(static_cast<int>(pairs.size()), list.num_pairs);
  return pairs;
}

void expect_same_as_brute_force(const BrickScene& scene, double reach) {
  const Boxes boxes = bound_all(scene, reach);
  const Pairs expected = find_by_brute_force(scene, boxes);
  for (const SearchMethod method : {SearchMethod::points_in_box, SearchMethod::blocks}) {
    SearchScratch scratch;
    scratch.method = method;
    EXPECT_EQ(find_pairs<SmallSpace>(scene, boxes, scratch), expected);  // and so sorted by (node, face)
    EXPECT_EQ(find_pairs<ExecSpace>(scene, boxes, scratch), expected);
  }
}

TEST(PointsInBox, FindsTheRandomPairsOfBruteForce) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-5, 5), size(0.1, 1);
  BrickScene scene;
  for (int i = 0; i < 150; ++i)
    scene.add_brick({place(random), place(random), place(random)}, {size(random), size(random), size(random)});
  expect_same_as_brute_force(scene, 0.2);
}

TEST(PointsInBox, FindsCoincidentNodesOfStackedBricks) {
  BrickScene scene;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 5; ++k)
        scene.add_brick({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}, {1, 1, 1});
  expect_same_as_brute_force(scene, 0);  // boxes without volume: the ends belong to them
  expect_same_as_brute_force(scene, 0.25);
}

TEST(PointsInBox, FindsPairsWhenAllNodesLieInOnePlane) {
  BrickScene scene;
  for (int i = 0; i < 60; ++i) scene.add_brick({0.37 * i, 0.11 * (i % 7), 0}, {1, 1, 0});
  expect_same_as_brute_force(scene, 0.1);
}

TEST(PointsInBox, FindsPairsOfVeryDifferentSizesFarFromTheOrigin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1);
  BrickScene scene;
  for (int i = 0; i < 100; ++i) {
    const double size = i % 10 == 0 ? 1.0 : 0.01;
    scene.add_brick({1e6 + place(random), -1e6 + place(random), place(random)}, {size, size, size});
  }
  expect_same_as_brute_force(scene, 0.01);
}

TEST(PointsInBox, ReportsTooManyPairsInsteadOfListingThem) {
  BrickScene scene;
  for (int i = 0; i < 20; ++i) scene.add_brick({}, {1, 1, 1});
  const Rows3<double> x = to_rows(scene.x);
  for (const SearchMethod method : {SearchMethod::points_in_box, SearchMethod::blocks}) {
    SearchScratch scratch;
    scratch.method = method;
    CandidateList list;
    EXPECT_GT(find_candidate_pairs(SmallSpace(), scene.surface(), {x, bound_all(scene, 1)}, 100, scratch, list), 100);
    EXPECT_EQ(list.num_pairs, 0);
  }
}

/// Bricks that fly apart and past one another.
BrickScene make_swarm(double time) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-2, 2), speed(-1, 1);
  BrickScene scene;
  for (int i = 0; i < 400; ++i) {
    const double x = place(random) + time * speed(random), y = place(random) + time * speed(random);
    scene.add_brick({x, y, place(random) + time * speed(random)}, {0.3, 0.3, 0.3});
  }
  return scene;
}

TEST(BlockSearch, KeepsItsOrderWhileItServesAndFindsTheSamePairsWhateverTheOrderIs) {
  SearchScratch kept;
  bool was_worn = false, was_kept = false;
  for (int step = 0; step < 12; ++step) {
    const BrickScene scene = make_swarm(0.25 * step);
    const Boxes boxes = bound_all(scene, 0.05);
    SearchScratch fresh;
    EXPECT_EQ(find_pairs<SmallSpace>(scene, boxes, kept), find_pairs<SmallSpace>(scene, boxes, fresh));
    (kept.blocks.is_worn ? was_worn : was_kept) = true;
  }
  EXPECT_TRUE(was_worn);
  EXPECT_TRUE(was_kept);
}

TEST(BlockSearch, TakesOtherPointsThanTheLastTime) {
  SearchScratch scratch;
  for (const int bricks : {40, 7, 1, 90}) {
    BrickScene scene;
    for (int i = 0; i < bricks; ++i) scene.add_brick({0.9 * (i % 9), 0.9 * (i / 9), 0.1 * (i % 2)}, {1, 1, 1});
    const Boxes boxes = bound_all(scene, 0.1);
    EXPECT_EQ(find_pairs<ExecSpace>(scene, boxes, scratch), find_by_brute_force(scene, boxes));
  }
}

/// A wall of bricks of which some have gone, and some others have come in places near these.
struct ChangedWall {
  BrickScene scene;
  std::vector<std::int64_t> nodes, faces;  // numbers, ascending

  ChangedWall(int gone, int come) {
    for (int i = 0; i < 225; ++i)
      if (i < 100 || i >= 100 + gone) add(i, {1.0 * (i % 15), 1.0 * (i / 15), 0});
    for (int i = 100; i < 100 + come; ++i) add(125 + i, {1.0 * (i % 15), 1.0 * (i / 15), 0.2});
  }

  void add(int number, const Point3& place) {
    scene.add_brick(place, {1, 1, 1});
    for (int n = 0; n < 8; ++n) nodes.push_back(8 * number + n);
    for (int f = 0; f < 6; ++f) faces.push_back(6 * number + f);
  }
};

TEST(BlockSearch, GoesOnInItsOrderWhenFewItemsAreOthers) {
  SearchScratch scratch;
  const auto expect_all_pairs = [&](const ChangedWall& wall) {
    const Boxes boxes = bound_all(wall.scene, 0.1);
    identify(wall.nodes, wall.faces, scratch.blocks);
    EXPECT_EQ(find_pairs<SmallSpace>(wall.scene, boxes, scratch), find_by_brute_force(wall.scene, boxes));
  };
  expect_all_pairs({0, 0});
  const double first_tests = scratch.blocks.first_tests;  // counted where an order is made anew
  for (int changed = 1; changed < 20; ++changed) {
    expect_all_pairs({changed, changed});
    EXPECT_EQ(scratch.blocks.first_tests, first_tests);
    EXPECT_FALSE(scratch.blocks.is_worn);
  }
  for (int gone = 20; gone < 40; ++gone) expect_all_pairs({gone, 20});
  for (int come = 20; come < 120; come += 7) expect_all_pairs({40, come});
  expect_all_pairs({110, 0});
  EXPECT_NE(scratch.blocks.first_tests, first_tests);
}

TEST(KdOrder, IsAPermutationWhoseBlocksAreSmall) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<double> points(3 * 4096);
  for (double& x : points) x = place(random);
  points[7] = std::nan("");
  const std::vector<int> order = find_kd_order(points);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], static_cast<int>(i));
  // 256 blocks of a unit cube: cells of 1/4 x 1/8 x 1/8 or near it.
  double mean = 0;
  for (std::size_t b = 0; b < 256; ++b) {
    double low = 1, high = 0;
    for (std::size_t i = 0; i < 16; ++i) {
      const double x = points[3 * static_cast<std::size_t>(order[16 * b + i])];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    mean += (high - low) / 256;
  }
  EXPECT_LT(mean, 0.25);
}

std::vector<int> find_order_of_line(std::size_t n) {
  std::vector<double> points(3 * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) points[3 * i] = static_cast<double>(i);
  return find_kd_order(points);
}

TEST(KdOrder, GoesOnOverAChangeWithNewItemsInThePlacesOfThoseGone) {
  std::vector<std::int64_t> before(64), now;
  std::iota(before.begin(), before.end(), 100);
  const std::vector<int> order = find_order_of_line(64);
  for (const std::int64_t number : before)
    if (number != 105 && number != 150) now.push_back(number);
  now.insert(now.begin(), {7, 8, 9});  // three come, two go
  const std::vector<int> carried = carry_order(order, before, now);
  ASSERT_EQ(carried.size(), now.size());
  std::vector<int> sorted = carried;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], static_cast<int>(i));
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::int64_t was = before[static_cast<std::size_t>(order[place])];
    const std::int64_t is = now[static_cast<std::size_t>(carried[place])];
    if (was == 105 || was == 150)
      EXPECT_LT(is, 10) << place;
    else
      EXPECT_EQ(is, was) << place;
  }
}

TEST(KdOrder, FillsPlacesThatAreLeftOverFromItsEnd) {
  std::vector<std::int64_t> before(64), now;
  std::iota(before.begin(), before.end(), 0);
  const std::vector<int> order = find_order_of_line(64);
  for (const std::int64_t number : before)
    if (number != 3 && number != 62 && number != 63) now.push_back(number);
  const std::vector<int> carried = carry_order(order, before, now);
  std::vector<int> sorted = carried;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), now.size());
  for (std::size_t place = 0; place < carried.size(); ++place) {
    const std::int64_t was = before[static_cast<std::size_t>(order[place])];
    if (was != 3 && was != 62 && was != 63) {
      EXPECT_EQ(now[static_cast<std::size_t>(carried[place])], was) << place;
    }
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], static_cast<int>(i));
}

TEST(KdOrder, DoesNotGoOnOverALargeChange) {
  std::vector<std::int64_t> before(64), now(64), less(64);
  std::iota(before.begin(), before.end(), 0);
  std::iota(now.begin(), now.end(), 9);  // 9 of 64 go and 9 come
  std::iota(less.begin(), less.end(), 8);
  const std::vector<int> order = find_order_of_line(64);
  EXPECT_TRUE(carry_order(order, before, now).empty());
  EXPECT_FALSE(carry_order(order, before, less).empty());
  EXPECT_FALSE(carry_order(order, before, before).empty());
  EXPECT_TRUE(carry_order({}, before, before).empty());
}

TEST(PointOrder, RanksByCoordinateThenByPlaceInTheList) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> few(-8, 8);
  std::vector<Point3> x;
  for (int i = 0; i < 9000; ++i) x.push_back({i % 5 == 0 ? -0.0 : 0.25 * few(random), 1e300 * few(random), 1e-300});
  std::vector<int> points(x.size());
  std::iota(points.begin(), points.end(), 0);
  const Rows3<double> rows = to_rows(x);
  const Array<int> list = to_array(points), order("test::order", x.size()), rank("test::rank", x.size());
  SortScratch scratch;
  for (int axis = 0; axis < 3; ++axis) {
    rank_points(ExecSpace(), {rows, list, static_cast<int>(x.size()), axis}, scratch, order, rank);
    std::vector<int> expected = points;
    std::stable_sort(expected.begin(), expected.end(), [&](int a, int b) { return rows(a, axis) < rows(b, axis); });
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_EQ(order(i), expected[i]);
      ASSERT_EQ(rank(expected[i]), static_cast<int>(i));
    }
  }
}

}  // namespace
}  // namespace percuss::test::points_in_box_test
