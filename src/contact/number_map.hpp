#pragma once
// From global numbers to their places in a list.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace percuss {

/// For many questions in a row. Open addressing at half load: a question costs one look, seldom more, where a bisection
/// of the list costs a dozen.
class NumberMap {
 public:
  /// numbers: different, none negative.
  explicit NumberMap(const std::vector<std::int64_t>& numbers) {
    std::size_t size = 16;
    while (size < 2 * numbers.size()) size *= 2;
    mask_ = size - 1;
    entries_.assign(size, {-1, -1});
    for (std::size_t i = 0; i < numbers.size(); ++i)
      entries_[find_entry(numbers[i])] = {numbers[i], static_cast<int>(i)};
  }

  /// Place of a number, -1 if it is not in the list.
  int find(std::int64_t number) const { return entries_[find_entry(number)].place; }

 private:
  struct Entry {
    std::int64_t number;
    int place;
  };

  std::size_t find_entry(std::int64_t number) const {
    std::size_t i = static_cast<std::size_t>(static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15ull >> 20) & mask_;
    while (entries_[i].place >= 0 && entries_[i].number != number) i = (i + 1) & mask_;
    return i;
  }

  std::vector<Entry> entries_;
  std::size_t mask_ = 0;
};

/// Place of a number in an ascending list, -1 if it is not there.
inline int find_number(const std::vector<std::int64_t>& numbers, std::int64_t number) {
  const auto place = std::lower_bound(numbers.begin(), numbers.end(), number);
  return place != numbers.end() && *place == number ? static_cast<int>(place - numbers.begin()) : -1;
}

}  // namespace percuss
