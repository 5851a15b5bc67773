#pragma once
// Keys of `mass_scaling`, of all parts or of one, and of `added_mass`.

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

MapValue<MassScalingDeck> mass_scaling_value();
MapValue<AddedMassDeck> added_mass_value();

}  // namespace percuss
