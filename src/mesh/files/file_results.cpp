#include "src/mesh/files/file_results.hpp"

namespace percuss {

std::vector<std::string> name_result_components(const std::string& array, std::int64_t components) {
  if (components == 1) return {array};
  if (components == 3) return {array + "_x", array + "_y", array + "_z"};
  if (components != 6) return {};
  return {array + "_xx", array + "_yy", array + "_zz", array + "_xy", array + "_yz", array + "_zx"};
}

}  // namespace percuss
