#include "src/deck/yaml/key_places.hpp"

#include <algorithm>

#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {
namespace {

/// Lists that are longer than this are data, such as a thousand history points: their items keep a place each with the
/// reader, and the keys inside them are identified by the place of the list.
constexpr std::size_t longest_list = 200;

bool is_data(const Node& list) {
  return list.items.size() > longest_list || std::all_of(list.items.begin(), list.items.end(), [](const Node& item) {
           return item.kind == Node::Kind::scalar;
         });
}

}  // namespace

KeyPlaces::KeyPlaces(const Node& root) { note("", root); }

void KeyPlaces::note(const std::string& path, const Node& node) {
  const std::string front = path.empty() ? "" : path + ".";
  for (const Entry& entry : node.entries) {
    places_.emplace(front + entry.name, entry.value.key.place);
    note(front + entry.name, entry.value);
  }
  if (is_data(node)) return;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    places_.emplace(front + std::to_string(i), node.items[i].spot.place);
    note(front + std::to_string(i), node.items[i]);
  }
}

Place KeyPlaces::find(std::string path) const {
  while (true) {
    if (const auto found = places_.find(path); found != places_.end()) return found->second;
    const auto end = path.rfind('.');
    if (end == std::string::npos) return {};
    path.resize(end);
  }
}

}  // namespace percuss
