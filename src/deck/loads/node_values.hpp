#pragma once
// What loads and conditions act on, and along which directions.

#include <algorithm>
#include <string>
#include <vector>

#include "src/deck/deck.hpp"
#include "src/deck/keys/keys.hpp"

namespace percuss {

/// All nodes of a rigid body.
struct BodyValue {
  bool read(const Reader& reader, const std::string& name, const Node& node, Selector& out) const;
  std::string takes() const { return NameValue{}.takes(); }
  Form form() const { return NameValue{}.form(); }
};

/// Whether an entry acts on nodes or on a body.
bool check_nodes_or_body(const Reader& reader, const Node& node);

/// Loads and conditions of bodies that exist.
void check_body_names(const Deck& deck, Reading& reading);

/// Reads a map from directions, at least one of them: read_one(place in `names`, inner reader, entry).
template <class ReadOne>
bool read_directions(const Reader& reader, const std::string& name, const Node& node, const std::string& takes,
                     const std::vector<std::string>& names, const ReadOne& read_one) {
  if (node.kind != Node::Kind::map || node.entries.empty()) {
    reader.refuse(node, name, takes);
    return false;
  }
  const Reader inner = reader.inside(name);
  bool good = true;
  for (const Entry& entry : node.entries) {
    const auto i = static_cast<std::size_t>(std::find(names.begin(), names.end(), entry.name) - names.begin());
    if (i < names.size()) {
      good = read_one(i, inner, entry) && good;
    } else {
      refuse_key(inner, entry, names, {});
      good = false;
    }
  }
  return good;
}

/// The form of such a map to curves.
Form directions_form(const std::vector<std::string>& names);

}  // namespace percuss
