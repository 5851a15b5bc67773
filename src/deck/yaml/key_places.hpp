#pragma once
// Where the keys of a deck stand, for messages about values that are right alone and doubtful together.

#include <map>
#include <string>

#include "src/deck/text/deck_errors.hpp"

namespace percuss {

struct Node;

/// The places of keys by their paths: "parts.rod.box.size", "conditions.0.nodes". Items of lists are counted from 0.
class KeyPlaces {
 public:
  KeyPlaces() = default;
  explicit KeyPlaces(const Node& root);

  /// Place of the key or, where the deck does not give it, of the closest map or list around it that the deck gives.
  Place find(std::string path) const;

  /// Whether the deck gives the key.
  bool has(const std::string& path) const { return places_.count(path) > 0; }

 private:
  void note(const std::string& path, const Node& node);

  std::map<std::string, Place> places_;
};

}  // namespace percuss
