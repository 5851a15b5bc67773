#include "kernels/core/ordered_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace percuss::test {

namespace {

/// What the fixed order says, written out: blocks of 1024 in ascending order, each summed in ascending order.
template <class Value>
double sum_by_blocks(int count, const Value& value) {
  double total = 0;
  for (int first = 0; first < count; first += 1024) {
    double block = 0;
    for (int i = first; i < std::min(first + 1024, count); ++i) block += value(i);
    total += block;
  }
  return total;
}

}  // namespace

TEST(OrderedSum, HasTheBitsOfItsWrittenOutOrder) {
  for (const int count : {0, 1, 1023, 1024, 1025, 50001}) {
    const auto sums = OrderedSum<2>("test_sum", count)(
        ExecSpace(), KOKKOS_LAMBDA(const int i, Kokkos::Array<double, 2>& sum) {
          sum[0] += 1.0 / (1 + i);
          sum[1] += i % 2 == 0 ? 0.1 : -0.3;
        });
    EXPECT_EQ(sums[0], sum_by_blocks(count, [](int i) { return 1.0 / (1 + i); })) << count;
    EXPECT_EQ(sums[1], sum_by_blocks(count, [](int i) { return i % 2 == 0 ? 0.1 : -0.3; })) << count;
  }
}

}  // namespace percuss::test
