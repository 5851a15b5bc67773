#include "src/deck/text/table_text.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "src/error.hpp"
#include "src/regular_file.hpp"

namespace percuss {

std::string_view trim_cell(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split_cells(std::string_view row) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= row.size();) {
    const auto end = std::min(row.find(',', begin), row.size());
    cells.push_back(trim_cell(row.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

std::string read_table_file(const std::string& path, std::string_view name, std::uintmax_t most) {
  if (const std::string kind = describe_irregular_file(path); !kind.empty())
    throw InputError(fmt::format("{}: error: {} is {}", path, name, kind));
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(path, problem);
  std::ifstream file(path, std::ios::binary);
  if (!file || problem) throw SystemError(fmt::format("{}: error: the file cannot be opened", path));
  if (bytes > most)
    throw InputError(fmt::format("{}: error: {} has {} bytes (at most {}): divide it", path, name, bytes, most));
  std::string text(bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(file.gcount()) != bytes)
    throw SystemError(fmt::format("{}: error: the file cannot be read", path));
  return text;
}

void refuse_row(const std::string& path, std::size_t line, const std::string& what) {
  throw InputError(fmt::format("{}:{}: error: {}", path, line, what));
}

}  // namespace percuss
