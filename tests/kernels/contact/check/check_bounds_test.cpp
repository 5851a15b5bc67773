// Bounds that spare the check of a pair its costly parts: they must rule out nothing that these would find.

#include <gtest/gtest.h>

#include <random>

#include "kernels/contact/check/pair_check.hpp"

namespace percuss::test::check_bounds_test {
namespace {

constexpr int num_draws = 20000;

/// A crooked face of size 1 near the node and its motion relative to the node, and what the check asks of them.
struct DrawnPair {
  FacePoints start, move, end;
  FacePoint closest_start, closest_end;

  explicit DrawnPair(std::mt19937& random) {
    const auto draw = [&](double largest) {
      return largest * (2 * (static_cast<double>(random()) / 4294967295.0) - 1);
    };
    const auto draw_point = [&](double largest) { return Point3{draw(largest), draw(largest), draw(largest)}; };
    const double pace = draw(1);  // of some pairs slow, of others a good part of the face in the step
    const Point3 place{draw(1), draw(1), draw(0.2)}, way = pace * pace * draw_point(0.2);
    for (int i = 0; i < 4; ++i) {
      const Point3 square{i == 1 || i == 2 ? 0.5 : -0.5, i >= 2 ? 0.5 : -0.5, 0};
      start.corner[i] = square + place + draw_point(0.1);
      move.corner[i] = way + pace * pace * draw_point(0.02);
      end.corner[i] = start.corner[i] + move.corner[i];
    }
    closest_start = find_closest_point(start);
    closest_end = find_closest_point(end);
  }
};

TEST(CheckBounds, ANodeThatGoesThroughAFaceMayMeetIt) {
  constexpr double band = 1e-3;
  std::mt19937 random(1);
  int hits = 0, ruled_out = 0;
  for (int draw = 0; draw < num_draws; ++draw) {
    const DrawnPair pair(random);
    const bool is_hit = sweep_face(pair.start, pair.move, band).hit;
    const bool may = may_meet(pair.start, pair.end, band);
    EXPECT_TRUE(may || !is_hit);
    hits += is_hit ? 1 : 0;
    ruled_out += may ? 0 : 1;
  }
  EXPECT_GT(hits, num_draws / 200);
  EXPECT_GT(ruled_out, num_draws / 50);
}

TEST(CheckBounds, ANodeThatIsSurelyNotHeldIsNearTheFaceAtTheEnd) {
  Touch touch;
  start_touch(0, 1, 0, touch);
  std::mt19937 random(2);
  int sure = 0, far = 0;
  for (int draw = 0; draw < num_draws; ++draw) {
    const DrawnPair pair(random);
    const bool is_sure = is_surely_not_held(pair.move, pair.closest_end.distance, touch);
    // The gap at the end is at most the distance there of the closest point of the start over the least cosine.
    const double distance = norm(interpolate(pair.end, pair.closest_start.weight));
    const bool is_far = distance / least_push_cosine >= find_reach(touch);
    EXPECT_FALSE(is_sure && is_far);
    sure += is_sure ? 1 : 0;
    far += is_far ? 1 : 0;
  }
  EXPECT_GT(sure, num_draws / 200);
  EXPECT_GT(far, num_draws / 50);
}

TEST(CheckBounds, ANodeThatIsSurelyShallowIsNoDeeperThanAHistoryMayBe) {
  std::mt19937 random(3);
  int sure = 0, deep = 0;
  for (int draw = 0; draw < num_draws; ++draw) {
    const DrawnPair pair(random);
    Touch touch;
    start_touch(0, 1, 0, touch);
    touch.record = 0;
    for (int i = 0; i < 4; ++i) touch.weight[i] = pair.closest_end.weight[i];
    const bool is_sure = is_surely_shallow(pair.start, touch);
    const bool is_deep = pair.closest_start.distance / least_push_cosine > find_deepest_start(touch);
    EXPECT_FALSE(is_sure && is_deep);
    sure += is_sure ? 1 : 0;
    deep += is_deep ? 1 : 0;
    touch.record = -1;  // a new contact is judged by its gap at n in other ways too
    EXPECT_FALSE(is_surely_shallow(pair.start, touch));
  }
  EXPECT_GT(sure, num_draws / 50);
  EXPECT_GT(deep, num_draws / 50);
}

}  // namespace
}  // namespace percuss::test::check_bounds_test
