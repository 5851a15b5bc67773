#pragma once
// Fluids at rest by their materials.

#include "kernels/material/pressure/pressed_fluid.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Whether a fluid can have this pressure without heat from its start: an explosive has none before it burns.
bool can_rest(const MaterialDeck& material, double pressure);

/// A fluid with an equation of state at a depth below a surface with this pressure. gravity: its size.
PressedFluid find_fluid_at_rest(const MaterialDeck& material, double pressure, double gravity, double depth);

}  // namespace percuss
