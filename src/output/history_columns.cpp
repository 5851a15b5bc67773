#include "src/output/history_columns.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace percuss {
namespace {

/// "mass length^2 time^-2"; "1" of a number.
std::string describe(const HistoryColumn& column) {
  if (column.kind == HistoryColumn::Kind::temperature) return "temperature";
  std::string text;
  const Dimension& d = column.dimension;
  for (const auto& [name, power] :
       {std::pair{"mass", d.mass}, std::pair{"length", d.length}, std::pair{"time", d.time}}) {
    if (power == 0) continue;
    if (!text.empty()) text += ' ';
    text += power == 1 ? name : fmt::format("{}^{}", name, power);
  }
  return text.empty() ? "1" : text;
}

nlohmann::ordered_json find_unit(const HistoryColumn& column, const std::optional<Units>& units) {
  if (!units) return nullptr;
  if (column.kind == HistoryColumn::Kind::temperature) return units->temperature;
  if (column.kind == HistoryColumn::Kind::moment)
    return fmt::format("{}\u00b7{}", units->name_of(dimensions::force), units->name_of(dimensions::length));
  const Dimension& d = column.dimension;
  const bool is_number = d.length == 0 && d.mass == 0 && d.time == 0;
  return is_number ? "" : units->name_of(d);
}

}  // namespace

std::vector<std::string> name_columns(std::span<const HistoryColumn> columns) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : columns) names.push_back(column.name);
  return names;
}

std::string format_columns(std::span<const HistoryColumn> columns, const std::string& units) {
  const std::optional<Units> known = find_units(units);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const HistoryColumn& column : columns) {
    list.push_back({{"name", column.name},
                    {"unit", find_unit(column, known)},
                    {"dimension", describe(column)},
                    {"meaning", column.meaning}});
  }
  nlohmann::ordered_json json;
  json["units"] = known ? nlohmann::ordered_json(known->text()) : nlohmann::ordered_json(nullptr);
  json["columns"] = std::move(list);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace percuss
