#pragma once
// Keys of `output.history`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<OutputDeck> history_value();

/// Blocks whose names are those of parts, which have columns of their own.
void check_blocks(const Deck& deck, Reading& reading);

/// Names of accelerometers, and of the nodes that they have.
void check_accelerometers(const Deck& deck, Reading& reading);

}  // namespace percuss
