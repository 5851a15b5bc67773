// What lies still is not looked at again, and nothing that has moved is taken for still.

#include "kernels/contact/check/still_items.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::still_items_test {
namespace {

/// Items of two nodes each, (0, 1), (1, 2), ...
struct Pairs {
  explicit Pairs(int nodes) : count(nodes - 1), x("test::x", at(nodes)), v("test::v", at(nodes)) {}
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// Whether each is found to lie still in a check of all of them.
  std::vector<bool> look(int nodes_each = 2, bool is_wanted = true) {
    still.begin(is_wanted, count);
    std::vector<bool> found;
    if (!still.is_watched()) return found;
    for (int item = 0; item < count; ++item) {
      found.push_back(still.look({x, v, 0.1}, item, nodes_each, [&](int k) { return item + k; }));
      EXPECT_NE(found.back(), still.has_moved(item));
    }
    return found;
  }

  int count;
  Rows3<double> x, v;
  StillItems<2> still;
};

using Found = std::vector<bool>;

TEST(StillItems, LieWhereTheyLayInTheCheckBefore) {
  Pairs pairs(4);
  EXPECT_EQ(pairs.look(), (Found{false, false, false}));
  EXPECT_EQ(pairs.look(), (Found{true, true, true}));
  pairs.v(0, 1) = 1e-300;
  EXPECT_EQ(pairs.look(), (Found{false, true, true}));
  EXPECT_EQ(pairs.look(), (Found{false, true, true}));
  pairs.v(0, 1) = 0;
  EXPECT_EQ(pairs.look(), (Found{false, true, true}));  // it may have got elsewhere
  EXPECT_EQ(pairs.look(), (Found{true, true, true}));
  pairs.x(1, 2) = 3;
  EXPECT_EQ(pairs.look(), (Found{false, false, true}));
  EXPECT_EQ(pairs.look(), (Found{true, true, true}));
}

TEST(StillItems, DifferInTheSignOfAZero) {
  Pairs pairs(2);
  pairs.look();
  EXPECT_EQ(pairs.look(), Found{true});
  pairs.x(1, 0) = -0.0;
  EXPECT_EQ(pairs.look(), Found{false});
  EXPECT_EQ(pairs.look(), Found{true});
  pairs.v(0, 0) = -0.0;
  EXPECT_EQ(pairs.look(), Found{false});
  EXPECT_EQ(pairs.look(), Found{false});
}

TEST(StillItems, CountAsMovedWhereOtherNodesAreAsked) {
  Pairs pairs(2);
  pairs.look(1);
  EXPECT_EQ(pairs.look(1), Found{true});
  EXPECT_EQ(pairs.look(2), Found{false});
  EXPECT_EQ(pairs.look(2), Found{true});
  EXPECT_EQ(pairs.look(1), Found{false});
}

TEST(StillItems, AreForgotten) {
  Pairs pairs(2);
  pairs.look();
  pairs.still.forget();
  EXPECT_EQ(pairs.look(), Found{false});
  EXPECT_EQ(pairs.look(), Found{true});
  EXPECT_EQ(pairs.look(2, false), Found());
  EXPECT_EQ(pairs.look(), Found{false});
  EXPECT_EQ(pairs.look(), Found{true});
}

TEST(StillItems, AreNotLookedForWhereTheyAreFew) {
  Pairs pairs(2);
  pairs.look();
  pairs.still.count_still(0, 100);  // the first check has nothing to compare with
  EXPECT_EQ(pairs.look(), Found{true});
  pairs.still.count_still(13, 100);
  EXPECT_EQ(pairs.look(), Found{true});
  pairs.still.count_still(12, 100);
  int passed = 0;
  while (pairs.look().empty()) ++passed;
  EXPECT_EQ(passed, 15);
  EXPECT_EQ(pairs.look(), Found{true});
}

struct SeenTouch {
  int node, face, record;
  double gap_start, gap_end, weight;
  bool operator==(const SeenTouch&) const = default;
};

std::vector<SeenTouch> list_touches(const CheckedScene& scene) {
  std::vector<SeenTouch> list;
  for (int n = 0; n < scene.surface.num_nodes; ++n) {
    const NodeTouches touches = scene.at(n);
    for (int i = 0; i < touches.count; ++i) {
      const Touch& t = touches.touch[i];
      list.push_back({n, t.face, t.record, t.gap_start, t.gap_end, t.weight[1]});
    }
  }
  return list;
}

void remember(CheckedScene& scene, const std::vector<SeenTouch>& touches) {
  Kokkos::deep_copy(scene.history_face, -1);
  int slot = 0, last = -1;
  for (const SeenTouch& touch : touches) {
    slot = touch.node == last ? slot + 1 : 0;
    last = touch.node;
    scene.history_face(contact_limits::max_touches * touch.node + slot) = touch.face;
  }
}

TEST(StillNodes, AreNotCheckedAgainAndTouchWhatTheyTouched) {
  // A pile of bricks that touch, of which some at a time take small steps, rest, and remember what they touch.
  const double dt = 0.1;
  BrickScene bricks;
  constexpr int side = 4;
  for (int i = 0; i < side * side * side; ++i)
    bricks.add_brick({1.0 * (i % side), 1.0 * (i / side % side), 1.0 * (i / side / side)}, {1, 1, 1}, {}, i);
  CheckedScene watched(bricks, dt), fresh(bricks, dt);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> speed(-0.02, 0.02);
  std::vector<SeenTouch> before;
  long kept = 0, all = 0;
  int repeated = 0;
  for (int step = 0; step < 60; ++step) {
    const int moving = step % 6 < 3 ? static_cast<int>(random() % (side * side * side)) : -1;
    for (CheckedScene* scene : {&watched, &fresh})
      for (int n = 0; n < scene->surface.num_nodes; ++n)
        store_row(scene->x, n, load_row(scene->x, n) + dt * load_row(scene->v, n));
    const Point3 v{speed(random), speed(random), speed(random)};
    for (CheckedScene* scene : {&watched, &fresh}) {
      Kokkos::deep_copy(scene->v, 0);
      for (int n = 8 * moving; moving >= 0 && n < 8 * moving + 8; ++n) store_row(scene->v, n, v);
      if (step % 4 == 1) remember(*scene, before);
    }
    watched.still.begin(true, watched.surface.num_faces);
    watched.check();
    fresh.check();
    const auto found = list_touches(watched), expected = list_touches(fresh);
    ASSERT_EQ(found, expected) << "step " << step;
    EXPECT_EQ(watched.touches.count, fresh.touches.count);
    if (watched.touches.num_new == 0 && found.size() == before.size()) {
      EXPECT_EQ(found, before) << "step " << step;
      ++repeated;
    }
    before = found;
    kept += watched.touches.num_kept_pairs;
    all += watched.candidates.num_pairs;
  }
  EXPECT_GT(before.size(), 200U);
  EXPECT_GT(repeated, 10);
  EXPECT_GT(kept, all / 2);
  EXPECT_EQ(fresh.touches.num_kept_pairs, 0);
}

}  // namespace
}  // namespace percuss::test::still_items_test
