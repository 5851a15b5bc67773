#include "kernels/core/short_transpose.hpp"

#include <gtest/gtest.h>

namespace percuss::test::transpose_test {

namespace {
constexpr int width = pack_size<double>;

template <class Scalar>
class TransposeOf : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(TransposeOf, Scalars);
}  // namespace

TYPED_TEST(TransposeOf, RecordsBecomePacks) {
  constexpr int lanes = pack_size<TypeParam>;
  alignas(64) TypeParam memory[2 * lanes][4] = {};
  const TypeParam* records[lanes];
  for (int lane = 0; lane < lanes; ++lane) {
    records[lane] = memory[2 * ((lane * 3) % lanes)];  // records lie anywhere, even twice
    for (int k = 0; k < 4; ++k) memory[2 * lane][k] = static_cast<TypeParam>(100 * lane + k);
  }
  Pack<TypeParam> packs[3];
  transpose_to_packs(records, packs);
  for (int k = 0; k < 3; ++k) {
    alignas(64) TypeParam row[lanes];
    store_pack(row, packs[k]);
    for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(row[lane], records[lane][k]);
  }
}

TEST(Transpose, PacksBecomeRecordsAgain) {
  Pack<double> packs[3];
  alignas(64) double records[width][4];
  for (int k = 0; k < 3; ++k) {
    alignas(64) double row[width];
    for (int lane = 0; lane < width; ++lane) row[lane] = 100 * lane + k + 1;
    packs[k] = load_pack(row);
  }
  transpose_to_records(packs, records);
  for (int lane = 0; lane < width; ++lane) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(records[lane][k], 100 * lane + k + 1);
    EXPECT_EQ(records[lane][3], 0);
  }
}

TEST(Transpose, RowsOfThreeBecomePacks) {
  double rows[3 * 2 * width];  // the last one ends with the memory
  for (int i = 0; i < 3 * 2 * width; ++i) rows[i] = i + 1;
  int index[width];
  for (int lane = 0; lane < width; ++lane) index[lane] = (5 * lane + 2 * width - 1) % (2 * width);
  Pack<double> packs[3];
  load_rows_of_three(rows, index, packs);
  for (int k = 0; k < 3; ++k) {
    alignas(64) double row[width];
    store_pack(row, packs[k]);
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(row[lane], 3 * index[lane] + k + 1);
  }
}

TEST(Transpose, SubtractRecordTouchesFourNumbersOnly) {
  alignas(64) double from[8] = {1, 2, 3, 4, 5, 6, 7, 8}, to[8] = {10, 10, 10, 10, 10, 10, 10, 10};
  subtract_record(from, to);
  const double expected[8] = {9, 8, 7, 6, 10, 10, 10, 10};
  for (int k = 0; k < 8; ++k) EXPECT_EQ(to[k], expected[k]);
}

}  // namespace percuss::test::transpose_test
