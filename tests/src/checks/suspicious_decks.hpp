#pragma once
// Decks with one mistake each that can be run all the same: what rule tells it, and where. Beside each a deck that
// comes near the limit of the rule and is left alone.

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace percuss {

/// Texts replaced in a deck, in order; each must be there.
using Changes = std::vector<std::pair<std::string, std::string>>;

struct SuspiciousDeck {
  std::string name;   // CamelCase: the test's name
  std::string rule;   // that warns
  std::string place;  // the text at whose beginning the warning points
  Changes mistake;    // of sound_deck
  Changes near;       // of sound_deck: nearly the same, and no warning of the rule
};

/// How a failed test calls it.
inline void PrintTo(const SuspiciousDeck& deck, std::ostream* out) { *out << deck.name; }

/// A block that falls on a plate, with a sheet and a wall below. No rule finds anything in it.
extern const std::string sound_deck;

/// sound_deck without its sheet, the part and its condition.
inline const std::pair<std::string, std::string> no_sheet{
    "  sheet: {shell_plate: {size: [0.1, 0.1], cells: [5, 5]}, at: [0, 0, -0.004], thickness: 0.002, material: "
    "aluminium}\n",
    ""};
inline const std::pair<std::string, std::string> no_sheet_condition{
    "  - {nodes: sheet/x_min, fixed: [x, y, z, rx, ry, rz]}\n", ""};

/// The plate of sound_deck, and another part after it.
inline const std::string plate = "plate: {box: {size: [0.1, 0.1, 0.01], cells: [6, 6, 3]}, material: aluminium}";
inline std::pair<std::string, std::string> add_part(const std::string& part) { return {plate, plate + "\n  " + part}; }

/// sound_deck with changes. Throws std::logic_error if a text is not there.
std::string change(const Changes& changes);

std::vector<SuspiciousDeck> suspicious_units();       // units and materials
std::vector<SuspiciousDeck> suspicious_parts();       // sizes and places
std::vector<SuspiciousDeck> suspicious_contact();     // contact, ties and walls
std::vector<SuspiciousDeck> suspicious_conditions();  // velocities, conditions and loads
std::vector<SuspiciousDeck> suspicious_output();      // time, output and settings

/// All of them.
std::vector<SuspiciousDeck> suspicious_decks();

}  // namespace percuss
