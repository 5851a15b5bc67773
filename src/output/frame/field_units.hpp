#pragma once
// Units of what a run writes, from those of the deck (src/deck/units.hpp).

#include <string>

namespace percuss {

/// The unit of a field of fields.vtkhdf: "m/s" of velocity where `units` are "m, kg, s". `Points` are the positions,
/// `time` that of a frame. Empty for a field without dimension, for one that is unknown, and where `units` are unknown.
std::string name_field_unit(const std::string& field, const std::string& units);

}  // namespace percuss
