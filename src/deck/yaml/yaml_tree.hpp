#pragma once
// The deck as a tree of maps, lists and scalars, every node with its place; strict where YAML is lax.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/deck/text/deck_errors.hpp"

namespace percuss {

struct Node;
struct Entry;

struct Node {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  bool quoted = false;  // a scalar in quotes or block style: text, never a number
  bool broken = false;  // an error about this node was reported already; readers pass over it in silence
  Spot spot;            // of the value
  Spot key;             // of the key that holds it; of the value where there is none
  std::string text;     // of a scalar
  std::vector<Node> items;
  std::vector<Entry> entries;

  /// The value of a key, or nullptr.
  const Node* find(const std::string& name) const;
};

struct Entry {
  std::string name;
  Node value;
};

/// Parses one YAML document. Adds errors for what is not YAML, for duplicate keys, keys that are no plain words,
/// anchors, aliases, tags, a second document, nesting deeper than 32 and more values than a deck can have. Returns
/// nothing if the rest of the text could not be understood. `override` is the number of the --set argument that the
/// text came from, or -1.
std::optional<Node> parse_yaml(const std::string& text, DeckErrors& errors, int override = -1);

/// A text in single quotes on one line, shortened if it is long.
std::string quote(std::string_view text);

/// What a node is, for messages: -7800, 'heavy', "a map", "[1, 2]", "a list of 12 values", "empty".
std::string describe(const Node& node);

}  // namespace percuss
