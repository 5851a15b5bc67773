#pragma once
// Recursive coordinate bisection the plain way: all points in one place, sorted at every cut. The answer that the
// parallel one must give to the last key.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "comm/rcb/cut_tree.hpp"

namespace percuss::test {

struct Point {
  std::array<double, 3> x{};
  std::int64_t id = 0;
  int weight = 1;
};

struct SerialRcb {
  std::vector<CoordinateKey> keys;        // [ranks] entry m: the cut whose upper ranks begin at m
  std::vector<int> axes;                  // [ranks]
  std::vector<std::vector<Point>> owned;  // [ranks]
};

inline CoordinateKey find_key(const Point& point, int axis) {
  return {order_coordinate(point.x[static_cast<std::size_t>(axis)]), point.id};
}

/// The longest extent, the previous axis unless that is more than 15 % longer.
inline int choose_axis_serially(const std::vector<Point>& points, int previous) {
  std::array<double, 3> extent{};
  for (std::size_t k = 0; k < 3 && !points.empty(); ++k) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [k](const Point& a, const Point& b) { return a.x[k] < b.x[k]; });
    extent[k] = high->x[k] - low->x[k];
  }
  const auto longest = std::max_element(extent.begin(), extent.end()) - extent.begin();
  const bool keep =
      previous >= 0 && extent[static_cast<std::size_t>(longest)] <= 1.15 * extent[static_cast<std::size_t>(previous)];
  return keep ? previous : static_cast<int>(longest);
}

inline void bisect_serially(std::vector<Point> points, int first, int last, const std::vector<int>& previous_axes,
                            SerialRcb& rcb) {
  if (last - first == 1) {
    rcb.owned[static_cast<std::size_t>(first)] = std::move(points);
    return;
  }
  const int middle = first + (last - first) / 2;
  const auto m = static_cast<std::size_t>(middle);
  const int axis = choose_axis_serially(points, previous_axes.empty() ? -1 : previous_axes[m]);
  std::sort(points.begin(), points.end(),
            [axis](const Point& a, const Point& b) { return find_key(a, axis) < find_key(b, axis); });
  std::int64_t total = 0, passed = 0;
  for (const Point& point : points) total += point.weight;
  const std::int64_t target = total * (middle - first) / (last - first);
  auto cut = points.begin();
  while (cut != points.end() && passed + cut->weight <= target) passed += (cut++)->weight;
  rcb.keys[m] = cut == points.end() ? last_key : find_key(*cut, axis);
  rcb.axes[m] = axis;
  bisect_serially({points.begin(), cut}, first, middle, previous_axes, rcb);
  bisect_serially({cut, points.end()}, middle, last, previous_axes, rcb);
}

/// previous_axes: [ranks], empty for none.
inline SerialRcb bisect_serially(const std::vector<Point>& points, int rank_count,
                                 const std::vector<int>& previous_axes = {}) {
  const auto size = static_cast<std::size_t>(rank_count);
  SerialRcb rcb{std::vector<CoordinateKey>(size), std::vector<int>(size, -1), std::vector<std::vector<Point>>(size)};
  bisect_serially(points, 0, rank_count, previous_axes, rcb);
  return rcb;
}

}  // namespace percuss::test
