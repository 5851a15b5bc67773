#include "src/deck/keys/point_keys.hpp"

#include <limits>

namespace percuss {

Keys<HistoryPoint> point_keys() {
  return {
      may("near", &HistoryPoint::near, vector3()),
      may("id", &HistoryPoint::id, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
}

bool check_point(const Reader& reader, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  if (point.near.has_value() != point.id.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of near and id)", reader.self(),
                                      point.near ? "both near and id" : "neither near nor id"));
  return false;
}

}  // namespace percuss
