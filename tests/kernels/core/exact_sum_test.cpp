// Sums of doubles that are rounded once, against integer arithmetic and exact cases.

#include "kernels/core/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <random>
#include <vector>

namespace percuss::test::exact_sum_test {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest_normal = std::numeric_limits<double>::min();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
const double two_53 = std::ldexp(1.0, 53);  // from here on doubles are even numbers

template <class Values>
ExactSum add_all(const Values& values) {
  ExactSum sum;
  for (const double value : values) sum.add(value);
  return sum;
}

double sum_up(std::initializer_list<double> values) { return add_all(values).round(); }

__extension__ using Integer = __int128;

/// Random integers of very different size; their doubles have 53 bits at most.
std::vector<std::int64_t> draw_integers(std::mt19937_64& random, int count) {
  std::vector<std::int64_t> integers;
  for (int i = 0; i < count; ++i) {
    const auto bits = static_cast<std::int64_t>(random() >> 11 >> (random() % 53));
    integers.push_back(random() % 2 == 0 ? bits : -bits);
  }
  return integers;
}

}  // namespace

TEST(ExactSum, OfOneNumberIsThatNumber) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value)) {
      ASSERT_EQ(sum_up({value}), value);
    }
  }
  for (const double value : {0.0, smallest, -smallest, smallest_normal, largest, -largest, 1.0, -1.0}) {
    EXPECT_EQ(sum_up({value}), value);
  }
}

TEST(ExactSum, IsTheNearestDoubleToTheSumOfIntegers) {
  std::mt19937_64 random(2);
  for (const int count : {2, 3, 10, 1000}) {
    for (int round = 0; round < 300; ++round) {
      for (const int scale : {-1074, -1060, -500, -31, 0, 500, 900}) {
        const std::vector<std::int64_t> integers = draw_integers(random, count);
        Integer expected = 0;
        ExactSum sum;
        for (const std::int64_t i : integers) {
          expected += i;
          sum.add(std::ldexp(static_cast<double>(i), scale));
        }
        // The conversion rounds to the nearest, ties to even; the scaling is exact, for no sum is a fraction of a unit.
        ASSERT_EQ(sum.round(), std::ldexp(static_cast<double>(expected), scale)) << count << " at " << scale;
      }
    }
  }
}

TEST(ExactSum, DoesNotDependOnTheOrder) {
  std::mt19937_64 random(3);
  std::vector<double> values;
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 2000; ++i) values.push_back((random() % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(random)));
  for (int i = 0; i < 1000; ++i) values.push_back(-values[static_cast<std::size_t>(i)]);
  const double first = add_all(values).round();
  for (int i = 0; i < 20; ++i) {
    std::shuffle(values.begin(), values.end(), random);
    EXPECT_EQ(add_all(values).round(), first);
  }
}

TEST(ExactSum, KeepsWhatIsLeftOfACancellation) {
  EXPECT_EQ(sum_up({1e308, 1, -1e308}), 1);
  EXPECT_EQ(sum_up({largest, smallest, -largest}), smallest);
  EXPECT_EQ(sum_up({1, -1}), 0);
  EXPECT_FALSE(std::signbit(sum_up({1, -1})));
  EXPECT_EQ(sum_up({}), 0);
  EXPECT_EQ(sum_up({0.1, 0.2, -0.3}), std::ldexp(1.0, -55));  // what these three doubles differ by from 1/10, ...
}

TEST(ExactSum, RoundsTiesToEven) {
  EXPECT_EQ(sum_up({two_53, 1}), two_53);
  EXPECT_EQ(sum_up({two_53, 2, 1}), two_53 + 4);
  EXPECT_EQ(sum_up({two_53, 1, smallest}), two_53 + 2);
  EXPECT_EQ(sum_up({two_53, 1, -smallest}), two_53);
  EXPECT_EQ(sum_up({two_53, 2, 1, -smallest}), two_53 + 2);
  EXPECT_EQ(sum_up({-two_53, -1}), -two_53);
  EXPECT_EQ(sum_up({-two_53, -1, -smallest}), -two_53 - 2);
  EXPECT_EQ(sum_up({-two_53, -2, -1}), -two_53 - 4);
}

TEST(ExactSum, IsRightAtTheEndsOfTheRange) {
  EXPECT_EQ(sum_up({smallest, smallest, smallest}), 3 * smallest);
  EXPECT_EQ(sum_up({smallest_normal, -smallest}), smallest_normal - smallest);
  EXPECT_EQ(sum_up({-smallest, smallest_normal}), smallest_normal - smallest);
  EXPECT_EQ(sum_up({largest, largest, -largest}), largest);
  EXPECT_EQ(sum_up({largest, largest}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(sum_up({-largest, -largest}), -std::numeric_limits<double>::infinity());
}

TEST(ExactSum, OfSomethingThatIsNotFiniteIsNotANumber) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(sum_up({1, std::nan(""), 2})));
  EXPECT_TRUE(std::isnan(sum_up({infinity})));
  EXPECT_TRUE(std::isnan(sum_up({infinity, -infinity})));
}

TEST(ExactSum, MergesSharesWhateverTheyAre) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (int i = 0; i < 5000; ++i) values.push_back(normal(random) * std::pow(10.0, static_cast<double>(i % 40) - 20));
  const double expected = add_all(values).round();
  for (const std::size_t shares : {1, 2, 7, 64}) {
    ExactSum total;
    for (std::size_t s = 0; s < shares; ++s) {
      ExactSum share;
      for (std::size_t i = s; i < values.size(); i += shares) share.add(values[i]);
      if (s % 2 == 0) share.normalize();
      total.merge(share);
    }
    EXPECT_EQ(total.round(), expected);
  }
}

TEST(ExactSum, HoldsABillionMergesOfTheLargestNumbers) {
  for (const double value : {largest, -largest, smallest, 1.0 / 3}) {
    ExactSum sum;
    sum.add(value);
    sum.normalize();
    for (int doubling = 0; doubling < 30; ++doubling) sum.merge(ExactSum(sum));
    EXPECT_EQ(sum.round(), std::ldexp(value, 30));
  }
}

TEST(ExactSums, HaveTheBitsOfOneSumForAnyBlocks) {
  const auto first = [](int i) { return 1.0 / (1 + i); };
  const auto second = [](int i) { return i % 2 == 0 ? 0.1 : -0.3e10; };
  for (const int count : {0, 1, 255, 256, 257, 50001}) {
    ExactSum expected[2];
    for (int i = 0; i < count; ++i) {
      expected[0].add(first(i));
      expected[1].add(second(i));
    }
    for (const int shortest : {1, 256, 100000}) {
      ExactSums<2> sums("test_sums", shortest);
      for (int repeat = 0; repeat < 2; ++repeat) {
        const auto totals = sums(
            ExecSpace(), count, KOKKOS_LAMBDA(const int i, const ExactAdder& add) {
              add(0, 1.0 / (1 + i));
              add(1, i % 2 == 0 ? 0.1 : -0.3e10);
            });
        EXPECT_EQ(totals[0].round(), expected[0].round()) << count << " by " << shortest;
        EXPECT_EQ(totals[1].round(), expected[1].round()) << count << " by " << shortest;
      }
    }
  }
}

}  // namespace percuss::test::exact_sum_test
