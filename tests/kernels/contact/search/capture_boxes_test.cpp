// How far nodes have gone, by which candidate pairs are used again.

#include "kernels/contact/search/capture_boxes.hpp"

#include <gtest/gtest.h>

#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::capture_boxes_test {
namespace {

struct CaptureBoxes : testing::Test {
  const Array<int> nodes = to_array(std::vector<int>{2, 0});
  const Rows3<double> x = to_rows({{1, 0, 0}, {50, 0, 0}, {0, -4, 3}}),
                      v = to_rows({{0, 2, 0}, {9, 9, 9}, {0, 0.125, -1}}), origin = to_rows({{0, 0, 0}, {1, 0, 0}});
};

// (No velocity repeats a number twice after {9, 9, 9}: GCC 12 tuned for Intel's AVX-512 then stores 9 for 0.)
// The first listed node is (0, -4, 3) away and comes nearer; the second starts in its place and goes by (0, 2 dt, 0).

TEST_F(CaptureBoxes, TheLargestMoveIsAComponentOfTheStep) {
  EXPECT_EQ(find_largest_move(SmallSpace(), nodes, {x, v, 0.5}), 1);
}

TEST_F(CaptureBoxes, TheLargestTravelIsAComponentAtEitherEndOfTheStep) {
  EXPECT_EQ(find_largest_travel(SmallSpace(), nodes, {x, v, 0.5}, origin), 4);
  EXPECT_EQ(find_largest_travel(SmallSpace(), nodes, {x, v, 3}, origin), 6);
}

TEST_F(CaptureBoxes, TheLargestDistanceIsThatOfEitherEndOfTheStep) {
  EXPECT_EQ(find_largest_distance(SmallSpace(), nodes, {x, v, 0.5}, origin), 5);
  EXPECT_EQ(find_largest_distance(SmallSpace(), nodes, {x, v, 3}, origin), 6);
}

}  // namespace
}  // namespace percuss::test::capture_boxes_test
