#include "kernels/core/index_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "kernels/contact/rows/row_sums.hpp"
#include "tests/kernels/contact/brick_scene.hpp"

namespace percuss::test::index_lists_test {
namespace {

TEST(IndexLists, GroupsAreSortedWithinEachKeyShortAndLong) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> pick(0, 9);
  std::vector<int> key, value;
  for (int i = 0; i < 3000; ++i) {
    key.push_back(i % 2 == 0 ? 4 : pick(random));  // one key with more than half of all
    value.push_back((i * 1237) % 3000);
  }
  constexpr int keys = 8;  // those above are left out
  Array<int> count("test::count", keys), offset("test::offset", keys + 1), grouped("test::grouped", 3000);
  group_by_key(ExecSpace(), {3000, to_array(key), to_array(value), keys}, {count, offset, grouped});
  for (int k = 0; k < keys; ++k) {
    std::vector<int> expected;
    for (std::size_t i = 0; i < key.size(); ++i)
      if (key[i] == k) expected.push_back(value[i]);
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(offset(k + 1) - offset(k), static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(grouped(static_cast<std::size_t>(offset(k)) + i), expected[i]);
  }
}

TEST(IndexLists, ListsTheWantedInAscendingOrder) {
  Array<int> list("test::list", 1000);
  const int found = list_where(
      ExecSpace(), 1000, [] KOKKOS_FUNCTION(int i) { return i % 7 == 3; }, list);
  ASSERT_EQ(found, 143);
  for (int i = 0; i < found; ++i) ASSERT_EQ(list(i), 7 * i + 3);
}

struct OneSum {
  ExactSum total;
  double largest = 0;
  KOKKOS_INLINE_FUNCTION void merge(const OneSum& other) {
    total.merge(other.total);
    largest = other.largest > largest ? other.largest : largest;
  }
};

TEST(RowSums, AreExactInBothSpaces) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> values;
  for (int i = 0; i < 10006; i += 2) {  // each value, and at the end the same with the other sign and a remainder
    values.push_back(value(random) * std::pow(10.0, i % 17));
    values.push_back(0.25);
  }
  for (int i = 10005; i >= 0; i -= 2) values.push_back(-values[static_cast<std::size_t>(i) - 1]);
  const Array<double> view = to_array(values);
  const auto body = [view] KOKKOS_FUNCTION(int i, OneSum& s) {
    s.total.add(view(i));
    s.largest = view(i) > s.largest ? view(i) : s.largest;
  };
  Array<OneSum> memory("test::sums", 0);
  const int n = static_cast<int>(values.size());
  const OneSum small = sum_rows<OneSum>(SmallSpace(), n, memory, body);
  const OneSum threads = sum_rows<OneSum>(ExecSpace(), n, memory, body);
  EXPECT_EQ(small.total.round(), 5003 * 0.25);
  EXPECT_EQ(threads.total.round(), 5003 * 0.25);
  EXPECT_EQ(small.largest, *std::max_element(values.begin(), values.end()));
  EXPECT_EQ(threads.largest, small.largest);
}

}  // namespace
}  // namespace percuss::test::index_lists_test
