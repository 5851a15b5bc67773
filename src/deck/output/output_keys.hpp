#pragma once
// Keys of `output`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<OutputDeck> output_value();

}  // namespace percuss
