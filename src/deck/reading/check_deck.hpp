#pragma once
// What must hold between the sections of a deck.

#include "src/deck/deck.hpp"
#include "src/deck/keys/reader.hpp"

namespace percuss {

/// Checks what must hold between sections: names that exist, a size that can be run, curves that stay finite.
void check_deck(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
