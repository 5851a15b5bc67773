#pragma once
// Points in the order of a kd tree: any sixteen that follow one another lie near each other.

#include <vector>

namespace percuss {

/// Splits places 0 to n - 1 on the widest extent of what they hold, at a multiple of the block size, by (coordinate,
/// place), until parts are blocks. points: x, y, z of each; order: out, [n]. On the host; n log n.
void find_kd_order(const std::vector<double>& points, std::vector<int>& order);

}  // namespace percuss
