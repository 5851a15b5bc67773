#include "src/mesh/files/included_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "src/mesh/files/text_numbers.hpp"

namespace percuss {

std::string find_folder(const std::string& path) { return std::filesystem::absolute(path).parent_path().string(); }

std::string find_included_file(const std::string& folder, std::string_view name, const TextNames& names,
                               TextPlace place) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::path(folder) / name, error);
  const fs::path inside = path.lexically_relative(fs::weakly_canonical(folder, error));
  if (name.empty() || error || inside.empty() || *inside.begin() == "..")
    names.refuse(place, fmt::format("{} is not read (included files lie in the folder of the first file, or below)",
                                    quote_field(name)));
  if (!fs::is_regular_file(path, error)) names.refuse(place, fmt::format("there is no file {}", quote_field(name)));
  return path.string();
}

}  // namespace percuss
