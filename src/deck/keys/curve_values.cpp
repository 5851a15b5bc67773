// CurveValue and PlaceFunctionValue.

#include <stdexcept>

#include "src/deck/keys/keys.hpp"

namespace percuss {
namespace {

constexpr const char* curve_forms = "a number, {table: [[time, value], ...]} or {expression: \"...\"}";

bool read_table(const Reader& reader, const std::string& name, const Node& node, Curve& out) {
  std::vector<std::array<double, 2>> rows;
  if (!ListValue<TupleValue<NumberValue, 2>>{}.read(reader, name, node, rows)) return false;
  std::vector<std::pair<double, double>> points;
  for (const auto& row : rows) {
    if (!points.empty() && !(row[0] > points.back().first)) {
      const Node& item = node.items[points.size()];
      reader.error(item.spot, fmt::format("{}.{} has time {} after {} (times must ascend)", name, points.size(), row[0],
                                          points.back().first));
      return false;
    }
    points.emplace_back(row[0], row[1]);
  }
  if (points.empty()) {
    reader.refuse(node, name, "at least one row [time, value]");
    return false;
  }
  out = Curve::table(std::move(points));
  return true;
}

/// F: Curve or PlaceFunction.
template <class F>
bool read_expression(const Reader& reader, const std::string& name, const Node& node, const std::string& takes,
                     F& out) {
  if (!reader.expect(node, Node::Kind::scalar, name, takes)) return false;
  try {
    out = F::expression(node.text);
    return true;
  } catch (const std::invalid_argument& reason) {
    reader.error(node.spot, fmt::format("{} is {}{} ({})", name, quote(node.text), reader.in(), reason.what()));
    return false;
  }
}

bool read_curve_map(const Reader& reader, const std::string& name, const Node& node, Curve& out) {
  const Reader inner = reader.inside(name);
  bool good = true;
  for (const Entry& entry : node.entries) {
    if (entry.name == "table")
      good = read_table(inner, inner.name_of(entry.name), entry.value, out) && good;
    else if (entry.name == "expression")
      good = read_expression(inner, inner.name_of(entry.name), entry.value, "a text, an expression of t", out) && good;
    else {
      refuse_key(inner, entry, {"table", "expression"}, {});
      good = false;
    }
  }
  if (good && node.entries.size() != 1) {
    const char* what = node.entries.empty() ? "neither table nor expression" : "both table and expression";
    reader.error(node.key, fmt::format("{} has {}{} (must be {})", name, what, reader.in(), curve_forms));
    return false;
  }
  return good;
}

}  // namespace

Form CurveValue::form() const {
  const auto one_key = [](const char* name, const char* takes, Form value) {
    Form form = map_form({{name, true, takes, std::move(value)}});
    form.listed_as = "";
    return form;
  };
  const Form rows = list_form(TupleValue<NumberValue, 2>{}.form(), 1);
  return any_form({number_form(), one_key("table", "rows [time, value], times ascending", rows),
                   one_key("expression", "a text, an expression of t", TextValue{}.form())});
}

bool PlaceFunctionValue::read(const Reader& reader, const std::string& name, const Node& node,
                              PlaceFunction& out) const {
  return read_expression(reader, name, node, takes(), out);
}

bool CurveValue::read(const Reader& reader, const std::string& name, const Node& node, Curve& out) const {
  if (node.kind == Node::Kind::map) {
    if (!read_curve_map(reader, name, node, out)) return false;
    reader.reading().curves.push_back({node.spot, name, out, is_not_negative});
    return true;
  }
  if (node.kind != Node::Kind::scalar) {
    reader.refuse(node, name, curve_forms);
    return false;
  }
  double value = 0;
  if (!NumberValue{is_not_negative ? not_negative : any_number}.read(reader, name, node, value)) return false;
  out = Curve::constant(value);
  return true;
}

}  // namespace percuss
