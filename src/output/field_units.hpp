#pragma once
// Units of what a run writes, from the deck's `units: m, kg, s`.

#include <string>

namespace percuss {

/// The unit of a field of fields.vtkhdf: "m/s" of velocity in metres, kilograms and seconds; stresses in "Pa" with its
/// prefix where the system has one ("GPa" in mm, kg, ms), else in words ("kg/(cm·s²)"). `points` are the positions,
/// `time` that of a frame. Empty for a field without dimension, for one that is unknown, and where `units` are not one
/// name each of a known length, mass and time, in any order.
std::string name_field_unit(const std::string& field, const std::string& units);

}  // namespace percuss
