#pragma once
// Keys of `contact.ties`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<TieDeck> tie_value();

}  // namespace percuss
