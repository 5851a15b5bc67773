#include "src/output/files/result_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace percuss {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> endings{".vtkhdf", ".xdmf", ".xdmf2", ".exo"};

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

}  // namespace

std::string name_fields(const std::string& output) { return output.empty() ? "fields" : "fields_" + output; }

bool is_fields_file(const std::string& name) {
  const fs::path path(name);
  const std::string stem = path.stem().string(), ending = path.extension().string();
  if (std::find(endings.begin(), endings.end(), ending) == endings.end()) return false;
  if (stem == name_fields("")) return true;
  const std::string begin = name_fields("") + "_";
  return stem.size() > begin.size() && stem.starts_with(begin) && std::all_of(stem.begin(), stem.end(), is_of_name);
}

std::vector<std::string> list_fields_files(const std::string& folder, const std::string& behind) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    std::string name = at->path().filename().string();
    if (!name.ends_with(behind)) continue;
    name.resize(name.size() - behind.size());
    if (is_fields_file(name)) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());  // '.' is before '_'
  return names;
}

bool holds_frames(const std::string& name) { return name.ends_with(".vtkhdf") || name.ends_with(".exo"); }

}  // namespace percuss
