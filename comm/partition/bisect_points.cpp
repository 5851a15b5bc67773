#include "comm/partition/bisect_points.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace percuss {
namespace {

using Place = std::vector<PlacedPoint>::iterator;

/// Points [begin, end), divided among ranks [first, last).
struct Group {
  Place begin, end;
  int first = 0, last = 0;
};

/// The longest extent; the first of equal ones.
std::size_t choose_axis(Place begin, Place end) {
  std::array<double, 3> extents{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(begin, end, [k](const PlacedPoint& a, const PlacedPoint& b) { return a.x[k] < b.x[k]; });
    extents[k] = high->x[k] - low->x[k];
  }
  return static_cast<std::size_t>(std::max_element(extents.begin(), extents.end()) - extents.begin());
}

CoordinateKey find_key(const PlacedPoint& point, std::size_t axis) {
  return {order_coordinate(point.x[axis]), point.id};
}

void bisect(const Group& group, std::vector<Cut>& cuts) {
  // A cut without points is never made: all ranks but the first of the group stay empty.
  if (group.last - group.first == 1 || group.begin == group.end) return;
  const int middle = find_middle_rank(group.first, group.last);
  const std::size_t axis = choose_axis(group.begin, group.end);
  const std::int64_t count = std::distance(group.begin, group.end);
  const Place first_upper = group.begin + count * (middle - group.first) / (group.last - group.first);
  std::nth_element(group.begin, first_upper, group.end, [axis](const PlacedPoint& a, const PlacedPoint& b) {
    return find_key(a, axis) < find_key(b, axis);
  });
  Cut& cut = cuts[static_cast<std::size_t>(middle)];
  cut.key = find_key(*first_upper, axis);
  cut.axis = static_cast<int>(axis);
  cut.lower_end = cut.upper_begin = restore_coordinate(cut.key.coordinate);
  bisect({group.begin, first_upper, group.first, middle}, cuts);
  bisect({first_upper, group.end, middle, group.last}, cuts);
}

}  // namespace

std::vector<Cut> bisect_points(std::vector<PlacedPoint> points, int rank_count) {
  if (rank_count < 1) throw std::invalid_argument("points are divided among at least one rank");
  std::vector<Cut> cuts(static_cast<std::size_t>(rank_count));
  bisect({points.begin(), points.end(), 0, rank_count}, cuts);
  return cuts;
}

}  // namespace percuss
