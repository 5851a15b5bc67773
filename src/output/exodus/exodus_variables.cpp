#include "src/output/exodus/exodus_variables.hpp"

#include <algorithm>
#include <array>

namespace percuss {
namespace {

constexpr std::array<const char*, 3> vector_endings{"_x", "_y", "_z"};
constexpr std::array<const char*, 6> tensor_endings{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"};

std::span<const char* const> find_endings(int components) {
  if (components == 3) return vector_endings;
  if (components == 6) return tensor_endings;
  return {};
}

}  // namespace

std::vector<std::string> list_component_names(const std::string& field, int components) {
  if (components == 1) return {field};
  std::vector<std::string> names;
  for (const char* ending : find_endings(components)) names.push_back(field + ending);
  return names;
}

std::string find_field_of_variable(const std::string& variable, std::span<const std::string> fields) {
  for (const std::string& field : fields) {
    for (const int components : {1, 3, 6}) {
      const std::vector<std::string> names = list_component_names(field, components);
      if (std::find(names.begin(), names.end(), variable) != names.end()) return field;
    }
  }
  return "";
}

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
