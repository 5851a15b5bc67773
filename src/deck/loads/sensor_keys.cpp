#include "src/deck/loads/sensor_keys.hpp"

namespace percuss {
namespace {

const Keys<SensorDeck>& sensor_keys() {
  static const Keys<SensorDeck> keys = {
      may("time", &SensorDeck::time, NumberValue{not_negative}),
      may("value", &SensorDeck::value, TextValue{}),
      may("distance", &SensorDeck::distance, ListValue<NameValue>{}),
      may("rises_above", &SensorDeck::rises_above, NumberValue{}),
      may("falls_below", &SensorDeck::falls_below, NumberValue{}),
      may("from_start", &SensorDeck::from_start, BooleanValue{}),
      may("delay", &SensorDeck::delay, NumberValue{not_negative}),
  };
  return keys;
}

/// How many of the keys the map has, and refuses it if that is not one.
bool has_one(const Reader& reader, const Node& node, const std::vector<std::string>& keys) {
  std::vector<std::string> given;
  for (const std::string& key : keys)
    if (node.find(key) != nullptr) given.push_back(key);
  if (given.size() == 1) return true;
  reader.error(node.spot, fmt::format("{} has {} (must have exactly one of {})", reader.self(),
                                      given.empty() ? "no event" : fmt::format("{}", fmt::join(given, " and ")),
                                      fmt::join(keys, ", ")));
  return false;
}

bool check_sensor(const Reader& reader, const Node& node, SensorDeck& sensor) {
  if (!has_one(reader, node, {"time", "value", "distance"})) return false;
  if (!sensor.time) {
    if (!has_one(reader, node, {"rises_above", "falls_below"})) return false;
    const Node* distance = node.find("distance");
    if (distance == nullptr || sensor.distance.size() == 2) return true;
    reader.refuse(*distance, reader.name_of("distance"), "two names of output.history.nodes");
    return false;
  }
  for (const char* key : {"rises_above", "falls_below", "from_start"}) {
    const Node* given = node.find(key);
    if (given == nullptr) continue;
    reader.error(given->key, fmt::format("{} has no effect{} (its event is a time)", reader.name_of(key), reader.in()));
    return false;
  }
  return true;
}

/// Checks that the history has what a sensor watches.
void check_sight(const Deck& deck, const SensorDeck& sensor, const Spot spot, Reading& reading) {
  if (sensor.time) return;
  if (!deck.output.history_every) {
    reading.errors.add(spot, fmt::format("sensor '{}' looks at the history (the deck has none): give "
                                         "output.history.every",
                                         sensor.name));
    return;
  }
  std::vector<std::string> nodes;
  for (const HistoryPoint& point : deck.output.points)
    if (!point.is_element && (point.near || point.id)) nodes.push_back(point.name);
  for (const std::string& name : sensor.distance)
    if (std::find(nodes.begin(), nodes.end(), name) == nodes.end())
      reading.errors.add(spot, fmt::format("sensor '{}' has the distance of '{}' (must be a name of "
                                           "output.history.nodes){}",
                                           sensor.name, name, name_hint(name, nodes)));
}

/// A switch of an entry of a list: `section.N`.
void check_switch(const SwitchDeck& when, const Node* list, std::size_t i, Reading& reading) {
  if (when.from.empty() || when.from != when.until) return;
  reading.errors.add(list->items[i].spot,
                     fmt::format("from and until are both '{}' (the entry would never act)", when.from));
}

void check_condition(const Deck& deck, const ConditionDeck& condition, const Node& node, Reading& reading) {
  if (!condition.when.any()) return;
  if (condition.kind == ConditionDeck::Kind::displacement && !condition.when.from.empty())
    reading.errors.add(node.find("from")->key,
                       "a displacement cannot have from (the nodes would jump to it): prescribe their velocity");
  if (deck.time.step_estimate == TimeDeck::StepEstimate::global)
    reading.errors.add(node.find(condition.when.from.empty() ? "until" : "from")->key,
                       "a condition that a sensor switches cannot be used with time.step_estimate: global (the "
                       "estimate is that of the first conditions): use element");
}

}  // namespace

NamedMapValue<SensorDeck, MapValue<SensorDeck>> sensors_value() { return {"sensor", {sensor_keys, check_sensor}}; }

void check_sensors(const Deck& deck, const Node& root, Reading& reading) {
  std::vector<std::string> known;
  for (const SensorDeck& sensor : deck.sensors) {
    known.push_back(sensor.name);
    check_sight(deck, sensor, {sensor.place, -1}, reading);
  }
  for (const NameUse& use : reading.sensors)
    if (std::find(known.begin(), known.end(), use.name) == known.end())
      reading.errors.add(use.spot,
                         fmt::format("unknown sensor {}{}{}", quote(use.name), use.in, name_hint(use.name, known)));
  const Node *loads = root.find("loads"), *conditions = root.find("conditions");
  const auto is_whole = [](const Node* list, std::size_t count) {
    return list != nullptr && list->kind == Node::Kind::list && list->items.size() == count;
  };
  const Node *pressures = loads ? loads->find("pressure") : nullptr, *nodal = loads ? loads->find("nodal") : nullptr;
  const auto check_all = [&](const auto& entries, const Node* list) {
    for (std::size_t i = 0; is_whole(list, entries.size()) && i < entries.size(); ++i)
      check_switch(entries[i].when, list, i, reading);
  };
  const Node* contact = root.find("contact");
  check_all(deck.pressures, pressures);
  check_all(deck.nodal_loads, nodal);
  check_all(deck.walls, root.find("walls"));
  check_all(deck.contact.pairs, contact ? contact->find("surfaces") : nullptr);
  check_all(deck.contact.ties, contact ? contact->find("ties") : nullptr);
  for (std::size_t i = 0; is_whole(conditions, deck.conditions.size()) && i < deck.conditions.size(); ++i) {
    check_switch(deck.conditions[i].when, conditions, i, reading);
    check_condition(deck, deck.conditions[i], conditions->items[i], reading);
  }
}

}  // namespace percuss
