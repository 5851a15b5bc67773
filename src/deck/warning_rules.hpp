#pragma once
// The names of all warnings: what a deck may silence, and what docs/checks.md explains.

#include <string>
#include <vector>

namespace percuss {

struct WarningRule {
  std::string name;       // "one_unit_system"
  std::string looks_for;  // in a line
};

/// Every rule that deck, mesh, checks and runs warn by, by subject.
const std::vector<WarningRule>& warning_rules();

}  // namespace percuss
