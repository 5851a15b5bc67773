#include "kernels/core/transpose.hpp"

#include <gtest/gtest.h>

namespace percuss::test {

namespace {
constexpr int width = pack_size<double>;
}

TEST(Transpose, RecordsBecomePacksLaneByLane) {
  alignas(64) double memory[2 * width][8];
  const double* records[width];
  for (int lane = 0; lane < width; ++lane) {
    records[lane] = memory[2 * ((lane * 3) % width)];  // records lie anywhere, even twice
    for (int k = 0; k < 8; ++k) memory[2 * lane][k] = 100 * lane + k;
  }
  alignas(64) double packs[8][width];
  transpose_to_packs(records, packs);
  for (int k = 0; k < 8; ++k) {
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(packs[k][lane], records[lane][k]);
  }
}

TEST(Transpose, PacksBecomeRecordsAgain) {
  alignas(64) double packs[8][width], records[width][8];
  for (int k = 0; k < 8; ++k) {
    for (int lane = 0; lane < width; ++lane) packs[k][lane] = 100 * lane + k;
  }
  transpose_to_records(packs, records);
  for (int k = 0; k < 8; ++k) {
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(records[lane][k], 100 * lane + k);
  }
}

TEST(Transpose, SubtractRecordTouchesFourNumbersOnly) {
  alignas(64) double from[8] = {1, 2, 3, 4, 5, 6, 7, 8}, to[8] = {10, 10, 10, 10, 10, 10, 10, 10};
  subtract_record(from, to);
  const double expected[8] = {9, 8, 7, 6, 10, 10, 10, 10};
  for (int k = 0; k < 8; ++k) EXPECT_EQ(to[k], expected[k]);
}

}  // namespace percuss::test
