#pragma once
// Tables of two columns, as materials have them.

#include "kernels/material/material_key.hpp"  // before values.hpp, whose ranges have names of its enumerators
#include "kernels/material/material_table.hpp"
#include "src/deck/keys/values.hpp"

namespace percuss {

/// Rows [x, y], x ascending.
struct TableValue {
  using Rows = std::vector<std::array<double, 2>>;
  Range range;  // of y

  bool read(const Reader& reader, const std::string& name, const Node& node, Rows& out) const {
    Rows rows;
    if (!read_rows(reader, name, node, MaterialTable::most_rows, rows)) return false;
    out = std::move(rows);
    return true;
  }
  /// most: rows.
  bool read_rows(const Reader& reader, const std::string& name, const Node& node, int most, Rows& rows) const {
    if (!ListValue<TupleValue<NumberValue, 2>>{}.read(reader, name, node, rows)) return false;
    if (rows.empty() || rows.size() > static_cast<std::size_t>(most)) {
      reader.error(node.spot,
                   fmt::format("{} has {} rows{} (must have 1 to {})", name, rows.size(), reader.in(), most));
      return false;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::string row = fmt::format("{}.{}", name, i);
      if (i > 0 && !(rows[i][0] > rows[i - 1][0])) {
        reader.error(node.items[i].spot, fmt::format("{} begins with {} after {}{} (rows must ascend)", row, rows[i][0],
                                                     rows[i - 1][0], reader.in()));
        return false;
      }
      if (!range.holds(rows[i][1])) {
        reader.error(node.items[i].spot,
                     fmt::format("{} has the value {}{} (must be {})", row, rows[i][1], reader.in(), range.text));
        return false;
      }
    }
    return true;
  }
  std::string takes() const {
    return "a table [[x, y], ...]" + (range.text.empty() ? std::string() : ", y " + range.text);
  }
  Form form() const { return list_form(tuple_form({number_form(), number_form(range)}), 1); }
};

}  // namespace percuss
