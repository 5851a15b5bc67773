// Keys of `join`, `imperfections` and `added_mass`.

#include <algorithm>
#include <stdexcept>

#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

/// A function of the place.
struct PlaceFunctionValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, PlaceFunction& out) const {
    if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
    try {
      out = PlaceFunction::expression(node.text);
      return true;
    } catch (const std::invalid_argument& reason) {
      reader.error(node.spot, fmt::format("{} is {}{} ({})", name, quote(node.text), reader.in(), reason.what()));
      return false;
    }
  }
  std::string takes() const { return "a text, an expression of x, y and z"; }
  Form form() const { return any_form({TextValue{}.form(), number_form()}); }
};

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

const Keys<AddedMassDeck>& added_mass_keys() {
  using Spread = AddedMassDeck::Spread;
  static const Keys<AddedMassDeck> keys = {
      need("nodes", &AddedMassDeck::where, SelectorValue{}),
      need("mass", &AddedMassDeck::mass, NumberValue{positive}),
      may("spread", &AddedMassDeck::spread,
          ChoiceValue<Spread>{{{"by_mass", Spread::by_mass}, {"evenly", Spread::evenly}}}),
  };
  return keys;
}

bool note_place(const Reader&, const Node& node, AddedMassDeck& added) {
  added.place = node.spot.place;
  return true;
}

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

MapValue<ImperfectionDeck> imperfection_value() { return {imperfection_keys, check_imperfection}; }
MapValue<AddedMassDeck> added_mass_value() { return {added_mass_keys, note_place}; }

}  // namespace percuss
