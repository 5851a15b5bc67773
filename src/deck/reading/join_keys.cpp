// Key `join`: which parts share the nodes that lie at one place.

#include <algorithm>

#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

const Keys<JoinDeck>& join_keys() {
  static const Keys<JoinDeck> keys = {
      may("parts", &JoinDeck::parts, ListValue<PartNameValue>{}),
      may("tolerance", &JoinDeck::tolerance, NumberValue{positive}),
  };
  return keys;
}

bool check_join(const Reader& reader, const Node& node, JoinDeck& join) {
  join.place = node.spot.place;
  const Node* parts = node.find("parts");
  if (parts == nullptr) return true;
  for (std::size_t i = 0; i < join.parts.size(); ++i) {
    const auto named = join.parts.begin() + static_cast<std::ptrdiff_t>(i);
    if (!named->empty() && std::find(join.parts.begin(), named, *named) == named) continue;
    reader.error(parts->items[i].spot,
                 fmt::format("{}.{} is {} (each part is named once; without {} all parts are joined)",
                             reader.name_of("parts"), i, describe(parts->items[i]), reader.name_of("parts")));
    return false;
  }
  if (join.parts.size() >= 2) return true;
  reader.refuse(*parts, reader.name_of("parts"), "a list of at least two parts");
  return false;
}

}  // namespace

bool JoinValue::read(const Reader& reader, const std::string& name, const Node& node,
                     std::vector<JoinDeck>& out) const {
  if (node.kind == Node::Kind::list)
    return ListValue<MapValue<JoinDeck>>{{join_keys, check_join}}.read(reader, name, node, out);
  bool joins_all = false;
  if (node.kind != Node::Kind::scalar || (node.text != "true" && node.text != "false")) {
    reader.refuse(node, name, takes());
    return false;
  }
  if (!BooleanValue{}.read(reader, name, node, joins_all)) return false;
  if (joins_all) out.push_back({{}, {}, node.spot.place});
  return true;
}

Form JoinValue::form() const {
  return any_form({BooleanValue{}.form(), list_form(MapValue<JoinDeck>{join_keys, check_join}.form())});
}

}  // namespace percuss
