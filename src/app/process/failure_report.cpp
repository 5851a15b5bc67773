#include "src/app/process/failure_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "src/fail_together.hpp"
#include "src/output/progress.hpp"

namespace percuss {

FailureReport describe_failure() {
  const Failure failure = describe_current_error();
  switch (static_cast<FailureKind>(failure.code)) {
    case FailureKind::input:
      return {ExitCode::wrong_input, failure.text};
    case FailureKind::run:
      return {ExitCode::run_failed, failure.text};
    case FailureKind::system:
    case FailureKind::mpi:
      return {ExitCode::system_failed, failure.text};
    case FailureKind::memory:
      return {ExitCode::system_failed,
              "memory is exhausted (the scene is too large for this machine): use a coarser mesh"};
    case FailureKind::length:
      return {ExitCode::system_failed,
              "memory is exhausted (the scene is too large for any machine): use a coarser mesh"};
    case FailureKind::internal:
      break;
  }
  return {ExitCode::system_failed, fmt::format("internal error ({}): please report it with the deck", failure.text)};
}

ExitCode tell(const FailureReport& failure) {
  // Messages about a file begin with its name and "error:"; the others need the program's name.
  const bool named = failure.message.find(": error: ") != std::string::npos;
  std::fflush(stdout);
  print_quietly(stderr, "{}{}\n", named ? "" : "percuss: error: ", failure.message);
  return failure.code;
}

}  // namespace percuss
