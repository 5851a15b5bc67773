#pragma once
// The values of a deck as JSON: what a run tells of the scene that it ran.

#include <string>

#include "src/deck/yaml/yaml_tree.hpp"

namespace percuss {

/// Maps, lists, numbers, true and false, texts and nulls, in the order of the deck; equal trees have equal texts. What
/// is in quotes there is a text here. Numbers read back to the same bits.
std::string write_deck_json(const Node& deck);

}  // namespace percuss
