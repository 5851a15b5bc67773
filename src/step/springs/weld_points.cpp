#include "src/step/springs/weld_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <variant>

#include "comm/agreement.hpp"
#include "src/deck/text/number_text.hpp"
#include "src/deck/text/table_text.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/regular_file.hpp"

namespace percuss {
namespace {

constexpr std::size_t most_rows = 100000;
constexpr std::uintmax_t most_bytes = 64 << 20;

/// Whether no cell begins as a number does.
bool is_heading(const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return cell.empty() || std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
  });
}

WeldPoint read_point(const std::vector<std::string_view>& cells, std::size_t line, const std::string& path) {
  if (cells.size() != 3 && cells.size() != 4)
    refuse_row(path, line,
               fmt::format("the row has {} values (must be x, y, z, or x, y, z, diameter, with commas)", cells.size()));
  std::array<double, 4> values{};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto value = read_number(cells[c]);
    if (const auto* problem = std::get_if<NumberProblem>(&value))
      refuse_row(path, line, fmt::format("value {} of the row must be {}", c + 1, problem->must_be));
    values[c] = std::get<double>(value);
  }
  if (cells.size() == 4 && !(values[3] > 0)) refuse_row(path, line, "the diameter is not positive");
  return {{values[0], values[1], values[2]}, 0.5 * values[3], static_cast<int>(line)};
}

std::string read_table(const std::string& path) {
  if (const std::string kind = describe_irregular_file(path); !kind.empty())
    throw InputError(fmt::format("{}: error: the table of welds is {}", path, kind));
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(path, problem);
  std::ifstream file(path, std::ios::binary);
  if (!file || problem) throw SystemError(fmt::format("{}: error: the file cannot be opened", path));
  if (bytes > most_bytes)
    throw InputError(fmt::format("{}: error: the table of welds has {} bytes (at most {}): is it another file?", path,
                                 bytes, most_bytes));
  std::string text(bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(bytes));
  if (static_cast<std::uintmax_t>(file.gcount()) != bytes)
    throw SystemError(fmt::format("{}: error: the file cannot be read", path));
  return text;
}

}  // namespace

std::vector<WeldPoint> parse_weld_points(const std::string& text, const std::string& path, std::size_t most) {
  std::vector<WeldPoint> points;
  std::size_t number = 0;
  bool is_first = true;
  for (std::size_t begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; begin < text.size();) {
    const auto end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trim_cell(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> cells = split_cells(line);
    if (!(is_first && is_heading(cells))) points.push_back(read_point(cells, number, path));
    is_first = false;
    if (points.size() > most)
      refuse_row(path, number, fmt::format("the table has more than {} welds: divide it", most));
  }
  if (points.empty()) refuse_row(path, number + 1, "there are no welds (a row x, y, z each is expected)");
  return points;
}

std::vector<WeldPoint> list_weld_points(const Deck& deck, const Communicator& ranks, const WeldDeck& weld) {
  std::vector<WeldPoint> points;
  for (const Vec3& at : weld.at) points.push_back({at, *weld.radius, 0});
  if (weld.file.empty()) return points;
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    points = parse_weld_points(read_table(weld.file), weld.file, most_rows);
    for (WeldPoint& point : points) {
      if (point.radius == 0 && !weld.radius)
        throw InputError(
            fmt::format("{}: error: weld '{}' has no radius for line {} of {} (which gives no diameter): "
                        "give radius",
                        deck.where(weld.place), weld.name, point.line, weld.file));
      if (point.radius == 0) point.radius = *weld.radius;
    }
  });
  broadcast_values(ranks, points, 0);
  return points;
}

}  // namespace percuss
