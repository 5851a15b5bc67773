#include "src/step/initial/start_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "src/deck/text/number_text.hpp"
#include "src/deck/text/table_text.hpp"
#include "src/error.hpp"
#include "src/index.hpp"

namespace percuss {
namespace {

constexpr std::string_view stress_heading = "stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx";
constexpr std::string_view strain_heading = "equivalent_plastic_strain";
constexpr std::string_view temperature_heading = "temperature";
constexpr std::uintmax_t largest_table = std::numeric_limits<int>::max();  // MPI sends it, and counts with an int
constexpr std::string_view velocity_heading = "node,velocity_x,velocity_y,velocity_z";

/// Takes a word, or some, and the comma before it from the front of a text.
bool take_heading(std::string_view& text, std::string_view words) {
  const std::string front = fmt::format(",{}", words);
  if (!text.starts_with(front) || (text.size() > front.size() && text[front.size()] != ',')) return false;
  text.remove_prefix(front.size());
  return true;
}

/// Each quantity at most once, in any order. Returns whether there is nothing else.
bool read_quantities(std::string_view text, StartTable& table) {
  const auto take = [&](std::string_view words, int count, int& first) {
    if (first != StartTable::absent || !take_heading(text, words)) return false;
    first = table.columns;
    table.columns += count;
    return true;
  };
  while (take(stress_heading, 6, table.stress) || take(strain_heading, 1, table.plastic_strain) ||
         take(temperature_heading, 1, table.temperature)) {
  }
  return text.empty() && table.columns > 0;
}

void read_heading(std::string_view line, std::size_t number, const std::string& path, StartTable& table) {
  const std::string heading = fmt::format("{}", fmt::join(split_cells(line), ","));
  table.is_of_nodes = heading == velocity_heading;
  table.columns = table.is_of_nodes ? 3 : 0;
  if (table.is_of_nodes) return;
  const std::string with_comma = "," + heading;
  std::string_view rest = with_comma;
  if (take_heading(rest, "element")) {
    table.has_layers = take_heading(rest, "layer");
    if (read_quantities(rest, table)) return;
  }
  refuse_row(
      path, number,
      fmt::format("the heading is neither '{}' nor 'element', perhaps 'layer', and one or more of '{}', '{}' and "
                  "'{}' (it says what the numbers are)",
                  velocity_heading, stress_heading, strain_heading, temperature_heading));
}

std::int64_t read_positive(std::string_view cell, std::size_t number, const std::string& path, const char* what) {
  const auto value = read_integer(cell);
  if (!std::holds_alternative<long long>(value) || std::get<long long>(value) < 1)
    refuse_row(path, number, fmt::format("the {} is not a positive integer", what));
  return std::get<long long>(value);
}

void read_row(std::string_view line, std::size_t number, const std::string& path, StartTable& table) {
  const std::vector<std::string_view> cells = split_cells(line);
  const std::size_t first = table.has_layers ? 2 : 1;
  if (cells.size() != first + at(table.columns))
    refuse_row(
        path, number,
        fmt::format("the row has {} numbers (must be {}, as the heading)", cells.size(), first + at(table.columns)));
  table.ids.push_back(read_positive(cells[0], number, path, "id"));
  table.layers.push_back(table.has_layers ? read_positive(cells[1], number, path, "layer") : 0);
  table.lines.push_back(static_cast<int>(number));
  for (std::size_t c = first; c < cells.size(); ++c) {
    const auto value = read_number(cells[c]);
    if (const auto* problem = std::get_if<NumberProblem>(&value))
      refuse_row(path, number, fmt::format("number {} of the row must be {}", c + 1, problem->must_be));
    table.values.push_back(std::get<double>(value));
  }
  const int strain = table.plastic_strain;
  if (strain != StartTable::absent && table.row(static_cast<int>(table.ids.size()) - 1)[strain] < 0)
    refuse_row(path, number, "the equivalent plastic strain is negative (must be zero or positive)");
}

/// Rows by ascending ids and layers.
void sort_rows(const std::string& path, StartTable& table) {
  std::vector<std::size_t> order(table.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t row) { return std::pair(table.ids[row], table.layers[row]); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  StartTable sorted = table;
  sorted.ids.clear();
  sorted.layers.clear();
  sorted.lines.clear();
  sorted.values.clear();
  for (const std::size_t row : order) {
    if (!sorted.ids.empty() && std::pair(sorted.ids.back(), sorted.layers.back()) == key(row))
      refuse_row(path, static_cast<std::size_t>(table.lines[row]),
                 fmt::format("{} {} is there twice{} (first in line {})", table.is_of_nodes ? "node" : "element",
                             table.ids[row], table.has_layers ? fmt::format(" with layer {}", table.layers[row]) : "",
                             sorted.lines.back()));
    sorted.ids.push_back(table.ids[row]);
    sorted.layers.push_back(table.layers[row]);
    sorted.lines.push_back(table.lines[row]);
    const double* const first = table.row(static_cast<int>(row));
    sorted.values.insert(sorted.values.end(), first, first + table.columns);
  }
  table = std::move(sorted);
}

}  // namespace

std::string read_start_file(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem) && !problem)
    throw InputError(fmt::format("{}: error: no such file (a table of stresses or velocities is expected)", path));
  return read_table_file(path, "the table", largest_table);
}

StartTable parse_start_table(const std::string& text, const std::string& path) {
  StartTable table;
  bool has_heading = false;
  const std::size_t lines = visit_rows(text, [&](std::string_view row, std::size_t line) {
    if (has_heading)
      read_row(row, line, path, table);
    else
      read_heading(row, line, path, table);
    has_heading = true;
  });
  if (table.ids.empty())
    refuse_row(path, lines + 1, "there are no rows (a heading and a row an element or node are expected)");
  sort_rows(path, table);
  return table;
}

}  // namespace percuss
