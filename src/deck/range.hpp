#pragma once
// Ranges of numbers that decks take.

#include <limits>
#include <string>

namespace percuss {

/// Range of the numbers that a key takes; `text` completes "must be".
struct Range {
  std::string text;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;

  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
};

enum class KeyRange;  // of a constant of a law (kernels/material/material_key.hpp)
const Range& find_range(KeyRange range);

inline const Range any_number{""};
inline const Range positive{"positive", 0, std::numeric_limits<double>::infinity(), true};
inline const Range not_negative{"zero or positive", 0};

}  // namespace percuss
