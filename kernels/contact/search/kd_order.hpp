#pragma once
// Points in the order of a kd tree: any sixteen that follow one another lie near each other.

#include <cstdint>
#include <vector>

namespace percuss {

/// Splits places 0 to n - 1 on the widest extent of what they hold, at a multiple of the block size, by (coordinate,
/// place), until parts are blocks. points: x, y, z of each. Returns the place of each in that order. On the host; n log
/// n.
std::vector<int> find_kd_order(const std::vector<double>& points);

/// The order of a list that has changed a little. order: places in `before`; both lists ascending, no number twice.
/// What is in both keeps its block; what is new takes the places of what has gone, then follows, and places that are
/// left over take the last of the order. Empty if there is no order of `before`, or if more than an eighth of either
/// list is not in the other: then a new order pays.
std::vector<int> carry_order(const std::vector<int>& order, const std::vector<std::int64_t>& before,
                             const std::vector<std::int64_t>& now);

}  // namespace percuss
