// Keys of `output.history.blocks` and `output.history.accelerometers`.

#include "src/deck/sections/history_keys.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace percuss {
namespace {

const Keys<AccelerometerDeck>& accelerometer_keys() {
  using Weight = AccelerometerDeck::Weight;
  static const Keys<AccelerometerDeck> keys = {
      need("name", &AccelerometerDeck::name, NameValue{}),
      need("nodes", &AccelerometerDeck::nodes, ListValue<NameValue>{}),
      may("gravity", &AccelerometerDeck::gravity,
          ChoiceValue<Weight>{{{"keep", Weight::keep}, {"remove", Weight::remove}}}),
  };
  return keys;
}

bool check_accelerometer(const Reader& reader, const Node& node, AccelerometerDeck& out) {
  out.place = node.spot.place;
  const std::set<std::string_view> different(out.nodes.begin(), out.nodes.end());
  if (out.nodes.size() == 3 && different.size() == 3) return true;
  reader.refuse(*node.find("nodes"), reader.name_of("nodes"), "three different names of output.history.nodes");
  return false;
}

}  // namespace

bool BlocksValue::read(const Reader& reader, const std::string& name, const Node& node,
                       std::vector<Selector>& out) const {
  if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
  if (node.items.empty()) {
    reader.refuse(node, name, "at least one element block or element set");
    return false;
  }
  bool good = true;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    if (item.kind != Node::Kind::scalar || item.text.empty() || item.text == "all") {
      reader.refuse(item, fmt::format("{}.{}", name, i), "the name of an element block or an element set");
      good = false;
    } else if (std::any_of(out.begin(), out.end(), [&](const Selector& other) { return other.name == item.text; })) {
      reader.error(item.spot, fmt::format("block '{}' is named twice in {}", item.text, name));
      good = false;
    } else {
      reader.reading().selectors.push_back({item.spot, item.text, fmt::format(" in {}", name)});
      out.push_back({item.text, {}, item.spot.place});
      reader.reading().used_selectors.push_back({out.back(), Chosen::elements});
    }
  }
  return good;
}

ListValue<MapValue<AccelerometerDeck>> accelerometers_value() { return {{accelerometer_keys, check_accelerometer}}; }

void check_blocks(const Deck& deck, Reading& reading) {
  for (const Selector& block : deck.output.blocks) {
    if (std::none_of(deck.parts.begin(), deck.parts.end(), [&](const auto& part) { return part.name == block.name; }))
      continue;
    reading.errors.add({block.place, -1},
                       fmt::format("output.history.blocks names the part '{}' (must be an element block or an element "
                                   "set): name it in output.history.parts",
                                   block.name));
  }
}

void check_accelerometers(const Deck& deck, Reading& reading) {
  std::vector<std::string> nodes;
  for (const HistoryPoint& point : deck.output.points)
    if (!point.is_element && !point.is_inside && (point.near || point.id)) nodes.push_back(point.name);
  std::set<std::string_view> names;
  for (const AccelerometerDeck& one : deck.output.accelerometers) {
    const Spot spot{one.place, -1};
    if (!names.insert(one.name).second)
      reading.errors.add(spot, fmt::format("name '{}' is given twice in output.history.accelerometers", one.name));
    for (const std::string& node : one.nodes)
      if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
        reading.errors.add(spot, fmt::format("accelerometer '{}' has the node '{}' (must be a name of "
                                             "output.history.nodes){}",
                                             one.name, node, name_hint(node, nodes)));
  }
}

}  // namespace percuss
