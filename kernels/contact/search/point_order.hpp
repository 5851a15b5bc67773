#pragma once
// Points ranked along an axis: a stable radix sort of their coordinates, the same for any number of threads.

#include "kernels/core/same_bits.hpp"
#include "kernels/core/small_space.hpp"

namespace percuss {

/// Scratch memory of rank_points().
struct SortScratch {
  Array<std::uint64_t> keys[2] = {Array<std::uint64_t>("contact::sort_keys_0", 0),
                                  Array<std::uint64_t>("contact::sort_keys_1", 0)};
  Array<int> items = Array<int>("contact::sort_items", 0);
  Array<int> histogram = Array<int>("contact::sort_histogram", 0);
};

/// Points to be ranked along an axis.
struct PointsAlongAxis {
  Rows3<const double> x;    // [mesh nodes][3]
  Array<const int> points;  // [n] rows of x
  int n = 0, axis = 0;
};

/// Sorts the points by (coordinate along the axis, place in the list). order: out, [n] places in `points`, ascending in
/// the coordinate; rank: out, [n] place of each point in `order`.
void rank_points(const WorkSpace& space, const PointsAlongAxis& points, SortScratch& scratch, const Array<int>& order,
                 const Array<int>& rank);

}  // namespace percuss
