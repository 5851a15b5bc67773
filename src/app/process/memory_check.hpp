#pragma once
// Refuses a scene that cannot fit before it fills the memory.

#include "comm/communicator.hpp"
#include "src/deck/deck.hpp"

namespace percuss {

/// Bytes of memory that this machine has.
double find_machine_memory();

/// Bytes of memory of all machines that the ranks run on. Collective. Throws MpiError.
double sum_machine_memory(const Communicator& ranks);

/// Throws SystemError if the generated meshes of the deck alone need more memory than there is. machine_bytes: of all
/// machines of the run.
void check_memory(const Deck& deck, double machine_bytes = find_machine_memory());

}  // namespace percuss
