#include "src/output/formats/result_names.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "src/output/formats/frame_formats.hpp"

namespace percuss {
namespace {

namespace fs = std::filesystem;

bool is_ending(const std::string& ending) {
  return std::any_of(frame_formats().begin(), frame_formats().end(), [&](const FrameFormat& format) {
    const std::vector<std::string> ends = format.list_endings();
    return std::find(ends.begin(), ends.end(), ending) != ends.end();
  });
}

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

}  // namespace

bool is_fields_file(const std::string& name) {
  const fs::path path(name);
  const std::string stem = path.stem().string(), ending = path.extension().string();
  if (!is_ending(ending)) return false;
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

bool holds_frames(const std::string& name) {
  return std::any_of(frame_formats().begin(), frame_formats().end(),
                     [&](const FrameFormat& format) { return name.ends_with(format.layout.ending); });
}

std::vector<std::string> name_fields_files(const std::string& output) {
  std::vector<std::string> names;
  for (const FrameFormat& format : frame_formats()) {
    for (const std::string& ending : format.list_endings()) names.push_back(name_fields(output) + ending);
  }
  return names;
}

}  // namespace percuss
