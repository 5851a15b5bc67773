#pragma once
// Keys of `initial`: velocities at time 0.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<InitialDeck> initial_value();

}  // namespace percuss
