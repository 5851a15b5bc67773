#pragma once
// Keys of `mirror` and `pattern`, and the parts that they make.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<MirrorDeck> mirror_value();
MapValue<PatternDeck> pattern_value();
/// Adds the parts that `mirror` and `pattern` make.
void add_part_images(Deck& deck, Reading& reading);

}  // namespace percuss
