#include "src/deck/parts/mesh_change_keys.hpp"

#include <algorithm>
#include <limits>

#include "src/deck/text/nearest_name.hpp"

namespace percuss {
namespace {

const Keys<NoiseDeck>& noise_keys() {
  static const Keys<NoiseDeck> keys = {
      need("amplitude", &NoiseDeck::amplitude, NumberValue{positive}),
      may("length", &NoiseDeck::length, NumberValue{positive}),
      may("seed", &NoiseDeck::seed, IntegerValue{0, std::numeric_limits<long>::max()}),
  };
  return keys;
}

const Keys<ImperfectionDeck>& imperfection_keys() {
  static const Keys<ImperfectionDeck> keys = {
      need("nodes", &ImperfectionDeck::where, SelectorValue{}),
      may("mode", &ImperfectionDeck::mode, PlaceFunctionValue{}),
      may("noise", &ImperfectionDeck::noise, MapValue<NoiseDeck>{noise_keys}),
      may("direction", &ImperfectionDeck::direction, DirectionValue{}),
  };
  return keys;
}

bool check_imperfection(const Reader& reader, const Node& node, ImperfectionDeck& imperfection) {
  imperfection.place = node.spot.place;
  const bool has_mode = node.find("mode") != nullptr, has_noise = node.find("noise") != nullptr;
  if (has_mode != has_noise) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of mode, noise)", reader.self(),
                                      has_mode ? "mode and noise" : "neither mode nor noise"));
  return false;
}

/// Sides and sets of parts, "part/side".
struct JoinSidesValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, std::vector<std::string>& out) const {
    if (!reader.expect(node, Node::Kind::list, name, takes())) return false;
    bool good = !node.items.empty();
    if (!good) reader.refuse(node, name, "at least one side");
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Node& item = node.items[i];
      if (item.kind == Node::Kind::scalar && item.text.find('/') != std::string::npos) {
        reader.reading().selectors.push_back({item.spot, item.text, fmt::format(" in {}", name)});
        out.push_back(item.text);
      } else {
        reader.refuse(item, fmt::format("{}.{}", name, i), "a side or a set with its part, such as plate/top");
        good = false;
      }
    }
    return good;
  }
  std::string takes() const { return "a list of sides or sets, each part/side"; }
  Form form() const { return list_form(TextValue{}.form(), 1); }
};

const Keys<JoinDeck>& join_keys() {
  static const Keys<JoinDeck> keys = {
      may("parts", &JoinDeck::parts, ListValue<PartNameValue>{}),
      may("tolerance", &JoinDeck::tolerance, NumberValue{positive}),
      may("sides", &JoinDeck::sides, JoinSidesValue{}),
  };
  return keys;
}

bool check_join(const Reader& reader, const Node& node, JoinDeck& join) {
  join.place = node.spot.place;
  const Node* parts = node.find("parts");
  for (std::size_t i = 0; parts != nullptr && !join.parts.empty() && i < join.sides.size(); ++i) {
    const std::string part = join.sides[i].substr(0, join.sides[i].find('/'));
    if (std::find(join.parts.begin(), join.parts.end(), part) != join.parts.end()) continue;
    reader.error(node.find("sides")->items[i].spot,
                 fmt::format("{}.{} is of part '{}', which {} does not name{}", reader.name_of("sides"), i, part,
                             reader.name_of("parts"), name_hint(part, join.parts)));
    return false;
  }
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

MapValue<ImperfectionDeck> imperfection_value() { return {imperfection_keys, check_imperfection}; }

}  // namespace percuss
