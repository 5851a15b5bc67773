#pragma once
// Items by a small key.

#include <cstddef>
#include <numeric>
#include <vector>

namespace percuss {

struct Buckets {
  std::vector<int> first;  // [keys + 1] into items
  std::vector<int> items;  // by key, those of one key ascending
};

/// A counting sort. keys: [items] in [0, key_count).
inline Buckets sort_into_buckets(const std::vector<int>& keys, std::size_t key_count) {
  Buckets buckets{std::vector<int>(key_count + 1, 0), std::vector<int>(keys.size())};
  for (const int key : keys) ++buckets.first[static_cast<std::size_t>(key) + 1];
  std::partial_sum(buckets.first.begin(), buckets.first.end(), buckets.first.begin());
  std::vector<int> next(buckets.first.begin(), buckets.first.end() - 1);
  for (std::size_t i = 0; i < keys.size(); ++i)
    buckets.items[static_cast<std::size_t>(next[static_cast<std::size_t>(keys[i])]++)] = static_cast<int>(i);
  return buckets;
}

}  // namespace percuss
