#pragma once
// Keys of `springs`, `welds`, `constraints` and `embedded`: what acts between nodes.

#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value();
NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value();
NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value();
NamedMapValue<EmbeddedDeck, MapValue<EmbeddedDeck>> embedded_value();

}  // namespace percuss
