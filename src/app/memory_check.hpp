#pragma once
// Refuses a scene that cannot fit before it fills the memory.

#include "src/deck/deck.hpp"

namespace percuss {

/// Throws SystemError if the generated meshes of the deck need more memory than the machine has.
void check_memory(const Deck& deck);

}  // namespace percuss
