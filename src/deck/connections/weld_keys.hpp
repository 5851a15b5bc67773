#pragma once
// Keys of `welds`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value();

}  // namespace percuss
