#pragma once
// Items by a small key, on the host: a stable counting sort.

#include <cstddef>
#include <numeric>
#include <vector>

namespace percuss {

/// Items by key (compressed rows), those of one key in the order in which they came.
template <class Item, class Place>
struct BucketsOf {
  std::vector<Place> first;  // [keys + 1] into items
  std::vector<Item> items;
};
using Buckets = BucketsOf<int, int>;

/// visit(put): calls put(key, item) for each item, and the same again when called once more. Keys in [0, key_count).
/// Place: counts the items.
template <class Item, class Place = int, class Visit>
BucketsOf<Item, Place> collect_buckets(std::size_t key_count, const Visit& visit) {
  BucketsOf<Item, Place> buckets;
  buckets.first.assign(key_count + 1, 0);
  visit([&](std::size_t key, const Item&) { ++buckets.first[key + 1]; });
  std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
  buckets.items.resize(static_cast<std::size_t>(buckets.first.back()));
  std::vector<Place> next(buckets.first.begin(), buckets.first.end() - 1);
  visit([&](std::size_t key, const Item& item) { buckets.items[static_cast<std::size_t>(next[key]++)] = item; });
  return buckets;
}

/// Indexes in a list by the key of each. keys: [items] in [0, key_count).
inline Buckets sort_into_buckets(const std::vector<int>& keys, std::size_t key_count) {
  return collect_buckets<int>(key_count, [&](auto&& put) {
    for (std::size_t i = 0; i < keys.size(); ++i) put(static_cast<std::size_t>(keys[i]), static_cast<int>(i));
  });
}

}  // namespace percuss
