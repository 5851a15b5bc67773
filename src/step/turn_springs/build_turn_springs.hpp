#pragma once

#include "src/deck/deck.hpp"
#include "src/step/model/model.hpp"

namespace percuss {

/// Builds turn springs; call after the rigid bodies.
void build_turn_springs(const Deck& deck, Model& model);

}  // namespace percuss
