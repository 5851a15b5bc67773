#pragma once
// How a failure ends the program: its message on stderr and its exit code.

#include <string>

#include "src/error.hpp"

namespace percuss {

struct FailureReport {
  ExitCode code = ExitCode::system_failed;
  std::string message;
};

/// Describes the error that is being handled. Only inside a catch clause.
FailureReport describe_failure();

/// Prints the message on stderr and returns the code.
ExitCode tell(const FailureReport& failure);

}  // namespace percuss
