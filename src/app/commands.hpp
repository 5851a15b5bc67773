#pragma once
// The commands of the program. Kokkos must be up for run and check.

#include "src/app/command_line.hpp"

namespace percuss {

/// Runs the deck's scene into its output folder; reports on stderr. Throws as run_scene does.
ExitCode run_command(const Command& command);

/// Reads the deck, builds and checks all that a run needs, and prints what it is on stdout. Throws InputError with
/// everything that is wrong.
ExitCode check_command(const Command& command);

/// Prints on stdout what a file of results or a mesh holds.
ExitCode info_command(const Command& command);

}  // namespace percuss
