#include "src/step/start/start_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <variant>

#include "src/deck/text/number_text.hpp"
#include "src/error.hpp"
#include "src/index.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

constexpr const char* stress_heading = "element,stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx";
constexpr const char* strain_heading = ",equivalent_plastic_strain";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::uintmax_t largest_table = std::numeric_limits<int>::max();  // MPI sends it, and counts with an int
constexpr const char* velocity_heading = "node,velocity_x,velocity_y,velocity_z";

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& what) {
  throw InputError(fmt::format("{}:{}: error: {}", path, line, what));
}

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> split_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(',', begin), line.size());
    cells.push_back(trim(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return cells;
}

void read_heading(std::string_view line, std::size_t number, const std::string& path, StartTable& table) {
  const std::string heading = fmt::format("{}", fmt::join(split_cells(line), ","));
  table.is_of_nodes = heading == velocity_heading;
  table.has_plastic_strain = heading == std::string(stress_heading) + strain_heading;
  if (table.is_of_nodes || table.has_plastic_strain || heading == stress_heading) return;
  refuse(path, number,
         fmt::format("the heading is not one of '{}', '{}' and '{}' (they say what the numbers are)", stress_heading,
                     std::string(stress_heading) + strain_heading, velocity_heading));
}

void read_row(std::string_view line, std::size_t number, const std::string& path, StartTable& table) {
  const std::vector<std::string_view> cells = split_cells(line);
  if (cells.size() != at(table.columns() + 1))
    refuse(path, number,
           fmt::format("the row has {} numbers (must be {}, as the heading)", cells.size(), table.columns() + 1));
  const auto id = read_integer(cells[0]);
  if (!std::holds_alternative<long long>(id) || std::get<long long>(id) < 1)
    refuse(path, number, fmt::format("the id is not a positive integer"));
  table.ids.push_back(std::get<long long>(id));
  table.lines.push_back(static_cast<int>(number));
  for (std::size_t c = 1; c < cells.size(); ++c) {
    const auto value = read_number(cells[c]);
    if (const auto* problem = std::get_if<NumberProblem>(&value))
      refuse(path, number, fmt::format("number {} of the row must be {}", c + 1, problem->must_be));
    table.values.push_back(std::get<double>(value));
  }
  if (table.has_plastic_strain && table.values.back() < 0)
    refuse(path, number, "the equivalent plastic strain is negative (must be zero or positive)");
}

/// Rows by ascending ids.
void sort_rows(const std::string& path, StartTable& table) {
  std::vector<std::size_t> order(table.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return table.ids[a] < table.ids[b]; });
  StartTable sorted{table.is_of_nodes, table.has_plastic_strain, {}, {}, {}};
  for (const std::size_t row : order) {
    if (!sorted.ids.empty() && sorted.ids.back() == table.ids[row])
      refuse(path, static_cast<std::size_t>(table.lines[row]),
             fmt::format("{} {} is there twice (first in line {})", table.is_of_nodes ? "node" : "element",
                         table.ids[row], sorted.lines.back()));
    sorted.ids.push_back(table.ids[row]);
    sorted.lines.push_back(table.lines[row]);
    const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(row) * table.columns();
    sorted.values.insert(sorted.values.end(), first, first + table.columns());
  }
  table = std::move(sorted);
}

}  // namespace

std::string read_start_file(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem) && !problem)
    throw InputError(fmt::format("{}: error: no such file (a table of stresses or velocities is expected)", path));
  if (const std::string kind = describe_irregular_file(path); !kind.empty())
    throw InputError(fmt::format("{}: error: the table is {}", path, kind));
  std::ifstream file(path, std::ios::binary);
  const std::uintmax_t bytes = std::filesystem::file_size(path, problem);
  if (!file || problem) throw SystemError(fmt::format("{}: error: the file cannot be opened", path));
  if (bytes > largest_table)
    throw InputError(
        fmt::format("{}: error: the table has {} bytes (must have less than 2 GiB): use several files", path, bytes));
  std::string text(bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(file.gcount()) != bytes)
    throw SystemError(fmt::format("{}: error: the file cannot be read", path));
  return text;
}

StartTable parse_start_table(const std::string& text, const std::string& path) {
  StartTable table;
  bool has_heading = false;
  std::size_t number = 0;
  for (std::size_t begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trim(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (has_heading)
      read_row(line, number, path, table);
    else
      read_heading(line, number, path, table);
    has_heading = true;
  }
  if (table.ids.empty())
    refuse(path, number + 1, "there are no rows (a heading and a row an element or node are expected)");
  sort_rows(path, table);
  return table;
}

}  // namespace percuss
