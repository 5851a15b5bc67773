#pragma once
// Names of the components of fields, for formats that know scalars alone.

#include <span>
#include <string>
#include <vector>

namespace percuss {

/// "velocity_x" ... of three components, "stress_xx" ... of six: the endings by which ParaView joins them again.
std::vector<std::string> list_component_names(const std::string& field, int components);

/// The field that a component belongs to; empty if it is none of `fields`.
std::string find_field_of_component(const std::string& component, std::span<const std::string> fields);

}  // namespace percuss
