#include "src/deck/yaml/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "src/deck/text/deck_text.hpp"
#include "src/deck/text/nearest_name.hpp"
#include "src/deck/text/number_text.hpp"

namespace percuss {
namespace {

std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> keys(1);
  for (const char c : path) {
    if (c == '.')
      keys.emplace_back();
    else
      keys.back() += c;
  }
  return keys;
}

Node empty_map(Spot spot) {
  Node node;
  node.kind = Node::Kind::map;
  node.spot = node.key = spot;
  return node;
}

// The value of a key of a map; made if it is not there. Fails only where making one would hide a misspelt name.
Node* step_into_map(Node& map, const std::string& key, const std::string& above, bool is_last, Spot spot,
                    DeckErrors& errors) {
  for (Entry& entry : map.entries) {
    if (entry.name == key) return &entry.value;
  }
  if (!is_last && (above == "parts" || above == "materials")) {
    std::vector<std::string> names;
    for (const Entry& entry : map.entries) names.push_back(entry.name);
    errors.add(spot, fmt::format("there is no {} in {}{}", quote(key), above, name_hint(key, names)));
    return nullptr;
  }
  map.entries.push_back({key, empty_map(spot)});
  return &map.entries.back().value;
}

// The item of a list by its index; the one after the last is made.
Node* step_into_list(Node& list, const std::string& key, const std::string& above, Spot spot, DeckErrors& errors) {
  const auto index = read_integer(key);
  const auto* number = std::get_if<long long>(&index);
  const auto size = static_cast<long long>(list.items.size());
  if (number == nullptr || *number < 0 || *number > size) {
    errors.add(spot, fmt::format("'{}' is a list of {} value{} ({} is not a valid index; items count from 0)", above,
                                 size, size == 1 ? "" : "s", quote(key)));
    return nullptr;
  }
  if (*number == size) list.items.push_back(empty_map(spot));
  return &list.items[static_cast<std::size_t>(*number)];
}

// The node that the path leads to.
Node* walk(Node& root, const std::vector<std::string>& keys, Spot spot, DeckErrors& errors) {
  Node* node = &root;
  std::string above;
  for (std::size_t i = 0; i < keys.size() && node != nullptr; ++i) {
    if (keys[i].empty()) {
      errors.add(spot, "a key between the dots is empty (must be path.to.key=value)");
      return nullptr;
    }
    if (node->kind == Node::Kind::null) node->kind = Node::Kind::map;
    if (node->kind == Node::Kind::scalar) {
      errors.add(spot, fmt::format("'{}' is {} (a value, not a map that could hold {})", above, describe(*node),
                                   quote(keys[i])));
      return nullptr;
    }
    node = node->kind == Node::Kind::map ? step_into_map(*node, keys[i], above, i + 1 == keys.size(), spot, errors)
                                         : step_into_list(*node, keys[i], above, spot, errors);
    above += (above.empty() ? "" : ".") + keys[i];
  }
  return node;
}

}  // namespace

std::string override_path(const std::string& argument) { return argument.substr(0, argument.find('=')); }

void apply_override(const std::string& argument, int index, Node& root, DeckErrors& errors) {
  const Spot spot{{-index - 1, 0}, index};
  const auto equals = argument.find('=');
  if (equals == std::string::npos || equals == 0) {
    errors.add(spot, fmt::format("{} is not a setting (must be path.to.key=value)", quote(argument)));
    return;
  }
  std::string text = argument.substr(equals + 1);
  DeckErrors in_text("", {argument.substr(0, equals)});
  if (!check_deck_text(text, in_text)) {
    errors.add(spot, "the value is not UTF-8 text");
    return;
  }
  const std::optional<Node> parsed = parse_yaml(text, errors, index);
  if (!parsed) return;
  Node* target = walk(root, split_path(argument.substr(0, equals)), spot, errors);
  if (target == nullptr) return;
  *target = *parsed;
  target->spot = target->key = spot;
}

}  // namespace percuss
