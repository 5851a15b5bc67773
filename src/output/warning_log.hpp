#pragma once
// The warnings of a run, of deck, mesh, start, steps and end: printed when first found, then counted, and listed at the
// end.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "src/warning.hpp"

namespace percuss {

class WarningLog {
 public:
  using Report = std::function<void(const Warning&)>;

  /// silenced: rules whose warnings are dropped; tell: called for each new warning, may be empty.
  explicit WarningLog(std::set<std::string> silenced, Report report = {});

  /// Reports a new warning. One with the rule, place and text of an earlier one is added to its count instead.
  void add(const Warning& warning);
  void add(const std::vector<Warning>& warnings);

  /// As add(), but the rule and the place alone say which warning it is: the text, which has figures of the run in it,
  /// becomes the new one. Its time stays that of the first.
  void renew(const Warning& warning);

  /// Takes the warnings of an earlier part of the run without printing, since they were printed then.
  void restore(const std::vector<Warning>& warnings);

  /// Whether the warnings of a rule are dropped.
  bool is_silenced(const std::string& rule) const { return silenced_.count(rule) > 0; }

  /// Warnings in the order in which they were found.
  const std::vector<Warning>& list() const { return warnings_; }

 private:
  void append(const Warning& warning);

  std::set<std::string> silenced_;
  Report report_;
  std::vector<Warning> warnings_;
};

/// "1 warning", "3 warnings".
std::string count_warnings(const std::vector<Warning>& warnings);

/// Warnings as a text that a file keeps, and back. Throws InputError if the text is no list of warnings.
std::string write_warnings(const std::vector<Warning>& warnings);
std::vector<Warning> read_warnings(const std::string& text);

}  // namespace percuss
