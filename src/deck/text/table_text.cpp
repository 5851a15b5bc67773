#include "src/deck/text/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/error.hpp"

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

void refuse_row(const std::string& path, std::size_t line, const std::string& what) {
  throw InputError(fmt::format("{}:{}: error: {}", path, line, what));
}

}  // namespace percuss
