#include "src/step/springs/weld_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <variant>

#include "comm/agreement.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/deck/text/number_text.hpp"
#include "src/deck/text/table_text.hpp"
#include "src/deck/units.hpp"
#include "src/error.hpp"
#include "src/fail_together.hpp"
#include "src/step/springs/connection_file.hpp"

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

/// The part of an end of a weld: "roof" of "roof/x_min".
std::string part_of(const SpringEndDeck& end) { return end.where.name.substr(0, end.where.name.find('/')); }

/// Whether a group connects two parts, each of which has one of its names.
bool connects(const ConnectionGroup& group, const std::string& one, const std::string& other) {
  const auto find = [&](const std::string& name) {
    return std::find_if(group.parts.begin(), group.parts.end(), [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    });
  };
  const auto first = find(one), second = find(other);
  return first != group.parts.end() && second != group.parts.end() && first != second;
}

[[noreturn]] void refuse_names(const Deck& deck, const WeldDeck& weld, const ConnectionFile& file) {
  std::vector<std::string> known;
  for (const ConnectionGroup& group : file.groups)
    for (const std::vector<std::string>& names : group.parts) known.insert(known.end(), names.begin(), names.end());
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::string hint;
  for (const SpringEndDeck& end : weld.between)
    if (std::find(known.begin(), known.end(), part_of(end)) == known.end() && hint.empty())
      hint = fmt::format("; it has no '{}'{}", part_of(end), name_hint(part_of(end), known));
  throw InputError(fmt::format(
      "{}: error: no group of {} connects '{}' and '{}' (its parts go by label, pname or pid{}): give parts "
      "of the deck these names",
      deck.where(weld.place), weld.file, part_of(weld.between[0]), part_of(weld.between[1]), hint));
}

/// Metres of the file in a unit of the deck.
double find_scale(const Deck& deck, const WeldDeck& weld, const ConnectionFile& file) {
  const auto units = find_units(deck.units);
  if (!units)
    throw InputError(fmt::format("{}: error: {} has lengths with a unit (the deck has no units): give units",
                                 deck.where(weld.place), weld.file));
  const double deck_in_si = units->in_si(dimensions::length);
  return file.length_in_si == deck_in_si ? 1 : file.length_in_si / deck_in_si;
}

/// The spot welds of the groups that connect both ends. A file of one group may name no parts.
WeldPoints choose_points(const Deck& deck, const WeldDeck& weld, const ConnectionFile& file) {
  const double scale = find_scale(deck, weld, file);
  const bool has_no_names = file.groups.size() == 1 && file.groups.front().parts.empty();
  WeldPoints found;
  std::map<std::string, int> others;
  bool is_found = false;
  for (const ConnectionGroup& group : file.groups) {
    if (!has_no_names && !connects(group, part_of(weld.between[0]), part_of(weld.between[1]))) continue;
    is_found = true;
    found.points.insert(found.points.end(), group.spots.begin(), group.spots.end());
    for (const auto& [kind, count] : group.others) others[kind] += count;
  }
  if (!is_found) refuse_names(deck, weld, file);
  if (found.points.empty())
    throw InputError(fmt::format("{}: error: {} has no spot weld between '{}' and '{}'", deck.where(weld.place),
                                 weld.file, part_of(weld.between[0]), part_of(weld.between[1])));
  for (WeldPoint& point : found.points) {
    for (double& x : point.at) x *= scale;
    point.radius *= scale;
  }
  for (const auto& [kind, count] : others)
    found.left_out += fmt::format("{}{} of kind {}", found.left_out.empty() ? "" : ", ", count, kind);
  return found;
}

void set_radius(const Deck& deck, const WeldDeck& weld, std::vector<WeldPoint>& points) {
  for (WeldPoint& point : points) {
    if (point.radius == 0 && !weld.radius)
      throw InputError(
          fmt::format("{}: error: weld '{}' has no radius for line {} of {} (which gives no diameter): "
                      "give radius",
                      deck.where(weld.place), weld.name, point.line, weld.file));
    if (point.radius == 0) point.radius = *weld.radius;
  }
}

}  // namespace

std::vector<WeldPoint> parse_weld_points(const std::string& text, const std::string& path, std::size_t most) {
  std::vector<WeldPoint> points;
  bool is_first = true;
  const std::size_t lines = visit_rows(text, [&](std::string_view row, std::size_t line) {
    const std::vector<std::string_view> cells = split_cells(row);
    if (!(is_first && is_heading(cells))) points.push_back(read_point(cells, line, path));
    is_first = false;
    if (points.size() > most) refuse_row(path, line, fmt::format("the table has more than {} welds: divide it", most));
  });
  if (points.empty()) refuse_row(path, lines + 1, "there are no welds (a row x, y, z each is expected)");
  return points;
}

WeldPoints list_weld_points(const Deck& deck, const Communicator& ranks, const WeldDeck& weld) {
  WeldPoints found;
  for (const Vec3& at : weld.at) found.points.push_back({at, *weld.radius, 0});
  if (weld.file.empty()) return found;
  fail_together(ranks, [&] {
    if (ranks.rank() != 0) return;
    const std::string text = read_table_file(weld.file, "the table of welds", most_bytes);
    if (is_connection_file(text))
      found = choose_points(deck, weld, parse_connections(text, weld.file, most_rows));
    else
      found.points = parse_weld_points(text, weld.file, most_rows);
    set_radius(deck, weld, found.points);
  });
  broadcast_values(ranks, found.points, 0);
  found.left_out = broadcast_text(ranks, found.left_out, 0);
  return found;
}

}  // namespace percuss
