#pragma once
// The program from arguments to exit code.

namespace percuss {

/// Parses the arguments, starts MPI and Kokkos as the command needs, runs it, and turns every failure into a message on
/// stderr and an exit code of src/error.hpp.
int run_program(int argc, char** argv);

}  // namespace percuss
