#include "kernels/core/counting_sort.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace percuss::test::counting_sort_test {
namespace {

TEST(CountingSort, KeepsTheOrderOfItemsWithOneKey) {
  const Buckets buckets = sort_into_buckets({2, 0, 2, 3, 0, 2}, 5);
  EXPECT_EQ(buckets.first, (std::vector<int>{0, 2, 2, 5, 6, 6}));
  EXPECT_EQ(buckets.items, (std::vector<int>{1, 4, 0, 2, 5, 3}));
}

TEST(CountingSort, WithoutItemsEveryBucketIsEmpty) {
  const Buckets buckets = sort_into_buckets({}, 3);
  EXPECT_EQ(buckets.first, (std::vector<int>{0, 0, 0, 0}));
  EXPECT_TRUE(buckets.items.empty());
  EXPECT_EQ(sort_into_buckets({}, 0).first, std::vector<int>{0});
}

TEST(CountingSort, PutsItemsOfAnyKindUnderSeveralKeys) {
  using Link = std::pair<int, int>;
  const auto by_end = collect_buckets<Link, std::int64_t>(3, [](auto&& put) {
    for (const Link& link : {Link{0, 2}, Link{1, 2}, Link{0, 1}}) {
      put(static_cast<std::size_t>(link.first), link);
      put(static_cast<std::size_t>(link.second), link);
    }
  });
  EXPECT_EQ(by_end.first, (std::vector<std::int64_t>{0, 2, 4, 6}));
  EXPECT_EQ(by_end.items, (std::vector<Link>{{0, 2}, {0, 1}, {1, 2}, {0, 1}, {0, 2}, {1, 2}}));
}

}  // namespace
}  // namespace percuss::test::counting_sort_test
