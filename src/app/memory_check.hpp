#pragma once
// Refuses a scene that cannot fit before it fills the memory.

#include "src/deck/deck.hpp"

namespace percuss {

/// Bytes of memory that this machine has.
double find_machine_memory();

/// Throws SystemError if the generated meshes of the deck alone need more memory than the machine has.
void check_memory(const Deck& deck, double machine_bytes = find_machine_memory());

}  // namespace percuss
