#include "src/deck/parts/mass_keys.hpp"

#include <limits>

namespace percuss {
namespace {

const Keys<MassScalingDeck>& mass_scaling_keys() {
  static const Keys<MassScalingDeck> keys = {
      need("step", &MassScalingDeck::step, NumberValue{positive}),
      may("max_added", &MassScalingDeck::max_added, NumberValue{positive}),
      may("every", &MassScalingDeck::every, IntegerValue{1, std::numeric_limits<long>::max()}),
  };
  return keys;
}

bool note_place(const Reader&, const Node& node, MassScalingDeck& scaling) {
  scaling.place = node.spot.place;
  return true;
}

const Keys<AddedMassDeck>& added_mass_keys() {
  using Spread = AddedMassDeck::Spread;
  static const Keys<AddedMassDeck> keys = {
      need("nodes", &AddedMassDeck::where, SelectorValue{Chosen::nodes}),
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

MapValue<MassScalingDeck> mass_scaling_value() { return {mass_scaling_keys, note_place}; }
MapValue<AddedMassDeck> added_mass_value() { return {added_mass_keys, note_place}; }

}  // namespace percuss
