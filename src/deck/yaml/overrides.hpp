#pragma once
// --set path.to.key=value: changes to the tree before it is read.

#include <string>
#include <vector>

#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {

/// The left side of a --set argument: all before the first '='.
std::string override_path(const std::string& argument);

/// Puts the value of a --set argument (YAML) where its path leads: keys by name, list items by index from 0, the index
/// after the last one to append. Maps on the way that the deck lacks are made, except parts and materials. Adds errors
/// that name the argument. `index` is the argument's number.
void apply_override(const std::string& argument, int index, Node& root, DeckErrors& errors);

}  // namespace percuss
