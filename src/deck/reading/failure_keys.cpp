// Keys of `failure` in a material, and of `erosion`.

#include "src/deck/reading/deck_keys.hpp"

namespace percuss {
namespace {

const Keys<JohnsonCookDamageDeck>& damage_keys() {
  static const Keys<JohnsonCookDamageDeck> keys = {
      need("d1", &JohnsonCookDamageDeck::d1, NumberValue{not_negative}),
      may("d2", &JohnsonCookDamageDeck::d2, NumberValue{not_negative}),
      may("d3", &JohnsonCookDamageDeck::d3, NumberValue{}),
      may("d4", &JohnsonCookDamageDeck::d4, NumberValue{not_negative}),
      may("d5", &JohnsonCookDamageDeck::d5, NumberValue{not_negative}),
      may("reference_rate", &JohnsonCookDamageDeck::reference_rate, NumberValue{positive}),
  };
  return keys;
}

bool check_damage(const Reader& reader, const Node& node, JohnsonCookDamageDeck& damage) {
  if (damage.d1 > 0 || damage.d2 > 0) return true;
  reader.error(node.find("d1")->spot,
               fmt::format("{} and d2 are both 0 (the material would fail at zero strain): make one of them positive",
                           reader.name_of("d1")));
  return false;
}

const Keys<FailureDeck>& failure_keys() {
  static const Keys<FailureDeck> keys = {
      may("plastic_strain", &FailureDeck::plastic_strain, NumberValue{positive}),
      may("principal_stress", &FailureDeck::principal_stress, NumberValue{positive}),
      may("principal_strain", &FailureDeck::principal_strain, NumberValue{positive}),
      may("pressure", &FailureDeck::pressure, NumberValue{positive}),
      may("johnson_cook", &FailureDeck::johnson_cook, MapValue<JohnsonCookDamageDeck>{damage_keys, check_damage}),
      may("yield_time", &FailureDeck::yield_time, NumberValue{positive}),
      may("step", &FailureDeck::step, NumberValue{positive}),
      may("inverted", &FailureDeck::inverted, BooleanValue{}),
      may("fade_steps", &FailureDeck::fade_steps, IntegerValue{1, 1000000}),
      may("layers", &FailureDeck::layers, NumberValue{{"above 0, at most 1", 0, 1, true}}),
  };
  return keys;
}

bool check_failure(const Reader& reader, const Node& node, FailureDeck& failure) {
  if (failure.plastic_strain || failure.principal_stress || failure.principal_strain || failure.pressure ||
      failure.johnson_cook || failure.yield_time || failure.step || failure.inverted)
    return true;
  reader.error(node.spot,
               fmt::format("{} names no criterion (nothing would ever fail): give plastic_strain, principal_stress, "
                           "principal_strain, pressure, johnson_cook, yield_time, step or inverted: true",
                           reader.self()));
  return false;
}

const Keys<ErosionDeck>& erosion_keys() {
  using FreeNodes = ErosionDeck::FreeNodes;
  static const Keys<ErosionDeck> keys = {
      may("free_nodes", &ErosionDeck::free_nodes,
          ChoiceValue<FreeNodes>{{{"keep", FreeNodes::keep}, {"remove", FreeNodes::remove}}}),
  };
  return keys;
}

}  // namespace

MapValue<FailureDeck> failure_value() { return {failure_keys, check_failure}; }
MapValue<ErosionDeck> erosion_value() { return {erosion_keys}; }

}  // namespace percuss
