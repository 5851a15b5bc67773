#pragma once
// What contact says of the start of a run.

#include <string>

namespace percuss {

/// A line for the user: a warning of a rule, or, without a rule, what is good to know.
struct StartNotice {
  std::string text;  // empty: there is nothing to say
  std::string rule;

  bool is_warning() const { return !rule.empty(); }
};

}  // namespace percuss
