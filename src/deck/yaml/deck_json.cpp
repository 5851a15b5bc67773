#include "src/deck/yaml/deck_json.hpp"

#include <nlohmann/json.hpp>
#include <variant>

#include "src/deck/text/number_text.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;

Json convert_scalar(const Node& node) {
  if (node.quoted) return node.text;
  if (const auto whole = read_integer(node.text); std::holds_alternative<long long>(whole))
    return std::get<long long>(whole);
  if (const auto number = read_number(node.text); std::holds_alternative<double>(number))
    return std::get<double>(number);
  if (is_boolean(node.text)) return node.text.front() == 't' || node.text.front() == 'T';
  return node.text;
}

Json convert(const Node& node) {
  Json json;
  switch (node.kind) {
    case Node::Kind::null:
      return nullptr;
    case Node::Kind::scalar:
      return convert_scalar(node);
    case Node::Kind::list:
      json = Json::array();
      for (const Node& item : node.items) json.push_back(convert(item));
      return json;
    case Node::Kind::map:
      json = Json::object();  // its keys differ: none is looked for
      for (const Entry& entry : node.entries)
        json.get_ref<Json::object_t&>().emplace_back(entry.name, convert(entry.value));
      return json;
  }
  return json;
}

}  // namespace

std::string write_deck_json(const Node& deck) {
  return convert(deck).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace percuss
