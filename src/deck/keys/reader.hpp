#pragma once
// What every value reader shares: where errors go, how a value is called in them, and what is checked at the end.

#include <set>
#include <string>
#include <vector>

#include "src/deck/functions/curve.hpp"
#include "src/deck/functions/selector.hpp"
#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {

/// A name that must exist elsewhere in the deck.
struct NameUse {
  Spot spot;
  std::string name;
  std::string in;  // " in part 'rod'", for the message
};

/// A curve that must be finite during the run.
struct CurveUse {
  Spot spot;
  std::string name;  // "loads.pressure.0.value"
  Curve curve;
  bool is_not_negative = false;
};

/// State of one reading, shared by all readers of it.
struct Reading {
  DeckErrors errors;
  std::string folder;  // of the deck, for files that it names
  std::vector<NameUse> materials{}, selectors{}, rotations{}, sensors{};
  std::vector<UsedSelector> used_selectors{};
  std::vector<CurveUse> curves{};
  std::set<std::string> shapeless{};  // parts whose shape is unknown, so that their sides are too
};

/// Where a value stands: messages name what is in parts.rod as "in part 'rod'", everything else by its path
/// ("time.end").
class Reader {
 public:
  explicit Reader(Reading& reading) : reading_(&reading) {}

  /// Reader of the values in the map that messages call `name` ("time", "initial.0").
  Reader inside(const std::string& name) const;

  /// Reader of the values of something that the user named: kind "part", name "rod".
  Reader inside_named(const std::string& kind, const std::string& name) const;

  /// "time.end" or "density": how messages call the key `key` of this map.
  std::string name_of(const std::string& key) const { return prefix_ + key; }

  /// " in material 'steel'", or nothing.
  const std::string& in() const { return in_; }

  /// "material 'steel'" or "'time'": this map itself, for messages; "the deck" at the top.
  std::string self() const;

  /// Adds an error: "NAME is FOUND in material 'steel' (must be RULE)", at the value.
  void refuse(const Node& node, const std::string& name, const std::string& rule) const;

  void error(Spot spot, std::string message) const { reading_->errors.add(spot, std::move(message)); }

  /// Whether the node is of the kind; if not, refuses it (in silence if it is broken).
  bool expect(const Node& node, Node::Kind kind, const std::string& name, const std::string& rule) const;

  Reading& reading() const { return *reading_; }

 private:
  Reading* reading_;
  std::string prefix_, in_;
};

}  // namespace percuss
