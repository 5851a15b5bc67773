#include "src/output/frame/component_names.hpp"

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

std::string find_field_of_component(const std::string& component, std::span<const std::string> fields) {
  for (const std::string& field : fields) {
    for (const int components : {1, 3, 6}) {
      const std::vector<std::string> names = list_component_names(field, components);
      if (std::find(names.begin(), names.end(), component) != names.end()) return field;
    }
  }
  return "";
}

}  // namespace percuss
