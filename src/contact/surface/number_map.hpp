#pragma once
// From global numbers to their positions in a list.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace percuss {

/// Finds places by numbers, for many queries in a row. Open addressing at half load: a query costs one access, seldom
/// more, where a bisection of the list costs a dozen.
class NumberMap {
 public:
  NumberMap() = default;

  /// numbers: different, none negative.
  explicit NumberMap(const std::vector<std::int64_t>& numbers) {
    reserve(numbers.size());
    for (const std::int64_t number : numbers) add(number);
  }

  /// Makes room for so many numbers, where that is known.
  void reserve(std::size_t count) {
    std::size_t size = entries_.size();
    while (size < 2 * count) size *= 2;
    if (size > entries_.size()) grow(size);
  }

  /// Index of a number, not negative; if it is new, it comes after all others.
  int add(std::int64_t number) {
    std::size_t i = find_entry(number);
    if (entries_[i].place >= 0) return entries_[i].place;
    if (2 * (numbers_.size() + 1) > entries_.size()) {
      grow(2 * entries_.size());
      i = find_entry(number);
    }
    entries_[i] = {number, static_cast<int>(numbers_.size())};
    numbers_.push_back(number);
    return entries_[i].place;
  }

  /// Index of a number, -1 if it is not there.
  int find(std::int64_t number) const { return entries_[find_entry(number)].place; }

  /// The numbers by place.
  const std::vector<std::int64_t>& numbers() const { return numbers_; }

 private:
  struct Entry {
    std::int64_t number = -1;
    int place = -1;
  };

  std::size_t find_entry(std::int64_t number) const {
    const std::size_t mask = entries_.size() - 1;
    std::size_t i = static_cast<std::size_t>(static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15ull >> 20) & mask;
    while (entries_[i].place >= 0 && entries_[i].number != number) i = (i + 1) & mask;
    return i;
  }

  void grow(std::size_t size) {
    entries_.assign(size, Entry{});
    for (std::size_t n = 0; n < numbers_.size(); ++n)
      entries_[find_entry(numbers_[n])] = {numbers_[n], static_cast<int>(n)};
  }

  std::vector<Entry> entries_ = std::vector<Entry>(16);  // a power of two
  std::vector<std::int64_t> numbers_;
};

/// Places in an ascending list of numbers that are requested in nearly ascending order: from one to the next it is not
/// far.
class NumberWalk {
 public:
  explicit NumberWalk(const std::vector<std::int64_t>& numbers) : numbers_(numbers) {}

  /// Index of a number, -1 if it is not there.
  int find(std::int64_t number) {
    std::size_t first = place_ < numbers_.size() && numbers_[place_] <= number ? place_ : 0, step = 1;
    while (first + step < numbers_.size() && numbers_[first + step] < number) {
      first += step;
      step *= 2;
    }
    const auto begin = numbers_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(first + step + 1, numbers_.size()));
    place_ =
        static_cast<std::size_t>(std::lower_bound(begin + static_cast<std::ptrdiff_t>(first), end, number) - begin);
    return place_ < numbers_.size() && numbers_[place_] == number ? static_cast<int>(place_) : -1;
  }

 private:
  const std::vector<std::int64_t>& numbers_;
  std::size_t place_ = 0;
};

/// Index of a number in an ascending list, -1 if it is not there.
inline int find_number(const std::vector<std::int64_t>& numbers, std::int64_t number) {
  // Most lists have no gaps: those of a whole mesh.
  const std::int64_t guess = numbers.empty() ? -1 : number - numbers.front();
  if (guess >= 0 && guess < static_cast<std::int64_t>(numbers.size()) &&
      numbers[static_cast<std::size_t>(guess)] == number)
    return static_cast<int>(guess);
  const auto place = std::lower_bound(numbers.begin(), numbers.end(), number);
  return place != numbers.end() && *place == number ? static_cast<int>(place - numbers.begin()) : -1;
}

}  // namespace percuss
