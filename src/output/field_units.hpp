#pragma once
// Units of what a run writes, from the deck's `units: m, kg, s`.

#include <string>

namespace percuss {

/// The unit of a field of fields.vtkhdf by src/deck/units.hpp: "m/s" of velocity in m, kg, s, "GPa" of stress in mm, kg,
/// ms. `points` are the positions, `time` that of a frame. Empty for a field without dimension, for one that is unknown,
/// and where the deck names no units.
std::string name_field_unit(const std::string& field, const std::string& units);

}  // namespace percuss
