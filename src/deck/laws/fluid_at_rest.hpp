#pragma once
// Fluids at rest by their materials.

#include "kernels/material/pressure/pressed_fluid.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Whether a fluid can have this pressure, and below it the weight of some depth, without heat from its start: an
/// explosive has none before it burns. weight: density times gravity times depth [pressure].
bool can_rest(const MaterialDeck& material, double pressure, double weight = 0);

/// A fluid with an equation of state below a surface with this pressure. weight: of the depth, as above.
PressedFluid find_fluid_at_rest(const MaterialDeck& material, double pressure, double weight);

}  // namespace percuss
