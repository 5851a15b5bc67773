#pragma once
// Keys of `elements`, and those that a part may have of them.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<ElementDeck> element_value();
/// Keys of `elements` that a part may have.
Keys<PartElementDeck> part_element_keys();
/// Reports settings that have no effect beside the others.
void check_element_settings(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
