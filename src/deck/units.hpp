#pragma once
// The units that a deck says it is written in (`units: mm, kg, ms`) and those that follow from them: the one table for
// messages, checks and result files. percuss computes in the numbers of the deck; no result depends on this.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// Powers of length, mass and time in a quantity.
struct Dimension {
  int length = 0, mass = 0, time = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimensions {
inline constexpr Dimension length{1, 0, 0}, area{2, 0, 0}, mass{0, 1, 0}, time{0, 0, 1}, velocity{1, 0, -1},
    acceleration{1, 0, -2}, density{-3, 1, 0}, force{1, 1, -2}, stress{-1, 1, -2}, energy{2, 1, -2}, momentum{1, 1, -1};
}  // namespace dimensions

/// A unit of length, mass or time.
struct BaseUnit {
  std::string name;   // as it is shown: "µs"
  double in_si = 1;   // metres, kilograms or seconds in it
  std::string plain;  // as decks write it: "us"
};

struct Units {
  BaseUnit length, mass, time;
  std::string temperature;  // "K", "C" or empty

  /// "mm, kg, ms": the form that results carry.
  std::string text() const;

  /// What one of a quantity is in SI: 1e9 of stress in mm, kg, ms.
  double in_si(const Dimension& quantity) const;

  /// The unit of a quantity: "GPa" of stress in mm, kg, ms, "psi" in in, lbf s2/in, s; a product of the base units
  /// where nothing shorter is usual.
  std::string name_of(const Dimension& quantity) const;
};

/// The units of a text such as "mm, kg, ms": a length, a mass and a time that are known, in this order, and optionally
/// a temperature, K or C. Nothing: the text is another.
std::optional<Units> find_units(std::string_view text);

/// "m, kg, s", "mm, t, s" ...: the systems that are usual.
std::vector<std::string> list_unit_systems();

/// "m mm ...; kg t ...; s ms ...": the names of lengths, masses and times that are known.
std::string list_base_units();

/// " kg" of mass, or nothing where the units are not known: what stands behind a number.
std::string unit_suffix(const std::string& units, const Dimension& quantity);

}  // namespace percuss
