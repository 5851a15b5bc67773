#pragma once
// A warning: what a user should know of a deck, a mesh or a run that is accepted all the same.

#include <fmt/format.h>

#include <string>

namespace percuss {

/// One warning, with all data for messages, summary.json and `percuss info`.
struct Warning {
  std::string rule;   // name of what was looked for, such as "one_unit_system"; a deck silences it by this name
  std::string text;   // problem (why it is one): what to do
  std::string place;  // "deck.yaml:14:12", "part 'rod', element 17", or empty: the whole scene
  double time = 0;    // of the simulation, when it was first seen; 0 for what the input shows
  long count = 1;     // how often it was seen
};

/// "PLACE: warning: TEXT [RULE] (first at t = 0.002, 12 times)", without what is empty, 0 or 1.
inline std::string format_warning(const Warning& warning) {
  std::string line = (warning.place.empty() ? "" : warning.place + ": ") + "warning: " + warning.text;
  if (!warning.rule.empty()) line += " [" + warning.rule + "]";
  const bool repeats = warning.count > 1;
  if (warning.time > 0) line += fmt::format(" ({}t = {:.6g}", repeats ? "first at " : "", warning.time);
  if (repeats) line += fmt::format("{}{} times", warning.time > 0 ? ", " : " (", warning.count);
  return warning.time > 0 || repeats ? line + ")" : line;
}

}  // namespace percuss
