#pragma once
// What can go wrong, by the exit code that it ends the program with.
//
// A message reads "problem (why it is one): suggestion" and names its place: deck.yaml:14:12, an element id, a file.

#include <stdexcept>
#include <string>
#include <utility>

namespace percuss {

/// Exit codes of the program; their meaning does not change.
enum class ExitCode : int { done = 0, wrong_input = 2, run_failed = 3, system_failed = 4, interrupted = 130 };

/// Deck, mesh or command is wrong (exit code 2). what() holds all messages found, one a line.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run itself failed: instability, inversion, energy, NaN (exit code 3).
class RunError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// I/O, memory or MPI failed (exit code 4).
class SystemError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace percuss
