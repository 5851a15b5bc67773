#include "src/deck/connections/spring_end_value.hpp"

#include <limits>
#include <utility>

namespace percuss {
namespace {

const Keys<HistoryPoint>& end_keys() {
  static const Keys<HistoryPoint> keys = {
      may("near", &HistoryPoint::near, vector3()),
      may("id", &HistoryPoint::id, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("part", &HistoryPoint::part, PartNameValue{}),
  };
  return keys;
}

bool check_end(const Reader& reader, const Node& node, HistoryPoint& point) {
  point.place = node.spot.place;
  if (point.near.has_value() != point.id.has_value()) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have one of near and id)", reader.self(),
                                      point.near ? "both near and id" : "neither near nor id"));
  return false;
}

}  // namespace

bool SpringEndValue::read(const Reader& reader, const std::string& name, const Node& node, SpringEndDeck& out) const {
  const bool is_point = node.find("near") != nullptr || node.find("id") != nullptr || node.find("part") != nullptr;
  if (!is_point) return SelectorValue{}.read(reader, name, node, out.where);
  HistoryPoint point;
  if (!MapValue<HistoryPoint>{end_keys, check_end}.read(reader, name, node, point)) return false;
  out.point = std::move(point);
  return true;
}

Form SpringEndValue::form() const { return any_form({SelectorValue{}.form(), form_of(end_keys())}); }

}  // namespace percuss
