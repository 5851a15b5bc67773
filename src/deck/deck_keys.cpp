// Keys of `time`, `elements` and `audit`, and the top of the deck.

#include "src/deck/deck_keys.hpp"

namespace percuss {
namespace {

const Keys<TimeDeck>& time_keys() {
  static const Keys<TimeDeck> keys = {
      need("end", &TimeDeck::end, NumberValue{positive}),
      may("step_scale", &TimeDeck::step_scale, NumberValue{{"above 0, at most 1", 0, 1, true}}),
      may("max_step", &TimeDeck::max_step, NumberValue{positive}),
      may("max_steps", &TimeDeck::max_steps, IntegerValue{1, std::numeric_limits<long>::max()}),
      may("collapse_ratio", &TimeDeck::collapse_ratio, NumberValue{{"at least 0 and below 1", 0, 1, false, true}}),
  };
  return keys;
}

const Keys<ElementDeck>& hourglass_keys() {
  using Hourglass = ElementDeck::Hourglass;
  static const Keys<ElementDeck> keys = {
      may("kind", &ElementDeck::hourglass,
          ChoiceValue<Hourglass>{{{"stiffness", Hourglass::stiffness}, {"viscous", Hourglass::viscous}}}),
      may("coefficient", &ElementDeck::hourglass_coefficient, NumberValue{{"from 0 to 1", 0, 1}}),
  };
  return keys;
}

const Keys<ElementDeck>& viscosity_keys() {
  static const Keys<ElementDeck> keys = {
      may("linear", &ElementDeck::linear_viscosity, NumberValue{not_negative}),
      may("quadratic", &ElementDeck::quadratic_viscosity, NumberValue{not_negative}),
  };
  return keys;
}

const Keys<ElementDeck>& element_keys() {
  static const Keys<ElementDeck> keys = {
      group<ElementDeck>("hourglass", MapValue<ElementDeck>{hourglass_keys}),
      group<ElementDeck>("bulk_viscosity", MapValue<ElementDeck>{viscosity_keys}),
  };
  return keys;
}

const Keys<AuditDeck>& audit_keys() {
  static const Keys<AuditDeck> keys = {may("max_energy_error", &AuditDeck::max_energy_error, NumberValue{positive})};
  return keys;
}

const Keys<Deck>& load_keys() {
  static const Keys<Deck> keys = {
      may("gravity", &Deck::gravity, vector3()),
      may("pressure", &Deck::pressures, ListValue<MapValue<PressureDeck>>{pressure_value()}),
  };
  return keys;
}

}  // namespace

MapValue<TimeDeck> time_value() { return {time_keys}; }
MapValue<ElementDeck> element_value() { return {element_keys}; }
MapValue<AuditDeck> audit_value() { return {audit_keys}; }

const Keys<Deck>& deck_keys() {
  static const Keys<Deck> keys = {
      may("title", &Deck::title, TextValue{}),
      may("units", &Deck::units, TextValue{}),
      need("time", &Deck::time, time_value()),
      need("parts", &Deck::parts, NamedMapValue<PartDeck, PartValue>{"part", {}}),
      need("materials", &Deck::materials, NamedMapValue<MaterialDeck, MaterialValue>{"material", {}}),
      may("elements", &Deck::elements, element_value()),
      may("initial", &Deck::initial, ListValue<MapValue<InitialDeck>>{initial_value()}),
      group<Deck>("loads", MapValue<Deck>{load_keys}),
      may("conditions", &Deck::conditions, ListValue<ConditionValue>{}),
      may("walls", &Deck::walls, ListValue<MapValue<WallDeck>>{wall_value()}),
      may("contact", &Deck::contact, ContactValue{}),
      may("output", &Deck::output, output_value()),
      may("audit", &Deck::audit, audit_value()),
  };
  return keys;
}

std::vector<DeckKey> list_deck_keys() {
  std::vector<DeckKey> all;
  list_keys(deck_keys(), "", all);
  list_keys(selector_keys(), "SELECTOR", all);
  return all;
}

}  // namespace percuss
