#pragma once
// Keys of `springs`, `welds` and `constraints`: what acts between nodes.

#include "src/deck/keys/keys.hpp"

namespace percuss {

NamedMapValue<SpringDeck, MapValue<SpringDeck>> springs_value();
NamedMapValue<WeldDeck, MapValue<WeldDeck>> welds_value();
NamedMapValue<ConstraintDeck, MapValue<ConstraintDeck>> constraints_value();

}  // namespace percuss
