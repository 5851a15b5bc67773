#pragma once
// Fields as variables of Exodus II, which are scalars: a vector or a tensor is one variable a component.

#include <span>
#include <string>
#include <vector>

#include "src/output/frame/frame_fields.hpp"

namespace percuss {

/// A component of a field in a frame.
struct ExodusVariable {
  std::string name;
  std::size_t field = 0;  // among those of the frame
  int component = 0;
};

/// The variables of nodes or of elements, field after field.
std::vector<ExodusVariable> list_exodus_variables(std::span<const FieldData> fields, FieldPlace place);

}  // namespace percuss
