#pragma once
// The deck of a run on many ranks.

#include <string>

#include "comm/communicator.hpp"
#include "src/app/process/command_line.hpp"
#include "src/deck/deck.hpp"
#include "src/deck/laws/user_routines.hpp"

namespace percuss {

/// Every rank reads the deck of the command and checks that its mesh fits in memory; rank 0 checks that its
/// mesh files take nothing from other files, unless the command allows it. Collective. Throws InputError and
/// SystemError, the same on all ranks.
Deck read_deck_together(const Command& command, const Communicator& ranks);

/// Data for code of a user of a run with this deck that writes to this folder.
UserRun describe_run(const std::string& deck, const std::string& folder, const Communicator& ranks);

}  // namespace percuss
