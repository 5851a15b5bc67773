#pragma once
// Keys of `springs`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value();

}  // namespace percuss
