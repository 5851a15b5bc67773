#include "kernels/contact/kd_order.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

#include "kernels/contact/lane_mask.hpp"
#include "kernels/contact/point_order.hpp"

namespace percuss {
namespace {

/// The axis along which the points first to last - 1 of the order lie farthest apart.
int find_widest_axis(const std::vector<double>& points, const int* first, const int* last) {
  double low[3], high[3];
  std::fill_n(low, 3, std::numeric_limits<double>::infinity());
  std::fill_n(high, 3, -std::numeric_limits<double>::infinity());
  for (const int* i = first; i != last; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = points[3 * static_cast<std::size_t>(*i) + axis];
      low[axis] = std::min(low[axis], x);
      high[axis] = std::max(high[axis], x);
    }
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  return widest;
}

void split(const std::vector<double>& points, int* first, int* last) {
  const std::ptrdiff_t blocks = (last - first + block_size - 1) / block_size;
  if (blocks < 2) return;
  const auto axis = static_cast<std::size_t>(find_widest_axis(points, first, last));
  int* const middle = first + block_size * ((blocks + 1) / 2);
  std::nth_element(first, middle, last, [&](int a, int b) {
    // As integers, which have an order even where something is not a number.
    const std::uint64_t x = make_sort_key(points[3 * static_cast<std::size_t>(a) + axis]);
    const std::uint64_t y = make_sort_key(points[3 * static_cast<std::size_t>(b) + axis]);
    return x < y || (x == y && a < b);
  });
  split(points, first, middle);
  split(points, middle, last);
}

}  // namespace

void find_kd_order(const std::vector<double>& points, std::vector<int>& order) {
  order.resize(points.size() / 3);
  std::iota(order.begin(), order.end(), 0);
  split(points, order.data(), order.data() + order.size());
}

}  // namespace percuss
