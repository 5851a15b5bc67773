#include "src/step/model/nearest_items.hpp"

#include <algorithm>

namespace percuss {
namespace {

double find_square_distance(const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

}  // namespace

NearestItems::NearestItems(std::vector<Item> items) : items_(std::move(items)) { arrange(items_, 0); }

void NearestItems::arrange(std::span<Item> items, std::size_t direction) {
  if (items.size() < 2) return;
  const std::size_t middle = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(middle), items.end(),
                   [&](const Item& a, const Item& b) { return a.place[direction] < b.place[direction]; });
  arrange(items.first(middle), (direction + 1) % 3);
  arrange(items.subspan(middle + 1), (direction + 1) % 3);
}

Nearest NearestItems::find(const Vec3& place) const {
  Nearest nearest;
  search(items_, 0, place, nearest);
  return nearest;
}

void NearestItems::search(std::span<const Item> items, std::size_t direction, const Vec3& place, Nearest& nearest) {
  if (items.empty()) return;
  const std::size_t middle = items.size() / 2;
  const Item& item = items[middle];
  const double score = find_square_distance(place, item.place);
  if (score < std::numeric_limits<double>::infinity()) nearest.merge({score, item.number});
  const double way = place[direction] - item.place[direction];
  const auto low = items.first(middle), high = items.subspan(middle + 1);
  search(way < 0 ? low : high, (direction + 1) % 3, place, nearest);
  // Rounding keeps the order of distances, so nothing behind the plane is nearer than the plane. Equals count, too.
  if (way * way <= nearest.score) search(way < 0 ? high : low, (direction + 1) % 3, place, nearest);
}

}  // namespace percuss
