#pragma once
// Keys of `loads` and `damping`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// Gravity, pressures and loads on nodes.
MapValue<Deck> loads_value();
MapValue<DampingDeck> damping_value();

}  // namespace percuss
