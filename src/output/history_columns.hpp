#pragma once
// columns.json: what the columns of history.csv are, for programs.

#include <span>
#include <string>
#include <vector>

#include "src/deck/units.hpp"

namespace percuss {

/// A column of history.csv.
struct HistoryColumn {
  std::string name;
  Dimension dimension{};
  std::string meaning;
  enum class Kind { by_dimension, temperature, moment };
  Kind kind = Kind::by_dimension;  // a moment has the dimension of an energy, but is no energy
};

/// The heading of the file.
std::vector<std::string> name_columns(std::span<const HistoryColumn> columns);

/// {"units": "mm, kg, ms", "columns": [{"name", "unit", "dimension", "meaning"}, ...]}. units: those of the deck, or
/// empty; then every unit is null. A column without a dimension has the unit "" and the dimension "1".
std::string format_columns(std::span<const HistoryColumn> columns, const std::string& units);

}  // namespace percuss
