#pragma once
// Keys of `elements`, and those that a part may have of them.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<ElementDeck> element_value();
/// Keys of `elements` that a part may have.
Keys<PartElementDeck> part_element_keys();
/// What has no effect beside the other settings that hold there.
void check_element_settings(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
