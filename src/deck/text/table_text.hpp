#pragma once
// Tables in text files: rows of cells between commas, as spreadsheets write them.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace percuss {

/// What some editors put before the text of a file in UTF-8.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Without blanks, tabs and returns at both ends.
std::string_view trim_cell(std::string_view text);

/// The trimmed cells of a row; at least one.
std::vector<std::string_view> split_cells(std::string_view row);

/// Throws InputError: "path:line: error: what".
[[noreturn]] void refuse_row(const std::string& path, std::size_t line, const std::string& what);

}  // namespace percuss
