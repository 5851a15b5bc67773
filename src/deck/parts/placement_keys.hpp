#pragma once
// Keys of `place`: parts that are turned and moved together before the run.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<PlaceDeck> place_value();
/// Parts and walls that `place` names, and what would not follow the parts.
void check_places(const Deck& deck, Reading& reading);

}  // namespace percuss
