// SelectorValue and PartNameValue.

#include "src/deck/keys/selector_keys.hpp"

namespace percuss {
namespace {

bool check_inside(const Reader& reader, const std::string& name, const Node& node, const Selector& selector) {
  if (!selector.inside) return true;
  const auto& [low, high] = *selector.inside;
  for (std::size_t i = 0; i < 3; ++i) {
    if (low[i] <= high[i]) continue;
    reader.error(node.find("inside")->spot,
                 fmt::format("{}.inside holds nothing{} (the lowest corner comes first, but {} > {} in {})", name,
                             reader.in(), low[i], high[i], "xyz"[i]));
    return false;
  }
  return true;
}

}  // namespace

const Keys<Selector>& selector_keys() {
  static const Keys<Selector> keys = {may("name", &Selector::name, TextValue{}),
                                      may("inside", &Selector::inside, TupleValue<TupleValue<NumberValue, 3>, 2>{})};
  return keys;
}

bool SelectorValue::read(const Reader& reader, const std::string& name, const Node& node, Selector& out) const {
  Selector selector;
  const Node* name_node = &node;
  if (node.kind == Node::Kind::map) {
    if (!read_keys(reader.inside(name), node, selector_keys(), selector) || !check_inside(reader, name, node, selector))
      return false;
    if (node.entries.empty()) {
      reader.refuse(node, name, "a map with name, inside or both");
      return false;
    }
    name_node = node.find("name");
  } else if (node.kind == Node::Kind::scalar) {
    selector.name = node.text;
  } else {
    reader.refuse(node, name, "a part, \"part/side\", all or {name: ..., inside: [...]}");
    return false;
  }
  selector.place = node.spot.place;
  if (name_node != nullptr) {
    if (selector.name.empty()) {
      reader.refuse(*name_node, name, "a part, \"part/side\" or all");
      return false;
    }
    if (selector.name == "all")
      selector.name.clear();
    else
      reader.reading().selectors.push_back({name_node->spot, selector.name, reader.in()});
  }
  reader.reading().used_selectors.push_back({selector, chosen});
  out = std::move(selector);
  return true;
}

Form SelectorValue::form() const {
  Form map = form_of(selector_keys());
  map.least = 1;
  map.listed_as = "SELECTOR";
  return any_form({TextValue{}.form(), std::move(map)});
}

bool PartNameValue::read(const Reader& reader, const std::string& name, const Node& node, std::string& out) const {
  if (!reader.expect(node, Node::Kind::scalar, name, takes())) return false;
  if (node.text.find('/') != std::string::npos) {
    reader.refuse(node, name, takes());
    return false;
  }
  if (node.text != "all") {
    out = node.text;
    reader.reading().selectors.push_back({node.spot, node.text, reader.in()});
  }
  return true;
}

}  // namespace percuss
