#include "kernels/core/number_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace percuss::test::number_rows_test {

namespace {
constexpr int width = pack_size<double>;

double number(int lane, int k) { return 100 * lane + k + 1; }
}  // namespace

TEST(NumberRows, AreSummedWhereverTheyLie) {
  double rows[3][9];  // of which none is aligned to eight
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 9; ++k) rows[i][k] = number(i, k);
  alignas(64) double scale[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  RowSum<8> sum;
  sum.add(rows[0]);
  sum.subtract(rows[1] + 1);
  sum.add_scaled(scale, rows[2]);
  sum.scale(2);
  double result[8];
  sum.store(result);
  for (int k = 0; k < 8; ++k) EXPECT_EQ(result[k], 2 * (number(0, k) - number(1, k + 1) + (k + 1) * number(2, k))) << k;
  RowSum<4> few;
  few.add(rows[1]);
  few.add(rows[1] + 4);
  few.store(result);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(result[k], number(1, k) + number(1, k + 4));
  EXPECT_EQ(result[4], 2 * (number(0, 4) - number(1, 5) + 5 * number(2, 4)));
}

TEST(NumberRows, BeginWithPlainZero) {
  const double minus[8] = {-0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0};
  RowSum<8> sum;
  sum.add(minus);
  double result[8];
  sum.store(result);
  for (const double value : result) EXPECT_FALSE(std::signbit(value));
}

TEST(NumberRows, OfEightBecomePacksAndPacksRows) {
  RowSum<8> rows[width];
  for (int lane = 0; lane < width; ++lane) {
    double row[8];
    for (int k = 0; k < 8; ++k) row[k] = number(lane, k);
    rows[lane].add(row);
  }
  Pack<double> packs[8];
  turn_to_packs(rows, packs);
  for (int k = 0; k < 8; ++k) {
    alignas(64) double column[width];
    store_pack(column, packs[k]);
    for (int lane = 0; lane < width; ++lane) EXPECT_EQ(column[lane], number(lane, k));
  }
  constexpr int stride = 16;
  alignas(64) double back[width * stride] = {};
  turn_to_rows(packs, back, stride);
  for (int lane = 0; lane < width; ++lane)
    for (int k = 0; k < stride; ++k) EXPECT_EQ(back[stride * lane + k], k < 8 ? number(lane, k) : 0);
}

TEST(NumberRows, OfThreeNumbersEndWithZero) {
  Pack<double> packs[3];
  for (int k = 0; k < 3; ++k) {
    alignas(64) double column[width];
    for (int lane = 0; lane < width; ++lane) column[lane] = number(lane, k);
    packs[k] = load_pack(column);
  }
  constexpr int stride = 12;
  alignas(64) double rows[width * stride];
  for (double& value : rows) value = -1;
  turn_to_rows(packs, rows, stride);
  for (int lane = 0; lane < width; ++lane)
    for (int k = 0; k < stride; ++k) EXPECT_EQ(rows[stride * lane + k], k < 3 ? number(lane, k) : k == 3 ? 0 : -1);
  RowSum<4> sum;
  sum.add(rows);
  sum.store_three(rows + 8);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(rows[8 + k], k < 3 ? number(0, k) : -1);
}

}  // namespace percuss::test::number_rows_test
