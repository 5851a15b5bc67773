#pragma once
// What sensors switch: loads, conditions, contact and walls that act from one event on, or until another.

#include <algorithm>
#include <vector>

#include "src/deck/sensor_deck.hpp"

namespace percuss {

/// The sensors, by their place in the deck, between whose events something acts.
struct Switch {
  static constexpr int none = -1;
  int from = none, until = none;

  bool is_on(const std::vector<char>& happened) const {
    const auto has = [&](int sensor) { return happened[static_cast<std::size_t>(sensor)] != 0; };
    return (from == none || has(from)) && (until == none || !has(until));
  }
  bool any() const { return from != none || until != none; }
};

/// The switch of an entry of the deck. Its sensors are known.
inline Switch find_switch(const std::vector<SensorDeck>& sensors, const SwitchDeck& when) {
  const auto find = [&](const std::string& name) {
    const auto sensor =
        std::find_if(sensors.begin(), sensors.end(), [&](const SensorDeck& one) { return one.name == name; });
    return sensor == sensors.end() ? Switch::none : static_cast<int>(sensor - sensors.begin());
  };
  return {find(when.from), find(when.until)};
}

struct SwitchModel {
  std::size_t sensors = 0;                                 // of the deck
  std::vector<Switch> pressures, nodal_loads, conditions;  // by entry of the deck
  std::vector<int> held_by, spins_held_by;                 // [entries of the held directions] condition
  bool switches_conditions = false;
};

}  // namespace percuss
