#pragma once
// Keys of `materials.NAME.failure` and of `erosion`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<FailureDeck> failure_value();
MapValue<ErosionDeck> erosion_value();

}  // namespace percuss
