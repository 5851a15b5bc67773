#pragma once
// Keys of `turn_springs`: what resists the turn of one rigid body against another.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<TurnSpringDeck, MapValue<TurnSpringDeck>> turn_springs_value();

/// Springs between bodies that exist.
void check_turn_springs(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
