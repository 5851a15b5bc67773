#pragma once
// Sensors: events that switch loads and conditions on or off, or end the run.

#include <optional>
#include <string>
#include <vector>

#include "src/deck/functions/selector.hpp"

namespace percuss {

/// An event. It happens once: at a time, or as a value of the history crosses a level.
struct SensorDeck {
  std::string name;
  std::optional<double> time;
  std::string value;                               // a column of the history
  std::vector<std::string> distance;               // or two of its nodes: how far they are apart
  std::optional<double> rises_above, falls_below;  // exactly one of them, with a value or a distance
  bool from_start = false;                         // whether the value is that of the first row less
  double delay = 0;                                // from the event to what it switches [time]
  Place place;
};

/// When an entry of the deck acts: from one event on, until another. No names: always.
struct SwitchDeck {
  std::string from, until;

  bool any() const { return !from.empty() || !until.empty(); }
};

}  // namespace percuss
