#pragma once
// A table of what a spring gives over what it is stretched or turned by.

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "src/deck/keys/values.hpp"

namespace percuss {

/// Rows of two numbers, at least two, the first ascending.
struct ForceTableValue {
  const char* first;   // "elongation"
  const char* second;  // "force"

  bool read(const Reader& reader, const std::string& name, const Node& node,
            std::vector<std::array<double, 2>>& out) const {
    std::vector<std::array<double, 2>> rows;
    if (!ListValue<TupleValue<NumberValue, 2>>{}.read(reader, name, node, rows)) return false;
    if (rows.size() < 2) {
      reader.refuse(node, name, fmt::format("at least two rows [{}, {}]", first, second));
      return false;
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (rows[i][0] > rows[i - 1][0]) continue;
      reader.error(node.items[i].spot, fmt::format("{}.{} has {} {} after {} ({}s must ascend)", name, i, first,
                                                   rows[i][0], rows[i - 1][0], first));
      return false;
    }
    out = std::move(rows);
    return true;
  }
  std::string takes() const { return fmt::format("rows [{}, {}], {}s ascending", first, second, first); }
  Form form() const { return list_form(TupleValue<NumberValue, 2>{}.form(), 2); }
};

}  // namespace percuss
