#pragma once
// A warning: what a user should know of a deck, a mesh or a run that is accepted all the same.

#include <string>

namespace percuss {

/// One warning, with everything that a message, summary.json and `percuss info` tell of it.
struct Warning {
  std::string rule;   // name of what was looked for, such as "one_unit_system"; a deck silences it by this name
  std::string text;   // problem (why it is one): what to do
  std::string place;  // "deck.yaml:14:12", "part 'rod', element 17", or empty: the whole scene
  double time = 0;    // of the simulation, when it was first seen; 0 for what the input shows
  long count = 1;     // how often it was seen
};

/// "PLACE: warning: TEXT [RULE]", without what is empty.
inline std::string format_warning(const Warning& warning) {
  const std::string front = warning.place.empty() ? "" : warning.place + ": ";
  const std::string back = warning.rule.empty() ? "" : " [" + warning.rule + "]";
  return front + "warning: " + warning.text + back;
}

}  // namespace percuss
