#include "src/deck/yaml/yaml_tree.hpp"

#include <fmt/format.h>

#include <string_view>
#include <variant>

#include "src/deck/text/number_text.hpp"

namespace percuss {
namespace {

// At most this much of a text is quoted in a message.
constexpr std::size_t longest_quote = 40;

bool is_number(std::string_view text) { return std::holds_alternative<double>(read_number(text)); }

std::string describe_scalar(const Node& node) {
  if (node.quoted) return "the text " + quote(node.text);
  return is_number(node.text) || is_boolean(node.text) ? node.text.substr(0, longest_quote) : quote(node.text);
}

}  // namespace

std::string quote(std::string_view text) {
  std::string out = "'";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool boundary = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;  // never cut a UTF-8 sequence
    if (i >= longest_quote && boundary) return out + "...'";
    out += text[i] == '\n' || text[i] == '\t' || text[i] == '\r' ? ' ' : text[i];
  }
  return out + "'";
}

const Node* Node::find(const std::string& name) const {
  for (const Entry& entry : entries) {
    if (entry.name == name) return &entry.value;
  }
  return nullptr;
}

std::string describe(const Node& node) {
  constexpr std::size_t most_shown = 4;
  switch (node.kind) {
    case Node::Kind::null:
      return "empty";
    case Node::Kind::scalar:
      return describe_scalar(node);
    case Node::Kind::map:
      return "a map";
    case Node::Kind::list:
      break;
  }
  std::string text;
  for (const Node& item : node.items) {
    if (item.kind != Node::Kind::scalar || node.items.size() > most_shown) {
      return fmt::format("a list of {} value{}", node.items.size(), node.items.size() == 1 ? "" : "s");
    }
    text += (text.empty() ? "" : ", ") + describe_scalar(item);
  }
  return "[" + text + "]";
}

}  // namespace percuss
