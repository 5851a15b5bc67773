#pragma once
// Keys of `start`: relaxation, fluids at rest, preloads and fields of files.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<StartDeck> start_value();

/// Preloads and hydrostatic pressures of parts that can have them.
void check_start(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
