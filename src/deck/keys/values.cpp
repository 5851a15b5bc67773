#include "src/deck/keys/values.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "src/deck/text/number_text.hpp"

namespace percuss {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// The text of a plain scalar; refuses everything else as not being `rule`.
const std::string* plain_text(const Reader& reader, const std::string& name, const Node& node,
                              const std::string& rule) {
  if (node.kind == Node::Kind::scalar && !node.quoted) return &node.text;
  const bool quoted_number = node.kind == Node::Kind::scalar && std::holds_alternative<double>(read_number(node.text));
  reader.refuse(node, name, quoted_number ? rule + "; remove the quotes" : rule);
  return nullptr;
}

}  // namespace

std::string comma_hint(const Node& list, std::size_t wanted) {
  if (list.kind != Node::Kind::list || list.items.size() <= wanted || list.items.size() > 2 * wanted) return "";
  const bool are_integers = std::all_of(list.items.begin(), list.items.end(), [](const Node& item) {
    return item.kind == Node::Kind::scalar && std::holds_alternative<long long>(read_integer(item.text));
  });
  return are_integers ? "; decimals take a point, not a comma" : "";
}

bool NumberValue::read(const Reader& reader, const std::string& name, const Node& node, double& out) const {
  const std::string* text = plain_text(reader, name, node, "a number");
  if (text == nullptr) return false;
  const auto number = read_number(*text);
  if (const auto* problem = std::get_if<NumberProblem>(&number)) {
    reader.refuse(node, name, problem->must_be);
    return false;
  }
  const double value = std::get<double>(number);
  if (!range.holds(value)) {
    reader.refuse(node, name, range.text);
    return false;
  }
  out = value;
  return true;
}

bool IntegerValue::read(const Reader& reader, const std::string& name, const Node& node, long& out) const {
  const std::string* text = plain_text(reader, name, node, "an integer");
  if (text == nullptr) return false;
  const auto number = read_integer(*text);
  if (const auto* problem = std::get_if<NumberProblem>(&number)) {
    reader.refuse(node, name, problem->must_be);
    return false;
  }
  const long long value = std::get<long long>(number);
  if (value < low || value > high) {
    reader.refuse(node, name, value < low ? fmt::format("at least {}", low) : fmt::format("at most {}", high));
    return false;
  }
  out = static_cast<long>(value);
  return true;
}

bool IntegerValue::read(const Reader& reader, const std::string& name, const Node& node, int& out) const {
  long value = 0;
  if (!read(reader, name, node, value)) return false;
  out = static_cast<int>(value);  // high is an int by default; a wider one is for members of type long
  return true;
}

Form IntegerValue::form() const {
  Form form{Form::Kind::integer};
  form.range.low = static_cast<double>(low);
  if (high <= std::numeric_limits<int>::max()) form.range.high = static_cast<double>(high);
  return form;
}

bool BooleanValue::read(const Reader& reader, const std::string& name, const Node& node, bool& out) const {
  if (node.kind != Node::Kind::scalar || node.quoted || !is_boolean(node.text)) {
    reader.refuse(node, name, takes());
    return false;
  }
  out = node.text[0] == 't' || node.text[0] == 'T';
  return true;
}

bool TextValue::read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
  if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
  out = node.text;
  return true;
}

bool is_name(const std::string& text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (const char c : text) {
    if (!is_letter(c) && !is_digit(c) && c != '-') return false;
  }
  return true;
}

bool NameValue::read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
  if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
  if (!is_name(node.text)) {
    reader.refuse(node, name, "letters, digits, '_' or '-', and begin with a letter");
    return false;
  }
  out = node.text;
  return true;
}

bool DirectionValue::read(const Reader& reader, const std::string& name, const Node& node, Vec3& out) const {
  if (node.kind == Node::Kind::scalar) {
    const bool negative = node.text.starts_with('-');
    const std::string axis = negative ? node.text.substr(1) : node.text;
    if (axis != "x" && axis != "y" && axis != "z") {
      reader.refuse(node, name, takes());
      return false;
    }
    out = {};
    out[static_cast<std::size_t>(axis[0] - 'x')] = negative ? -1 : 1;
    return true;
  }
  if (node.kind != Node::Kind::list) {
    reader.refuse(node, name, takes());
    return false;
  }
  Vec3 v{};
  if (!vector3().read(reader, name, node, v)) return false;
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0) {
    reader.refuse(node, name, "a vector that is not zero");
    return false;
  }
  // Scaled first, so that no square over- or underflows.
  for (double& x : v) x /= largest;
  const double length = std::hypot(v[0], v[1], v[2]);
  for (std::size_t i = 0; i < 3; ++i) out[i] = v[i] / length;
  return true;
}

}  // namespace percuss
