#pragma once
// The commands of the program. MPI and Kokkos must be up for run, check and plan.

#include "comm/communicator.hpp"
#include "src/app/process/command_line.hpp"

namespace percuss {

/// Runs the deck's scene into its output folder; rank 0 reports on stderr. Collective. Throws as run_scene does.
ExitCode run_command(Command command, const Communicator& ranks);

/// Reads the deck, builds and checks all that a run needs; rank 0 prints on stdout what it is. Collective. Throws
/// InputError with everything that is wrong, the same on all ranks.
ExitCode check_command(const Command& command, const Communicator& ranks);

/// Rank 0 prints on stdout how the deck's scene would be divided among other numbers of ranks, and how long a step
/// would take. Collective. Throws InputError, RunError and SystemError, the same on all ranks.
ExitCode plan_command(const Command& command, const Communicator& ranks);

/// Prints on stdout what a file of results or a mesh holds.
ExitCode info_command(const Command& command);

/// Prints on stdout the JSON Schema of decks.
ExitCode schema_command();

}  // namespace percuss
