#pragma once
// Tables in text files: rows of cells between commas, as spreadsheets write them.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// Mark that some editors put before the text of a file in UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The cell without blanks, tabs and returns at both ends.
std::string_view trim_cell(std::string_view text);

/// The trimmed cells of a row; at least one.
std::vector<std::string_view> split_cells(std::string_view row);

/// Calls take(row, line) for each row, trimmed, with its line from 1 on: not of blank ones and comments after #.
/// Returns how many lines there are.
template <class Take>
std::size_t visit_rows(std::string_view text, const Take& take) {
  std::size_t line = 0;
  for (std::size_t begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view row = trim_cell(text.substr(begin, end - begin));
    begin = end + 1;
    ++line;
    if (!row.empty() && row.front() != '#') take(row, line);
  }
  return line;
}

/// The text of a file of at most so many bytes. name: "the table". Throws InputError, SystemError.
std::string read_table_file(const std::string& path, std::string_view name, std::uintmax_t most);

/// Throws InputError: "path:line: error: what".
[[noreturn]] void refuse_row(const std::string& path, std::size_t line, const std::string& what);

}  // namespace percuss
