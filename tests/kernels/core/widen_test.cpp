#include "kernels/core/widen.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/long_sum.hpp"
#include "kernels/material/polar.hpp"

namespace percuss::test::widen_test {

TEST(Widen, PartsHaveTheLanesInTheirOrder) {
  constexpr int width = pack_size<float>;
  alignas(64) float row[width];
  for (int i = 0; i < width; ++i) row[i] = 0.1F + static_cast<float>(i);
  const Pack<float> pack = load_pack(row);
  int next = 0;
  visit_parts<Pack<float>>([&](auto part) {
    alignas(64) double wide[pack_size<double>];
    store_pack(wide, widen<part>(pack));
    for (const double value : wide) EXPECT_EQ(value, double{row[next++]});
  });
  EXPECT_EQ(next, width);
}

TEST(Widen, NarrowIsTheWayBackRoundedToNearest) {
  using Long = Wide<Pack<float>>;
  constexpr int parts = wide_count<Pack<float>>, width = pack_size<double>;
  Long wide[parts];
  for (int part = 0; part < parts; ++part) {
    alignas(64) double row[width];
    for (int i = 0; i < width; ++i) row[i] = 1 / (3.0 + part * width + i);
    wide[part] = load_pack(row);
  }
  Pack<float> pack;
  narrow(wide, pack);
  alignas(64) float row[parts * width];
  store_pack(row, pack);
  for (int i = 0; i < parts * width; ++i) EXPECT_EQ(row[i], static_cast<float>(1 / (3.0 + i)));
}

TEST(Widen, DoublesStayWhatTheyAre) {
  alignas(64) double row[pack_size<double>];
  store_pack(row, widen<0>(Pack<double>(1.0 / 3)));
  for (const double value : row) EXPECT_EQ(value, 1.0 / 3);
  EXPECT_EQ(widen<0>(1.0F / 3), static_cast<double>(1.0F / 3));
}

TEST(LongSum, KeepsWhatAFloatWouldLose) {
  float value = 1, rest = 0, alone = 1;
  for (int i = 0; i < 1000000; ++i) {
    add_to(value, rest, 1e-9F);
    alone += 1e-9F;
  }
  EXPECT_EQ(alone, 1);
  // 1.001 to the last place of the rest, which is 2^-24 of that of the value; the addends are 1e-9 to 1e-7 of it
  EXPECT_NEAR(double{value} + double{rest}, 1 + 1e6 * double{1e-9F}, 1e-10);
  EXPECT_LE(std::abs(rest), 6.1e-8);
}

TEST(LongSum, DoublesHaveNoRest) {
  EXPECT_EQ(sizeof(Polar<double>), 15 * sizeof(double));
  EXPECT_EQ(sizeof(Polar<float>), (15 + 9) * sizeof(float));
}

}  // namespace percuss::test::widen_test
