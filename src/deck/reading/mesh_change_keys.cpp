// Keys of `imperfections` and `added_mass`.

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

}  // namespace

MapValue<ImperfectionDeck> imperfection_value() { return {imperfection_keys, check_imperfection}; }
MapValue<AddedMassDeck> added_mass_value() { return {added_mass_keys, note_place}; }

}  // namespace percuss
