#pragma once
// Keys of `walls`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<WallDeck> wall_value();

}  // namespace percuss
