#pragma once
// The nearest of many places, found without looking at all of them: a tree of medians, one direction after the other
// (Bentley, Multidimensional binary search trees used for associative searching, Comm. ACM 18 (1975)).

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "src/mesh/mesh.hpp"

namespace percuss {

/// Nearest item so far: least score first, then lowest number in the whole mesh.
struct Nearest {
  double score = std::numeric_limits<double>::infinity();
  std::int64_t number = std::numeric_limits<std::int64_t>::max();

  void merge(const Nearest& other) {
    if (std::pair(other.score, other.number) < std::pair(score, number)) *this = other;
  }
};

/// A node or the centre of an element.
struct Item {
  Vec3 place{};
  std::int64_t number = 0;  // in the whole mesh
};

class NearestItems {
 public:
  explicit NearestItems(std::vector<Item> items);

  /// The item nearest to a place, scored by the square of its distance; among equals that of the lowest number.
  Nearest find(const Vec3& place) const;

 private:
  void arrange(std::span<Item> items, std::size_t direction);
  static void search(std::span<const Item> items, std::size_t direction, const Vec3& place, Nearest& nearest);

  std::vector<Item> items_;  // the median of each range in its middle
};

}  // namespace percuss
