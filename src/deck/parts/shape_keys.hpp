#pragma once
// Keys of the shapes in `parts`. A new shape is a struct in src/deck/shape_deck.hpp, a table and a row in shape_keys(),
// and its sides in side_names().

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// The keys of a part of which it has exactly one.
const Keys<PartDeck>& shape_keys();

}  // namespace percuss
