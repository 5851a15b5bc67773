#pragma once
// Fields as variables of Exodus II, which are scalars: a vector or a tensor is one variable a component.

#include <span>
#include <string>
#include <vector>

#include "src/output/fields/fields_file.hpp"

namespace percuss {

/// "velocity_x" ... of three components, "stress_xx" ... of six: the endings by which ParaView joins them again.
std::vector<std::string> list_component_names(const std::string& field, int components);

/// The field of a variable: its name without such an ending.
std::string find_field_of_variable(const std::string& variable, std::span<const std::string> fields);

/// A component of a field in a frame.
struct ExodusVariable {
  std::string name;
  std::size_t field = 0;  // among those of the frame
  int component = 0;
};

/// The variables of nodes or of elements, field after field.
std::vector<ExodusVariable> list_exodus_variables(std::span<const FieldData> fields, FieldPlace place);

}  // namespace percuss
