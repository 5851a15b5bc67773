#include "kernels/contact/surface/lane_mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace percuss::test::lane_mask_test {
namespace {

// Few different coordinates, so that many boxes end where another begins.
class RandomBlock {
 public:
  explicit RandomBlock(unsigned seed) : random_(seed) {}

  FloatBox make_box() {
    FloatBox box{};
    for (int axis = 0; axis < 3; ++axis) {
      const int low = place_(random_);
      box.low[axis] = static_cast<float>(low);
      box.high[axis] = static_cast<float>(low + place_(random_) / 3);
    }
    return box;
  }

  int make_number() { return place_(random_); }

 private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> place_{0, 9};
};

TEST(LaneMask, BoxesMeetWhereTheirIntervalsHaveAPointInCommonOnEveryAxis) {
  RandomBlock random(1);
  int met = 0, touched = 0;
  for (int trial = 0; trial < 200; ++trial) {
    BoxBlock block{};
    FloatBox boxes[block_size];
    for (int lane = 0; lane < block_size; ++lane) {
      boxes[lane] = random.make_box();
      for (int axis = 0; axis < 3; ++axis) {
        block.low[axis][lane] = boxes[lane].low[axis];
        block.high[axis][lane] = boxes[lane].high[axis];
      }
    }
    const FloatBox query = random.make_box();
    const std::uint32_t mask = find_meeting_lanes(block, query);
    ASSERT_EQ(mask >> block_size, 0u);
    for (int lane = 0; lane < block_size; ++lane) {
      bool meets = true, touches = false;
      for (int axis = 0; axis < 3; ++axis) {
        const float low = std::max(boxes[lane].low[axis], query.low[axis]);
        const float high = std::min(boxes[lane].high[axis], query.high[axis]);
        meets = meets && low <= high;
        touches = touches || low == high;
      }
      ASSERT_EQ((mask >> lane & 1u) != 0, meets) << trial << ", lane " << lane;
      met += meets ? 1 : 0;
      touched += meets && touches ? 1 : 0;
    }
  }
  EXPECT_GT(met, 50);
  EXPECT_GT(touched, 20);
}

TEST(LaneMask, PointsLieInsideWithAndWithoutTheFacesOfTheBox) {
  RandomBlock random(3);
  int inside = 0, on_faces = 0;
  for (int trial = 0; trial < 200; ++trial) {
    PointLanes points{};
    for (int lane = 0; lane < block_size; ++lane)
      for (auto& x : points.x) x[lane] = static_cast<float>(random.make_number());
    FloatBox box = random.make_box();
    for (float& high : box.high) high += 3;
    const std::uint32_t with = find_lanes_inside(points, box), without = find_lanes_inside<false>(points, box);
    ASSERT_EQ((with | without) >> block_size, 0u);
    for (int lane = 0; lane < block_size; ++lane) {
      bool in = true, strictly = true;
      for (int axis = 0; axis < 3; ++axis) {
        const float x = points.x[axis][lane];
        in = in && x >= box.low[axis] && x <= box.high[axis];
        strictly = strictly && x > box.low[axis] && x < box.high[axis];
      }
      ASSERT_EQ((with >> lane & 1u) != 0, in) << trial << ", lane " << lane;
      ASSERT_EQ((without >> lane & 1u) != 0, strictly) << trial << ", lane " << lane;
      inside += strictly ? 1 : 0;
      on_faces += in && !strictly ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(on_faces, 20);
}

TEST(LaneMask, NothingThatIsNotANumberLiesInABox) {
  PointLanes points{};
  points.x[1][5] = std::numeric_limits<float>::quiet_NaN();
  const FloatBox box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_EQ(find_lanes_inside(points, box), 0xffdfu);
  EXPECT_EQ(find_lanes_inside<false>(points, box), 0xffdfu);
}

TEST(LaneMask, NumbersBelowAValueAreFoundAndCounted) {
  RandomBlock random(4);
  LaneNumbers counts{};
  int expected[block_size] = {};
  for (int trial = 0; trial < 50; ++trial) {
    LaneNumbers numbers{};
    for (int& number : numbers.lane) number = random.make_number() - 4;  // below 0 too
    const int value = random.make_number() - 4;
    const std::uint32_t mask = find_lanes_below(numbers, value);
    int below = 0;
    for (int lane = 0; lane < block_size; ++lane) {
      ASSERT_EQ((mask >> lane & 1u) != 0, numbers.lane[lane] < value) << trial << ", lane " << lane;
      below += numbers.lane[lane] < value ? 1 : 0;
      expected[lane] += numbers.lane[lane] < value ? 1 : 0;
    }
    EXPECT_EQ(count_bits(mask), below);
    count_lanes(mask, counts);
  }
  for (int lane = 0; lane < block_size; ++lane) EXPECT_EQ(counts.lane[lane], expected[lane]) << "lane " << lane;
}

TEST(LaneMask, NumbersAreFoundThatAreOneOfFourValues) {
  RandomBlock random(2);
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    LaneNumbers numbers{};
    for (int& number : numbers.lane) number = random.make_number();
    int values[4];
    for (int& value : values) value = random.make_number() - 1;
    const std::uint32_t mask = find_equal_lanes(numbers, values);
    ASSERT_EQ(mask >> block_size, 0u);
    for (int lane = 0; lane < block_size; ++lane) {
      const bool equal = std::find(values, values + 4, numbers.lane[lane]) != values + 4;
      ASSERT_EQ((mask >> lane & 1u) != 0, equal) << trial << ", lane " << lane;
      found += equal ? 1 : 0;
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace percuss::test::lane_mask_test
