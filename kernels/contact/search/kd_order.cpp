#include "kernels/contact/search/kd_order.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "kernels/contact/surface/lane_mask.hpp"
#include "kernels/core/contract.hpp"
#include "kernels/core/same_bits.hpp"

namespace percuss {
namespace {

/// A point and its place in the list, moved together: looked up by their places, points would come from all over
/// memory at every comparison.
struct ListedPoint {
  double x[3];
  int place;
};

/// The axis along which points lie farthest apart.
int find_widest_axis(const ListedPoint* first, const ListedPoint* last) {
  double low[3], high[3];
  std::fill_n(low, 3, std::numeric_limits<double>::infinity());
  std::fill_n(high, 3, -std::numeric_limits<double>::infinity());
  for (const ListedPoint* point = first; point != last; ++point)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point->x[axis]);
      high[axis] = std::max(high[axis], point->x[axis]);
    }
  int widest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
  return widest;
}

void split(ListedPoint* first, ListedPoint* last) {
  const std::ptrdiff_t blocks = (last - first + block_size - 1) / block_size;
  if (blocks < 2) return;
  const int axis = find_widest_axis(first, last);
  ListedPoint* const middle = first + block_size * ((blocks + 1) / 2);
  std::nth_element(first, middle, last, [axis](const ListedPoint& a, const ListedPoint& b) {
    // As integers, which have an order even where something is not a number.
    const std::uint64_t x = make_sort_key(a.x[axis]), y = make_sort_key(b.x[axis]);
    return x < y || (x == y && a.place < b.place);
  });
  split(first, middle);
  split(middle, last);
}

}  // namespace

std::vector<int> find_kd_order(const std::vector<double>& points) {
  std::vector<ListedPoint> placed(points.size() / 3);
  for (std::size_t i = 0; i < placed.size(); ++i)
    placed[i] = {{points[3 * i], points[3 * i + 1], points[3 * i + 2]}, static_cast<int>(i)};
  split(placed.data(), placed.data() + placed.size());
  std::vector<int> order;
  order.reserve(placed.size());
  for (const ListedPoint& point : placed) order.push_back(point.place);
  return order;
}

std::vector<int> carry_order(const std::vector<int>& order, const std::vector<std::int64_t>& before,
                             const std::vector<std::int64_t>& now) {
  constexpr std::size_t part = 8;
  PERCUSS_EXPECT(std::is_sorted(before.begin(), before.end()) && std::is_sorted(now.begin(), now.end()));
  if (order.size() != before.size()) return {};
  std::vector<int> places(before.size(), -1), fresh;  // places in `now`
  std::size_t b = 0;
  for (std::size_t n = 0; n < now.size(); ++n) {
    while (b < before.size() && before[b] < now[n]) ++b;
    if (b < before.size() && before[b] == now[n])
      places[b] = static_cast<int>(n);
    else
      fresh.push_back(static_cast<int>(n));
  }
  const std::size_t gone = before.size() + fresh.size() - now.size();
  if (part * fresh.size() > now.size() || part * gone > before.size()) return {};
  std::vector<int> carried;
  carried.reserve(before.size() + fresh.size());
  for (const int place : order) carried.push_back(places[static_cast<std::size_t>(place)]);
  auto next = fresh.begin();
  for (int& place : carried)
    if (place < 0 && next != fresh.end()) place = *next++;
  carried.insert(carried.end(), next, fresh.end());
  for (std::size_t i = 0; i < carried.size(); ++i) {
    while (!carried.empty() && carried.back() < 0) carried.pop_back();
    if (i >= carried.size() || carried[i] >= 0) continue;
    carried[i] = carried.back();
    carried.pop_back();
  }
  return carried;
}

}  // namespace percuss
