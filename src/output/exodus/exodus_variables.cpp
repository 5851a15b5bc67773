#include "src/output/exodus/exodus_variables.hpp"

#include "src/output/frame/component_names.hpp"

namespace percuss {

std::vector<ExodusVariable> list_exodus_variables(std::span<const FieldData> fields, FieldPlace place) {
  std::vector<ExodusVariable> variables;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    if (fields[f].place != place) continue;
    int component = 0;
    for (std::string& name : list_component_names(fields[f].name, fields[f].components))
      variables.push_back({std::move(name), f, component++});
  }
  return variables;
}

}  // namespace percuss
