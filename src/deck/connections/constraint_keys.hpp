#pragma once
// Keys of `constraints` and `embedded`: motions of nodes that depend on those of others.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value();
NamedMapValue<EmbeddedDeck, MapValue<EmbeddedDeck>> embedded_value();

}  // namespace percuss
