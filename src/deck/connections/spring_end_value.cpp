#include "src/deck/connections/spring_end_value.hpp"

#include <utility>

#include "src/deck/keys/point_keys.hpp"

namespace percuss {
namespace {

const Keys<HistoryPoint>& end_keys() {
  static const Keys<HistoryPoint> keys = point_keys();
  return keys;
}

}  // namespace

bool SpringEndValue::read(const Reader& reader, const std::string& name, const Node& node, SpringEndDeck& out) const {
  const bool is_point = node.find("near") != nullptr || node.find("id") != nullptr || node.find("part") != nullptr;
  if (!is_point) return SelectorValue{}.read(reader, name, node, out.where);
  HistoryPoint point;
  if (!MapValue<HistoryPoint>{end_keys, check_point}.read(reader, name, node, point)) return false;
  out.point = std::move(point);
  return true;
}

Form SpringEndValue::form() const { return any_form({SelectorValue{}.form(), form_of(end_keys())}); }

}  // namespace percuss
