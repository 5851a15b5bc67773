#pragma once
// Keys of `joints`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<JointDeck, MapValue<JointDeck>> joints_value();

/// Joints between bodies that exist.
void check_joints(const Deck& deck, const Node& root, Reading& reading);

}  // namespace percuss
