#pragma once
// Keys of `sensors`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<SensorDeck, MapValue<SensorDeck>> sensors_value();

/// Sensors that exist, that see something, and entries that they can switch.
void check_sensors(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
